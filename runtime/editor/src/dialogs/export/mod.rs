//! Writing what the scene came to: its picture, its text, and what other programs read.

mod kind;

use chiaro_compiler::export::{Language, Target};
use chiaro_exports::{Format, MeshFormat};
use egui::{Align2, Context, DragValue, Grid, ProgressBar, Ui, Window};

use super::overwrite::Overwrite;
use super::place::Place;
use crate::app::Editor;
use crate::darkroom::{Shot, still};
use crate::worker::Job;
use crate::workshop::Piece;
use kind::Kind;

/// The width of the dialogs, in points.
const WIDTH: f32 = 440.0;

/// The most pixels along an edge.
pub(super) const MOST_EDGE: u32 = 8192;

/// The dialog.
pub(crate) struct Export {
    kind: Kind,
    place: Place,
    pub(super) frame: FrameSize,
    job: Option<Job<Result<(), String>>>,
    /// What is to be written over, if the user says so.
    overwrite: Option<Overwrite>,
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

    /// Shows the controls: a label, and what stands behind it.
    pub(super) fn show(&mut self, ui: &mut Ui) {
        let label = ui.label("Size");
        ui.horizontal(|ui| {
            let [width, height] = &mut self.size;
            ui.add(DragValue::new(width).range(1..=MOST_EDGE)).labelled_by(label.id);
            ui.label("×");
            ui.add(DragValue::new(height).range(1..=MOST_EDGE).suffix(" px")).labelled_by(label.id);
            ui.add_space(12.0);
            let label = ui.label("Samples");
            ui.add(DragValue::new(&mut self.samples).range(1..=65_536)).labelled_by(label.id);
        });
    }
}

impl Export {
    /// Ready to write the shader.
    pub(crate) fn of_shader(editor: &Editor, language: Language) -> Self {
        Self::new(editor, Kind::Other(Format::Shader(Target::Library(language))))
    }

    /// Ready to write a mesh.
    pub(crate) fn of_scene(editor: &Editor) -> Self {
        Self::new(editor, Kind::Other(Format::Mesh(MeshFormat::Stl)))
    }

    /// Ready to write the picture.
    pub(crate) fn of_picture(editor: &Editor) -> Self {
        Self::new(editor, Kind::Png)
    }

    fn new(editor: &Editor, kind: Kind) -> Self {
        let scene = editor.session.scene_document();
        let beside = scene.path.clone().unwrap_or_else(|| scene.title().into());
        let place = Place::beside(&beside, kind.ending());
        Self { kind, place, frame: FrameSize::of(editor), job: None, overwrite: None, outcome: None }
    }

    /// Whether a file is being written.
    pub(super) fn is_busy(&self) -> bool {
        self.job.is_some()
    }

    /// Whether an answer is needed before anything else.
    pub(super) fn is_asking(&self) -> bool {
        self.overwrite.is_some()
    }

    /// Begins, after asking if something would be written over.
    fn ask_to_start(&mut self, editor: &Editor, context: &Context) {
        self.outcome = None;
        self.overwrite = Overwrite::if_occupied(&self.place.path());
        if self.overwrite.is_none() {
            self.start(editor, context, false);
        }
    }

    fn answer(&mut self, editor: &Editor, context: &Context) {
        let Some(answer) = self.overwrite.as_ref().and_then(|overwrite| overwrite.ask(context)) else { return };
        self.overwrite = None;
        if answer {
            self.start(editor, context, true);
        }
    }

    fn start(&mut self, editor: &Editor, context: &Context, replaces: bool) {
        match self.job(editor, context, replaces) {
            Some(Ok(job)) => self.job = Some(job),
            Some(Err(error)) => self.outcome = Some(Err(error.to_string())),
            None => self.outcome = Some(Err("there is no scene without errors yet".to_owned())),
        }
    }

    /// None, if there is no scene.
    fn job(&self, editor: &Editor, context: &Context, replaces: bool) -> Option<Started> {
        let (path, adapter) = (self.place.path(), editor.adapter.clone());
        Some(match self.kind {
            Kind::Png | Kind::Exr => {
                let shot = Shot::of(&editor.session, adapter, self.frame.size, self.frame.samples)?;
                Job::start(context, move |progress| still(&shot, &path, progress))
            }
            Kind::Scene => {
                let text = editor.session.scene_document().text.clone();
                let write = move || chiaro_files::write(&path, text.as_bytes());
                Job::start(context, move |_| write().map_err(|error| format!("{error:#}")))
            }
            Kind::Other(format) => {
                let piece = Piece::of(&editor.session, editor.viewport.drawn, adapter)?;
                Job::start(context, move |progress| piece.export(format, &path, replaces, progress))
            }
        })
    }

    fn poll(&mut self) {
        let Some(result) = self.job.as_mut().and_then(Job::poll) else { return };
        let is_cancelled = self.job.take().is_some_and(|job| job.progress.is_cancelled());
        self.outcome = Some(match result.and_then(|result| result) {
            Ok(()) if is_cancelled => Err("cancelled: nothing is written".to_owned()),
            Ok(()) => Ok(format!("{} is written", self.place.path)),
            Err(reason) => Err(reason),
        });
    }
}

/// A job, or why the system has no room for one.
type Started = std::io::Result<Job<Result<(), String>>>;

/// Shows the dialog, if it is open.
pub(super) fn show(editor: &mut Editor, context: &Context) {
    let Some(mut export) = editor.dialogs.export.take() else { return };
    export.poll();
    export.answer(editor, context);
    let mut is_open = true;
    dialog("Export", &mut is_open, context, |ui| {
        let is_idle = export.job.is_none();
        ui.add_enabled_ui(is_idle, |ui| controls(&mut export, ui));
        ui.add_space(8.0);
        ui.horizontal(|ui| {
            if is_idle {
                if ui.button("Export").clicked() {
                    export.ask_to_start(editor, ui.ctx());
                }
            } else {
                under_way(ui, export.job.as_ref());
            }
        });
        tell(ui, export.outcome.as_ref());
    });
    if is_open {
        editor.dialogs.export = Some(export);
    } else if let Some(job) = &export.job {
        job.progress.cancel();
    }
}

/// A window in the middle that can be moved and closed.
pub(super) fn dialog(title: &str, is_open: &mut bool, context: &Context, contents: impl FnOnce(&mut Ui)) {
    let window = Window::new(title).open(is_open).collapsible(false).resizable(false);
    let middle = context.content_rect().center();
    window.pivot(Align2::CENTER_CENTER).default_pos(middle).show(context, |ui| {
        ui.set_width(WIDTH);
        contents(ui);
    });
}

fn controls(export: &mut Export, ui: &mut Ui) {
    let before = export.kind;
    Grid::new("export").num_columns(2).spacing([12.0, 6.0]).show(ui, |ui| {
        ui.label("Format");
        export.kind.choose(ui);
        ui.end_row();
        export.place.show(ui);
        ui.end_row();
        if export.kind.is_picture() {
            export.frame.show(ui);
            ui.end_row();
        }
    });
    if export.kind != before {
        export.place.end(export.kind.ending());
        export.outcome = None;
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
