//! What one can ask of the text panel.

use std::sync::Arc;

use super::edits::{Change, Selected};
use super::{completion, find, fixes, navigate};
use crate::app::Editor;
use crate::studio::BufferWorld;

/// A thing to do with the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Command {
    Undo,
    Redo,
    Find,
    Replace,
    FindNext,
    FindPrevious,
    GoToLine,
    Definition,
    Back,
    Format,
    ToggleComment,
    Indent,
    Unindent,
    NewLine,
    Backspace,
    Duplicate,
    DeleteLines,
    MoveUp,
    MoveDown,
    Complete,
    QuickFix,
    NextTab,
    PreviousTab,
}

impl Command {
    /// As the menus name it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Command::Undo => "Undo",
            Command::Redo => "Redo",
            Command::Find => "Find…",
            Command::Replace => "Replace…",
            Command::FindNext => "Find next",
            Command::FindPrevious => "Find previous",
            Command::GoToLine => "Go to line…",
            Command::Definition => "Go to definition",
            Command::Back => "Go back",
            Command::Format => "Format",
            Command::ToggleComment => "Toggle comment",
            Command::Indent => "Indent",
            Command::Unindent => "Unindent",
            Command::NewLine => "New line",
            Command::Backspace => "Remove the letter before",
            Command::Duplicate => "Duplicate lines",
            Command::DeleteLines => "Delete lines",
            Command::MoveUp => "Move lines up",
            Command::MoveDown => "Move lines down",
            Command::Complete => "Complete",
            Command::QuickFix => "Quick fix",
            Command::NextTab => "Next tab",
            Command::PreviousTab => "Previous tab",
        }
    }

    /// The key for it.
    pub(crate) fn shortcut(self) -> Option<egui::KeyboardShortcut> {
        super::keys::shortcut(self)
    }
}

impl Editor {
    /// Does something with the text that is open.
    pub(crate) fn text_command(&mut self, command: Command) {
        match command {
            Command::Undo => self.restore(true),
            Command::Redo => self.restore(false),
            Command::Find => find::open(self, false),
            Command::Replace => find::open(self, true),
            Command::FindNext => find::go(self, true),
            Command::FindPrevious => find::go(self, false),
            Command::GoToLine => navigate::ask_for_line(self),
            Command::Definition => navigate::to_definition(self, self.session.active().caret),
            Command::Back => navigate::back(self),
            Command::Format => self.format_text(),
            Command::Complete => completion::ask(self),
            Command::QuickFix => fixes::ask(self),
            Command::NextTab => self.next_tab(1),
            Command::PreviousTab => self.next_tab(self.session.documents().len() - 1),
            edit => self.edit_lines(edit),
        }
    }

    fn edit_lines(&mut self, command: Command) {
        let selected = self.selected();
        let change = match command {
            Command::ToggleComment => selected.toggle_comment(),
            Command::Indent => Some(selected.indent()),
            Command::Unindent => selected.unindent(),
            Command::NewLine => Some(selected.new_line()),
            Command::Backspace => Some(selected.backspace()),
            Command::Duplicate => Some(selected.duplicate()),
            Command::DeleteLines => Some(selected.delete_lines()),
            Command::MoveUp => selected.move_up(),
            Command::MoveDown => selected.move_down(),
            _ => None,
        };
        if let Some(change) = change {
            self.change(&change);
        }
    }

    /// The text that is open, and what is selected.
    pub(super) fn selected(&self) -> Selected<'_> {
        let document = self.session.active();
        Selected { text: &document.text, anchor: document.anchor, caret: document.caret }
    }

    /// Changes the text, so that it can be undone.
    pub(super) fn change(&mut self, change: &Change) {
        let document = self.session.active_mut();
        if !change.edits.is_empty() {
            document.replace(change.applied(&document.text), change.caret, false);
        }
        document.select(change.anchor, change.caret);
        self.text.shows_caret = true;
        if !change.edits.is_empty() {
            self.session.text_changed();
        }
    }

    fn restore(&mut self, is_undo: bool) {
        let document = self.session.active_mut();
        if if is_undo { document.undo() } else { document.redo() } {
            self.text.shows_caret = true;
            self.session.text_changed();
        }
    }

    /// Writes the text as it is written well. The caret stays at its word.
    fn format_text(&mut self) {
        let document = self.session.active_mut();
        let text = chiaro_assist::format(&document.text);
        if text == document.text {
            return;
        }
        let caret = same_letter(&document.text, document.caret, &text);
        document.history.pause();
        document.replace(text, caret, false);
        document.history.pause();
        self.text.shows_caret = true;
        self.session.text_changed();
    }

    fn next_tab(&mut self, steps: usize) {
        let count = self.session.documents().len();
        self.session.activate((self.session.active_index() + steps) % count);
        self.text.wants_focus = true;
    }

    /// The files as the compiler sees them, the texts that are open included.
    pub(super) fn world(&self) -> BufferWorld {
        let open = self.session.documents().iter();
        BufferWorld::new(Arc::new(open.map(|open| (open.name(), open.text.as_str().into())).collect()))
    }
}

/// Where a place of one text is in another that differs in white space only: before the same letter, or behind it at the end of
/// a line.
fn same_letter(before: &str, at: usize, after: &str) -> usize {
    let count = before[..at].chars().filter(|letter| !letter.is_whitespace()).count();
    let behind = &before[at..];
    let is_last = behind[..behind.len() - behind.trim_start().len()].contains('\n');
    let mut letters = after.char_indices().filter(|(_, letter)| !letter.is_whitespace());
    match count.checked_sub(1).filter(|_| is_last) {
        Some(last) => letters.nth(last).map_or(after.len(), |(at, letter)| at + letter.len_utf8()),
        None => letters.nth(count).map_or(after.len(), |(at, _)| at),
    }
}

#[cfg(test)]
mod tests {
    use super::same_letter;

    #[test]
    fn the_caret_stays_at_its_word_when_the_text_is_formatted() {
        assert_eq!(same_letter("cube( 1 ) ;", 6, "cube(1);"), 5);
        assert_eq!(same_letter("a=1;", 2, "a = 1;"), 4);
        assert_eq!(same_letter("a;  ", 4, "a;\n"), 3);
        assert_eq!(same_letter("a ;\nb;", 3, "a;\nb;\n"), 2);
        assert_eq!(same_letter("a ;\n\nb;", 4, "a;\n\nb;\n"), 2);
    }
}
