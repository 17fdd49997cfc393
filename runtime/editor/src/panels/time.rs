//! Play, pause and scrub the time `$t`.

use egui::{Slider, Ui};

use crate::app::Editor;
use crate::studio::LiveValue;

/// The name of OpenSCAD's clock.
const CLOCK: &str = "$t";

/// Shows the controls.
pub(crate) fn show(editor: &mut Editor, ui: &mut Ui) {
    ui.horizontal(|ui| {
        if ui.button(if editor.clock.is_running() { "⏸" } else { "▶" }).on_hover_text("Play or pause $t").clicked()
        {
            editor.clock.toggle();
        }
        let mut time = editor.clock.time;
        if ui.add(Slider::new(&mut time, 0.0..=1.0).text("$t")).changed() {
            editor.clock.set(time);
            show_time(editor);
        }
    });
}

/// Moves the scene to the clock's time: as a live number, or by compiling it for that time where `$t` decides its structure.
pub(crate) fn show_time(editor: &mut Editor) {
    let time = editor.clock.time;
    let session = &mut editor.session;
    let is_live = session.shown.as_ref().is_some_and(|shown| shown.scene.parameters.iter().any(|p| &*p.name == CLOCK));
    session.values.retain(|value| value.name != CLOCK);
    if is_live {
        session.values.push(LiveValue { name: CLOCK.to_owned(), component: None, value: time });
        session.show();
    } else if session.scene_document().text.contains(CLOCK) && !session.is_outdated() {
        session.definitions.insert(CLOCK.to_owned(), time.to_string());
        session.compile(None);
    }
}
