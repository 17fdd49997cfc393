//! Formatting: indentation and the spaces between words, and nothing else.
//!
//! Lines stay as they are broken, and all comments stay where they are, so that nobody loses what they laid out. What
//! changes is the white space at the beginning and end of lines and between words, and blank lines beyond one. A text
//! that is already formatted stays the same.

mod lines;
mod roles;
mod spacing;

use chiaro_syntax::{Dialect, FileId, parse, print};

use crate::tokens;

/// The text, well formatted.
///
/// Whatever the text, its words, texts and comments stay the same, and so does what it means.
pub fn format(text: &str) -> String {
    let formatted = lines::formatted(text);
    if is_same(text, &formatted) { formatted } else { text.to_owned() }
}

/// Whether two texts have the same tokens, comments included, and the same syntax tree with the same parameters.
///
/// That is so but for rare texts whose white space matters, such as those that resemble a dump.
fn is_same(text: &str, other: &str) -> bool {
    let words = |text: &str| tokens(text).len();
    if words(text) != words(other) {
        return false;
    }
    let mut pairs = tokens(text).into_iter().zip(tokens(other));
    let is_same = pairs.all(|(a, b)| a.kind == b.kind && text[a.range()] == other[b.range()]);
    is_same && tree(text) == tree(other)
}

/// The syntax tree, without its places.
fn tree(text: &str) -> String {
    print(&parse(FileId(0), text, Dialect::Dump).0)
}

#[cfg(test)]
mod tests;
