//! The colours of a text: what kind of word each one is.

use std::ops::Range;

use chiaro_syntax::{Token, TokenKind};
use rustc_hash::FxHashSet;

use crate::words::{Position, is_keyword, is_operator};
use crate::{manual, tokens};

/// What kind of word a part of a text is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// `module`, `if`, `true`, …
    Keyword,
    /// A module of the language: `cube`, `union`, …
    BuiltInModule,
    /// A function of the language: `sin`, `len`, …
    BuiltInFunction,
    /// A module that is not the language's own.
    Module,
    /// A function that is not the language's own.
    Function,
    /// The name of a parameter, where it is defined or given a value.
    Parameter,
    /// Any other name.
    Variable,
    /// A variable that follows the calls: `$fn`, `$t`, …
    SpecialVariable,
    /// A number.
    Number,
    /// A text, or the path of `use` and `include`.
    String,
    /// A comment.
    Comment,
    /// `+`, `=`, `?`, …
    Operator,
    /// Brackets, commas, semicolons.
    Punctuation,
    /// `#`, `%`, `!` or `*` in front of a module.
    Modifier,
    /// What means nothing, or is never closed.
    Error,
}

/// A part of a text and its kind.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Highlight {
    /// The bytes.
    pub range: Range<usize>,
    /// What they are.
    pub kind: Kind,
}

/// The kinds of all words of a text, in its order. Between them there is only white space.
///
/// It takes time in proportion to the text's length: a few milliseconds for 100 kB.
pub fn highlight(text: &str) -> Vec<Highlight> {
    let tokens = tokens(text);
    let grammar: Vec<Token> = tokens.iter().copied().filter(|token| !token.kind.is_comment()).collect();
    let own = Own::of(text, &grammar);
    let mut position = Position::default();
    let mut previous = None;
    let mut next = 0;
    let mut highlights = Vec::with_capacity(tokens.len());
    for token in tokens {
        if token.kind.is_comment() {
            let kind = if token.kind == TokenKind::UnclosedComment { Kind::Error } else { Kind::Comment };
            highlights.push(Highlight { range: token.range(), kind });
            continue;
        }
        next += 1;
        let context = Context {
            own: &own,
            previous,
            next: grammar.get(next).map(|token| token.kind),
            is_statement: position.is_statement(),
            in_parentheses: position.innermost() == Some(0),
        };
        mark(text, token, &context, &mut highlights);
        position.see(token.kind);
        previous = Some(token.kind);
    }
    highlights
}

/// What stands around a token.
struct Context<'a> {
    own: &'a Own<'a>,
    previous: Option<TokenKind>,
    next: Option<TokenKind>,
    is_statement: bool,
    in_parentheses: bool,
}

/// The modules and functions that the text defines.
struct Own<'a> {
    modules: FxHashSet<&'a str>,
    functions: FxHashSet<&'a str>,
}

impl<'a> Own<'a> {
    fn of(text: &'a str, tokens: &[Token]) -> Self {
        let defined = |keyword: TokenKind| {
            let pairs =
                tokens.windows(2).filter(move |pair| pair[0].kind == keyword && pair[1].kind == TokenKind::Name);
            pairs.map(|pair| &text[pair[1].range()]).collect()
        };
        Self { modules: defined(TokenKind::Module), functions: defined(TokenKind::Function) }
    }
}

/// Adds what a token is. The word of a `use <…>` is a keyword, and the path a text.
fn mark(text: &str, token: Token, context: &Context, highlights: &mut Vec<Highlight>) {
    let range = token.range();
    match token.kind {
        TokenKind::Use | TokenKind::Include => {
            let path = text[range.clone()].find('<').map_or(range.end, |at| range.start + at);
            let word = range.start + text[range.start..path].trim_end().len();
            highlights.push(Highlight { range: range.start..word, kind: Kind::Keyword });
            highlights.push(Highlight { range: path..range.end, kind: Kind::String });
        }
        kind => {
            let kind = kind_of(kind, &text[range.clone()], context);
            highlights.push(Highlight { range, kind });
        }
    }
}

fn kind_of(kind: TokenKind, word: &str, context: &Context) -> Kind {
    match kind {
        TokenKind::Name => kind_of_name(word, context),
        TokenKind::Number => Kind::Number,
        TokenKind::String | TokenKind::RawString => Kind::String,
        TokenKind::UnclosedString | TokenKind::UnclosedPath | TokenKind::Unknown => Kind::Error,
        TokenKind::Star | TokenKind::Bang | TokenKind::Hash | TokenKind::Percent if context.is_statement => {
            Kind::Modifier
        }
        TokenKind::Assign => Kind::Operator,
        kind if is_keyword(kind) => Kind::Keyword,
        kind if is_operator(kind) => Kind::Operator,
        _ => Kind::Punctuation,
    }
}

