//! Numbers and types of emitted functions, spelled as in the vocabulary: `2.0` for naga's `2f`, and `vec3(` for `vec3<f32>(`.

/// The text with its numbers short, and without what a reader can do without.
pub(super) fn tidied(text: &str) -> String {
    let mut result = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find(is_part) {
        let end = rest[start..].find(|c| !is_part(c)).map_or(rest.len(), |length| start + length);
        result += &rest[..start];
        let (token, behind) = token(&rest[start..end], &rest[end..]);
        result += &token;
        rest = behind;
    }
    without_parentheses_around_arguments(&without_needless_parentheses(&(result + rest)))
}

fn is_part(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_' || c == '.'
}

/// How a word or number is spelled, and what stands behind it.
fn token<'t>(word: &str, behind: &'t str) -> (String, &'t str) {
    if word.starts_with(|c: char| c.is_ascii_digit()) {
        // The sign of an exponent is no part of a word.
        let sign = behind.chars().next().filter(|c| word.ends_with('e') && "+-".contains(*c));
        let digits = sign.map_or(0, |_| behind[1..].find(|c| !is_part(c)).unwrap_or(behind.len() - 1) + 1);
        let written = format!("{word}{}", &behind[..digits]);
        let number = written.strip_suffix('f').and_then(|digits| digits.parse().ok());
        return (number.map_or(written, number_spelled), &behind[digits..]);
    }
    let is_constructor = word.starts_with("vec") || word.starts_with("mat");
    match behind.strip_prefix("<f32>(").filter(|_| is_constructor) {
        Some(_) => (word.to_owned(), &behind["<f32>".len()..]),
        None => (word.to_owned(), behind),
    }
}

/// The shortest decimal that is read as the same number, with a point or an exponent.
fn number_spelled(number: f32) -> String {
    let size = number.abs();
    if size != 0.0 && !(1e-4..1e7).contains(&size) {
        return format!("{number:e}");
    }
    let digits = number.to_string();
    if digits.contains('.') { digits } else { digits + ".0" }
}

/// The text with `-p.x` for `-(p.x)`.
fn without_needless_parentheses(text: &str) -> String {
    let mut result = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find("-(") {
        let (before, inner) = (&rest[..at + 1], &rest[at + 2..]);
        let length = inner.find(|c| !is_part(c)).unwrap_or(inner.len());
        result += before;
        match inner[length..].strip_prefix(')').filter(|_| length > 0) {
            Some(behind) => {
                result += &inner[..length];
                rest = behind;
            }
            None => rest = &rest[at + 1..],
        }
    }
    result + rest
}

/// The text without parentheses around a whole argument, index or value in parentheses.
fn without_parentheses_around_arguments(text: &str) -> String {
    let mut kept = vec![true; text.len()];
    let mut open: Vec<usize> = Vec::new();
    let bytes = text.as_bytes();
    for (at, &byte) in bytes.iter().enumerate() {
        match byte {
            b'(' => open.push(at),
            b')' => {
                let Some(start) = open.pop() else { continue };
                let before = text[..start].trim_end_matches(' ').bytes().next_back();
                let begins = matches!(before, Some(b'(' | b',' | b'['));
                let ends = matches!(bytes.get(at + 1), Some(b',' | b')' | b']'));
                if begins && ends {
                    (kept[start], kept[at]) = (false, false);
                }
            }
            _ => {}
        }
    }
    text.char_indices().filter(|(at, _)| kept[*at]).map(|(_, c)| c).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_types_are_left_out() {
        let text = "let a = vec3<f32>(0f, -(p.y), 12.5f) * -(b + c) - 3.5e-15f + 1e15f + tables[3u].x;";
        assert_eq!(tidied(text), "let a = vec3(0.0, -p.y, 12.5) * -(b + c) - 3.5e-15 + 1e15 + tables[3u].x;");
        let nested = "tables[(row + 1u)].x + f((p - vec3(1.0)), -(a + b), ((c) * d), (e).x)";
        assert_eq!(tidied(nested), "tables[row + 1u].x + f(p - vec3(1.0), -(a + b), (c) * d, (e).x)");
        assert_eq!(tidied("0.0000000000000035527137f"), "3.5527137e-15");
        assert_eq!(tidied("var x: vec2<f32> = 2f;"), "var x: vec2<f32> = 2.0;");
    }
}
