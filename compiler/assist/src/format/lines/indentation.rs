//! How deep lines are indented.

use chiaro_syntax::TokenKind;

use crate::nesting::{BRACES, Nesting};
use crate::words::bracket;

/// What is open at a place, and how deep.
#[derive(Default)]
pub(super) struct Indentation {
    levels: Nesting<Level>,
    /// The statements outside of all brackets.
    outside: Statements,
    /// How deep the current line is indented.
    line: usize,
    /// In which column the current line begins in the text.
    column: usize,
    previous: Option<TokenKind>,
}

/// An open bracket.
struct Level {
    /// How deep the line is indented that the bracket stands on: the closing one goes there too.
    opener: usize,
    statements: Statements,
}

/// The statements of a block.
#[derive(Default)]
struct Statements {
    /// The heads of the statement under way, as in `for (…) if (…) translate(…)`.
    heads: Vec<Head>,
    /// Whether the statement has ended, unless there is an `else`.
    has_ended: bool,
}

/// The beginning of a statement, which others may follow.
#[derive(Clone, Copy)]
struct Head {
    /// How deep its line is indented.
    depth: usize,
    /// In which column its line begins in the text.
    column: usize,
    kind: TokenKind,
}

impl Indentation {
    /// How deep a line is indented that begins with such a token, in a column of the text.
    pub(super) fn of_line(&mut self, first: TokenKind, column: usize, is_statement: bool) -> usize {
        self.column = column;
        self.line = self.depth(first, is_statement);
        self.line
    }

    fn depth(&self, first: TokenKind, is_statement: bool) -> usize {
        if let Some((pair, false)) = bracket(first)
            && let Some(level) = self.levels.opener(pair)
        {
            return level.opener;
        }
        let (inside, statements) = match self.levels.innermost() {
            Some((_, level)) => (level.opener + 1, &level.statements),
            None => (0, &self.outside),
        };
        if !self.levels.is_block() {
            let begins_item = matches!(
                self.previous,
                Some(TokenKind::OpenParenthesis | TokenKind::OpenBracket | TokenKind::Comma | TokenKind::Semicolon)
            );
            return if begins_item || first.is_comment() { inside } else { inside + 1 };
        }
        match statements.heads.last() {
            None => inside,
            Some(_) if statements.has_ended && first == TokenKind::Else => {
                let chosen = statements.heads.iter().rev().find(|head| head.kind == TokenKind::If);
                chosen.map_or(inside, |head| head.depth)
            }
            Some(_) if statements.has_ended => inside,
            Some(head) if first == TokenKind::OpenBrace && is_statement => head.depth,
            // Some write what is transformed below the transform, on the same level. That is left to them.
            Some(head) if head.kind == TokenKind::Name && is_statement && self.column <= head.column => head.depth,
            Some(head) => head.depth + 1,
        }
    }

    /// Takes note of a token that is no comment. `is_statement` says whether a statement, or a child, can begin there.
    pub(super) fn see(&mut self, kind: TokenKind, is_statement: bool) {
        self.previous = Some(kind);
        let (depth, column) = (self.line, self.column);
        match bracket(kind) {
            Some((pair, true)) => {
                self.levels.open(pair, Level { opener: depth, statements: Statements::default() });
                return;
            }
            Some((pair, false)) => {
                self.levels.close(pair);
                if pair == BRACES {
                    self.statements().has_ended = true;
                }
                return;
            }
            None => {}
        }
        if !self.levels.is_block() {
            return;
        }
        let statements = self.statements();
        if statements.has_ended {
            statements.has_ended = false;
            if kind == TokenKind::Else {
                let chosen = statements.heads.iter().rposition(|head| head.kind == TokenKind::If);
                statements.heads.truncate(chosen.unwrap_or(0));
            } else {
                statements.heads.clear();
            }
        }
        match kind {
            TokenKind::Semicolon | TokenKind::Use | TokenKind::Include | TokenKind::UnclosedPath => {
                statements.has_ended = true;
            }
            _ if is_statement || statements.heads.is_empty() => statements.heads.push(Head { depth, column, kind }),
            _ => {}
        }
    }

    fn statements(&mut self) -> &mut Statements {
        self.levels.innermost_mut().map_or(&mut self.outside, |level| &mut level.statements)
    }
}
