//! What is written along with a letter: the bracket that closes, the indentation of the next line.

use std::ops::Range;

use chiaro_assist::{Edit, Kind, brackets, highlight};

use super::edits::{Change, LEVEL, Selected, indentation};

/// What brackets and quotes are closed by.
const PAIRS: [(char, char); 4] = [('(', ')'), ('[', ']'), ('{', '}'), ('"', '"')];

impl Selected<'_> {
    /// What a letter does that is more than itself.
    pub(super) fn typed(self, letter: &str) -> Option<Change> {
        let mut letters = letter.chars();
        let letter = letters.next().filter(|_| letters.next().is_none())?;
        let closer = PAIRS.iter().find(|(opener, _)| *opener == letter).map(|(_, closer)| *closer);
        if !self.is_empty() {
            return closer.map(|closer| self.wrapped(letter, closer));
        }
        let is_closer = PAIRS.iter().any(|(_, closer)| *closer == letter);
        if is_closer && self.stands_before_own(letter) {
            return Some(Change { edits: Vec::new(), anchor: self.caret + 1, caret: self.caret + 1 });
        }
        if letter == '}' {
            return self.unindented_brace();
        }
        let closer = closer.filter(|_| self.is_free())?;
        let mut change = Change::replacement(self.range(), format!("{letter}{closer}"));
        (change.anchor, change.caret) = (self.caret + 1, self.caret + 1);
        Some(change)
    }

    /// The selection between brackets.
    fn wrapped(self, opener: char, closer: char) -> Change {
        let range = self.range();
        let edits = vec![
            Edit { range: range.start..range.start, text: opener.into() },
            Edit { range: range.end..range.end, text: closer.into() },
        ];
        Change { edits, anchor: self.anchor + 1, caret: self.caret + 1 }
    }

    /// Whether the caret is before a closing bracket or quote that has its partner.
    fn stands_before_own(self, closer: char) -> bool {
        if !self.text[self.caret..].starts_with(closer) {
            return false;
        }
        if closer == '"' {
            let is_end = |at: usize| at == self.caret + 1;
            return highlight(self.text)
                .iter()
                .any(|word| word.kind == Kind::String && is_end(word.range.end) && word.range.start < self.caret);
        }
        brackets(self.text, self.caret).is_some_and(|[_, closing]| closing.start == self.caret)
    }

    /// Whether a bracket at the caret would be one, and nothing follows that it could belong to.
    fn is_free(self) -> bool {
        let next = self.text[self.caret..].chars().next();
        let is_end = next.is_none_or(|next| next.is_whitespace() || matches!(next, ')' | ']' | '}' | ';' | ','));
        is_end && !self.is_in_prose()
    }

    /// Whether the caret is in a comment or a text.
    fn is_in_prose(self) -> bool {
        highlight(self.text).iter().any(|word| {
            let goes_on = word.kind == Kind::Comment && self.text[word.range.clone()].starts_with("//");
            let is_prose = matches!(word.kind, Kind::Comment | Kind::String | Kind::Error);
            let end = if goes_on { word.range.end + 1 } else { word.range.end };
            is_prose && word.range.start < self.caret && self.caret < end
        })
    }

    /// A brace on a line of its own closes its block, not the block's last line.
    fn unindented_brace(self) -> Option<Change> {
        let start = self.text[..self.caret].rfind('\n').map_or(0, |at| at + 1);
        let before = &self.text[start..self.caret];
        let is_alone = !before.is_empty() && before.trim().is_empty();
        let level = before.len().checked_sub(LEVEL).filter(|_| is_alone)?;
        Some(Change::replacement(start..self.caret, format!("{}}}", &before[..level])))
    }

    /// A new line, as far in as it should be.
    pub(super) fn new_line(self) -> Change {
        let range = self.range();
        let start = self.text[..range.start].rfind('\n').map_or(0, |at| at + 1);
        let before = &self.text[start..range.start];
        let indentation = indentation(before);
        let opener = before.trim_end().chars().next_back().filter(|letter| matches!(letter, '(' | '[' | '{'));
        let Some(opener) = opener else { return Change::replacement(range, format!("\n{indentation}")) };
        let inner = format!("\n{indentation}{}", " ".repeat(LEVEL));
        let closes =
            PAIRS.iter().any(|(other, closer)| *other == opener && self.text[range.end..].starts_with(*closer));
        let outer = if closes { format!("\n{indentation}") } else { String::new() };
        let caret = range.start + inner.len();
        Change { edits: vec![Edit { range, text: inner + &outer }], anchor: caret, caret }
    }

    /// Removes what is selected, or else an empty pair of brackets, indentation up to the level
    /// before, or one letter.
    pub(super) fn backspace(self) -> Change {
        Change::replacement(if self.is_empty() { self.removed_before() } else { self.range() }, "")
    }

    /// What is removed with the letter before the caret.
    fn removed_before(self) -> Range<usize> {
        let (before, after) = self.text.split_at(self.caret);
        let is_pair = |(opener, closer): &(char, char)| before.ends_with(*opener) && after.starts_with(*closer);
        if PAIRS.iter().any(is_pair) {
            return self.caret - 1..self.caret + 1;
        }
        let spaces = before.len() - before.trim_end_matches(' ').len();
        let is_indentation = spaces > 0 && before[..before.len() - spaces].ends_with('\n') || spaces == before.len();
        let letter = before.chars().next_back().map_or(0, char::len_utf8);
        let removed = if is_indentation && spaces > 1 { (spaces - 1) % LEVEL + 1 } else { letter };
        self.caret - removed..self.caret
    }
}

