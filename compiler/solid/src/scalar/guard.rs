//! What a condition tells of the numbers behind it: in `x > 0 ? ln(x) : 0`, the logarithm is only asked of what is
//! greater than 0.

use chiaro_vocabulary::Interval;

use super::{Function, Operation, Scalar, range};

/// Longer formulas are not looked through for what their conditions tell.
const LONGEST: u32 = 4_096;

/// What a number is known to be within.
type Known<'a> = (&'a Scalar, Interval);

/// Bounds of `condition ? yes : no`, where what the condition tells of each branch counts.
pub(super) fn choice(condition: &Scalar, yes: &Scalar, no: &Scalar) -> Interval {
    let all = [condition.range(), yes.range(), no.range()];
    let plain = Function::Select.range(&all);
    if plain.is_finite() || yes.size().saturating_add(no.size()) > LONGEST {
        return plain;
    }
    let branch = |number: &Scalar, holds: bool| range_given(number, &told(condition, holds));
    Function::Select.range(&[all[0], branch(yes, true), branch(no, false)])
}

/// What a comparison tells if it holds, or if it does not.
fn told(condition: &Scalar, holds: bool) -> Vec<Known<'_>> {
    let Scalar::Live(expression) = condition else { return Vec::new() };
    match &expression.operation {
        Operation::Apply(Function::Less, x) if holds => ordered(&x[0], &x[1], true),
        Operation::Apply(Function::Less, x) => ordered(&x[1], &x[0], false),
        Operation::Apply(Function::LessEqual, x) if holds => ordered(&x[0], &x[1], false),
        Operation::Apply(Function::LessEqual, x) => ordered(&x[1], &x[0], true),
        // `!`
        Operation::Apply(Function::Select, x) if x[1].is(0.0) && x[2].is(1.0) => told(&x[0], !holds),
        _ => Vec::new(),
    }
}

/// That one number is less than another, or at most that. (Of what may be no number, nothing is told: comparisons with
/// that don't hold.)
fn ordered<'a>(less: &'a Scalar, greater: &'a Scalar, strictly: bool) -> Vec<Known<'a>> {
    let (low, high) = (less.range(), greater.range());
    if !(low.is_finite() && high.is_finite()) {
        return Vec::new();
    }
    let (most, least) = if strictly { (high.max.next_down(), low.min.next_up()) } else { (high.max, low.min) };
    let below = Interval { min: low.min, max: low.max.min(most).max(low.min) };
    let above = Interval { min: high.min.max(least).min(high.max), max: high.max };
    vec![(less, below), (greater, above)]
}

/// Bounds of a number while some are known to be within theirs.
fn range_given(number: &Scalar, known: &[Known]) -> Interval {
    if let Some((_, range)) = known.iter().find(|(other, _)| *other == number) {
        return *range;
    }
    let Scalar::Live(expression) = number else { return number.range() };
    let Operation::Apply(function, arguments) = &expression.operation else { return number.range() };
    let ranges: Vec<Interval> = arguments.iter().map(|argument| range_given(argument, known)).collect();
    let given = range::of_arguments(*function, arguments, &ranges);
    // Conditions within the number may tell more.
    if given.is_finite() { given } else { number.range() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::ParameterId;

    fn apply(function: Function, arguments: &[&Scalar]) -> Scalar {
        Scalar::apply(function, arguments.iter().map(|argument| (*argument).clone()).collect())
    }

    #[test]
    fn branches_are_asked_only_where_their_condition_sends_them() {
        let x = Scalar::parameter(ParameterId(0), Interval::new(-2.0, 4.0));
        let (zero, one) = (Scalar::ZERO, Scalar::ONE);
        let logarithm = apply(Function::Ln, &[&x]);
        let angle = apply(Function::Asin, &[&x]);
        let positive = apply(Function::Less, &[&zero, &x]);
        let not_above_one = apply(Function::LessEqual, &[&x, &one]);
        let above_one = apply(Function::Select, &[&not_above_one, &zero, &one]);
        let is_finite =
            |condition: &Scalar, yes: &Scalar, no: &Scalar| apply(Function::Select, &[condition, yes, no]).is_finite();
        assert!(is_finite(&positive, &logarithm, &zero));
        assert!(!is_finite(&positive, &zero, &logarithm));
        assert!(!is_finite(&apply(Function::LessEqual, &[&zero, &x]), &logarithm, &zero));
        // From −2 to −1 there is no such angle, whatever is above 1.
        assert!(!is_finite(&above_one, &zero, &angle));
        let above_minus_one = apply(Function::LessEqual, &[&-one.clone(), &x]);
        let within = apply(Function::Select, &[&above_one, &zero, &angle]);
        assert!(is_finite(&above_minus_one, &apply(Function::Min, &[&x, &one]), &zero));
        assert!(!within.is_finite());
        assert!(is_finite(&above_one, &zero, &apply(Function::Asin, &[&apply(Function::Max, &[&x, &-one.clone()])])));
    }

    #[test]
    fn bounds_hold_at_all_values() {
        let x = Scalar::parameter(ParameterId(0), Interval::new(-2.0, 4.0));
        let root = apply(Function::Sqrt, &[&x]);
        let choice = apply(Function::Select, &[&apply(Function::Less, &[&x, &Scalar::ZERO]), &x, &root]);
        assert_eq!(choice.range(), Interval::new(-2.0, 2.0));
        for step in 0..=60 {
            let value = choice.value(&[-2.0 + 0.1 * f64::from(step)]);
            assert!(choice.range().contains(value), "{value}");
        }
    }
}
