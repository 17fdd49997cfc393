//! The lexer: text to tokens, one at a time and in linear time, whatever the text.

use nom::branch::alt;
use nom::bytes::complete::{is_not, tag, take_until, take_while, take_while1};
use nom::character::complete::{anychar, char, digit1, hex_digit1, one_of, satisfy};
use nom::combinator::{map_opt, opt, recognize, value};
use nom::multi::many0_count;
use nom::sequence::{delimited, preceded};
use nom::{IResult, Parser as _};

use crate::parser::Dialect;
use crate::token::{Token, TokenKind};

mod raw_string;

use raw_string::RawStrings;

/// The character that ends the text, as OpenSCAD has it.
const END_OF_TEXT: char = '\x03';

/// All tokens of a text, comments included, such as an editor needs for highlighting.
pub fn tokens(text: &str, dialect: Dialect) -> Vec<Token> {
    let mut lexer = Lexer::new(text, dialect);
    std::iter::from_fn(|| Some(lexer.next()).filter(|token| token.kind != TokenKind::End)).collect()
}

/// Reads tokens from a text.
pub(crate) struct Lexer<'a> {
    text: &'a str,
    rest: &'a str,
    raw_strings: Option<RawStrings>,
    /// Whether some string was never closed. From then on strings end with their line, so that the search for
    /// closing quotes takes linear time in all.
    quotes_are_odd: bool,
}

impl<'a> Lexer<'a> {
    /// A lexer at the beginning of `text`.
    pub(crate) fn new(text: &'a str, dialect: Dialect) -> Self {
        let raw_strings = (dialect == Dialect::Dump).then(RawStrings::default);
        Self { text, rest: text, raw_strings, quotes_are_odd: false }
    }

    /// The next token; [`TokenKind::End`] at the end of the text and ever after.
    pub(crate) fn next(&mut self) -> Token {
        self.rest = skip_space(self.rest);
        let start = self.text.len() - self.rest.len();
        let (kind, length) = self.scan(start);
        self.rest = &self.rest[length..];
        let token = Token { kind, start: start as u32, end: (start + length) as u32 };
        if let Some(raw_strings) = &mut self.raw_strings {
            raw_strings.see(&self.text[token.range()], kind);
        }
        token
    }

    /// Kind and length of the token that the rest of the text begins with.
    fn scan(&mut self, start: usize) -> (TokenKind, usize) {
        let rest = self.rest;
        match rest.chars().next() {
            None => (TokenKind::End, 0),
            Some(END_OF_TEXT) => {
                self.text = &self.text[..start];
                self.rest = "";
                (TokenKind::End, 0)
            }
            Some('"') => self.scan_string(start),
            Some('a'..='z' | 'A'..='Z' | '_' | '$') => scan_word(rest),
            Some('0'..='9' | '.') => scan_number(rest),
            Some(_) => scan_sign(rest),
        }
    }

    fn scan_string(&mut self, start: usize) -> (TokenKind, usize) {
        if let Some(length) = self.raw_strings.as_mut().and_then(|raw| raw.length(self.text, start)) {
            return (TokenKind::RawString, length);
        }
        let searched = if self.quotes_are_odd { &self.rest[..line_length(self.rest)] } else { self.rest };
        match matched(string, searched) {
            Some(length) => (TokenKind::String, length),
            None => {
                self.quotes_are_odd = true;
                (TokenKind::UnclosedString, line_length(self.rest))
            }
        }
    }
}

/// The text behind any white space, which includes U+00A0 and U+FEFF: editors leave them behind.
fn skip_space(text: &str) -> &str {
    text.trim_start_matches([' ', '\t', '\n', '\r', '\u{a0}', '\u{feff}'])
}

/// How much of `text` is its first line, the line break not included.
fn line_length(text: &str) -> usize {
    text.find(['\n', '\r']).unwrap_or(text.len())
}

/// How much of `text` the parser takes, if it takes any.
fn matched<'a>(mut parser: impl FnMut(&'a str) -> IResult<&'a str, &'a str>, text: &'a str) -> Option<usize> {
    parser(text).ok().map(|(_, taken)| taken.len())
}