fn kind_of_name(word: &str, context: &Context) -> Kind {
    match context.previous {
        Some(TokenKind::Module) => return Kind::Module,
        Some(TokenKind::Function) => return Kind::Function,
        Some(TokenKind::Dot) => return Kind::Variable,
        _ => {}
    }
    match context.next {
        _ if word.starts_with('$') => Kind::SpecialVariable,
        Some(TokenKind::Assign) if context.in_parentheses => Kind::Parameter,
        Some(TokenKind::OpenParenthesis) if context.is_statement => {
            let is_built_in = !context.own.modules.contains(word) && manual::module(word).is_some();
            if is_built_in { Kind::BuiltInModule } else { Kind::Module }
        }
        Some(TokenKind::OpenParenthesis) => {
            let is_built_in = !context.own.functions.contains(word) && manual::function(word).is_some();
            if is_built_in { Kind::BuiltInFunction } else { Kind::Function }
        }
        _ => Kind::Variable,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Words and their kinds.
    fn kinds(text: &str) -> Vec<(&str, Kind)> {
        highlight(text).into_iter().map(|highlight| (&text[highlight.range], highlight.kind)).collect()
    }

    /// The kind of the first occurrence of a word.
    fn kind(text: &str, word: &str) -> Kind {
        kinds(text).into_iter().find(|(other, _)| *other == word).unwrap_or_else(|| panic!("{word} in {text}")).1
    }

    #[test]
    fn each_word_has_its_kind() {
        let text = "use <a.scad>\n// c\nmodule wall(h = 2) { #cube([h, len(\"s\"), $fn]); }\nwall(h = 1.5); @";
        assert_eq!(
            kinds(text),
            [
                ("use", Kind::Keyword),
                ("<a.scad>", Kind::String),
                ("// c", Kind::Comment),
                ("module", Kind::Keyword),
                ("wall", Kind::Module),
                ("(", Kind::Punctuation),
                ("h", Kind::Parameter),
                ("=", Kind::Operator),
                ("2", Kind::Number),
                (")", Kind::Punctuation),
                ("{", Kind::Punctuation),
                ("#", Kind::Modifier),
                ("cube", Kind::BuiltInModule),
                ("(", Kind::Punctuation),
                ("[", Kind::Punctuation),
                ("h", Kind::Variable),
                (",", Kind::Punctuation),
                ("len", Kind::BuiltInFunction),
                ("(", Kind::Punctuation),
                ("\"s\"", Kind::String),
                (")", Kind::Punctuation),
                (",", Kind::Punctuation),
                ("$fn", Kind::SpecialVariable),
                ("]", Kind::Punctuation),
                (")", Kind::Punctuation),
                (";", Kind::Punctuation),
                ("}", Kind::Punctuation),
                ("wall", Kind::Module),
                ("(", Kind::Punctuation),
                ("h", Kind::Parameter),
                ("=", Kind::Operator),
                ("1.5", Kind::Number),
                (")", Kind::Punctuation),
                (";", Kind::Punctuation),
                ("@", Kind::Error),
            ]
        );
    }

    #[test]
    fn a_name_that_is_both_is_what_its_place_says() {
        assert_eq!(kind("round(2) cube(1);", "round"), Kind::BuiltInModule);
        assert_eq!(kind("a = 2 * round(2);", "round"), Kind::BuiltInFunction);
        assert_eq!(kind("module round() {} round(2);", "round"), Kind::Module);
        assert_eq!(kind("translate([1, 0, 0]) mine();", "mine"), Kind::Module);
    }

    #[test]
    fn signs_are_modifiers_only_in_front_of_modules() {
        assert_eq!(kind("translate([1, 0, 0]) %cube(1);", "%"), Kind::Modifier);
        assert_eq!(kind("a = (3) % 2;", "%"), Kind::Operator);
        assert_eq!(kind("*cube(2 * 3);", "*"), Kind::Modifier);
        assert_eq!(kind("cube(2 * 3);", "*"), Kind::Operator);
    }

    #[test]
    fn what_is_never_closed_is_an_error() {
        assert_eq!(kind("a = \"b", "\"b"), Kind::Error);
        assert_eq!(kind("a = 1; /* b", "/* b"), Kind::Error);
    }
}
