//! The line at the bottom: how the text and the picture stand, and how long each stage took.

use std::time::Duration;

use egui::{Label, RichText, Ui};

use crate::app::Editor;
use crate::gallery;

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
        quiet(
            ui,
            format!(
                "compile {} · pipelines {} · first sample {} · key to frame {}",
                milliseconds(timings.compile),
                milliseconds(timings.pipelines),
                milliseconds(timings.first_sample),
                milliseconds(timings.to_frame)
            ),
        );
        ui.separator();
        quiet(ui, format!("sample {} in {}", editor.viewport.samples(), milliseconds(timings.sample)));
        ui.separator();
        quiet(ui, editor.session.device.clone());
    });
}

/// What is there to be looked up. It gives way to the rest where there is little room, and is shown in full when the pointer
/// rests on it.
fn quiet(ui: &mut Ui, text: String) {
    ui.add(Label::new(RichText::new(text).weak()).truncate());
}

/// What is wrong: as much of it as there is room for.
fn loud(ui: &mut Ui, text: &str) {
    let color = ui.visuals().error_fg_color;
    ui.add(Label::new(RichText::new(text).color(color)).truncate());
}

/// What the user asked for and could not be done, until they have seen it.
fn failure(editor: &mut Editor, ui: &mut Ui) {
    let Some(failure) = &editor.session.failure else { return };
    let is_seen = ui.small_button("OK").clicked();
    loud(ui, failure);
    if is_seen {
        editor.session.failure = None;
    }
    ui.separator();
}

fn state(editor: &Editor, ui: &mut Ui) {
    let session = &editor.session;
    if let Some(trouble) = &session.trouble {
        loud(ui, trouble);
    } else if session.is_compiled() && session.has_errors() {
        let picture =
            if editor.viewport.drawn().is_some() { ": the picture is of the last text without any" } else { "" };
        loud(ui, &format!("errors{picture}"));
    } else {
        ui.label(under_way(editor, ui).unwrap_or_else(|| "ready".to_owned()));
    }
}

/// What is being waited for, if anything is.
pub(crate) fn under_way(editor: &Editor, ui: &Ui) -> Option<String> {
    let session = &editor.session;
    let what = match (session.is_compiled(), session.is_outdated()) {
        (false, _) => "compiling",
        (true, true) => "preparing the picture",
        (true, false) => return None,
    };
    Some(waiting(what, session.waits_since(), ui))
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