fn scan_word(text: &str) -> (TokenKind, usize) {
    let length = matched(word, text).unwrap_or(1);
    let kind = match &text[..length] {
        "use" => TokenKind::Use,
        "include" => TokenKind::Include,
        word => return (TokenKind::of_word(word), length),
    };
    // Only a bracket makes it one of these words; otherwise it is a name like any other.
    let behind = text[length..].trim_start_matches([' ', '\t', '\n', '\r']);
    if !behind.starts_with('<') {
        return (TokenKind::Name, length);
    }
    let opened = text.len() - behind.len();
    match matched(path, behind) {
        Some(length) => (kind, opened + length),
        None => (TokenKind::UnclosedPath, opened + line_length(behind)),
    }
}

/// A number, or a name that begins with a digit: whichever takes more.
fn scan_number(text: &str) -> (TokenKind, usize) {
    let as_number = matched(number, text).unwrap_or(0);
    let as_word = matched(|text| take_while1(is_word_character)(text), text).unwrap_or(0);
    match (as_number, as_word) {
        (0, 0) => (TokenKind::Dot, 1),
        _ if as_word > as_number => (TokenKind::Name, as_word),
        _ => (TokenKind::Number, as_number),
    }
}

/// An operator, a bracket, a comment, or what is none of these.
fn scan_sign(text: &str) -> (TokenKind, usize) {
    if text.starts_with("//") {
        return (TokenKind::LineComment, line_length(text));
    }
    if text.starts_with("/*") {
        return match matched(block_comment, text) {
            Some(length) => (TokenKind::BlockComment, length),
            None => (TokenKind::UnclosedComment, text.len()),
        };
    }
    match sign(text) {
        Ok((rest, kind)) => (kind, text.len() - rest.len()),
        Err(_) => (TokenKind::Unknown, matched(unknown, text).unwrap_or(text.len())),
    }
}

fn is_word_character(character: char) -> bool {
    character.is_ascii_alphanumeric() || character == '_'
}

fn word(text: &str) -> IResult<&str, &str> {
    let begins = satisfy(|first| first.is_ascii_alphabetic() || first == '_' || first == '$');
    recognize((begins, take_while(is_word_character))).parse(text)
}

fn number(text: &str) -> IResult<&str, &str> {
    let hexadecimal = recognize((tag("0x"), hex_digit1));
    // Not nom's `digit0`: at the end of the text it answers a rest from which `recognize` can't tell what was read.
    let decimals = take_while(|digit: char| digit.is_ascii_digit());
    let whole = recognize((digit1, opt((char('.'), decimals))));
    let fraction = recognize((char('.'), digit1));
    let exponent = (one_of("eE"), opt(one_of("+-")), digit1);
    alt((hexadecimal, recognize((alt((whole, fraction)), opt(exponent))))).parse(text)
}

fn string(text: &str) -> IResult<&str, &str> {
    let piece = alt((is_not("\"\\"), recognize(preceded(char('\\'), anychar))));
    recognize(delimited(char('"'), many0_count(piece), char('"'))).parse(text)
}

fn path(text: &str) -> IResult<&str, &str> {
    recognize(delimited(char('<'), take_while(|inside| !">\r\n".contains(inside)), char('>'))).parse(text)
}

fn block_comment(text: &str) -> IResult<&str, &str> {
    recognize(delimited(tag("/*"), take_until("*/"), tag("*/"))).parse(text)
}

/// A run of characters that begin no token, so that one message is enough for them.
fn unknown(text: &str) -> IResult<&str, &str> {
    let begins_token = |character: char| {
        is_word_character(character) || " \t\n\r\u{a0}\u{feff}\x03$\"()[]{};,.:?=+-*/%^!~#&|<>".contains(character)
    };
    take_while1(|character| !begins_token(character))(text)
}

fn sign(text: &str) -> IResult<&str, TokenKind> {
    let two = alt((
        value(TokenKind::AmpersandAmpersand, tag("&&")),
        value(TokenKind::BarBar, tag("||")),
        value(TokenKind::Equal, tag("==")),
        value(TokenKind::NotEqual, tag("!=")),
        value(TokenKind::LessEqual, tag("<=")),
        value(TokenKind::GreaterEqual, tag(">=")),
        value(TokenKind::ShiftLeft, tag("<<")),
        value(TokenKind::ShiftRight, tag(">>")),
    ));
    let mut one = map_opt(anychar, single_sign);
    // Most signs of a large file are commas and brackets, which need no search for longer operators.
    match text.as_bytes().get(1) {
        Some(b'&' | b'|' | b'=' | b'<' | b'>') => alt((two, one)).parse(text),
        _ => one.parse(text),
    }
}

