//! Undo and redo.

use std::ops::Range;
use std::time::{Duration, Instant};

/// Letters typed within this time of each other are undone together.
const PAUSE: Duration = Duration::from_millis(800);
/// The most bytes that are kept of what was removed and inserted.
const MOST_BYTES: usize = 64 << 20;

/// What was done to a text, and can be undone.
#[derive(Debug, Default)]
pub(crate) struct History {
    done: Vec<Change>,
    undone: Vec<Change>,
    bytes: usize,
}

/// The replacement of a part of a text.
#[derive(Clone, Debug, PartialEq)]
struct Change {
    start: usize,
    removed: String,
    inserted: String,
    /// Where the caret was before and after, in bytes.
    carets: [usize; 2],
    at: Instant,
    /// A step of a drag.
    is_step: bool,
    /// It is undone together with the change before it.
    continues: bool,
    /// It is not continued.
    is_closed: bool,
}

impl History {
    /// Remembers that `before` became `after`. Steps of a drag that follow each other are undone together.
    pub(crate) fn note(&mut self, before: &str, after: &str, carets: [usize; 2], is_step: bool) {
        let (was, is) = difference(before, after);
        if was.is_empty() && is.is_empty() {
            return;
        }
        self.undone.clear();
        let mut change = Change {
            start: was.start,
            removed: before[was].to_owned(),
            inserted: after[is].to_owned(),
            carets,
            at: Instant::now(),
            is_step,
            continues: false,
            is_closed: false,
        };
        change.continues = self.done.last().is_some_and(|last| last.is_continued_by(&change));
        self.bytes += change.bytes();
        self.done.push(change);
        while self.bytes > MOST_BYTES && self.done.len() > 1 {
            self.bytes -= self.done.remove(0).bytes();
        }
    }

    /// Ends a group: what comes is undone separately.
    pub(crate) fn pause(&mut self) {
        if let Some(last) = self.done.last_mut() {
            last.is_closed = true;
        }
    }

    /// Takes back the last group of changes. Where the caret then is, in bytes.
    pub(crate) fn undo(&mut self, text: &mut String) -> Option<usize> {
        loop {
            let change = self.done.pop()?;
            text.replace_range(change.start..change.start + change.inserted.len(), &change.removed);
            let (caret, continues) = (change.carets[0], change.continues);
            self.undone.push(change);
            if !continues {
                return Some(caret);
            }
        }
    }

    /// Does again what was taken back.
    pub(crate) fn redo(&mut self, text: &mut String) -> Option<usize> {
        loop {
            let change = self.undone.pop()?;
            text.replace_range(change.start..change.start + change.removed.len(), &change.inserted);
            let caret = change.carets[1];
            self.done.push(change);
            if !self.undone.last().is_some_and(|next| next.continues) {
                return Some(caret);
            }
        }
    }

    pub(crate) fn can_undo(&self) -> bool {
        !self.done.is_empty()
    }

    pub(crate) fn can_redo(&self) -> bool {
        !self.undone.is_empty()
    }
}

impl Change {
    fn bytes(&self) -> usize {
        self.removed.len() + self.inserted.len()
    }

    /// Whether the next change continues this one: a step of the same drag, or the next letter of a word.
    fn is_continued_by(&self, next: &Change) -> bool {
        let is_letter = |change: &Change| change.removed.is_empty() && is_one_word_letter(&change.inserted);
        let is_typing = is_letter(self) && is_letter(next) && next.start == self.start + self.inserted.len();
        let is_drag = self.is_step && next.is_step;
        !self.is_closed && (is_drag || is_typing && next.at.duration_since(self.at) < PAUSE)
    }
}

fn is_one_word_letter(text: &str) -> bool {
    let mut letters = text.chars();
    letters.next().is_some_and(|letter| letter.is_alphanumeric() || letter == '_' || letter == '.')
        && letters.next().is_none()
}

/// The parts in which two texts differ.
pub(crate) fn difference(before: &str, after: &str) -> (Range<usize>, Range<usize>) {
    let same_start = before.bytes().zip(after.bytes()).take_while(|(a, b)| a == b).count();
    let mut start = same_start;
    while !(before.is_char_boundary(start) && after.is_char_boundary(start)) {
        start -= 1;
    }
    let rest = |text: &str| text.len() - start;
    let ends = before[start..].bytes().rev().zip(after[start..].bytes().rev()).take_while(|(a, b)| a == b).count();
    let mut end = ends.min(rest(before)).min(rest(after));
    while !(before.is_char_boundary(before.len() - end) && after.is_char_boundary(after.len() - end)) {
        end -= 1;
    }
    (start..before.len() - end, start..after.len() - end)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn changed(history: &mut History, text: &mut String, after: &str, is_joined: bool) {
        history.note(text, after, [0, 0], is_joined);
        *text = after.to_owned();
    }

    #[test]
    fn differences_are_least_and_on_letters() {
        assert_eq!(difference("sphere(3);", "sphere(35);"), (8..8, 8..9));
        assert_eq!(difference("aaa", "aa"), (2..3, 2..2));
        assert_eq!(difference("é", "è"), (0..2, 0..2));
        assert_eq!(difference("same", "same"), (4..4, 4..4));
    }

    #[test]
    fn a_word_is_undone_at_once_and_a_drag_too() {
        let (mut history, mut text) = (History::default(), String::new());
        for word in ["c", "cu", "cub", "cube"] {
            changed(&mut history, &mut text, word, false);
        }
        changed(&mut history, &mut text, "cube(", false);
        history.pause();
        changed(&mut history, &mut text, "cube(1", true);
        changed(&mut history, &mut text, "cube(2", true);
        changed(&mut history, &mut text, "cube(3", true);
        history.undo(&mut text);
        assert_eq!(text, "cube(");
        history.undo(&mut text);
        history.undo(&mut text);
        assert_eq!((text.as_str(), history.can_undo()), ("", false));
        for expected in ["cube", "cube(", "cube(3"] {
            history.redo(&mut text);
            assert_eq!(text, expected);
        }
        assert!(!history.can_redo());
    }

    #[test]
    fn a_change_after_an_undo_forgets_what_was_undone() {
        let (mut history, mut text) = (History::default(), String::from("a"));
        changed(&mut history, &mut text, "a b", false);
        history.undo(&mut text);
        changed(&mut history, &mut text, "a c", false);
        assert!(!history.can_redo());
    }
}
