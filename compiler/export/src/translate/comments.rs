//! The comments of a WGSL text, which its syntax tree does not keep.

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

/// The comments of a text, in their order. WGSL has no strings that could contain slashes, and our texts no block comments.
pub(super) fn comments(text: &str) -> Vec<Comment> {
    let mut comments = Vec::new();
    let mut offset = 0;
    let mut after_blank = true;
    for line in text.split_inclusive('\n') {
        if let Some(at) = line.find("//") {
            let is_alone = line[..at].trim().is_empty();
            let text = line[at..].trim_end().to_owned();
            comments.push(Comment { start: offset + at, text, is_alone, after_blank: after_blank && is_alone });
        }
        after_blank = line.trim().is_empty();
        offset += line.len();
    }
    comments
}

/// Whether there is a blank line just before the line that holds a place.
pub(super) fn follows_blank_line(text: &str, place: usize) -> bool {
    let line_start = text[..place].rfind('\n').map_or(0, |at| at + 1);
    text[..line_start].ends_with("\n\n")
}
