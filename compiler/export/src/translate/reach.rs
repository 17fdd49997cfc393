//! Which functions of a text read its live parameters, themselves or by what they call.

use rustc_hash::FxHashSet;
use wgsl_parse::syntax::{GlobalDeclaration, TranslationUnit};

use super::comments::code;

/// The uniform variable of live parameters.
pub(super) const PARAMETERS: &str = "parameters";

/// The names of those functions.
pub(super) fn readers(wgsl: &str, unit: &TranslationUnit) -> FxHashSet<String> {
    let functions: Vec<(String, FxHashSet<&str>)> = (unit.global_declarations.iter())
        .filter_map(|declaration| match declaration.node() {
            GlobalDeclaration::Function(function) => {
                let text = &wgsl[declaration.span().range()];
                Some((function.ident.name().clone(), words(text).map(|(word, _)| word).collect()))
            }
            _ => None,
        })
        .collect();
    let mut readers = FxHashSet::default();
    loop {
        let before = readers.len();
        for (name, words) in &functions {
            if words.contains(PARAMETERS) || words.iter().any(|word| readers.contains(*word)) {
                readers.insert(name.clone());
            }
        }
        if readers.len() == before {
            return readers;
        }
    }
}

/// The identifiers of a text that are not in its comments, and whether an opening parenthesis stands behind.
pub(crate) fn words(text: &str) -> impl Iterator<Item = (&str, bool)> {
    code(text).into_iter().flat_map(words_of_code)
}

fn words_of_code(code: &str) -> impl Iterator<Item = (&str, bool)> {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut rest = code;
    std::iter::from_fn(move || {
        let start = rest.find(is_part)?;
        let end = rest[start..].find(|c| !is_part(c)).map_or(rest.len(), |length| start + length);
        let (word, behind) = (&rest[start..end], &rest[end..]);
        rest = behind;
        Some((word, behind.starts_with('(')))
    })
}
