//! What signs are there for, which decides how they are spaced.

use chiaro_syntax::{Token, TokenKind};

use crate::nesting::Nesting;
use crate::words::{Position, bracket, ends_operand};

/// What a token is there for, beyond what its kind says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// Nothing beyond its kind.
    Plain,
    /// A sign in front of its only operand, or a modifier character.
    Prefix,
    /// A bracket that belongs to the word in front of it: a call's, or an index's.
    Attached,
    /// The bracket that closes what stands behind `for`, `if` and the like.
    ClosesHead,
    /// A `:` between the parts of a range.
    RangeColon,
}

/// A bracket that is open.
struct Open {
    /// Whether a word such as `for` stands in front of it.
    is_head: bool,
    /// How many `?` wait for their `:`.
    questions: usize,
}

/// The roles of tokens, none of which is a comment.
pub(super) fn roles(text: &str, tokens: &[Token]) -> Vec<Role> {
    let mut position = Position::default();
    let mut open: Nesting<Open> = Nesting::default();
    let mut outside_questions = 0;
    let mut roles: Vec<Role> = Vec::with_capacity(tokens.len());
    for (at, token) in tokens.iter().enumerate() {
        let previous = at.checked_sub(1).map(|before| (tokens[before], roles[before]));
        let has_operand = previous.is_some_and(|(token, role)| ends_operand(token.kind) && role != Role::ClosesHead);
        let questions = open.innermost_mut().map_or(&mut outside_questions, |open| &mut open.questions);
        let role =
            match token.kind {
                TokenKind::Star | TokenKind::Percent | TokenKind::Hash | TokenKind::Bang if position.is_statement() => {
                    Role::Prefix
                }
                TokenKind::Plus | TokenKind::Minus | TokenKind::Bang | TokenKind::Tilde if !has_operand => Role::Prefix,
                TokenKind::OpenParenthesis
                    if previous.is_some_and(|(token, _)| is_called(text, token)) || has_operand =>
                {
                    if previous.is_some_and(|(token, _)| is_head(text, token)) { Role::Plain } else { Role::Attached }
                }
                TokenKind::OpenBracket if has_operand => Role::Attached,
                TokenKind::Question => {
                    *questions += 1;
                    Role::Plain
                }
                TokenKind::Colon if *questions == 0 => Role::RangeColon,
                TokenKind::Colon => {
                    *questions -= 1;
                    Role::Plain
                }
                TokenKind::Semicolon => {
                    *questions = 0;
                    Role::Plain
                }
                TokenKind::CloseParenthesis if open.opener(0).is_some_and(|open| open.is_head) => Role::ClosesHead,
                _ => Role::Plain,
            };
        match bracket(token.kind) {
            Some((pair, true)) => {
                let is_head = pair == 0 && previous.is_some_and(|(token, _)| begins_body(text, tokens, at, token));
                open.open(pair, Open { is_head, questions: 0 });
            }
            Some((pair, false)) => {
                open.close(pair);
            }
            None => {}
        }
        position.see(token.kind);
        roles.push(role);
    }
    roles
}

/// Whether a parenthesis behind a word follows it without a space.
fn is_called(text: &str, token: Token) -> bool {
    matches!(token.kind, TokenKind::Assert | TokenKind::Echo) || token.kind == TokenKind::Name && !is_head(text, token)
}

/// Whether a word stands in front of a parenthesis with a space between.
fn is_head(text: &str, token: Token) -> bool {
    match token.kind {
        TokenKind::For | TokenKind::If | TokenKind::Let | TokenKind::Function | TokenKind::Each | TokenKind::Else => {
            true
        }
        TokenKind::Name => &text[token.range()] == "intersection_for",
        _ => false,
    }
}

/// Whether behind the parentheses that open at a token, with a word in front, an expression can begin.
fn begins_body(text: &str, tokens: &[Token], at: usize, word: Token) -> bool {
    let is_defined = at >= 2 && matches!(tokens[at - 2].kind, TokenKind::Module);
    is_defined
        || matches!(word.kind, TokenKind::Assert | TokenKind::Echo)
        || is_head(text, word) && !matches!(word.kind, TokenKind::Each | TokenKind::Else)
}
