//! Writing what the scene came to: its shader, its text, its picture.

use std::path::Path;

use egui::{ComboBox, Context, DragValue, ProgressBar, Ui, Window};

use super::place::Place;
use crate::app::Editor;
use crate::darkroom::{Shot, still};
use crate::panels::shader;
use crate::worker::Job;

/// The most pixels along an edge.
pub(super) const MOST_EDGE: u32 = 8192;

/// What is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Wgsl,
    Scene,
    Png,
    Exr,
}

impl Kind {
    const ALL: [Kind; 4] = [Kind::Wgsl, Kind::Scene, Kind::Png, Kind::Exr];

    fn name(self) -> &'static str {
        match self {
            Kind::Wgsl => "Shader, WGSL",
            Kind::Scene => "Scene, text",
            Kind::Png => "Picture, PNG",
            Kind::Exr => "Picture, EXR with its radiance",
        }
    }

    fn ending(self) -> &'static str {
        match self {
            Kind::Wgsl => "wgsl",
            Kind::Scene => "csg",
            Kind::Png => "png",
            Kind::Exr => "exr",
        }
    }

    fn is_picture(self) -> bool {
        matches!(self, Kind::Png | Kind::Exr)
    }
}

/// The dialog.
pub(crate) struct Export {
    kind: Kind,
    place: Place,
    pub(super) frame: FrameSize,
    job: Option<Job<Result<(), String>>>,
    /// What came of the last one.
    outcome: Option<Result<String, String>>,
}

/// How large a picture is, and how good.
pub(super) struct FrameSize {
    pub(super) size: [u32; 2],
    pub(super) samples: u32,
}

impl FrameSize {
    /// As large as the picture in the window.
    pub(super) fn of(editor: &Editor) -> Self {
        Self { size: editor.session.wanted().size, samples: editor.settings.samples }
    }

    /// Shows the controls.
    pub(super) fn show(&mut self, ui: &mut Ui) {
        ui.horizontal(|ui| {
            for (name, edge) in ["Width", "Height"].into_iter().zip(&mut self.size) {
                let label = ui.label(name);
                ui.add(DragValue::new(edge).range(1..=MOST_EDGE).suffix(" px")).labelled_by(label.id);
            }
            let label = ui.label("Samples");
            ui.add(DragValue::new(&mut self.samples).range(1..=65_536)).labelled_by(label.id);
        });
    }
}

impl Export {
    /// Ready to write the shader.
    pub(crate) fn of_shader(editor: &Editor) -> Self {
        Self::new(editor, Kind::Wgsl)
    }

    /// Ready to write the picture.
    pub(crate) fn of_picture(editor: &Editor) -> Self {
        Self::new(editor, Kind::Png)
    }

    fn new(editor: &Editor, kind: Kind) -> Self {
        let scene = editor.session.scene_document().path.clone();
        let place = Place::beside(scene.as_deref(), kind.ending());
        Self { kind, place, frame: FrameSize::of(editor), job: None, outcome: None }
    }

    fn start(&mut self, editor: &Editor, context: &Context) {
        let path = self.place.path();
        self.outcome = None;
        let job = if self.kind.is_picture() {
            let shot = Shot::of(&editor.session, editor.adapter.clone(), self.frame.size, self.frame.samples);
            shot.map(|shot| Job::start(context, move |progress| still(&shot, &path, progress)))
        } else {
            text_job(editor, self.kind, context, path)
        };
        match job {
            Some(Ok(job)) => self.job = Some(job),
            Some(Err(error)) => self.outcome = Some(Err(error.to_string())),
            None => self.outcome = Some(Err("there is no scene without errors yet".to_owned())),
        }
    }

    fn poll(&mut self) {
        let Some(result) = self.job.as_mut().and_then(Job::poll) else { return };
        let is_cancelled = self.job.take().is_some_and(|job| job.progress.is_cancelled());
        self.outcome = Some(match result.and_then(|result| result) {
            Ok(()) if is_cancelled => Err("cancelled".to_owned()),
            Ok(()) => Ok(format!("{} is written", self.place.path)),
            Err(reason) => Err(reason),
        });
    }
}

fn text_job(
    editor: &Editor,
    kind: Kind,
    context: &Context,
    path: std::path::PathBuf,
) -> Option<std::io::Result<Job<Result<(), String>>>> {
    let write =
        |path: &Path, text: &str| chiaro_files::write(path, text.as_bytes()).map_err(|error| format!("{error:#}"));
    if kind == Kind::Scene {
        let text = editor.session.scene_document().text.clone();
        return Some(Job::start(context, move |_| write(&path, &text)));
    }
    let program = editor.session.shown.as_ref().map(|_| editor.session.program())?;
    Some(Job::start(context, move |_| write(&path, &shader::code(program)?.text)))
}

/// Shows the dialog, if it is open.
pub(super) fn show(editor: &mut Editor, context: &Context) {
    let Some(mut export) = editor.dialogs.export.take() else { return };
    export.poll();
    let mut is_open = true;
    Window::new("Export").open(&mut is_open).collapsible(false).resizable(false).default_width(420.0).show(
        context,
        |ui| {
            ui.set_width(420.0);
            let is_idle = export.job.is_none();
            ui.add_enabled_ui(is_idle, |ui| controls(&mut export, ui));
            ui.add_space(8.0);
            ui.horizontal(|ui| {
                if is_idle {
                    if ui.button("Export").clicked() {
                        export.start(editor, ui.ctx());
                    }
                } else {
                    under_way(ui, export.job.as_ref());
                }
            });
            tell(ui, export.outcome.as_ref());
        },
    );
    if is_open {
        editor.dialogs.export = Some(export);
    } else if let Some(job) = &export.job {
        job.progress.cancel();
    }
}

fn controls(export: &mut Export, ui: &mut Ui) {
    let before = export.kind;
    ComboBox::from_label("What").selected_text(export.kind.name()).width(220.0).show_ui(ui, |ui| {
        for kind in Kind::ALL {
            ui.selectable_value(&mut export.kind, kind, kind.name());
        }
    });
    if export.kind != before {
        export.place.end(export.kind.ending());
        export.outcome = None;
    }
    export.place.show(ui);
    if export.kind.is_picture() {
        export.frame.show(ui);
    }
}

/// How far a job is, and a way to end it.
pub(super) fn under_way(ui: &mut Ui, job: Option<&Job<Result<(), String>>>) {
    let Some(job) = job else { return };
    let bar = ProgressBar::new(job.progress.part()).desired_width(280.0).show_percentage();
    ui.add(bar);
    if ui.button("Cancel").clicked() {
        job.progress.cancel();
    }
}

/// What came of a job.
pub(super) fn tell(ui: &mut Ui, outcome: Option<&Result<String, String>>) {
    match outcome {
        Some(Ok(message)) => {
            ui.label(message);
        }
        Some(Err(message)) => {
            ui.colored_label(ui.visuals().error_fg_color, message);
        }
        None => {}
    }
}
