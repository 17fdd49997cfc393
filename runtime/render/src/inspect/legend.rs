//! What an inspection's colours mean.

/// What an inspection's colours mean.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Legend {
    /// What is shown, with its unit.
    pub title: &'static str,
    /// Colours with their meaning. Between those with values, colours and values change evenly.
    pub marks: Vec<Mark>,
    /// From one contour of a section to the next, in millimetres; 0 if there are none.
    pub step: f64,
}

/// A colour with its meaning.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Red, green and blue in sRGB.
    pub color: [u8; 3],
    /// The number it stands for, if it is one.
    pub value: Option<f64>,
    /// That number or meaning, as it is to be shown.
    pub label: String,
}

impl Mark {
    /// A colour for a number.
    pub(super) fn of_value(color: [u8; 3], value: f64) -> Self {
        Self { color, value: Some(value), label: shown(value) }
    }

    /// A colour with a meaning in words.
    pub(super) fn of_words(color: [u8; 3], label: &str) -> Self {
        Self { color, value: None, label: label.to_owned() }
    }
}

/// A number with four digits that count.
fn shown(value: f64) -> String {
    let digits = if value == 0.0 { 0 } else { (3 - value.abs().log10().floor() as i32).clamp(0, 12) };
    let text = format!("{value:.*}", digits as usize);
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

/// The least of 1, 2 and 5 times a power of ten that is not less than a positive number.
pub(super) fn nice(number: f64) -> f64 {
    if !(number.is_finite() && number > 0.0) {
        return 1.0;
    }
    let power = 10f64.powf(number.log10().floor());
    let factor = [1.0, 2.0, 5.0, 10.0].into_iter().find(|factor| factor * power >= number * (1.0 - 1e-9));
    factor.unwrap_or(10.0) * power
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nice_numbers_are_not_less() {
        for (number, expected) in [(0.9, 1.0), (1.0, 1.0), (1.1, 2.0), (2.1, 5.0), (61.0, 100.0), (0.03, 0.05)] {
            assert!((nice(number) / expected - 1.0).abs() < 1e-12, "{number}: {}", nice(number));
        }
        assert_eq!(nice(f64::NAN), 1.0);
    }

    #[test]
    fn numbers_are_shown_short() {
        for (number, expected) in [(0.0, "0"), (12.5, "12.5"), (1234.56, "1235"), (0.012345, "0.01235"), (-2.0, "-2")] {
            assert_eq!(shown(number), expected);
        }
    }
}
