//! What the compiler has to say about the text that is open.

use std::ops::Range;

use chiaro_assist::quick_fixes;
use chiaro_compiler::syntax::{Diagnostic, FileId, Severity};

use super::edits::Change;
use crate::app::Editor;
use crate::document::DocumentId;
use crate::history::difference;

/// The messages about the text that is open, where they are now.
#[derive(Default)]
pub(crate) struct Messages {
    /// What they were found for: the compilation, the text and its version.
    of: Option<(u64, DocumentId, u64)>,
    pub(super) found: Vec<Message>,
}

/// A message about a part of the text.
#[derive(Clone)]
pub(super) struct Message {
    /// The part, since what was edited meanwhile.
    pub(super) range: Range<usize>,
    pub(super) diagnostic: Diagnostic,
    /// How to mend it, as long as the text is the one that was compiled.
    pub(super) fixes: Vec<Fix>,
}

/// A way to mend something.
#[derive(Clone)]
pub(super) struct Fix {
    pub(super) title: String,
    pub(super) change: Change,
}

impl Message {
    pub(super) fn severity(&self) -> Severity {
        self.diagnostic.severity
    }

    /// The part that is marked in the text. Of a note that is the first word: it is no fault, and a
    /// statement which is right must not look like one.
    pub(super) fn marked(&self, text: &str) -> Range<usize> {
        let Some(part) = text.get(self.range.clone()).filter(|_| self.severity() == Severity::Note) else {
            return self.range.clone();
        };
        let word = part.len() - part.trim_start_matches(|c: char| c.is_alphanumeric() || matches!(c, '_' | '$')).len();
        let first = part.chars().next().map_or(0, char::len_utf8);
        self.range.start..self.range.start + word.max(first)
    }

    /// Whether it is about a byte, or about nothing but the place before it.
    pub(super) fn is_at(&self, at: usize) -> bool {
        self.range.start <= at && at < self.range.end.max(self.range.start + 1)
    }
}

/// Finds the messages again, if there are others or the text changed.
pub(super) fn update(editor: &mut Editor) {
    let document = editor.session.active();
    let Some(outcome) = &editor.session.outcome else { return };
    let of = Some((outcome.revision, document.id, editor.text.layout.version()));
    if editor.text.messages.of == of {
        return;
    }
    let name = document.name();
    let file = outcome.sources.iter().find(|(_, file)| file.name == name);
    editor.text.messages.found = match file {
        Some((id, file)) => found(id, &file.text, &document.text, &outcome.diagnostics),
        None => Vec::new(),
    };
    editor.text.messages.of = of;
}

/// The messages about a file, whose text was `before` and is `now`.
fn found(file: FileId, before: &str, now: &str, diagnostics: &[Diagnostic]) -> Vec<Message> {
    let (was, is) = difference(before, now);
    let here = diagnostics.iter().filter_map(|diagnostic| Some((diagnostic, diagnostic.span?)));
    let here = here.filter(|(_, span)| span.file == file);
    let messages = here.filter_map(|(diagnostic, span)| {
        let range = moved(span.range(), &was, &is)?;
        now.get(range.clone())?;
        let fixes = if before == now { fixes(diagnostic, file, now) } else { Vec::new() };
        Some(Message { range, diagnostic: diagnostic.clone(), fixes })
    });
    messages.collect()
}

fn fixes(diagnostic: &Diagnostic, file: FileId, text: &str) -> Vec<Fix> {
    let fixes = quick_fixes(diagnostic, file, text).into_iter();
    let with_caret = fixes.map(|fix| {
        let caret = fix.edits.first().map_or(0, |edit| edit.range.start + edit.text.len());
        Fix { title: fix.title, change: Change { edits: fix.edits, anchor: caret, caret } }
    });
    with_caret.collect()
}

/// Where a range is after what was `was` became `is`; none if it was in the midst of that.
fn moved(range: Range<usize>, was: &Range<usize>, is: &Range<usize>) -> Option<Range<usize>> {
    if range.end <= was.start {
        return Some(range);
    }
    if range.start >= was.end {
        return Some(range.start - was.end + is.end..range.end - was.end + is.end);
    }
    (range.start <= was.start && was.end <= range.end).then(|| range.start..range.end - was.end + is.end)
}

#[cfg(test)]
mod tests {
    use chiaro_compiler::syntax::{SourceFile, Sources, Span};

    use super::*;

    #[test]
    fn messages_move_with_the_text() {
        let mut sources = Sources::default();
        let before = "cube(1); spere(2);";
        let file = sources.add(SourceFile::new("a.csg", before));
        let span = Span::new(file, 9..14);
        let diagnostics = [Diagnostic::error(span, "unknown").with_suggestion(span, "sphere")];
        let ranges = |now: &str| -> Vec<(usize, usize)> {
            found(file, before, now, &diagnostics)
                .into_iter()
                .map(|message| (message.range.start, message.range.end))
                .collect()
        };
        assert_eq!(ranges("cube(1); spere(2);"), [(9, 14)]);
        assert_eq!(ranges("cube(100); spere(2);"), [(11, 16)]);
        assert_eq!(ranges("cube(1); spere(200);"), [(9, 14)]);
        assert_eq!(ranges("cube(1); sp0ere(2);"), [(9, 15)]);
        assert_eq!(ranges("cube(1"), []);
    }

    #[test]
    fn a_note_marks_its_first_word_and_a_fault_all_of_it() {
        let mut sources = Sources::default();
        let text = "echo(version = version()); #cube(1);";
        let file = sources.add(SourceFile::new("a.csg", text));
        let marked = |diagnostic: Diagnostic| found(file, text, text, &[diagnostic]).remove(0).marked(text);
        assert_eq!(marked(Diagnostic::note(Span::new(file, 0..25), "ECHO: version = 1")), 0..4);
        assert_eq!(marked(Diagnostic::note(Span::new(file, 27..28), "highlighted")), 27..28);
        assert_eq!(marked(Diagnostic::warning(Span::new(file, 0..25), "odd")), 0..25);
    }

    #[test]
    fn fixes_are_of_the_text_as_it_was_compiled() {
        let mut sources = Sources::default();
        let file = sources.add(SourceFile::new("a.csg", "spere(2);"));
        let span = Span::new(file, 0..5);
        let diagnostics = [Diagnostic::error(span, "unknown").with_suggestion(span, "sphere")];
        let found = |now: &str| found(file, "spere(2);", now, &diagnostics).remove(0).fixes;
        assert_eq!(found("spere(2);")[0].change.applied("spere(2);"), "sphere(2);");
        assert!(found("spere(20);").is_empty());
    }
}
