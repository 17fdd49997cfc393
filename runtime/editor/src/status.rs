//! The line at the bottom: how the text and the picture stand, and how long each stage took.

use std::time::Duration;

use egui::{Color32, Ui};

use crate::app::Editor;

/// Shows the line.
pub(crate) fn show(editor: &mut Editor, ui: &mut Ui) {
    ui.horizontal(|ui| {
        let session = &editor.session;
        if let Some(trouble) = &session.trouble {
            ui.colored_label(Color32::from_rgb(220, 80, 60), trouble);
        } else if !session.is_compiled() {
            ui.label("compiling…");
        } else if session.has_errors() {
            let picture = if session.shown.is_some() { ": the picture is of the last text without any" } else { "" };
            ui.colored_label(Color32::from_rgb(220, 80, 60), format!("errors{picture}"));
        } else if session.is_outdated() {
            ui.label("drawing…");
        } else {
            ui.label("ready");
        }
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
        ui.weak(&session.device);
    });
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
