//! Play, pause and scrub the time `$t`.

use egui::{Align, Button, DragValue, Layout, Slider, Ui};

use crate::app::Editor;
use crate::command::Command;
use crate::darkroom::CLOCK;
use crate::studio::LiveValue;

/// The width of the time as a number, in points.
const NUMBER: f32 = 64.0;

/// Whether the scene moves, as far as its text tells.
pub(crate) fn is_wanted(editor: &Editor) -> bool {
    is_live(editor) || editor.session.scene_document().text.contains(CLOCK)
}

/// Shows the controls.
pub(crate) fn show(editor: &mut Editor, ui: &mut Ui) {
    ui.horizontal(|ui| {
        let name = if editor.clock.is_running() { "Pause" } else { "Play" };
        if ui.add(Button::new(name).min_size(egui::vec2(56.0, 0.0))).clicked() {
            editor.clock.toggle();
        }
        // From the right, so that the slider gets what is left.
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if ui.button("Record…").clicked() {
                Command::Record.run(editor, ui.ctx());
            }
            let period = DragValue::new(&mut editor.clock.period).range(0.1..=600.0).speed(0.1).suffix(" s");
            ui.add(period).on_hover_text("How long $t takes from 0 to 1");
            slider(editor, ui);
        });
    });
}

fn slider(editor: &mut Editor, ui: &mut Ui) {
    let mut time = editor.clock.time;
    ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
        let label = ui.label(CLOCK);
        ui.spacing_mut().slider_width = (ui.available_width() - NUMBER).max(60.0);
        if ui.add(Slider::new(&mut time, 0.0..=1.0).fixed_decimals(3)).labelled_by(label.id).changed() {
            editor.clock.set(time);
            show_time(editor);
        }
    });
}

fn is_live(editor: &Editor) -> bool {
    let shown = editor.session.shown.as_ref();
    shown.is_some_and(|shown| shown.scene.parameters.iter().any(|parameter| &*parameter.name == CLOCK))
}

/// Moves the scene to the clock's time: as a live number, or by compiling it for that time where `$t` decides its structure.
pub(crate) fn show_time(editor: &mut Editor) {
    let (time, is_live) = (editor.clock.time, is_live(editor));
    let session = &mut editor.session;
    session.values.retain(|value| value.name != CLOCK);
    if is_live {
        session.values.push(LiveValue { name: CLOCK.to_owned(), component: None, value: time });
        session.show();
    } else if session.scene_document().text.contains(CLOCK) && !session.is_outdated() {
        session.definitions.insert(CLOCK.to_owned(), time.to_string());
        session.compile(None);
    }
}
