//! Edits of whole lines: comments, indentation, moving and copying.

use std::ops::Range;

use chiaro_assist::{Edit, apply};

/// How far a level is indented.
pub(super) const LEVEL: usize = 4;

/// What becomes of a text and of its selection.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Change {
    pub(super) edits: Vec<Edit>,
    /// The selection afterwards.
    pub(super) anchor: usize,
    pub(super) caret: usize,
}

/// A text and what is selected of it, in bytes.
#[derive(Clone, Copy)]
pub(super) struct Selected<'a> {
    pub(super) text: &'a str,
    pub(super) anchor: usize,
    pub(super) caret: usize,
}

impl Change {
    /// One replacement, with the caret behind it.
    pub(super) fn replacement(range: Range<usize>, text: impl Into<String>) -> Self {
        let text = text.into();
        let caret = range.start + text.len();
        Self { edits: vec![Edit { range, text }], anchor: caret, caret }
    }

    /// Edits that move what is selected along.
    pub(super) fn around(selected: Selected, edits: Vec<Edit>) -> Self {
        let (anchor, caret) = (moved(selected.anchor, &edits), moved(selected.caret, &edits));
        Self { edits, anchor, caret }
    }

    /// The text afterwards.
    pub(super) fn applied(&self, text: &str) -> String {
        apply(text, &self.edits)
    }
}

/// Where a place is after edits that are in the order of the text.
pub(super) fn moved(at: usize, edits: &[Edit]) -> usize {
    let mut moved = at;
    for edit in edits.iter().take_while(|edit| edit.range.start <= at) {
        let removed = edit.range.end.min(at) - edit.range.start;
        moved = moved - removed + edit.text.len();
    }
    moved
}

impl<'a> Selected<'a> {
    pub(super) fn range(self) -> Range<usize> {
        self.anchor.min(self.caret)..self.anchor.max(self.caret)
    }

    pub(super) fn is_empty(self) -> bool {
        self.anchor == self.caret
    }

    /// The lines that are selected, from the first one's beginning to the last one's end.
    fn lines(self) -> Range<usize> {
        let range = self.range();
        let start = self.text[..range.start].rfind('\n').map_or(0, |at| at + 1);
        // A selection that ends before a line's first letter does not mean that line.
        let last =
            if range.end > range.start && self.text[..range.end].ends_with('\n') { range.end - 1 } else { range.end };
        let end = self.text[last..].find('\n').map_or(self.text.len(), |at| last + at);
        start..end
    }

    /// Each of the lines that are selected, and where it begins.
    fn each_line(self) -> impl Iterator<Item = (usize, &'a str)> {
        let lines = self.lines();
        let mut start = lines.start;
        self.text[lines].split('\n').map(move |line| {
            let at = start;
            start += line.len() + 1;
            (at, line)
        })
    }

    /// Makes comments of the selected lines, or makes them program again if all are comments.
    pub(super) fn toggle_comment(self) -> Option<Change> {
        let is_written = |line: &str| !line.trim().is_empty();
        let lines: Vec<_> = self.each_line().filter(|(_, line)| is_written(line)).collect();
        let indentation = lines.iter().map(|(_, line)| indentation(line).len()).min()?;
        let is_comment = |line: &str| line.trim_start().starts_with("//");
        let edits = if lines.iter().all(|(_, line)| is_comment(line)) {
            let removed = |(at, line): &(usize, &str)| {
                let start = at + self::indentation(line).len();
                let length = if self.text[start..].starts_with("// ") { 3 } else { 2 };
                Edit { range: start..start + length, text: String::new() }
            };
            lines.iter().map(removed).collect()
        } else {
            let inserted = |(at, _): &(usize, &str)| insertion(at + indentation, "// ");
            lines.iter().map(inserted).collect()
        };
        Some(Change::around(self, edits))
    }

    /// Indents the selected lines by a level; without a selection, the caret.
    pub(super) fn indent(self) -> Change {
        if !self.text[self.range()].contains('\n') {
            let line = self.lines().start;
            let column = self.text[line..self.range().start].chars().count();
            return Change::replacement(self.range(), " ".repeat(LEVEL - column % LEVEL));
        }
        let written = self.each_line().filter(|(_, line)| !line.is_empty());
        Change::around(self, written.map(|(at, _)| insertion(at, &" ".repeat(LEVEL))).collect())
    }

    /// Takes a level of indentation from the selected lines.
    pub(super) fn unindent(self) -> Option<Change> {
        let removed = |(at, line): (usize, &str)| {
            let spaces = line.bytes().take(LEVEL).take_while(|byte| *byte == b' ').count();
            let length = if line.starts_with('\t') { 1 } else { spaces };
            (length > 0).then(|| Edit { range: at..at + length, text: String::new() })
        };
        let edits: Vec<_> = self.each_line().filter_map(removed).collect();
        (!edits.is_empty()).then(|| Change::around(self, edits))
    }

    /// Writes the selected lines once more below themselves, and goes there.
    pub(super) fn duplicate(self) -> Change {
        let lines = self.lines();
        let copy = format!("\n{}", &self.text[lines.clone()]);
        let length = copy.len();
        let edits = vec![insertion(lines.end, &copy)];
        Change { edits, anchor: self.anchor + length, caret: self.caret + length }
    }

