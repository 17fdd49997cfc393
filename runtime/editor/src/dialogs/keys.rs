//! The keys, in a window.

use egui::{Align2, Context, Grid, Id, ScrollArea, Ui, Window};

use crate::app::Editor;
use crate::command::Command;

/// The columns of the list.
const COLUMNS: usize = 2;

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

/// Lists them, in columns beside each other.
pub(super) fn show(editor: &mut Editor, context: &Context) {
    let by_key = |command: &Command| {
        let keys = context.format_shortcut(&command.shortcut()?);
        Some((command.name().trim_end_matches('…'), keys))
    };
    let by_mouse = MOUSE.iter().map(|(gesture, what)| (*what, (*gesture).to_owned()));
    let rows: Vec<(&str, String)> = Command::ALL.iter().filter_map(by_key).chain(by_mouse).collect();
    let window = Window::new("Keys")
        .id(Id::unique("keys"))
        .open(&mut editor.dialogs.shows_keys)
        .resizable(false)
        .collapsible(false);
    let middle = context.content_rect().center();
    window.pivot(Align2::CENTER_CENTER).default_pos(middle).show(context, |ui| {
        ScrollArea::vertical().show(ui, |ui| {
            ui.horizontal_top(|ui| {
                ui.spacing_mut().item_spacing.x = 32.0;
                for (index, column) in rows.chunks(rows.len().div_ceil(COLUMNS)).enumerate() {
                    grid(ui, index, column);
                }
            });
        });
    });
}

fn grid(ui: &mut Ui, index: usize, rows: &[(&str, String)]) {
    Grid::new(("keys", index)).num_columns(2).spacing([16.0, 4.0]).striped(true).show(ui, |ui| {
        for (what, keys) in rows {
            ui.label(*what);
            ui.monospace(keys);
            ui.end_row();
        }
    });
}
