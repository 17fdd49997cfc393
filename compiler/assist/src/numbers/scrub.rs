//! How a number changes when it is dragged.

/// From this magnitude on, steps are a larger part of the number.
const LARGE: f64 = 100.0;
/// Which part of a large number a step is, at most.
const LARGE_PART: f64 = 0.05;
/// Which part of any other number a step is, at most, unless its last digit is more.
const SMALL_PART: f64 = 0.005;
/// The most decimals that are written.
const MOST_DECIMALS: usize = 17;

/// The literal that many steps on. It has as many decimals as before, its exponent stays, and it is never `-0`.
///
/// A step is 1 in the last digit; where that would be little of the number, the greatest of 1, 2, 5, 10, 20, 50, … in
/// that digit which is at most 0.5 % of it, or 5 % from 100 on: 0.1 for `1.5`, 1 for `10`, 5 for `100`, 0.05 for
/// `12.345`. Steps refer to the literal as it is given: a drag should pass the one that it began with, and the steps since
/// then, so that going back leads back. What is no number stays as it is.
pub fn scrub(literal: &str, steps: f64) -> String {
    let changed = Literal::read(literal).and_then(|literal| literal.moved(steps));
    changed.unwrap_or_else(|| literal.to_owned())
}

/// A number as it is written.
struct Literal<'a> {
    /// The number without its exponent.
    mantissa: f64,
    /// How many digits stand behind the point.
    decimals: usize,
    /// From the `e` on.
    exponent: &'a str,
    /// Whether there is no digit in front of the point.
    begins_with_point: bool,
    /// Whether the mantissa's last character is the point.
    ends_with_point: bool,
    is_hexadecimal: bool,
}

impl<'a> Literal<'a> {
    fn read(text: &'a str) -> Option<Self> {
        let (is_negative, digits) = match text.trim().strip_prefix('-') {
            Some(rest) => (true, rest.trim_start()),
            None => (false, text.trim()),
        };
        let is_hexadecimal = digits.starts_with("0x");
        let exponent_at = if is_hexadecimal { None } else { digits.find(['e', 'E']) };
        let (mantissa, exponent) = digits.split_at(exponent_at.unwrap_or(digits.len()));
        let are_digits = |allowed: fn(&char) -> bool| mantissa.chars().all(|c| allowed(&c));
        let magnitude = match digits.strip_prefix("0x") {
            Some(digits) if !digits.is_empty() && digits.chars().all(|c| c.is_ascii_hexdigit()) => {
                super::value(mantissa)
            }
            None if are_digits(|c| c.is_ascii_digit() || *c == '.') => mantissa.parse().ok()?,
            _ => return None,
        };
        if !exponent.is_empty() && digits.parse::<f64>().is_err() {
            return None;
        }
        Some(Self {
            mantissa: if is_negative { -magnitude } else { magnitude },
            decimals: mantissa.find('.').map_or(0, |at| mantissa.len() - at - 1).min(MOST_DECIMALS),
            exponent,
            begins_with_point: mantissa.starts_with('.'),
            ends_with_point: mantissa.ends_with('.'),
            is_hexadecimal,
        })
    }

    fn step(&self) -> f64 {
        let last_digit = 0.1_f64.powi(self.decimals as i32);
        let magnitude = self.mantissa.abs();
        let part = if magnitude >= LARGE { LARGE_PART } else { SMALL_PART };
        let wanted = magnitude * part / last_digit;
        if wanted < 2.0 {
            return last_digit;
        }
        let power = 10.0_f64.powf(wanted.log10().floor());
        let leading = [5.0, 2.0].into_iter().find(|leading| leading * power <= wanted).unwrap_or(1.0);
        leading * power * last_digit
    }

    /// The literal that many steps on; none, if that is no finite number.
    fn moved(&self, steps: f64) -> Option<String> {
        let value = self.mantissa + steps * self.step();
        if !value.is_finite() {
            return None;
        }
        let digits = if self.is_hexadecimal { hexadecimal(value.abs())? } else { self.decimal(value.abs()) };
        let is_zero = digits.trim_start_matches("0x").chars().all(|digit| matches!(digit, '0' | '.'));
        let sign = if value < 0.0 && !is_zero { "-" } else { "" };
        Some(format!("{sign}{digits}{}", self.exponent))
    }

    fn decimal(&self, magnitude: f64) -> String {
        let digits = format!("{magnitude:.*}", self.decimals);
        if self.ends_with_point {
            return digits + ".";
        }
        match digits.strip_prefix("0.") {
            Some(behind) if self.begins_with_point => format!(".{behind}"),
            _ => digits,
        }
    }
}

fn hexadecimal(magnitude: f64) -> Option<String> {
    let rounded = magnitude.round();
    (rounded < 2.0_f64.powi(53)).then(|| format!("0x{:X}", rounded as u64))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_one_in_the_last_digit_of_small_numbers() {
        for (literal, steps, expected) in [
            ("1.5", 1.0, "1.6"),
            ("10", 1.0, "11"),
            ("10", -3.0, "7"),
            ("0.05", 1.0, "0.06"),
            ("0", 2.0, "2"),
            ("-1.5", -1.0, "-1.6"),
            ("99", 1.0, "100"),
        ] {
            assert_eq!(scrub(literal, steps), expected, "{literal} by {steps}");
        }
    }

    #[test]
    fn steps_grow_with_large_numbers() {
        assert_eq!(scrub("100", 1.0), "105");
        assert_eq!(scrub("1000", 1.0), "1050");
        assert_eq!(scrub("1500", -1.0), "1450");
        assert_eq!(scrub("12.345", 1.0), "12.395");
    }

    #[test]
    fn writing_stays_as_it_was() {
        for (literal, steps, expected) in [
            ("1.50", 1.0, "1.51"),
            ("9.9", 1.0, "10.0"),
            (".5", 1.0, ".6"),
            (".5", 6.0, "1.1"),
            ("5.", 1.0, "6."),
            ("1e-3", 1.0, "2e-3"),
            ("2.5E+10", -1.0, "2.4E+10"),
            ("0x1F", 1.0, "0x20"),
        ] {
            assert_eq!(scrub(literal, steps), expected, "{literal} by {steps}");
        }
    }

    #[test]
    fn zero_has_no_sign() {
        assert_eq!(scrub("-1", 1.0), "0");
        assert_eq!(scrub("0.1", -1.0), "0.0");
        assert_eq!(scrub("0.1", -1.4), "0.0");
        assert_eq!(scrub("1e-3", -1.0), "0e-3");
    }

    #[test]
    fn going_back_leads_back_and_nothing_else_is_touched() {
        assert_eq!(scrub("12.5", 0.0), "12.5");
        for literal in ["", "-", "abc", "1.2.3", "0x", "1e", "inf"] {
            assert_eq!(scrub(literal, 1.0), literal);
        }
        assert_eq!(scrub("1", f64::NAN), "1");
        assert_eq!(scrub("1", f64::INFINITY), "1");
    }
}
