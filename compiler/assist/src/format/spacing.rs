//! Whether there is a space between two tokens on one line.

use chiaro_syntax::{Token, TokenKind};

use super::roles::Role;
use crate::tokens;
use crate::words::is_operator;

/// A token and its role.
#[derive(Clone, Copy)]
pub(super) struct Word {
    pub(super) token: Token,
    pub(super) role: Role,
}

/// Whether there is to be a space between two tokens. `was_spaced` says whether there was.
pub(super) fn is_spaced(text: &str, a: Word, b: Word, was_spaced: bool) -> bool {
    use TokenKind::*;
    match (a.token.kind, b.token.kind) {
        (Unknown | UnclosedString | UnclosedPath, _) | (_, Unknown) => was_spaced,
        (_, Comma | Semicolon) => false,
        (OpenParenthesis | OpenBracket, _) | (_, CloseParenthesis | CloseBracket) => false,
        (OpenBrace, CloseBrace) => false,
        (Comma | Semicolon | OpenBrace | CloseBrace, _) | (_, OpenBrace | CloseBrace) => true,
        (a, b) if a.is_comment() || b.is_comment() => true,
        (Dot | Caret, _) | (_, Dot | Caret) => merge(text, a.token, b.token),
        _ if a.role == Role::Prefix => merge(text, a.token, b.token),
        _ if b.role == Role::Attached => false,
        _ if a.role == Role::RangeColon || b.role == Role::RangeColon => was_spaced || merge(text, a.token, b.token),
        (Assign | Colon, _) | (_, Assign | Colon) => true,
        (a, b) if is_operator(a) || is_operator(b) => true,
        _ => true,
    }
}

/// Whether two tokens without a space between would not be these two tokens.
fn merge(text: &str, a: Token, b: Token) -> bool {
    let (first, second) = (&text[a.range()], &text[b.range()]);
    if second.starts_with("//") || second.starts_with("/*") {
        return true;
    }
    let joined = format!("{first}{second} ");
    let found = tokens(&joined);
    !matches!(found[..], [one, two] if joined[one.range()] == *first && joined[two.range()] == *second
        && (one.kind, two.kind) == (a.kind, b.kind))
}
