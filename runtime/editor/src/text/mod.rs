//! The text panel: the open texts in tabs, and the one that is being written.

mod around;
mod colors;
mod commands;
mod completion;
mod edits;
mod find;
mod fixes;
mod gutter;
mod hover;
mod keys;
mod layout;
mod manual;
mod marks;
mod messages;
mod navigate;
mod numbers;
mod page;
mod popup;
mod signature;
mod tabs;
mod typing;

use std::ops::Range;

use egui::Ui;

use crate::app::Editor;
use crate::document::DocumentId;

pub(crate) use commands::Command;

/// What the panel remembers.
#[derive(Default)]
pub(crate) struct TextPanel {
    layout: layout::Layout,
    messages: messages::Messages,
    around: around::Around,
    /// Completions or quick fixes to choose from.
    list: Option<popup::List>,
    written_along: Option<completion::WrittenAlong>,
    hover: hover::Hovering,
    find: Option<find::Find>,
    /// The line to go to, as it is being typed.
    line: Option<String>,
    /// Where one went away from, the newest last.
    visited: Vec<navigate::Visited>,
    /// A number that is being changed, by the pointer in the text or by its hover's button.
    drag: Option<numbers::Drag>,
    /// What was asked for from elsewhere, and when in the window's time.
    flash: Option<(Range<usize>, f64)>,
    /// The text whose tab was scrolled into sight.
    shown_tab: Option<DocumentId>,
    /// The selection that the page knows.
    known: Option<(DocumentId, [usize; 2])>,
    /// Keys that wait for the text field.
    aside: Vec<egui::Event>,
    /// The caret has to be scrolled to.
    shows_caret: bool,
    pub(crate) wants_focus: bool,
}

impl TextPanel {
    /// Whether something that was typed has yet to be written into the text.
    pub(crate) fn is_behind(&self) -> bool {
        !self.aside.is_empty()
    }

    /// Whether nothing is offered.
    pub(crate) fn is_quiet(&self) -> bool {
        self.list.is_none()
    }
}

/// Shows the open texts.
pub(crate) fn show(editor: &mut Editor, ui: &mut Ui) {
    ui.spacing_mut().item_spacing.y = 2.0;
    // Before any field sees them: some keys that mean something to us remove a letter there.
    let was_typed = page::take_keys(editor, ui);
    tabs::show(editor, ui);
    conflict(editor, ui);
    find::show(editor, ui);
    navigate::show(editor, ui);
    page::show(editor, ui, was_typed);
}

/// Asks which text counts, if a file changed while its text had changes of its own.
fn conflict(editor: &mut Editor, ui: &mut Ui) {
    let document = editor.session.active_mut();
    if document.conflict.is_none() {
        return;
    }
    let mut answer = None;
    ui.horizontal_wrapped(|ui| {
        ui.label(format!("{} was changed by another program.", document.title()));
        if ui.button("Take that").on_hover_text("Your changes can be had back by undoing").clicked() {
            answer = Some(true);
        }
        if ui.button("Keep mine").on_hover_text("Saving writes over the other changes").clicked() {
            answer = Some(false);
        }
    });
    if let Some(take_disk) = answer {
        document.resolve(take_disk);
        editor.session.text_changed();
    }
}

impl Editor {
    /// Selects a part of the text that is being edited, and scrolls there.
    pub(crate) fn reveal(&mut self, range: Range<usize>) {
        self.session.active_mut().select(range.end, range.start);
        self.text.flash = Some((range, f64::INFINITY));
        self.text.shows_caret = true;
    }
}

#[cfg(test)]
impl TextPanel {
    /// Where a byte is on the page.
    pub(crate) fn place(&self, byte: usize) -> egui::Pos2 {
        self.layout.caret(byte).center()
    }
}
