//! The comments of a WGSL text, which its syntax tree does not keep.

use std::ops::Range;

/// A comment that goes to the end of its line.
pub(super) struct Comment {
    /// Where it starts.
    pub(super) start: usize,
    /// The text, slashes included.
    pub(super) text: String,
    /// Whether nothing but space stands before it in its line.
    pub(super) is_alone: bool,
    /// Whether a blank line, or the text's start, stands before it.
    pub(super) after_blank: bool,
}

/// The comments of a text that go to the ends of their lines, in their order. Those between `/*` and `*/`, which our texts don't
/// have, are left out.
pub(super) fn comments(text: &str) -> Vec<Comment> {
    let of_line = ranges(text).into_iter().filter(|range| text[range.start..].starts_with("//"));
    of_line.map(|range| comment(text, range)).collect()
}

fn comment(text: &str, range: Range<usize>) -> Comment {
    let before = text[..range.start].rsplit(is_line_break).next().unwrap_or_default();
    let is_alone = before.trim().is_empty();
    let is_first = before.len() == range.start;
    let after_blank = is_alone && (is_first || follows_blank_line(text, range.start));
    Comment { start: range.start, text: text[range].trim_end().to_owned(), is_alone, after_blank }
}

/// Where comments are, without the ends of their lines. WGSL has no strings that could contain slashes.
fn ranges(text: &str) -> Vec<Range<usize>> {
    let mut ranges = Vec::new();
    let mut from = 0;
    while let Some(start) = text[from..].find("/").map(|at| from + at) {
        let behind = &text[start..];
        let length = match behind.as_bytes().get(1) {
            Some(b'/') => behind.find(is_line_break).unwrap_or(behind.len()),
            Some(b'*') => length_of_block(behind),
            _ => 0,
        };
        if length > 0 {
            ranges.push(start..start + length);
        }
        from = start + length.max(1);
    }
    ranges
}

/// The length of the comment from `/*` to `*/` that a text begins with. There may be others within.
fn length_of_block(text: &str) -> usize {
    let mut depth = 0;
    let mut at = 0;
    while let Some(found) = text[at..].find(['/', '*']).map(|found| at + found) {
        let sign = &text.as_bytes()[found..];
        (depth, at) = match sign {
            [b'/', b'*', ..] => (depth + 1, found + 2),
            [b'*', b'/', ..] => (depth - 1, found + 2),
            _ => (depth, found + 1),
        };
        if depth == 0 {
            return at;
        }
    }
    text.len()
}

/// Whether a character ends a line in WGSL, and a comment in it.
fn is_line_break(c: char) -> bool {
    matches!(c, '\n' | '\u{b}' | '\u{c}' | '\r' | '\u{85}' | '\u{2028}' | '\u{2029}')
}

/// What stands between the comments of a text.
pub(super) fn code(text: &str) -> Vec<&str> {
    let mut from = 0;
    let mut pieces = Vec::new();
    for range in ranges(text) {
        pieces.push(&text[from..range.start]);
        from = range.end;
    }
    pieces.push(&text[from..]);
    pieces
}

/// Whether there is a blank line just before the line that holds a place.
pub(super) fn follows_blank_line(text: &str, place: usize) -> bool {
    let line_start = text[..place].rfind('\n').map_or(0, |at| at + 1);
    text[..line_start].ends_with("\n\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_end_where_wgsl_ends_them() {
        for c in ['\n', '\u{b}', '\u{c}', '\r', '\u{85}', '\u{2028}', '\u{2029}'] {
            let text = format!("a // b{c}c // d /* e{c}/* f /* // */ g */ h / i");
            let found: Vec<_> = comments(&text).into_iter().map(|comment| (comment.text, comment.is_alone)).collect();
            assert_eq!(found, [("// b".to_owned(), false), ("// d /* e".to_owned(), false)], "{c:?}");
            assert_eq!(code(&text), ["a ".to_owned(), format!("{c}c "), format!("{c}"), " h / i".to_owned()], "{c:?}");
        }
        assert_eq!(code("a /* b"), ["a ", ""]);
    }
}
