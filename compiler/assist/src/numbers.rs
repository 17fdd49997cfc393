//! The numbers of a text, and how they change when they are dragged.

use std::ops::Range;

use chiaro_syntax::{Token, TokenKind};

use crate::tokens;
use crate::words::{ends_operand, is_word};

mod scrub;

pub use scrub::scrub;

/// A number that is written out in the text.
#[derive(Clone, Debug, PartialEq)]
pub struct NumberLiteral {
    /// The digits, and the sign that stands right in front of them.
    pub range: Range<usize>,
    /// The value, sign included. Numbers that are too large are infinite.
    pub value: f64,
    /// Whether a minus sign is part of the range.
    pub negative: bool,
}

/// All numbers of a text, in its order. A minus sign belongs to the number behind it where it is no subtraction.
pub fn numbers(text: &str) -> Vec<NumberLiteral> {
    let tokens: Vec<_> = tokens(text).into_iter().filter(|token| !token.kind.is_comment()).collect();
    let mut numbers = Vec::new();
    for (at, token) in tokens.iter().enumerate() {
        if token.kind != TokenKind::Number {
            continue;
        }
        let before = |count: usize| at.checked_sub(count).map(|before| tokens[before]);
        let sign = before(1).filter(|sign| sign.kind == TokenKind::Minus && sign.end == token.start);
        // Without the sign, the number would become part of a word that stands right in front of it.
        let is_apart = |sign: Token| before(2).is_none_or(|word| !is_word(word.kind) || word.end < sign.start);
        let has_operand = before(2).is_some_and(|operand| ends_operand(operand.kind));
        let sign = sign.filter(|sign| !has_operand && is_apart(*sign));
        // `-2 ^ 2` is the negative of a power, whose sign is not the base's.
        let is_base = tokens.get(at + 1).is_some_and(|next| next.kind == TokenKind::Caret);
        let sign = sign.filter(|_| !is_base);
        let start = sign.map_or(token.start, |sign| sign.start) as usize;
        let magnitude = value(&text[token.range()]);
        let value = if sign.is_some() { -magnitude } else { magnitude };
        numbers.push(NumberLiteral { range: start..token.end as usize, value, negative: sign.is_some() });
    }
    numbers
}

/// The value of a number without a sign, as the language reads it.
pub(crate) fn value(word: &str) -> f64 {
    match word.strip_prefix("0x") {
        Some(digits) => {
            let digits = digits.chars().filter_map(|digit| digit.to_digit(16));
            digits.fold(0.0, |value, digit| value * 16.0 + f64::from(digit))
        }
        None => word.parse().unwrap_or(f64::INFINITY),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The literals' texts and values.
    fn found(text: &str) -> Vec<(&str, f64)> {
        numbers(text).into_iter().map(|number| (&text[number.range], number.value)).collect()
    }

    #[test]
    fn signs_belong_to_numbers_where_they_are_no_subtraction() {
        assert_eq!(
            found("a = -1.5; b = 3 -2; c = [-.5, 2]-1;"),
            [("-1.5", -1.5), ("3", 3.0), ("2", 2.0), ("-.5", -0.5), ("2", 2.0), ("1", 1.0)]
        );
        assert_eq!(found("a = f(-1e-3) - -2 + - 4;"), [("-1e-3", -0.001), ("-2", -2.0), ("4", 4.0)]);
    }

    #[test]
    fn the_sign_in_front_of_a_power_is_not_the_bases() {
        assert_eq!(found("a = -2 ^ -3;"), [("2", 2.0), ("-3", -3.0)]);
    }

    #[test]
    fn texts_comments_and_names_hold_no_numbers() {
        assert_eq!(found("a2 = \"3\"; // 4\n2d = 0x1F;"), [("0x1F", 31.0)]);
    }
}
