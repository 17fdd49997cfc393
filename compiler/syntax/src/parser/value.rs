//! The values of numbers and strings.

use super::Parser;
use crate::diagnostic::Diagnostic;
use crate::source::Span;
use crate::string::unescape;
use crate::token::TokenKind;
use crate::tree::ExpressionKind;

impl Parser<'_> {
    pub(super) fn number(&mut self) -> ExpressionKind {
        let token = self.bump();
        let word = &self.text[token.range()];
        let value = match word.strip_prefix("0x") {
            Some(digits) => hexadecimal(digits),
            None => word.parse().unwrap_or(f64::INFINITY),
        };
        if value.is_infinite() {
            let warning = Diagnostic::warning(self.span(token), "this number is too large and counts as infinite");
            self.reports.push(warning);
        }
        ExpressionKind::Number(value)
    }

    pub(super) fn string(&mut self) -> ExpressionKind {
        let token = self.bump();
        let quoted = &self.text[token.range()];
        let inside = match token.kind {
            TokenKind::UnclosedString => &quoted[1..],
            _ => &quoted[1..quoted.len() - 1],
        };
        if token.kind == TokenKind::RawString || !inside.contains(['\\', '\r', '\n']) {
            return ExpressionKind::String(self.intern(inside).into());
        }
        let (file, reports, begin) = (self.file, &mut self.reports, token.range().start + 1);
        let value = unescape(inside, |range, message| {
            let span = Span::new(file, begin + range.start..begin + range.end);
            reports.push(Diagnostic::warning(span, message).with_hint("a backslash is written `\\\\`"));
        });
        ExpressionKind::String(value.into())
    }
}

/// The value of hexadecimal digits, the nearest there is if they are too many for an integer.
fn hexadecimal(digits: &str) -> f64 {
    digits.chars().filter_map(|digit| digit.to_digit(16)).fold(0.0, |value, digit| value * 16.0 + f64::from(digit))
}
