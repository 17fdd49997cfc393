//! How deep lines are indented.

use chiaro_syntax::TokenKind;

use super::LEVEL;
use crate::nesting::{BRACES, Nesting};
use crate::words::bracket;

/// The most spaces in front of a line, which bounds the length of texts that are very deep.
const MOST: usize = 16 * LEVEL;

/// Where a token stands on its line, in characters.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct Column {
    /// In the text as it was.
    pub(super) from: usize,
    /// In the formatted text.
    pub(super) to: usize,
}

/// What is open at a place, and how deep. All depths are in spaces.
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
    /// Where the first token behind the bracket stands, if it is on the same line. Lines that were aligned with it stay so.
    first: Option<Column>,
    /// Whether there is no token behind the bracket yet.
    is_new: bool,
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
        self.line = self.depth(first, is_statement).min(MOST);
        if let Some(level) = self.levels.innermost_mut().filter(|_| !first.is_comment()) {
            // What begins on a line of its own is nothing to be aligned with.
            level.is_new = false;
        }
        self.line
    }

    fn depth(&self, first: TokenKind, is_statement: bool) -> usize {
        if let Some((pair, false)) = bracket(first)
            && let Some(level) = self.levels.opener(pair)
        {
            return level.opener;
        }
        let (inside, statements) = match self.levels.innermost() {
            Some((_, level)) => (level.opener + LEVEL, &level.statements),
            None => (0, &self.outside),
        };
        if !self.levels.is_block() {
            let aligned = self.levels.innermost().and_then(|(_, level)| level.first);
            if let Some(aligned) = aligned.filter(|aligned| aligned.from == self.column && aligned.to <= MOST) {
                return aligned.to;
            }
            let begins_item = matches!(
                self.previous,
                Some(TokenKind::OpenParenthesis | TokenKind::OpenBracket | TokenKind::Comma | TokenKind::Semicolon)
            );
            return if begins_item || first.is_comment() { inside } else { inside + LEVEL };
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
            Some(head) => head.depth + LEVEL,
        }
    }

    /// Takes note of a token. `is_statement` says whether a statement, or a child, can begin there.
    pub(super) fn see(&mut self, kind: TokenKind, is_statement: bool, at: Column) {
        if kind.is_comment() {
            return;
        }
        if let Some(level) = self.levels.innermost_mut().filter(|level| level.is_new) {
            level.is_new = false;
            level.first = Some(at);
        }
        self.previous = Some(kind);
        let (depth, column) = (self.line, self.column);
        match bracket(kind) {
            Some((pair, true)) => {
                self.levels
                    .open(pair, Level { opener: depth, first: None, is_new: true, statements: Statements::default() });
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
