//! What the tests of this crate share.

use crate::parser::{Dialect, parse};
use crate::source::{FileId, SourceFile};
use crate::tree::File;
use crate::{Diagnostic, Severity};

/// A file number that no number in a text is mistaken for.
pub(crate) const FILE: FileId = FileId(987_654);

/// The tree of a text without errors.
pub(crate) fn tree(text: &str) -> File {
    let (file, diagnostics) = parse(FILE, text, Dialect::Program);
    let is_error = |diagnostic: &Diagnostic| diagnostic.severity == Severity::Error;
    assert!(!diagnostics.iter().any(is_error), "{text}\n{diagnostics:#?}");
    file
}

/// What a text's diagnostics say, one `line:column message` each.
pub(crate) fn messages(text: &str) -> Vec<String> {
    let source = SourceFile::new("test", text);
    let (_, diagnostics) = parse(FILE, text, Dialect::Program);
    let place = |diagnostic: &Diagnostic| diagnostic.span.map_or((0, 0), |span| source.line_column(span.start));
    diagnostics
        .iter()
        .map(|diagnostic| format!("{}:{} {}", place(diagnostic).0, place(diagnostic).1, diagnostic.message))
        .collect()
}

/// A tree as text, its places left out, and the byte ranges of those places.
pub(crate) fn without_places(tree: &impl std::fmt::Debug) -> (String, Vec<(usize, usize)>) {
    let text = format!("{tree:?}");
    let file = format!("{}:", FILE.0);
    let mut parts = text.split(&file);
    let mut rest = parts.next().unwrap_or_default().to_owned();
    let mut places = Vec::new();
    for part in parts {
        let end = part.find(|character: char| !character.is_ascii_digit() && character != '.').unwrap_or(part.len());
        if let Some((start, stop)) = part[..end].split_once("..")
            && let (Ok(start), Ok(stop)) = (start.parse(), stop.parse())
        {
            places.push((start, stop));
        }
        rest.push_str(&part[end..]);
    }
    (rest, places)
}
