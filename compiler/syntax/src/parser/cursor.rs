//! Walking along the tokens.

use super::Parser;
use crate::diagnostic::Diagnostic;
use crate::source::{Span, Spanned};
use crate::token::{Token, TokenKind};
use crate::tree::Name;

impl<'a> Parser<'a> {
    pub(super) fn at(&self, kind: TokenKind) -> bool {
        self.token.kind == kind
    }

    /// Reads the next token, whatever it is.
    pub(super) fn bump(&mut self) -> Token {
        let token = self.token;
        self.previous_end = token.end;
        self.token = self.ahead;
        if self.ahead_is_tainted {
            self.last_error = Some(self.token.start);
        }
        self.ahead = self.next_token();
        token
    }

    /// Reads the next token if it is of that kind.
    pub(super) fn eat(&mut self, kind: TokenKind) -> bool {
        let found = self.at(kind);
        if found {
            self.bump();
        }
        found
    }

    /// Reads a name if there is one.
    pub(super) fn eat_name(&mut self) -> Option<Spanned<Name>> {
        self.at(TokenKind::Name).then(|| self.bump_name())
    }

    /// Reads the next token, a name or a keyword, as a name.
    pub(super) fn bump_name(&mut self) -> Spanned<Name> {
        let token = self.bump();
        let name = self.intern(&self.text[token.range()]);
        Spanned::new(name, self.span(token))
    }

    /// The shared copy of a word.
    pub(super) fn intern(&mut self, word: &'a str) -> Name {
        self.names.entry(word).or_insert_with(|| Name::from(word)).clone()
    }

    pub(super) fn span(&self, token: Token) -> Span {
        Span::new(self.file, token.range())
    }

    /// From `start` to the end of what has been read.
    pub(super) fn span_from(&self, start: u32) -> Span {
        Span { file: self.file, start, end: self.previous_end.max(start) }
    }

    /// The place behind the last token read, where something is missing.
    pub(super) fn gap(&self) -> Span {
        Span { file: self.file, start: self.previous_end, end: self.previous_end }
    }

    /// Whether the next token is the first of its line.
    pub(super) fn at_line_start(&self) -> bool {
        self.text[self.previous_end as usize..self.token.start as usize].contains('\n')
    }

    /// Ends parsing with a last error about the next token.
    pub(super) fn stop(&mut self, message: String) {
        if self.stopped {
            return;
        }
        self.reports.push(Diagnostic::error(self.span(self.token), message).with_label("the rest is not read"));
        self.stopped = true;
        let end = self.token.end;
        self.token = Token { kind: TokenKind::End, start: end, end };
        self.ahead = self.token;
    }

    /// The next token that the grammar sees. What no token can be is reported here.
    fn next_token(&mut self) -> Token {
        self.ahead_is_tainted = self.ahead.kind == TokenKind::UnclosedString;
        if self.stopped {
            return self.ahead;
        }
        loop {
            let token = self.lexer.next();
            match token.kind {
                TokenKind::LineComment | TokenKind::BlockComment => {}
                TokenKind::UnclosedComment => {
                    let opener = Span::new(self.file, token.start as usize..token.start as usize + 2);
                    let error = Diagnostic::error(opener, "this comment is never closed");
                    let end = Span::new(self.file, token.range().end..token.range().end);
                    self.reports.push(error.with_hint("close it with `*/`").with_suggestion(end, " */"));
                }
                TokenKind::Unknown => {
                    self.report_unknown(token);
                    self.ahead_is_tainted = true;
                }
                TokenKind::UnclosedString => {
                    let error = Diagnostic::error(self.span(token), "this string is never closed");
                    let end = Span::new(self.file, token.range().end..token.range().end);
                    self.reports.push(error.with_hint("close it with `\"`").with_suggestion(end, "\""));
                    self.hides_braces |= self.text[token.range()].contains(['{', '}']);
                    return token;
                }
                TokenKind::UnclosedPath => {
                    let error = Diagnostic::error(self.span(token), "this path is not closed");
                    self.reports.push(error.with_hint("close it with `>` on the same line"));
                    return token;
                }
                _ => return token,
            }
        }
    }

    fn report_unknown(&mut self, token: Token) {
        let word = &self.text[token.range()];
        let is_shown = |character: &char| !character.is_control();
        let shown: String = word.chars().filter(is_shown).take(20).collect();
        let error = Diagnostic::error(self.span(token), format!("`{shown}` means nothing here"));
        let hint = match word.chars().next() {
            Some('\'' | '“' | '”' | '„' | '‘' | '’' | '«' | '»') => {
                Some("a string stands in straight double quotes: \"…\"")
            }
            Some('−' | '–' | '—') => Some("write the sign `-`"),
            Some('×' | '·') => Some("write `*` to multiply"),
            Some('\u{ff01}'..='\u{ff5e}') => Some("write the plain sign instead of the full-width one"),
            Some('≤') => Some("write `<=`"),
            Some('≥') => Some("write `>=`"),
            Some('≠') => Some("write `!=`"),
            Some(char::REPLACEMENT_CHARACTER) => Some("the file is not encoded in UTF-8"),
            Some(control) if control.is_control() => Some("there is a control character, which can't be seen"),
            Some(letter) if letter.is_alphabetic() => Some("names are made of the letters a to z, digits and `_`"),
            _ => None,
        };
        let error = match hint {
            Some(hint) => error.with_hint(hint),
            None => error,
        };
        self.reports.push(match plain_sign(word) {
            Some(sign) => error.with_suggestion(self.span(token), sign),
            None => error,
        });
    }
}

/// The sign of the language that a sign from elsewhere stands for.
fn plain_sign(word: &str) -> Option<String> {
    let mut characters = word.chars();
    let (first, None) = (characters.next()?, characters.next()) else { return None };
    Some(match first {
        '−' | '–' | '—' => "-".to_owned(),
        '×' | '·' => "*".to_owned(),
        '≤' => "<=".to_owned(),
        '≥' => ">=".to_owned(),
        '≠' => "!=".to_owned(),
        '\u{ff01}'..='\u{ff5e}' => char::from_u32(first as u32 - 0xfee0)?.to_string(),
        _ => return None,
    })
}