fn single_sign(sign: char) -> Option<TokenKind> {
    Some(match sign {
        '(' => TokenKind::OpenParenthesis,
        ')' => TokenKind::CloseParenthesis,
        '[' => TokenKind::OpenBracket,
        ']' => TokenKind::CloseBracket,
        '{' => TokenKind::OpenBrace,
        '}' => TokenKind::CloseBrace,
        ';' => TokenKind::Semicolon,
        ',' => TokenKind::Comma,
        ':' => TokenKind::Colon,
        '?' => TokenKind::Question,
        '=' => TokenKind::Assign,
        '+' => TokenKind::Plus,
        '-' => TokenKind::Minus,
        '*' => TokenKind::Star,
        '/' => TokenKind::Slash,
        '%' => TokenKind::Percent,
        '^' => TokenKind::Caret,
        '!' => TokenKind::Bang,
        '~' => TokenKind::Tilde,
        '#' => TokenKind::Hash,
        '&' => TokenKind::Ampersand,
        '|' => TokenKind::Bar,
        '<' => TokenKind::Less,
        '>' => TokenKind::Greater,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Vec<(TokenKind, &str)> {
        tokens(text, Dialect::Program).into_iter().map(|token| (token.kind, &text[token.range()])).collect()
    }

    #[test]
    fn numbers_and_names_take_as_much_as_they_can() {
        use TokenKind::{Dot, Name, Number};
        for number in ["1", "1.", "12.5", ".5", "1e-3", "1.5E+10", "0x1F", "1.e2"] {
            assert_eq!(words(number), [(Number, number)]);
        }
        for name in ["2d_shape", "$fn", "_", "1e", "0x", "0x1G", "modules"] {
            assert_eq!(words(name), [(Name, name)]);
        }
        assert_eq!(words("v.x"), [(Name, "v"), (Dot, "."), (Name, "x")]);
        assert_eq!(words("1.x"), [(Number, "1."), (Name, "x")]);
    }

    #[test]
    fn white_space_and_the_end_of_text_are_those_of_openscad() {
        let text = "\u{feff}a\u{a0}b \t\r\n c \x03 d";
        assert_eq!(words(text).iter().map(|word| word.1).collect::<String>(), "abc");
    }

    #[test]
    fn paths_are_part_of_their_word_and_use_alone_is_a_name() {
        assert_eq!(words("use <a b/c.scad>"), [(TokenKind::Use, "use <a b/c.scad>")]);
        assert_eq!(words("include<x>;").len(), 2);
        assert_eq!(words("use = 1")[0], (TokenKind::Name, "use"));
        assert_eq!(words("use <x\ny>")[0], (TokenKind::UnclosedPath, "use <x"));
    }

    #[test]
    fn what_is_never_closed_ends_somewhere_sensible() {
        assert_eq!(words("\"abc\nd"), [(TokenKind::UnclosedString, "\"abc"), (TokenKind::Name, "d")]);
        assert_eq!(
            words("a /* b */ /* c"),
            [(TokenKind::Name, "a"), (TokenKind::BlockComment, "/* b */"), (TokenKind::UnclosedComment, "/* c"),]
        );
    }

    #[test]
    fn characters_that_begin_nothing_are_one_token_per_run() {
        assert_eq!(words("a@@é b"), [(TokenKind::Name, "a"), (TokenKind::Unknown, "@@é"), (TokenKind::Name, "b"),]);
    }

    #[test]
    fn two_signs_are_one_operator_where_they_can_be() {
        use TokenKind::*;
        let kinds: Vec<_> = tokens("<<=>>&&&|||!==", Dialect::Program).into_iter().map(|token| token.kind).collect();
        assert_eq!(
            kinds,
            [ShiftLeft, Assign, ShiftRight, AmpersandAmpersand, Ampersand, BarBar, Bar, NotEqual, Assign]
        );
    }
}
