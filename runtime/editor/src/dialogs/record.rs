//! Recording a film of `$t`.

use egui::{ComboBox, Context, DragValue, Ui, Window};

use super::export::{FrameSize, tell, under_way};
use super::place::Place;
use crate::app::Editor;
use crate::darkroom::{Film, FilmFormat, Shot, film};
use crate::worker::Job;

/// The most frames of a film.
const MOST_FRAMES: u32 = 100_000;
/// The samples of a pixel of a film at first.
const SAMPLES: u32 = 16;

/// The dialog.
pub(crate) struct Record {
    film: Film,
    place: Place,
    frame: FrameSize,
    job: Option<Job<Result<(), String>>>,
    outcome: Option<Result<String, String>>,
}

impl Record {
    /// A round of the clock at 25 frames a second.
    pub(crate) fn new(editor: &Editor) -> Self {
        let frames = (25.0 * editor.clock.period).round().clamp(1.0, 1000.0) as u32;
        let film = Film { frames, range: [0.0, 1.0], frames_per_second: 25, format: FilmFormat::Animation };
        let place = Place::beside(editor.session.scene_document().path.as_deref(), "png");
        let frame = FrameSize { samples: SAMPLES, ..FrameSize::of(editor) };
        Self { film, place, frame, job: None, outcome: None }
    }

    fn start(&mut self, editor: &Editor, context: &Context) {
        let (settings, path) = (self.film, self.place.path());
        self.outcome = None;
        let shot = Shot::of(&editor.session, editor.adapter.clone(), self.frame.size, self.frame.samples);
        let job = shot.map(|shot| Job::start(context, move |progress| film(&shot, settings, &path, progress)));
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
            Ok(()) if is_cancelled => Err("cancelled; nothing is left of it".to_owned()),
            Ok(()) => Ok(format!("{} frames are written", self.film.frames)),
            Err(reason) => Err(reason),
        });
    }
}

/// Shows the dialog, if it is open.
pub(super) fn show(editor: &mut Editor, context: &Context) {
    let Some(mut record) = editor.dialogs.record.take() else { return };
    record.poll();
    let mut is_open = true;
    Window::new("Record").open(&mut is_open).collapsible(false).resizable(false).show(context, |ui| {
        ui.set_width(420.0);
        let is_idle = record.job.is_none();
        ui.add_enabled_ui(is_idle, |ui| controls(&mut record, ui));
        ui.add_space(8.0);
        ui.horizontal(|ui| {
            if is_idle {
                if ui.button("Record").clicked() {
                    record.start(editor, ui.ctx());
                }
            } else {
                under_way(ui, record.job.as_ref());
            }
        });
        tell(ui, record.outcome.as_ref());
    });
    if is_open {
        editor.dialogs.record = Some(record);
    } else if let Some(job) = &record.job {
        job.progress.cancel();
    }
}

fn controls(record: &mut Record, ui: &mut Ui) {
    let name = |format: FilmFormat| match format {
        FilmFormat::Animation => "One animated PNG",
        FilmFormat::Sequence => "A PNG for each frame",
    };
    let film = &mut record.film;
    ComboBox::from_label("Format").selected_text(name(film.format)).width(180.0).show_ui(ui, |ui| {
        for format in [FilmFormat::Animation, FilmFormat::Sequence] {
            ui.selectable_value(&mut film.format, format, name(format));
        }
    });
    record.place.show(ui);
    record.frame.show(ui);
    ui.horizontal(|ui| {
        let label = ui.label("Frames");
        ui.add(DragValue::new(&mut film.frames).range(1..=MOST_FRAMES)).labelled_by(label.id);
        let label = ui.label("a second");
        ui.add(DragValue::new(&mut film.frames_per_second).range(1..=120)).labelled_by(label.id);
    });
    ui.horizontal(|ui| {
        for (name, time) in ["$t from", "to"].into_iter().zip(&mut film.range) {
            let label = ui.label(name);
            ui.add(DragValue::new(time).range(0.0..=1.0).speed(0.01).max_decimals(3)).labelled_by(label.id);
        }
    });
}
