//! Reporting what is wrong, and finding a place to go on.

use super::Parser;
use crate::diagnostic::Diagnostic;
use crate::token::{Token, TokenKind};

/// The longest word that a message repeats in full.
const MAX_SHOWN_CHARACTERS: usize = 40;

impl Parser<'_> {
    /// Reports an error about the next token, unless one has been reported about it.
    pub(super) fn error(&mut self, error: Diagnostic) {
        if !self.stopped && self.last_error != Some(self.token.start) {
            self.last_error = Some(self.token.start);
            self.reports.push(error);
        }
    }

    /// Reports that something else than `expected` was found.
    #[inline(never)]
    pub(super) fn expected(&mut self, expected: &str) {
        let error = self.unexpected(expected);
        self.error(error);
    }

    /// Reports that something else than `expected` was found, and how to mend it.
    #[inline(never)]
    pub(super) fn expected_but(&mut self, expected: &str, hint: &str) {
        let error = self.unexpected(expected).with_hint(hint);
        self.error(error);
    }

    /// Reports that something is missing behind the last token.
    #[inline(never)]
    pub(super) fn missing(&mut self, what: &str, hint: &str) {
        let error = Diagnostic::error(self.gap(), format!("missing {what}")).with_hint(hint);
        self.error(error);
    }

    /// Reports that a block ends with the file, unless its end may be in a string that is never closed.
    #[inline(never)]
    pub(super) fn unclosed_block(&mut self, opener: Token) {
        if self.hides_braces {
            return;
        }
        let error = Diagnostic::error(self.gap(), "missing `}` at the end of the file");
        let error = error.with_suggestion(self.gap(), "\n}");
        // Every open block is worth a message.
        self.last_error = None;
        self.error(error.with_related(self.span(opener), "this `{` is never closed"));
    }

    /// Reports a `}` that closes nothing, unless its `{` may be in a string that is never closed.
    #[inline(never)]
    pub(super) fn unmatched_brace(&mut self) {
        if !self.hides_braces {
            let error = Diagnostic::error(self.span(self.token), "unmatched `}`");
            self.error(error.with_hint("nothing is open that it could close"));
        }
    }

    /// The error that something else than `expected` was found.
    pub(super) fn unexpected(&self, expected: &str) -> Diagnostic {
        Diagnostic::error(self.span(self.token), format!("expected {expected}, found {}", self.found()))
    }

    /// What the next token is, for a message.
    fn found(&self) -> String {
        let word = &self.text[self.token.range()];
        let shown = match word.char_indices().nth(MAX_SHOWN_CHARACTERS) {
            Some((end, _)) => format!("{}…", &word[..end]),
            None => word.to_owned(),
        };
        match self.token.kind {
            TokenKind::End => "the end of the file".to_owned(),
            TokenKind::String | TokenKind::RawString | TokenKind::UnclosedString => "a string".to_owned(),
            TokenKind::Name => format!("the name `{shown}`"),
            TokenKind::Number => format!("the number `{shown}`"),
            _ => format!("`{shown}`"),
        }
    }

    /// Reads an opening bracket, to be closed by [`Parser::close`].
    pub(super) fn open(&mut self) -> Token {
        match self.token.kind {
            TokenKind::OpenParenthesis => self.open.parentheses += 1,
            TokenKind::OpenBracket => self.open.brackets += 1,
            _ => {}
        }
        self.bump()
    }

    /// Reads the closing bracket that belongs to `opener`. If there is something else, it is reported, and skipped
    /// unless the bracket just seems forgotten.
    pub(super) fn close(&mut self, opener: Token, expected: &str) {
        let closer = closer(opener);
        if !self.at(closer) {
            self.bracket_error(opener, expected);
            self.skip_in_brackets(&[closer]);
            if self.ends_brackets() {
                // Brackets around this one may be unclosed for the same reason.
                self.last_error = Some(self.token.start);
            }
        }
        self.eat(closer);
        match opener.kind {
            TokenKind::OpenParenthesis => self.open.parentheses -= 1,
            _ => self.open.brackets -= 1,
        }
    }

    /// Reads the commas behind an item of a list. What stands where it or the closing bracket should is reported and
    /// skipped. Answers whether the list goes on.
    pub(super) fn next_item(&mut self, opener: Token) -> bool {
        let closer = closer(opener);
        if !self.at(TokenKind::Comma) && !self.at(closer) && !self.ends_brackets() {
            let is_bracket = closer == TokenKind::CloseBracket;
            self.bracket_error(opener, if is_bracket { "`,` or `]`" } else { "`,` or `)`" });
            self.skip_in_brackets(&[TokenKind::Comma, closer]);
            if self.ends_brackets() {
                // That the bracket is not closed has been said by that.
                self.last_error = Some(self.token.start);
            }
        }
        self.skip_commas()
    }

    /// Reads commas. OpenSCAD takes several as one, and some in front of the first item as none. Answers whether there
    /// are any.
    pub(super) fn skip_commas(&mut self) -> bool {
        let found = self.eat(TokenKind::Comma);
        while self.eat(TokenKind::Comma) {}
        found
    }

    /// Reports that something else than `expected`, or nothing, stands where the bracket `opener` should close.
    #[inline(never)]
    fn bracket_error(&mut self, opener: Token, expected: &str) {
        let (sign, missing, closer) = match opener.kind {
            TokenKind::OpenParenthesis => ("`(`", "missing `)`", ")"),
            _ => ("`[`", "missing `]`", "]"),
        };
        let error = if self.ends_brackets() {
            Diagnostic::error(self.gap(), missing).with_suggestion(self.gap(), closer)
        } else {
            self.unexpected(expected)
        };
        let error = error.with_related(self.span(opener), format!("{sign} is opened here"));
        let error = match self.token.kind {
            TokenKind::Assign => {
                error.with_hint("`==` compares two values").with_suggestion(self.span(self.token), "==")
            }
            kind if kind.begins_expression() && expected.contains(',') => {
                error.with_hint("`,` separates values").with_suggestion(self.gap(), ",")
            }
            _ => error,
        };
        self.error(error);
    }

    /// Whether the next token shows that the innermost bracket has been left open.
    fn ends_brackets(&self) -> bool {
        match self.token.kind {
            TokenKind::End
            | TokenKind::Semicolon
            | TokenKind::OpenBrace
            | TokenKind::CloseBrace
            | TokenKind::Module
            | TokenKind::Use
            | TokenKind::Include
            | TokenKind::UnclosedPath => true,
            TokenKind::Function => self.ahead.kind == TokenKind::Name,
            TokenKind::CloseParenthesis => self.open.parentheses > 0,
            TokenKind::CloseBracket => self.open.brackets > 0,
            _ => false,
        }
    }

    /// Skips tokens, in whole brackets, up to one of `stops` or where the brackets end.
    pub(super) fn skip_in_brackets(&mut self, stops: &[TokenKind]) {
        let mut nesting = 0_usize;
        loop {
            let kind = self.token.kind;
            match kind {
                _ if nesting == 0 && stops.contains(&kind) => return,
                TokenKind::OpenParenthesis | TokenKind::OpenBracket => nesting += 1,
                TokenKind::CloseParenthesis | TokenKind::CloseBracket if nesting > 0 => nesting -= 1,
                _ if self.ends_brackets() => return,
                _ => {}
            }
            self.bump();
        }
    }

    /// Skips a whole `{ … }`.
    pub(super) fn skip_braces(&mut self) {
        let mut nesting = 0_usize;
        loop {
            match self.bump().kind {
                TokenKind::OpenBrace => nesting += 1,
                TokenKind::CloseBrace => nesting -= 1,
                TokenKind::End => return,
                _ => {}
            }
            if nesting == 0 {
                return;
            }
        }
    }

    /// Skips the rest of a statement: its `;`, or up to a brace or the beginning of another statement.
    pub(super) fn skip_statement(&mut self) {
        loop {
            match self.token.kind {
                TokenKind::End | TokenKind::OpenBrace | TokenKind::CloseBrace => return,
                TokenKind::Semicolon => {
                    self.bump();
                    return;
                }
                _ if self.at_statement() => return,
                _ => {}
            }
            self.bump();
        }
    }

    /// Whether the next token quite certainly begins a statement.
    pub(super) fn at_statement(&self) -> bool {
        let is_applied = matches!(self.ahead.kind, TokenKind::OpenParenthesis | TokenKind::Assign);
        match self.token.kind {
            TokenKind::Module | TokenKind::Use | TokenKind::Include | TokenKind::If => true,
            TokenKind::Function => self.ahead.kind == TokenKind::Name,
            kind if kind.names_module() => is_applied && self.at_line_start(),
            kind => kind.begins_statement() && self.at_line_start(),
        }
    }

    /// Reads the `;` behind `what`. A forgotten one is reported where it should stand.
    pub(super) fn semicolon(&mut self, what: &str) {
        if self.eat(TokenKind::Semicolon) {
            return;
        }
        let is_forgotten = self.at_statement()
            || matches!(self.token.kind, TokenKind::End | TokenKind::CloseBrace)
            || self.token.kind.names_module()
                && matches!(self.ahead.kind, TokenKind::OpenParenthesis | TokenKind::Assign);
        if is_forgotten {
            let error = Diagnostic::error(self.gap(), format!("missing `;` behind {what}"));
            self.error(error.with_suggestion(self.gap(), ";"));
        } else {
            let error = self.unexpected("`;`");
            self.error(self.with_statement_hint(error));
            self.skip_statement();
        }
    }

    pub(super) fn with_statement_hint(&self, error: Diagnostic) -> Diagnostic {
        match self.token.kind {
            TokenKind::Assign => error.with_hint("`==` compares two values"),
            TokenKind::CloseParenthesis | TokenKind::CloseBracket => {
                error.with_hint("nothing is open that it could close")
            }
            TokenKind::Comma => error.with_hint("a list stands in brackets: `[1, 2]`"),
            _ => error,
        }
    }
}

/// The kind of bracket that closes `opener`.
fn closer(opener: Token) -> TokenKind {
    match opener.kind {
        TokenKind::OpenParenthesis => TokenKind::CloseParenthesis,
        _ => TokenKind::CloseBracket,
    }
}
