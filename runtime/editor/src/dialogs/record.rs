//! Recording a film of `$t`.

use egui::{ComboBox, Context, DragValue, Grid, Ui};

use super::export::{FrameSize, dialog, tell, under_way};
use super::overwrite::Overwrite;
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
    /// What is to be written over, if the user says so.
    overwrite: Option<Overwrite>,
    outcome: Option<Result<String, String>>,
}

impl Record {
    /// A round of the clock at 25 frames a second.
    pub(crate) fn new(editor: &Editor) -> Self {
        let frames = (25.0 * editor.clock.period).round().clamp(1.0, 1000.0) as u32;
        let film = Film { frames, range: [0.0, 1.0], frames_per_second: 25, format: FilmFormat::Animation };
        let scene = editor.session.scene_document();
        let place = Place::beside(&scene.path.clone().unwrap_or_else(|| scene.title().into()), Some("png"));
        let frame = FrameSize { samples: SAMPLES, ..FrameSize::of(editor) };
        Self { film, place, frame, job: None, overwrite: None, outcome: None }
    }

    /// Whether a film is being written.
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
        self.overwrite = Overwrite::if_occupied(&self.film.first_file(&self.place.path()));
        if self.overwrite.is_none() {
            self.start(editor, context);
        }
    }

    fn answer(&mut self, editor: &Editor, context: &Context) {
        let Some(answer) = self.overwrite.as_ref().and_then(|overwrite| overwrite.ask(context)) else { return };
        self.overwrite = None;
        if answer {
            self.start(editor, context);
        }
    }

    fn start(&mut self, editor: &Editor, context: &Context) {
        let (settings, path) = (self.film, self.place.path());
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
    record.answer(editor, context);
    let mut is_open = true;
    dialog("Record", &mut is_open, context, |ui| {
        let is_idle = record.job.is_none();
        ui.add_enabled_ui(is_idle, |ui| controls(&mut record, ui));
        ui.add_space(8.0);
        ui.horizontal(|ui| {
            if is_idle {
                if ui.button("Record").clicked() {
                    record.ask_to_start(editor, ui.ctx());
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
    Grid::new("record").num_columns(2).spacing([12.0, 6.0]).show(ui, |ui| {
        let film = &mut record.film;
        ui.label("Format");
        let combo = ComboBox::from_id_salt("format").selected_text(name(film.format)).width(ui.available_width());
        combo.show_ui(ui, |ui| {
            for format in [FilmFormat::Animation, FilmFormat::Sequence] {
                ui.selectable_value(&mut film.format, format, name(format));
            }
        });
        ui.end_row();
        record.place.show(ui);
        ui.end_row();
        record.frame.show(ui);
        ui.end_row();
        let label = ui.label("Frames");
        ui.horizontal(|ui| {
            ui.add(DragValue::new(&mut film.frames).range(1..=MOST_FRAMES)).labelled_by(label.id);
            ui.label("at");
            ui.add(DragValue::new(&mut film.frames_per_second).range(1..=120).suffix(" a second"));
        });
        ui.end_row();
        let label = ui.label("$t from");
        ui.horizontal(|ui| {
            let time = |time| DragValue::new(time).range(0.0..=1.0).speed(0.01).max_decimals(3);
            let [from, to] = &mut film.range;
            ui.add(time(from)).labelled_by(label.id);
            ui.label("to");
            ui.add(time(to));
        });
        ui.end_row();
    });
}
