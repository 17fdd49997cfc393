//! The menu bar and the keyboard's short cuts.

use egui::Ui;

use crate::app::Editor;

/// Shows the bar.
pub(crate) fn show(editor: &mut Editor, ui: &mut Ui) {
    egui::MenuBar::new().ui(ui, |ui| {
        ui.menu_button("View", |ui| {
            if ui.button("Frame all").clicked() {
                editor.viewport.frame_all();
            }
        });
    });
}

/// Does what the keys ask for.
pub(crate) fn shortcuts(_: &mut Editor, _: &Ui) {}
