//! The text of a Customizer comment: `[1:0.5:30]`, `5`, `[a, b, c]`, `[10:Small, 20:Large]`.

use nom::branch::alt;
use nom::bytes::complete::{is_not, take_until};
use nom::character::complete::{char, space0};
use nom::combinator::{map, opt};
use nom::multi::separated_list1;
use nom::sequence::{delimited, preceded, terminated};
use nom::{IResult, Parser as _};

use crate::tree::Domain;

/// The values that a comment allows; `None` if it is a comment like any other.
pub(super) fn read(comment: &str) -> Option<Domain> {
    let comment = comment.trim();
    if let Some(step) = number(comment) {
        return Some(Domain::Step(step));
    }
    let inside = comment.strip_prefix('[')?;
    if let Some(range) = inside.split_once(']').and_then(|(inside, _)| range(inside)) {
        return Some(range);
    }
    let (_, choices) = choices(inside).ok()?;
    let choices: Vec<_> = choices.into_iter().filter(|(value, _)| !value.is_empty()).collect();
    (!choices.is_empty()).then_some(Domain::Choices(choices))
}

/// Whether a choice's text reads as a number.
pub(crate) fn is_number(text: &str) -> bool {
    number(text).is_some()
}

fn number(text: &str) -> Option<f64> {
    let begins = text.trim_start_matches(['-', '+']);
    let is_number = begins.starts_with(|first: char| first.is_ascii_digit() || first == '.');
    text.parse().ok().filter(|number: &f64| is_number && number.is_finite())
}

fn range(text: &str) -> Option<Domain> {
    let numbers: Option<Vec<f64>> = text.split(':').map(|part| number(part.trim())).collect();
    Some(match numbers?[..] {
        [max] => Domain::Range { min: 0.0, step: None, max },
        [min, max] => Domain::Range { min, step: None, max },
        [min, step, max] => Domain::Range { min, step: Some(step), max },
        _ => return None,
    })
}

fn choices(text: &str) -> IResult<&str, Vec<(String, Option<String>)>> {
    let label = preceded(char(':'), |text| word(text, ",]"));
    let choice = (|text| word(text, ",:]"), map(opt(label), |label| label.filter(|label| !label.is_empty())));
    terminated(separated_list1(char(','), choice), char(']')).parse(text)
}

/// A quoted text, or whatever stands before one of the characters `ends`.
fn word<'a>(text: &'a str, ends: &'static str) -> IResult<&'a str, String> {
    let quoted = delimited((space0, char('"')), take_until("\""), (char('"'), space0));
    let plain = map(opt(is_not(ends)), |word: Option<&str>| word.unwrap_or("").trim());
    map(alt((quoted, plain)), str::to_owned).parse(text)
}
