//! The line at the bottom: how the text and the picture stand, and how long each stage took.

use std::time::Duration;

use egui::{Color32, Ui};

use crate::app::Editor;
use crate::gallery;

/// What is wrong.
const RED: Color32 = Color32::from_rgb(220, 80, 60);
/// After so long, the line says for how long the picture is being waited for.
const LONG: Duration = Duration::from_secs(1);

/// Shows the line.
pub(crate) fn show(editor: &mut Editor, ui: &mut Ui) {
    ui.horizontal(|ui| {
        failure(editor, ui);
        if gallery::is_wanted(editor) {
            ui.weak("no scene yet");
            return;
        }
        state(editor, ui);
        let timings = &editor.viewport.timings;
        ui.separator();
        ui.label(format!(
            "compile {} · pipelines {} · first sample {} · key to frame {}",
            milliseconds(timings.compile),
            milliseconds(timings.pipelines),
            milliseconds(timings.first_sample),
            milliseconds(timings.to_frame)
        ));
        ui.separator();
        ui.label(format!("sample {} in {}", editor.viewport.samples, milliseconds(timings.sample)));
        ui.separator();
        ui.weak(&editor.session.device);
    });
}

/// What the user asked for and could not be done, until they have seen it.
fn failure(editor: &mut Editor, ui: &mut Ui) {
    let Some(failure) = &editor.session.failure else { return };
    ui.colored_label(RED, failure);
    if ui.small_button("OK").clicked() {
        editor.session.failure = None;
    }
    ui.separator();
}

fn state(editor: &Editor, ui: &mut Ui) {
    let session = &editor.session;
    if let Some(trouble) = &session.trouble {
        ui.colored_label(RED, trouble);
    } else if !session.is_compiled() {
        ui.label(waiting("compiling", session.waits_since(), ui));
    } else if session.has_errors() {
        let picture = if session.shown.is_some() { ": the picture is of the last text without any" } else { "" };
        ui.colored_label(RED, format!("errors{picture}"));
    } else if session.is_outdated() {
        ui.label(waiting("preparing the picture", session.waits_since(), ui));
    } else {
        ui.label("ready");
    }
}

/// What is under way, and for how long already if that is long.
fn waiting(what: &str, since: Option<Duration>, ui: &Ui) -> String {
    ui.ctx().request_repaint_after(LONG);
    match since.filter(|since| *since >= LONG) {
        Some(since) => format!("{what}, {} s so far", since.as_secs()),
        None => format!("{what}…"),
    }
}

/// A time as people read it.
pub(crate) fn milliseconds(time: Duration) -> String {
    let milliseconds = time.as_secs_f64() * 1e3;
    match milliseconds {
        ..10.0 => format!("{milliseconds:.1} ms"),
        ..10_000.0 => format!("{milliseconds:.0} ms"),
        _ => format!("{:.1} s", milliseconds / 1e3),
    }
}