    /// Removes the selected lines.
    pub(super) fn delete_lines(self) -> Change {
        let lines = self.lines();
        let end = (lines.end + 1).min(self.text.len());
        // The last line takes the line end before it along.
        let start = if lines.end == self.text.len() { lines.start.saturating_sub(1) } else { lines.start };
        let caret = if start < lines.start { start } else { lines.start };
        Change { edits: vec![Edit { range: start..end, text: String::new() }], anchor: caret, caret }
    }

    /// Changes places with the line above.
    pub(super) fn move_up(self) -> Option<Change> {
        let lines = self.lines();
        let above = self.text[..lines.start.checked_sub(1)?].rfind('\n').map_or(0, |at| at + 1);
        let length = lines.start - above;
        let text = format!("{}\n{}", &self.text[lines.clone()], &self.text[above..lines.start - 1]);
        let edits = vec![Edit { range: above..lines.end, text }];
        let to = |at: usize| at.saturating_sub(length);
        Some(Change { edits, anchor: to(self.anchor), caret: to(self.caret) })
    }

    /// Changes places with the line below.
    pub(super) fn move_down(self) -> Option<Change> {
        let lines = self.lines();
        let below = lines.end + 1;
        let rest = self.text.get(below..)?;
        let end = below + rest.find('\n').unwrap_or(rest.len());
        let text = format!("{}\n{}", &self.text[below..end], &self.text[lines.clone()]);
        let length = end - below + 1;
        let edits = vec![Edit { range: lines.start..end, text }];
        Some(Change { edits, anchor: self.anchor + length, caret: self.caret + length })
    }
}

/// The white space that a line begins with.
pub(super) fn indentation(line: &str) -> &str {
    &line[..line.len() - line.trim_start_matches([' ', '\t']).len()]
}

fn insertion(at: usize, text: &str) -> Edit {
    Edit { range: at..at, text: text.to_owned() }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// A text with `|` for the caret and perhaps `^` for the other end of the selection.
    pub(crate) fn read(marked: &str) -> (String, usize, usize) {
        let text: String = marked.chars().filter(|letter| !matches!(letter, '|' | '^')).collect();
        let place = |mark: char, other: char| {
            let at = marked.find(mark)?;
            Some(at - marked[..at].matches(other).count())
        };
        let caret = place('|', '^').expect("a caret");
        (text, place('^', '|').unwrap_or(caret), caret)
    }

    /// The text after a change, marked in the same way.
    pub(crate) fn written(text: &str, change: &Change) -> String {
        let mut text = change.applied(text);
        let (anchor, caret) = (change.anchor, change.caret);
        let marks = if anchor == caret { vec![(caret, '|')] } else { vec![(caret, '|'), (anchor, '^')] };
        let mut marks = marks;
        marks.sort_by_key(|mark| std::cmp::Reverse(mark.0));
        marks.into_iter().for_each(|(at, mark)| text.insert(at, mark));
        text
    }

    #[track_caller]
    fn check(marked: &str, change: impl for<'a> Fn(Selected<'a>) -> Option<Change>, expected: &str) {
        let (text, anchor, caret) = read(marked);
        let change = change(Selected { text: &text, anchor, caret }).expect("a change");
        assert_eq!(written(&text, &change), expected);
    }

    #[test]
    fn comments_come_and_go() {
        check("  cube(|1);", |selected| selected.toggle_comment(), "  // cube(|1);");
        check("  // cube(|1);", |selected| selected.toggle_comment(), "  cube(|1);");
        check("//c|", |selected| selected.toggle_comment(), "c|");
        check("{\n^  a();\n\n    b();\n|}", |selected| selected.toggle_comment(), "{\n^  // a();\n\n  //   b();\n|}");
        check("^// a\nb|", |selected| selected.toggle_comment(), "// ^// a\n// b|");
    }

    #[test]
    fn lines_are_indented() {
        let indent = |selected: Selected| Some(selected.indent());
        check("ab|c", indent, "ab  |c");
        check("ab^c|d", indent, "ab  |d");
        check("a^a\n\nb|b", indent, "    a^a\n\n    b|b");
        check("    a^a\n  b|b", |selected| selected.unindent(), "a^a\nb|b");
        check("\tx|", |selected| selected.unindent(), "x|");
    }

    #[test]
    fn lines_move_and_multiply() {
        check("a\nb|b\nc", |selected| selected.move_up(), "b|b\na\nc");
        check("a\nb|b\nc", |selected| selected.move_down(), "a\nc\nb|b");
        check("a\nb|b\n", |selected| selected.move_down(), "a\n\nb|b");
        check("a^a\nb|b\nc", |selected| Some(selected.duplicate()), "aa\nbb\na^a\nb|b\nc");
        check("a\nb|b\nc", |selected| Some(selected.delete_lines()), "a\n|c");
        check("a\nb|b", |selected| Some(selected.delete_lines()), "a|");
        assert!(Selected { text: "a", anchor: 0, caret: 0 }.move_up().is_none());
        assert!(Selected { text: "a", anchor: 0, caret: 0 }.move_down().is_none());
    }
}
