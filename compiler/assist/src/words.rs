//! Tokens and the places between them.

use chiaro_syntax::{Token, TokenKind};

use crate::nesting::Nesting;

/// The greatest character boundary of a text at or before an offset.
pub(crate) fn boundary(text: &str, offset: usize) -> usize {
    let mut offset = offset.min(text.len());
    while !text.is_char_boundary(offset) {
        offset -= 1;
    }
    offset
}

/// The token around an offset, or the one that ends there.
pub(crate) fn token_at(tokens: &[Token], offset: usize) -> Option<Token> {
    let behind = tokens.partition_point(|token| token.start as usize <= offset);
    let last = *tokens[..behind].last()?;
    if offset < last.end as usize {
        // At the beginning of a sign, the word before it is meant.
        let before = behind.checked_sub(2).map(|before| tokens[before]);
        let ends_here = |token: &Token| token.end as usize == offset && is_word(token.kind);
        let is_sign = last.start as usize == offset && !is_word(last.kind);
        return before.filter(|token| is_sign && ends_here(token)).or(Some(last));
    }
    (offset == last.end as usize).then_some(last)
}

/// Whether a token is a name, a number or a keyword.
pub(crate) fn is_word(kind: TokenKind) -> bool {
    matches!(kind, TokenKind::Name | TokenKind::Number) || is_keyword(kind)
}

/// Whether a token is a keyword.
pub(crate) fn is_keyword(kind: TokenKind) -> bool {
    matches!(
        kind,
        TokenKind::Module
            | TokenKind::Function
            | TokenKind::If
            | TokenKind::Else
            | TokenKind::Let
            | TokenKind::Assert
            | TokenKind::Echo
            | TokenKind::For
            | TokenKind::Each
            | TokenKind::True
            | TokenKind::False
            | TokenKind::Undef
    )
}

/// Whether an operand can end with a token, so that a sign behind it has two operands.
pub(crate) fn ends_operand(kind: TokenKind) -> bool {
    matches!(
        kind,
        TokenKind::Name
            | TokenKind::Number
            | TokenKind::String
            | TokenKind::RawString
            | TokenKind::UnclosedString
            | TokenKind::True
            | TokenKind::False
            | TokenKind::Undef
            | TokenKind::CloseParenthesis
            | TokenKind::CloseBracket
    )
}

/// Whether a token is a sign between two operands, or in front of one.
pub(crate) fn is_operator(kind: TokenKind) -> bool {
    matches!(
        kind,
        TokenKind::Question
            | TokenKind::Plus
            | TokenKind::Minus
            | TokenKind::Star
            | TokenKind::Slash
            | TokenKind::Percent
            | TokenKind::Caret
            | TokenKind::Bang
            | TokenKind::Tilde
            | TokenKind::Hash
            | TokenKind::Ampersand
            | TokenKind::AmpersandAmpersand
            | TokenKind::Bar
            | TokenKind::BarBar
            | TokenKind::Equal
            | TokenKind::NotEqual
            | TokenKind::Less
            | TokenKind::LessEqual
            | TokenKind::Greater
            | TokenKind::GreaterEqual
            | TokenKind::ShiftLeft
            | TokenKind::ShiftRight
    )
}

/// Whether a token may be a modifier character.
pub(crate) fn is_modifier(kind: TokenKind) -> bool {
    matches!(kind, TokenKind::Star | TokenKind::Bang | TokenKind::Hash | TokenKind::Percent)
}

/// How a kind of bracket pairs: the pair's number, and whether it opens.
pub(crate) fn bracket(kind: TokenKind) -> Option<(usize, bool)> {
    Some(match kind {
        TokenKind::OpenParenthesis => (0, true),
        TokenKind::CloseParenthesis => (0, false),
        TokenKind::OpenBracket => (1, true),
        TokenKind::CloseBracket => (1, false),
        TokenKind::OpenBrace => (2, true),
        TokenKind::CloseBrace => (2, false),
        _ => return None,
    })
}

/// Follows whether the next token begins a statement, stands in a value, or inside of brackets.
#[derive(Default)]
pub(crate) struct Position {
    nesting: Nesting<()>,
    /// Whether an assignment's value has begun at the level of statements.
    in_value: bool,
    previous: Option<TokenKind>,
}

impl Position {
    /// Whether a module instantiated, a definition or a modifier character can stand here.
    pub(crate) fn is_statement(&self) -> bool {
        if self.in_value || !self.nesting.is_block() {
            return false;
        }
        match self.previous {
            None => true,
            Some(kind) => {
                is_modifier(kind)
                    || matches!(
                        kind,
                        TokenKind::Semicolon
                            | TokenKind::OpenBrace
                            | TokenKind::CloseBrace
                            | TokenKind::CloseParenthesis
                            | TokenKind::Else
                            | TokenKind::Use
                            | TokenKind::Include
                            | TokenKind::UnclosedPath
                    )
            }
        }
    }

    /// The innermost open bracket, as [`bracket`] numbers it.
    pub(crate) fn innermost(&self) -> Option<usize> {
        self.nesting.innermost().map(|(pair, _)| pair)
    }

    /// Takes note of a token. To be called for each that is no comment.
    pub(crate) fn see(&mut self, kind: TokenKind) {
        match bracket(kind) {
            Some((pair, true)) => self.nesting.open(pair, ()),
            Some((pair, false)) => {
                self.nesting.close(pair);
            }
            None => {}
        }
        match kind {
            TokenKind::Assign if self.nesting.is_block() => self.in_value = true,
            TokenKind::Semicolon | TokenKind::OpenBrace | TokenKind::CloseBrace => self.in_value = false,
            _ => {}
        }
        self.previous = Some(kind);
    }
}
