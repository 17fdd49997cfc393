//! Texts as messages show them: what a terminal would obey is seen instead.

use std::borrow::Cow;
use std::fmt::Write;

/// A text in which signs stand for what isn't a character to see: ␛ for an escape, `\u{202e}` for what turns the direction of
/// writing. Lines and tabs stay.
pub(crate) fn shown(text: &str) -> Cow<'_, str> {
    if !text.contains(is_obeyed) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len());
    for (at, c) in text.char_indices() {
        match sign(text, at, c) {
            Some(sign) => shown += &sign,
            None => shown.push(c),
        }
    }
    Cow::Owned(shown)
}

/// Where what starts at a byte of a text starts in the text that is shown.
pub(crate) fn shown_place(text: &str, place: usize) -> usize {
    if !text.contains(is_obeyed) {
        return place;
    }
    let before = text.char_indices().take_while(|(at, _)| *at < place);
    before.map(|(at, c)| sign(text, at, c).map_or(c.len_utf8(), |sign| sign.len())).sum()
}

/// What stands for a character of a text, if it isn't shown as it is.
fn sign(text: &str, at: usize, c: char) -> Option<String> {
    match c {
        // The end of a line.
        '\r' if matches!(text.as_bytes().get(at + 1), None | Some(b'\n')) => None,
        '\u{7f}' => Some('␡'.to_string()),
        '\u{0}'..='\u{1f}' if is_obeyed(c) => char::from_u32(0x2400 + u32::from(c)).map(String::from),
        _ => is_obeyed(c).then(|| c.escape_unicode().to_string()),
    }
}

/// The same in one line: for what may hold the names of files, which could look like messages of ours.
pub(crate) fn shown_line(text: &str) -> String {
    shown(text).replace(['\n', '\r'], "␤").replace('\t', "␉")
}

/// JSON that says the same, but in which what a terminal would obey is escaped.
pub(crate) fn escaped(json: &str) -> String {
    let mut escaped = String::with_capacity(json.len());
    for c in json.chars() {
        // All of them are within strings, and none needs two units of UTF-16.
        match is_obeyed(c) {
            true => drop(write!(escaped, "\\u{:04x}", u32::from(c))),
            false => escaped.push(c),
        }
    }
    escaped
}

/// Whether a character does something to a terminal, or to the direction of what stands behind it.
fn is_obeyed(c: char) -> bool {
    match c {
        '\n' | '\t' => false,
        '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => true,
        _ => c.is_control(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_terminal_obeys_is_seen() {
        assert_eq!(shown("\u{1b}]0;title\u{7}\u{0}\u{7f}"), "␛]0;title␇␀␡");
        assert_eq!(shown("a\u{202e}b\u{9b}c\u{2066}"), r"a\u{202e}b\u{9b}c\u{2066}");
        assert_eq!(shown("over\rwritten"), "over␍written");
        assert_eq!(shown("é\tb\r\nc\r"), "é\tb\r\nc\r");
        let text = "é\rb\u{1b}c";
        assert_eq!(["b", "c"].map(|c| shown_place(text, text.find(c).unwrap())), [5, 9]);
        assert_eq!(shown_line("a\nerror: b.csg"), "a␤error: b.csg");
    }

    #[test]
    fn json_says_the_same() {
        let text = "\u{1b}[2J\u{7f}\u{9b}\u{202e}é\n";
        let json = escaped(&serde_json::json!({ "message": text }).to_string());
        assert!(!json.contains(is_obeyed), "{json}");
        assert_eq!(serde_json::from_str::<serde_json::Value>(&json).unwrap()["message"], text);
    }
}
