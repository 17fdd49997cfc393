//! Source files and places in them.

use std::fmt;
use std::ops::Range;
use std::sync::Arc;

use crate::diagnostic::Diagnostic;

/// The number of a file in [`Sources`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FileId(pub u32);

/// A range of bytes in one file.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Span {
    /// The file the range is in.
    pub file: FileId,
    /// Offset of the first byte.
    pub start: u32,
    /// Offset behind the last byte.
    pub end: u32,
}

impl Span {
    /// The bytes `range` of `file`. Files are limited to far less than 4 GiB, so offsets fit in 32 bits.
    pub fn new(file: FileId, range: Range<usize>) -> Self {
        Self { file, start: range.start as u32, end: range.end as u32 }
    }

    /// The smallest span that covers `self` and `other`, which are in the same file.
    pub fn to(self, other: Span) -> Span {
        debug_assert_eq!(self.file, other.file);
        Span { file: self.file, start: self.start.min(other.start), end: self.end.max(other.end) }
    }

    /// The byte range, for slicing the file's text.
    pub fn range(self) -> Range<usize> {
        self.start as usize..self.end as usize
    }
}

impl fmt::Debug for Span {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}..{}", self.file.0, self.start, self.end)
    }
}

/// A value and the place it was written at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Spanned<T> {
    /// The value.
    pub node: T,
    /// Where it stands.
    pub span: Span,
}

impl<T> Spanned<T> {
    /// `node`, written at `span`.
    pub fn new(node: T, span: Span) -> Self {
        Self { node, span }
    }
}

/// The text of a file's bytes: UTF-8, but for bytes that are none, which count as in Latin-1. Of those, the place of
/// the first one that is more than a space comes with it.
pub fn decode(bytes: &[u8]) -> (String, Option<usize>) {
    const NO_BREAK_SPACE: u8 = 0xa0;
    let mut text = String::with_capacity(bytes.len());
    let mut first = None;
    for chunk in bytes.utf8_chunks() {
        text.push_str(chunk.valid());
        for byte in chunk.invalid() {
            if *byte != NO_BREAK_SPACE {
                first.get_or_insert(text.len());
            }
            text.push(char::from(*byte));
        }
    }
    (text, first)
}

/// One file's name and text.
#[derive(Clone, Debug)]
pub struct SourceFile {
    /// The name diagnostics show, and that relative `use` and `include` paths are resolved against.
    pub name: String,
    /// The whole text.
    pub text: Arc<str>,
    line_starts: Vec<u32>,
}

impl SourceFile {
    /// A file of this name and text.
    pub fn new(name: impl Into<String>, text: impl Into<Arc<str>>) -> Self {
        let text = text.into();
        let after_newlines = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n').map(|(at, _)| at as u32 + 1);
        let line_starts = std::iter::once(0).chain(after_newlines).collect();
        Self { name: name.into(), text, line_starts }
    }

    /// Whether the file is called as scenes are. Messages show the text of such files only: a scene may name any other.
    pub fn is_called_scene(&self) -> bool {
        let ending = self.name.rsplit_once('.').map(|(_, ending)| ending.to_ascii_lowercase());
        matches!(ending.as_deref(), Some("csg" | "scad"))
    }

    /// Line and column, both counted from 1 and the column in characters, of a byte offset.
    pub fn line_column(&self, offset: u32) -> (usize, usize) {
        let line = self.line_starts.partition_point(|start| *start <= offset) - 1;
        let start = self.line_starts[line] as usize;
        let offset = (offset as usize).min(self.text.len());
        let column = self.text.get(start..offset).map_or(0, |before| before.chars().count());
        (line + 1, column + 1)
    }
}

/// All files of one compilation: the scene first, then whatever it includes or uses, in the order read.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    files: Vec<SourceFile>,
}

impl Sources {
    /// Adds a file and answers its number.
    pub fn add(&mut self, file: SourceFile) -> FileId {
        self.files.push(file);
        FileId(self.files.len() as u32 - 1)
    }

    /// Adds a file that has these bytes and answers its number. A warning, if they are no UTF-8.
    pub fn add_bytes(&mut self, name: impl Into<String>, bytes: &[u8]) -> (FileId, Option<Diagnostic>) {
        let (text, odd) = decode(bytes);
        let wrong = odd.and_then(|place| Some((place, text[place..].chars().next()?)));
        let file = self.add(SourceFile::new(name, text));
        let warning = wrong.map(|(place, character)| {
            let message = format!("this byte is no UTF-8, and counts as `{character}`");
            Diagnostic::warning(Span::new(file, place..place + character.len_utf8()), message)
                .with_label("bytes like this one count as in Latin-1")
                .with_hint("save the file as UTF-8")
        });
        (file, warning)
    }

    /// The file of that number.
    pub fn get(&self, id: FileId) -> &SourceFile {
        &self.files[id.0 as usize]
    }

    /// The text under a span.
    pub fn text(&self, span: Span) -> &str {
        self.get(span.file).text.get(span.range()).unwrap_or("")
    }

    /// Every file with its number.
    pub fn iter(&self) -> impl Iterator<Item = (FileId, &SourceFile)> {
        self.files.iter().enumerate().map(|(index, file)| (FileId(index as u32), file))
    }
}

#[cfg(test)]
mod tests {
    use super::decode;

    #[test]
    fn bytes_that_are_no_utf8_count_as_latin_1() {
        assert_eq!(decode("aé".as_bytes()), ("aé".into(), None));
        assert_eq!(decode(b"cube(\xa03);"), ("cube(\u{a0}3);".into(), None));
        assert_eq!(decode(b"\xa0caf\xe9 \xfc"), ("\u{a0}café ü".into(), Some(5)));
        assert_eq!(decode(b"\xe2\x82"), ("â\u{82}".into(), Some(0)));
    }
}
