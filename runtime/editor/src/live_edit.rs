//! Edits of one number, which need no new pipeline.
//!
//! Practice: the first edit of a number compiles the scene with that number live. Until something else is edited, the value
//! goes to the picture as a uniform. Some time after the last of these edits, the text is compiled as it stands, with the number live
//! as before, so that the picture keeps its pipelines.

use std::ops::Range;

use chiaro_assist::{NumberLiteral, numbers};
use chiaro_compiler::LiveLiteral;
use chiaro_compiler::vocabulary::Interval;

use crate::history::difference;
use crate::studio::LiveValue;

/// A live number reaches this many times as far as its value.
const REACH: f64 = 4.0;
/// The least part of its value that it can become as long as it has no sign.
const LEAST_PART: f64 = 1.0 / 64.0;
/// The least reach of a number, so that zero can move.
const LEAST_REACH: f64 = 10.0;

/// An edit that changed nothing but one number.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct NumberEdit {
    /// The number before.
    before: NumberLiteral,
    /// The number after.
    after: NumberLiteral,
}

/// The edit between two texts, if nothing but one number differs.
pub(crate) fn number_edit(before: &str, after: &str) -> Option<NumberEdit> {
    let (was, is) = difference(before, after);
    if !could_be_number(before, &was) || !could_be_number(after, &is) {
        return None;
    }
    let number_at = |text: &str, start: usize, end: usize| {
        numbers(text).into_iter().find(|number| number.range.start <= start && end <= number.range.end)
    };
    let old = number_at(before, was.start, was.end)?;
    let new = number_at(after, is.start, is.end)?;
    let same_place = old.range.start == new.range.start && before[old.range.end..] == after[new.range.end..];
    (same_place && new.value.is_finite()).then_some(NumberEdit { before: old, after: new })
}

/// Whether a part of a text may be one of a number. That is seen at once, where finding the numbers of a long text takes time
/// that most letters typed needn't wait for.
fn could_be_number(text: &str, part: &Range<usize>) -> bool {
    let is_of_number = |byte: &&u8| byte.is_ascii_hexdigit() || matches!(byte, b'.' | b'x' | b'X' | b'+' | b'-');
    let bytes = text.as_bytes();
    let before = bytes[..part.start].iter().rev().take_while(is_of_number);
    let after = bytes[part.start..].iter().take_while(is_of_number);
    bytes[part.clone()].iter().all(|byte| is_of_number(&byte)) && before.chain(after).any(u8::is_ascii_digit)
}

impl NumberEdit {
    /// The number after the edit, as one to be live.
    pub(crate) fn literal(&self) -> LiveLiteral {
        let magnitude = self.after.value.abs();
        let reach = (REACH * magnitude).max(LEAST_REACH);
        // A radius stays one: numbers without a sign become neither negative nor zero before the text says so. For whether
        // there is a sphere at all is no question that a shader could answer.
        let least = if self.before.negative || self.after.negative { -reach } else { magnitude * LEAST_PART };
        LiveLiteral { start: digits(&self.after), range: Interval::new(least, reach) }
    }

    /// What it makes of a number that is live already; none if that is another one, or can't take the value.
    pub(crate) fn value(&self, live: &LiveLiteral) -> Option<LiveValue> {
        let value = if self.before.negative { -self.after.value } else { self.after.value };
        let fits = live.start == digits(&self.before) && (live.range.min..=live.range.max).contains(&value);
        fits.then(|| LiveValue { name: format!("@{}", live.start), component: None, value })
    }
}

/// Where the digits start, behind any sign.
fn digits(number: &NumberLiteral) -> usize {
    number.range.start + usize::from(number.negative)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(before: &str, after: &str) -> Option<f64> {
        number_edit(before, after).map(|edit| edit.after.value)
    }

    #[test]
    fn only_edits_of_one_number_are_number_edits() {
        assert_eq!(value("cube(10);", "cube(12);"), Some(12.0));
        assert_eq!(value("cube(10);", "cube(1);"), Some(1.0));
        assert_eq!(value("cube(10);", "cube(-10.5);"), Some(-10.5));
        assert_eq!(value("cube(10);", "cube();"), None);
        assert_eq!(value("cube(10);", "cube(10a);"), None);
        assert_eq!(value("cube([1, 2]);", "cube([3, 4]);"), None);
        assert_eq!(value("r10 = 1;", "r12 = 1;"), None);
        assert_eq!(value("cube(1e2);", "cube(1e-2);"), Some(0.01));
        assert_eq!(value("cube(0x1F);", "cube(0x1);"), Some(1.0));
        assert_eq!(value("// 10\ncube(1);", "// 12\ncube(1);"), None);
    }

    #[test]
    fn radii_and_sizes_can_be_live() {
        struct Text(&'static str);
        impl chiaro_compiler::World for Text {
            fn find(&self, _: &str, _: &str) -> Option<String> {
                None
            }
            fn read(&self, _: &str) -> Result<Vec<u8>, String> {
                Ok(self.0.as_bytes().to_vec())
            }
        }
        for [before, after] in [
            ["sphere(2);", "sphere(3);"],
            ["cube([2, 5, 1]);", "cube([2, 6, 1]);"],
            ["cylinder(r = 1, h = 2);", "cylinder(r = 1, h = 3);"],
        ] {
            let literal = number_edit(before, after).unwrap().literal();
            let options = chiaro_compiler::Options { live_literals: vec![literal], ..Default::default() };
            let scene = chiaro_compiler::compile(&Text(after), "a.csg", &options).scene.unwrap();
            assert_eq!(scene.parameters.len(), 1, "{after}");
        }
    }

    #[test]
    fn a_live_numbers_value_knows_the_sign_it_was_compiled_with() {
        let first = number_edit("translate([-4, 0, 0]) cube(1);", "translate([-5, 0, 0]) cube(1);").unwrap();
        let live = first.literal();
        assert_eq!(live.start, 12);
        let next = number_edit("translate([-5, 0, 0]) cube(1);", "translate([3, 0, 0]) cube(1);").unwrap();
        let value = next.value(&live).unwrap();
        assert_eq!((value.name.as_str(), value.value), ("@12", -3.0));
        let far = number_edit("translate([-5, 0, 0]) cube(1);", "translate([-5000, 0, 0]) cube(1);").unwrap();
        assert_eq!(far.value(&live), None);
    }
}
