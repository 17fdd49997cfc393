//! What a crash left is offered.

use egui::{Context, Id, Modal};

use crate::app::Editor;
use crate::document::UNTITLED;
use crate::recovery::{Found, Kept};

/// Asks what to do with it.
pub(super) fn show(editor: &mut Editor, context: &Context) {
    let Some(found) = &editor.dialogs.recovered else { return };
    let names: Vec<String> = found.texts.iter().map(name).collect();
    let (mut restore, mut discard) = (false, false);
    let modal = Modal::new(Id::unique("recovered")).show(context, |ui| {
        ui.set_width(380.0);
        ui.heading("Unsaved work was found");
        ui.add_space(4.0);
        ui.label("The editor was not closed in order. These texts had changes that were not saved:");
        for name in &names {
            ui.monospace(name);
        }
        ui.add_space(12.0);
        ui.horizontal(|ui| {
            restore = ui.button("Restore").clicked();
            discard = ui.button("Discard").clicked();
            ui.weak("Esc: ask again next time");
        });
    });
    if !(restore || discard || modal.should_close()) {
        return;
    }
    let Some(found) = editor.dialogs.recovered.take() else { return };
    if restore {
        open(editor, found);
    } else if discard {
        editor.recovery.discard(&found);
    }
}

fn name(kept: &Kept) -> String {
    match &kept.path {
        Some(path) => path.display().to_string(),
        None => kept.text.lines().next().unwrap_or_default().chars().take(60).collect(),
    }
}

/// Opens the texts as they were, with their changes.
fn open(editor: &mut Editor, found: Found) {
    for kept in &found.texts {
        let is_open = kept.path.as_ref().is_some_and(|path| editor.session.open(path).is_ok());
        if !is_open {
            editor.session.open_text(UNTITLED, String::new());
            editor.gallery.is_left = true;
        }
        editor.session.active_mut().replace(kept.text.clone(), 0, false);
    }
    editor.session.text_changed();
    editor.recovery.take_over(found);
}
