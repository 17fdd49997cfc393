//! The values of string tokens.

use std::ops::Range;

use nom::branch::alt;
use nom::bytes::complete::{is_not, take_while_m_n};
use nom::character::complete::{char, one_of, satisfy};
use nom::combinator::{map, recognize, value};
use nom::sequence::preceded;
use nom::{IResult, Parser as _};

/// A code point 0 would end OpenSCAD's strings, so that it is a space there, and here.
const INSTEAD_OF_NUL: char = ' ';

/// A part of a string.
#[derive(Clone)]
enum Piece<'a> {
    Plain(&'a str),
    Character(char),
    /// Line breaks are dropped, so that a long text can be written on several lines.
    Nothing,
    /// A code point that is no character.
    NoCharacter,
    /// A backslash that begins no escape sequence. It is dropped.
    Backslash,
}

/// The value of a string whose text between the quotes is `inside`. What is odd about it goes to `report`, each
/// with its place in `inside`.
pub(crate) fn unescape(inside: &str, mut report: impl FnMut(Range<usize>, String)) -> String {
    let mut value = String::with_capacity(inside.len());
    let mut rest = inside;
    while let Ok((behind, piece)) = piece(rest) {
        let start = inside.len() - rest.len();
        match piece {
            Piece::Plain(text) => value.push_str(text),
            Piece::Character(character) => value.push(character),
            Piece::Nothing => {}
            Piece::NoCharacter => {
                let range = start..inside.len() - behind.len();
                report(range.clone(), format!("`{}` is no Unicode character", &inside[range]));
                value.push(char::REPLACEMENT_CHARACTER);
            }
            Piece::Backslash => {
                let next = behind.chars().next();
                let range = start..start + 1 + next.map_or(0, char::len_utf8);
                let sequence = next.map_or(String::new(), |next| next.escape_debug().to_string());
                report(range, format!("`\\{sequence}` is no escape sequence"));
            }
        }
        rest = behind;
    }
    value
}

fn piece(text: &str) -> IResult<&str, Piece<'_>> {
    alt((
        map(is_not("\\\r\n"), Piece::Plain),
        value(Piece::Nothing, one_of("\r\n")),
        preceded(char('\\'), escape),
        value(Piece::Backslash, char('\\')),
    ))
    .parse(text)
}

fn escape(text: &str) -> IResult<&str, Piece<'_>> {
    alt((
        value(Piece::Character('\n'), char('n')),
        value(Piece::Character('\t'), char('t')),
        value(Piece::Character('\r'), char('r')),
        map(one_of("\\\""), Piece::Character),
        map(preceded(char('x'), ascii_code), Piece::Character),
        map(preceded(char('u'), hexadecimal(4)), character),
        map(preceded(char('U'), hexadecimal(6)), character),
    ))
    .parse(text)
}

/// Two digits up to 7F.
fn ascii_code(text: &str) -> IResult<&str, char> {
    let digits = recognize((one_of("01234567"), satisfy(|digit| digit.is_ascii_hexdigit())));
    map(digits, |digits| match u8::from_str_radix(digits, 16) {
        Ok(0) | Err(_) => INSTEAD_OF_NUL,
        Ok(code) => code as char,
    })
    .parse(text)
}

fn hexadecimal<'a>(digits: usize) -> impl FnMut(&'a str) -> IResult<&'a str, &'a str> {
    take_while_m_n(digits, digits, |digit: char| digit.is_ascii_hexdigit())
}

fn character(digits: &str) -> Piece<'static> {
    let code = u32::from_str_radix(digits, 16).ok();
    match code.and_then(char::from_u32) {
        None => Piece::NoCharacter,
        Some('\0') => Piece::Character(INSTEAD_OF_NUL),
        Some(character) => Piece::Character(character),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unescaped(inside: &str) -> (String, Vec<Range<usize>>) {
        let mut places = Vec::new();
        let value = unescape(inside, |range, _| places.push(range));
        (value, places)
    }

    #[test]
    fn escapes_become_their_characters() {
        let (value, places) = unescaped(r#"a\n\t\r\\\"\x41\x00\u0000\u00e9\U01F600"#);
        assert_eq!(value, "a\n\t\r\\\"A  é😀");
        assert!(places.is_empty());
    }

    #[test]
    fn line_breaks_are_dropped() {
        assert_eq!(unescaped("a\r\nb\nc").0, "abc");
    }

    #[test]
    fn what_is_no_escape_loses_its_backslash_and_is_reported() {
        let (value, places) = unescaped(r"\q \x8F \uD800");
        assert_eq!(value, "q x8F \u{fffd}");
        assert_eq!(places, [0..2, 3..5, 8..14]);
    }
}
