//! How deep lines are indented.

use chiaro_syntax::TokenKind;

use crate::words::bracket;

/// What is open at a place, and how deep.
#[derive(Default)]
pub(super) struct Indentation {
    levels: Vec<Level>,
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
    pair: usize,
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
            && let Some(level) = self.opener(pair)
        {
            return self.levels[level].opener;
        }
        let inside = self.levels.last().map_or(0, |level| level.opener + 1);
        let (pair, statements) = match self.levels.last() {
            Some(level) => (level.pair, &level.statements),
            None => (2, &self.outside),
        };
        if pair != 2 {
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

    /// The innermost open bracket of that pair, but none outside of braces.
    fn opener(&self, pair: usize) -> Option<usize> {
        let found = self.levels.iter().rposition(|level| level.pair == pair || level.pair == 2)?;
        (self.levels[found].pair == pair).then_some(found)
    }

    /// Takes note of a token that is no comment. `is_statement` says whether a statement, or a child, can begin there.
    pub(super) fn see(&mut self, kind: TokenKind, is_statement: bool) {
        self.previous = Some(kind);
        let (depth, column) = (self.line, self.column);
        match bracket(kind) {
            Some((pair, true)) => {
                self.levels.push(Level { pair, opener: depth, statements: Statements::default() });
                return;
            }
            Some((pair, false)) => {
                if let Some(level) = self.opener(pair) {
                    self.levels.truncate(level);
                }
                if pair == 2 {
                    self.statements().has_ended = true;
                }
                return;
            }
            None => {}
        }
        if self.levels.last().is_some_and(|level| level.pair != 2) {
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
        self.levels.last_mut().map_or(&mut self.outside, |level| &mut level.statements)
    }
}
