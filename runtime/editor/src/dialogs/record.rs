//! Recording a film of `$t`.

use std::path::PathBuf;

use egui::{ComboBox, DragValue, Grid, Ui};

use super::frame_size::FrameSize;
use super::place::Place;
use super::writing::{Form, Work};
use crate::app::Editor;
use crate::darkroom::{Film, FilmFormat, Shot, film};

/// The most frames of a film.
const MOST_FRAMES: u32 = 100_000;
/// The samples of a pixel of a film at first.
const SAMPLES: u32 = 16;
/// The frames of a second of a film at first.
const RATE: u16 = 25;

/// What to record, and where to.
pub(crate) struct Record {
    film: Film,
    place: Place,
    frame: FrameSize,
}

impl Record {
    /// A round of the clock.
    pub(crate) fn new(editor: &Editor) -> Self {
        let frames = (f64::from(RATE) * editor.clock.period).round().clamp(1.0, 1000.0) as u32;
        let film = Film { frames, range: [0.0, 1.0], frames_per_second: RATE, format: FilmFormat::Animation };
        let place = Place::beside_scene(editor, Some("png"));
        Self { film, place, frame: FrameSize { samples: SAMPLES, ..FrameSize::of(editor) } }
    }
}

impl Form for Record {
    fn title(&self) -> &'static str {
        "Record"
    }

    fn follow(&mut self, editor: &Editor) -> bool {
        self.place.follow(editor)
    }

    fn controls(&mut self, ui: &mut Ui) -> bool {
        let before = self.film;
        Grid::new("record").num_columns(2).spacing([12.0, 6.0]).show(ui, |ui| {
            self.place.show_scene(ui);
            ui.end_row();
            ui.label("Format");
            format(ui, &mut self.film.format);
            ui.end_row();
            self.place.show(ui);
            ui.end_row();
            self.frame.show(ui);
            ui.end_row();
            length(ui, &mut self.film);
            ui.end_row();
            range(ui, &mut self.film.range);
            ui.end_row();
        });
        self.film != before
    }

    fn occupied(&self) -> Option<PathBuf> {
        self.film.occupied(&self.place.path())
    }

    fn work(&self, editor: &Editor, _: bool) -> Option<Work> {
        let shot = Shot::of(&editor.session, editor.adapter.clone(), self.frame.size, self.frame.samples)?;
        let (settings, path) = (self.film, self.place.path());
        Some(Box::new(move |progress| film(&shot, settings, &path, progress)))
    }

    fn done(&self) -> String {
        match self.film.format {
            FilmFormat::Animation => format!("{} is written", self.place.path),
            FilmFormat::Sequence => format!("{} frames are written", self.film.frames),
        }
    }
}

fn format(ui: &mut Ui, format: &mut FilmFormat) {
    let name = |format: FilmFormat| match format {
        FilmFormat::Animation => "One animated PNG",
        FilmFormat::Sequence => "A PNG for each frame",
    };
    let combo = ComboBox::from_id_salt("format").selected_text(name(*format)).width(ui.available_width());
    let response = combo.show_ui(ui, |ui| {
        for choice in [FilmFormat::Animation, FilmFormat::Sequence] {
            ui.selectable_value(format, choice, name(choice));
        }
    });
    ui.ctx().accesskit_node_builder(response.response.id, |node| node.set_label("Format"));
}

/// How many frames, and how fast.
fn length(ui: &mut Ui, film: &mut Film) {
    let label = ui.label("Frames");
    ui.horizontal(|ui| {
        ui.add(DragValue::new(&mut film.frames).range(1..=MOST_FRAMES)).labelled_by(label.id);
        ui.label("at");
        ui.add(DragValue::new(&mut film.frames_per_second).range(1..=120).suffix(" a second"));
    });
}

/// From which time to which.
fn range(ui: &mut Ui, [from, to]: &mut [f64; 2]) {
    let label = ui.label("$t from");
    let time = |time| DragValue::new(time).range(0.0..=1.0).speed(0.01).max_decimals(3);
    ui.horizontal(|ui| {
        ui.add(time(from)).labelled_by(label.id);
        ui.label("to");
        ui.add(time(to));
    });
}