#[cfg(test)]
mod tests {
    use super::super::edits::tests::{read, written};
    use super::*;

    #[track_caller]
    fn check(marked: &str, letter: &str, expected: Option<&str>) {
        let (text, anchor, caret) = read(marked);
        let selected = Selected { text: &text, anchor, caret };
        let change = match letter {
            "\n" => Some(selected.new_line()),
            "<" => Some(selected.backspace()),
            letter => selected.typed(letter),
        };
        assert_eq!(change.map(|change| written(&text, &change)).as_deref(), expected, "{marked} {letter}");
    }

    #[test]
    fn brackets_are_closed_where_nothing_follows() {
        check("cube|", "(", Some("cube(|)"));
        check("cube(|)", "[", Some("cube([|])"));
        check("a = |;", "\"", Some("a = \"|\";"));
        check("|cube", "(", None);
        check("// it|", "(", None);
        check("a = \"x|\";", "(", None);
        check("^cube|", "(", Some("(^cube|)"));
    }

    #[test]
    fn a_closing_bracket_is_not_written_twice() {
        check("cube(1|)", ")", Some("cube(1)|"));
        check("a = \"x|\"", "\"", Some("a = \"x\"|"));
        check("cube(1|", ")", None);
        check("(cube(1|)", ")", Some("(cube(1)|"));
        check("cube(1|))", ")", Some("cube(1)|)"));
        check("cube(1)|)", ")", None);
    }

    #[test]
    fn lines_are_indented_as_they_should_be() {
        check("  a();|", "\n", Some("  a();\n  |"));
        check("union() {|}", "\n", Some("union() {\n    |\n}"));
        check("  m() { |", "\n", Some("  m() { \n      |"));
        check("{\n    |", "}", Some("{\n}|"));
        check("a|", "}", None);
    }

    #[test]
    fn backspace_removes_what_was_written_along() {
        check("cube(|)", "<", Some("cube|"));
        check("        |a", "<", Some("    |a"));
        check("      |a", "<", Some("    |a"));
        check("a = 1;  |b", "<", Some("a = 1; |b"));
        check(" |b", "<", Some("|b"));
        check("é|", "<", Some("|"));
        check("|b", "<", Some("|b"));
        check("a^bc|d", "<", Some("a|d"));
    }
}
