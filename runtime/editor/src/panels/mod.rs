//! The panel at the right: parameters, solids, messages, shader, timings.

pub(crate) mod time;

use egui::Ui;

use crate::app::Editor;
use crate::settings::Panel;

/// What the panels remember.
#[derive(Default)]
pub(crate) struct Panels {}

/// Shows the panel that is chosen.
pub(crate) fn show(editor: &mut Editor, ui: &mut Ui) {
    ui.add_space(2.0);
    ui.horizontal_wrapped(|ui| {
        for panel in Panel::ALL {
            ui.selectable_value(&mut editor.settings.panel, panel, panel.name());
        }
    });
    ui.separator();
}
