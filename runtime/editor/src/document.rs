//! A text that is open.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::history::History;

/// The name of what has no file yet, unless it has a better one.
pub(crate) const UNTITLED: &str = "untitled.csg";

/// A number that no other open text has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct DocumentId(u64);

/// A text that is open, with its file if it has one.
#[derive(Debug)]
pub(crate) struct Document {
    pub(crate) id: DocumentId,
    pub(crate) path: Option<PathBuf>,
    /// What it is called as long as it has no file.
    pub(crate) working_title: String,
    pub(crate) text: String,
    /// The text as it is on the disk.
    pub(crate) saved: Arc<str>,
    pub(crate) history: History,
    /// Where the caret is, and the other end of the selection, in bytes.
    pub(crate) caret: usize,
    pub(crate) anchor: usize,
    /// The file changed on the disk while the text had changes of its own.
    pub(crate) conflict: Option<Arc<str>>,
}

impl Document {
    /// A text with a file, as it is there.
    pub(crate) fn new(path: Option<PathBuf>, text: String) -> Self {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        Self {
            id: DocumentId(NEXT.fetch_add(1, Ordering::Relaxed)),
            path,
            working_title: UNTITLED.to_owned(),
            saved: text.as_str().into(),
            text,
            history: History::default(),
            caret: 0,
            anchor: 0,
            conflict: None,
        }
    }

    /// Reads a file. The error says why it can't be.
    pub(crate) fn open(path: &Path) -> Result<Self, String> {
        let path = std::fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        Ok(Self::new(Some(path.clone()), read(&path)?))
    }

    /// The name that the compiler knows it by: the file's full name.
    pub(crate) fn name(&self) -> String {
        match &self.path {
            Some(path) => path.to_string_lossy().into_owned(),
            None => self.working_title.clone(),
        }
    }

    /// The name that the user knows it by.
    pub(crate) fn title(&self) -> String {
        let name = self.path.as_ref().and_then(|path| path.file_name());
        name.map_or(self.working_title.clone(), |name| name.to_string_lossy().into_owned())
    }

    pub(crate) fn is_modified(&self) -> bool {
        *self.text != *self.saved
    }

    /// Replaces the text, so that it can be undone. Steps of a drag are undone together.
    pub(crate) fn replace(&mut self, text: String, caret: usize, is_step: bool) {
        self.history.note(&self.text, &text, [self.caret, caret], is_step);
        self.text = text;
        self.place_caret(caret);
    }

    /// Remembers an edit that was made to the text already.
    pub(crate) fn note_edit(&mut self, before: &str, caret_before: usize) {
        self.history.note(before, &self.text, [caret_before, self.caret], false);
    }

    pub(crate) fn undo(&mut self) -> bool {
        let caret = self.history.undo(&mut self.text);
        caret.inspect(|caret| self.place_caret(*caret)).is_some()
    }

    pub(crate) fn redo(&mut self) -> bool {
        let caret = self.history.redo(&mut self.text);
        caret.inspect(|caret| self.place_caret(*caret)).is_some()
    }

    /// Puts the caret at a byte, or the nearest character before it.
    pub(crate) fn place_caret(&mut self, at: usize) {
        self.select(at, at);
    }

    /// Selects from one byte to another, where the caret then is.
    pub(crate) fn select(&mut self, anchor: usize, caret: usize) {
        let on_character = |at: usize| {
            let at = at.min(self.text.len());
            (0..=at).rev().find(|at| self.text.is_char_boundary(*at)).unwrap_or(0)
        };
        (self.anchor, self.caret) = (on_character(anchor), on_character(caret));
    }

    /// Writes the text to a file, whole or not at all.
    pub(crate) fn save_to(&mut self, path: &Path) -> Result<(), String> {
        chiaro_files::write(path, self.text.as_bytes()).map_err(|error| format!("{error:#}"))?;
        self.saved = self.text.as_str().into();
        self.conflict = None;
        Ok(())
    }

    /// Looks at what is on the disk now. True if the text became that.
    pub(crate) fn reload(&mut self) -> bool {
        let Some(path) = &self.path else { return false };
        // A file in the middle of an atomic save is missing for a moment; the watcher tells when it is back.
        let Ok(text) = read(path) else { return false };
        if text == *self.saved {
            return false;
        }
        if self.is_modified() && text != self.text {
            self.conflict = Some(text.into());
            return false;
        }
        self.saved = text.as_str().into();
        self.conflict = None;
        if text == self.text {
            return false;
        }
        let caret = self.caret;
        self.history.pause();
        self.replace(text, caret, false);
        self.history.pause();
        true
    }

    /// Ends a conflict: with the text of the disk, or with one's own.
    pub(crate) fn resolve(&mut self, take_disk: bool) {
        let Some(disk) = self.conflict.take() else { return };
        self.saved = disk.clone();
        if take_disk {
            let caret = self.caret;
            self.history.pause();
            self.replace(disk.to_string(), caret, false);
        }
    }
}

/// Reads a text. Bytes that are no UTF-8 are an error: saving would change them.
fn read(path: &Path) -> Result<String, String> {
    let bytes = chiaro_files::FileWorld::new().read_file(path)?;
    String::from_utf8(bytes).map_err(|_| "it is no text in UTF-8".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_changed_elsewhere_is_reloaded_and_can_be_undone() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csg");
        std::fs::write(&path, "cube(1);").unwrap();
        let mut document = Document::open(&path).unwrap();
        std::fs::write(&path, "cube(2);").unwrap();
        assert!(document.reload());
        assert_eq!((document.text.as_str(), document.is_modified()), ("cube(2);", false));
        assert!(document.undo());
        assert_eq!((document.text.as_str(), document.is_modified()), ("cube(1);", true));
    }

    #[test]
    fn changes_of_ones_own_are_not_overwritten() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csg");
        std::fs::write(&path, "cube(1);").unwrap();
        let mut document = Document::open(&path).unwrap();
        document.replace("cube(10);".to_owned(), 0, false);
        std::fs::write(&path, "cube(2);").unwrap();
        assert!(!document.reload());
        assert_eq!((document.text.as_str(), document.conflict.as_deref()), ("cube(10);", Some("cube(2);")));
        document.resolve(false);
        assert!(document.is_modified() && document.conflict.is_none());
        document.save_to(&path).unwrap();
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "cube(10);");
    }

    #[test]
    fn carets_stay_on_characters() {
        let mut document = Document::new(None, "é".to_owned());
        document.place_caret(1);
        assert_eq!(document.caret, 0);
        document.place_caret(9);
        assert_eq!(document.caret, 2);
    }
}
