//! Values as text, the way `echo` and `str` write them.

use super::{Trouble, Value, print};

/// The number with six significant digits, as OpenSCAD writes it.
pub(crate) fn number(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    if !value.is_finite() {
        return if value.is_nan() {
            "nan".into()
        } else if value > 0.0 {
            "inf".into()
        } else {
            "-inf".into()
        };
    }
    // One digit, a point, five digits and the exponent: correctly rounded, so that 999999.5 has exponent 6 here.
    let scientific = format!("{value:.5e}");
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if !(-5..=5).contains(&exponent) {
        return format!("{}e{exponent:+}", without_trailing_zeros(mantissa));
    }
    let decimals = (5 - exponent) as usize;
    without_trailing_zeros(&format!("{value:.decimals$}")).into()
}

fn without_trailing_zeros(digits: &str) -> &str {
    if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.') } else { digits }
}

/// The text of a value: of a string itself, and of others what `echo` writes.
pub(crate) fn plain(value: &Value, limit: usize) -> Result<String, Trouble> {
    match value {
        Value::String(text) => Ok(text.to_string()),
        _ => quoted(value, limit),
    }
}

/// The text of a value as `echo` writes it, with strings in quotation marks.
pub(crate) fn quoted(value: &Value, limit: usize) -> Result<String, Trouble> {
    let mut text = String::new();
    write(value, limit, &mut text)?;
    Ok(text)
}

/// Appends a value's text; it stops when the limit is passed, which the caller has to look for.
fn write(value: &Value, limit: usize, text: &mut String) -> Result<(), Trouble> {
    match value {
        Value::Undef => text.push_str("undef"),
        Value::Bool(value) => text.push_str(if *value { "true" } else { "false" }),
        Value::Number(value) => match value.constant() {
            Some(value) => text.push_str(&number(value)),
            None => return Err(Trouble::Demote(value.clone(), "a text")),
        },
        Value::Condition(live) => return Err(Trouble::Demote(live.clone(), "a text")),
        Value::String(value) => {
            text.push('"');
            text.push_str(value);
            text.push('"');
        }
        Value::List(values) => {
            text.push('[');
            for (at, value) in values.iter().enumerate() {
                if text.len() > limit {
                    return Ok(());
                }
                if at > 0 {
                    text.push_str(", ");
                }
                write(value, limit, text)?;
            }
            text.push(']');
        }
        Value::Range(range) => {
            let [start, step, end] = [range.start, range.step, range.end].map(number);
            text.push_str(&format!("[{start} : {step} : {end}]"));
        }
        Value::Function(closure) => print::function(&closure.function, text),
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn numbers_have_six_significant_digits() {
        let cases = [
            (0.1 + 0.2, "0.3"),
            (100000.0, "100000"),
            (999999.0, "999999"),
            (999999.5, "1e+6"),
            (123456789.0, "1.23457e+8"),
            (1e-5, "0.00001"),
            (1e-6, "1e-6"),
            (0.000012345678, "0.0000123457"),
            (-0.0, "0"),
            (-2.5, "-2.5"),
            (f64::NEG_INFINITY, "-inf"),
            (1e100, "1e+100"),
        ];
        for (value, text) in cases {
            assert_eq!(number(value), text);
        }
    }
}
