//! The keys, in a window.

use egui::{Context, Grid, Window};

use crate::app::Editor;
use crate::command::Command;

/// What the mouse does over the picture and in the text.
const MOUSE: [(&str, &str); 7] = [
    ("Drag in the picture", "Orbit"),
    ("Shift or right drag", "Pan"),
    ("Wheel", "Zoom"),
    ("Click a surface", "Go to the expression that made it"),
    ("Drag a handle", "Change the numbers behind it"),
    ("Ctrl drag on a number", "Change it in the text"),
    ("Ctrl click on a name", "Go to its definition"),
];

/// Lists them.
pub(super) fn show(editor: &mut Editor, context: &Context) {
    Window::new("Keys").open(&mut editor.dialogs.shows_keys).resizable(false).collapsible(false).show(context, |ui| {
        Grid::new("keys").num_columns(2).spacing([24.0, 4.0]).striped(true).show(ui, |ui| {
            for command in Command::ALL {
                let Some(shortcut) = command.shortcut() else { continue };
                ui.label(command.name().trim_end_matches('…'));
                ui.monospace(ui.ctx().format_shortcut(&shortcut));
                ui.end_row();
            }
            for (gesture, what) in MOUSE {
                ui.label(what);
                ui.monospace(gesture);
                ui.end_row();
            }
        });
    });
}
