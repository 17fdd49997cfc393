//! The panel at the right: parameters, solids, messages, shader, timings.

pub(crate) mod time;

use egui::Ui;

use crate::app::Editor;

/// What the panels remember.
#[derive(Default)]
pub(crate) struct Panels {}

/// Shows the panel that is chosen.
pub(crate) fn show(editor: &mut Editor, ui: &mut Ui) {
    time::show(editor, ui);
}
