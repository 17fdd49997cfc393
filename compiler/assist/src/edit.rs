//! Changes of a text.

use std::ops::Range;

/// One change: what stands in a range gives way to other text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// The bytes to be replaced; empty where text is inserted.
    pub range: Range<usize>,
    /// What is to stand there.
    pub text: String,
}

/// The text with all edits made, which refer to the text as it was and do not overlap. Edits whose ranges are no part of
/// the text, or overlap one before them, are left out.
pub fn apply(text: &str, edits: &[Edit]) -> String {
    let mut edits: Vec<&Edit> = edits.iter().collect();
    edits.sort_by_key(|edit| (edit.range.start, edit.range.end));
    let mut changed = String::with_capacity(text.len());
    let mut done = 0;
    for edit in edits {
        if edit.range.start < done || text.get(edit.range.clone()).is_none() {
            continue;
        }
        changed.push_str(&text[done..edit.range.start]);
        changed.push_str(&edit.text);
        done = edit.range.end;
    }
    changed + &text[done..]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edit(range: Range<usize>, text: &str) -> Edit {
        Edit { range, text: text.to_owned() }
    }

    #[test]
    fn edits_refer_to_the_text_as_it_was() {
        assert_eq!(apply("abcd", &[edit(3..4, "x"), edit(0..1, ""), edit(1..1, "++")]), "++bcx");
    }

    #[test]
    fn edits_that_do_not_fit_are_left_out() {
        assert_eq!(apply("aé", &[edit(0..2, "x"), edit(0..1, "b"), edit(0..9, "y"), edit(9..9, "z")]), "bé");
    }
}
