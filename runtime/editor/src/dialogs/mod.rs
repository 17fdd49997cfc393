//! What is asked in windows of its own.

use egui::Ui;

use crate::app::Editor;

/// Which dialogs are open.
#[derive(Default)]
pub(crate) struct Dialogs {}

/// Shows the dialogs that are open.
pub(crate) fn show(_: &mut Editor, _: &mut Ui) {}
