//! The text panel.

use egui::{ScrollArea, TextEdit, Ui};

use crate::app::Editor;

/// What the panel remembers.
#[derive(Default)]
pub(crate) struct TextPanel {}

/// Shows the open texts.
pub(crate) fn show(editor: &mut Editor, ui: &mut Ui) {
    let before = editor.session.active().text.clone();
    ScrollArea::both().auto_shrink(false).show(ui, |ui| {
        let document = editor.session.active_mut();
        let edit = TextEdit::multiline(&mut document.text).code_editor().desired_width(f32::INFINITY);
        ui.add_sized(ui.available_size(), edit);
    });
    if editor.session.active().text != before {
        let caret = editor.session.active().caret;
        editor.session.active_mut().note_edit(&before, caret);
        editor.session.text_changed();
    }
}

impl Editor {
    /// Selects a part of the text that is being edited, and scrolls there.
    pub(crate) fn reveal(&mut self, range: std::ops::Range<usize>) {
        self.session.active_mut().select(range.start, range.end);
    }
}
