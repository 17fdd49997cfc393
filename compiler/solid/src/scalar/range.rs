//! Interval arithmetic for the functions of live numbers. Where a tight rule is not worth its lines, the range is
//! everything: that is sound, and makes the evaluator treat the number as structural where its range matters.

use chiaro_vocabulary::Interval;

use super::function::{Function, degrees};

/// Bounds of `function` for arguments within the ranges `x`.
pub(super) fn of(function: Function, x: &[Interval]) -> Interval {
    match function {
        Function::Negate => -x[0],
        Function::Add => x[0] + x[1],
        Function::Subtract => x[0] - x[1],
        Function::Multiply => x[0] * x[1],
        Function::Divide => x[0] * x[1].recip(),
        Function::Modulo => modulo(x[0], x[1]),
        Function::Power => power(x[0], x[1]),
        Function::Min => x[0].min(x[1]),
        Function::Max => x[0].max(x[1]),
        Function::Abs => x[0].abs(),
        Function::Sign | Function::Floor | Function::Ceil | Function::Round => {
            x[0].increasing(|v| function.value(&[v]))
        }
        Function::Exp | Function::Atan => x[0].increasing(|v| function.value(&[v])),
        Function::Sqrt | Function::Ln | Function::Log => within(x[0], 0.0, f64::INFINITY, |v| function.value(&[v])),
        Function::Asin | Function::Acos => within(x[0], -1.0, 1.0, |v| function.value(&[v])),
        Function::Sin => sine(x[0]),
        Function::Cos => sine(x[0] + Interval::point(90.0)),
        Function::Tan => Interval::ALL,
        Function::Atan2 => Interval { min: -180.0, max: 180.0 },
        Function::Less => truth(x[0].max < x[1].min, x[0].min >= x[1].max),
        Function::LessEqual => truth(x[0].max <= x[1].min, x[0].min > x[1].max),
        Function::Select => select(x),
        Function::SmallestSingularValue => smallest_singular_value(x),
    }
}

/// A monotonic function that is only defined from `least` to `most`.
fn within(x: Interval, least: f64, most: f64, f: impl Fn(f64) -> f64) -> Interval {
    if x.min < least || x.max > most { Interval::ALL } else { Interval::new(f(x.min), f(x.max)) }
}

/// 1, 0, or both.
fn truth(always: bool, never: bool) -> Interval {
    Interval { min: f64::from(always), max: f64::from(!never) }
}

fn select(x: &[Interval]) -> Interval {
    if !x[0].contains(0.0) {
        x[1]
    } else if x[0].is_point() {
        x[2]
    } else {
        x[1].hull(x[2])
    }
}

/// The remainder keeps the dividend's sign and stays below the divisor.
fn modulo(x: Interval, by: Interval) -> Interval {
    let most = by.magnitude().min(x.magnitude());
    Interval { min: if x.min < 0.0 { -most } else { 0.0 }, max: if x.max > 0.0 { most } else { 0.0 } }
}

/// Powers of what is not negative are monotonic in each argument, so that the corners bound them; a square is
/// handled apart, because its base may be negative.
fn power(base: Interval, exponent: Interval) -> Interval {
    if exponent == Interval::point(2.0) {
        return base.abs().increasing(|v| v * v);
    }
    if base.min < 0.0 || (base.min == 0.0 && exponent.min <= 0.0) {
        return Interval::ALL;
    }
    let of_min = Interval::new(base.min.powf(exponent.min), base.min.powf(exponent.max));
    of_min.hull(Interval::new(base.max.powf(exponent.min), base.max.powf(exponent.max)))
}

/// The sine of angles in degrees: its values at the ends, and ±1 where a crest or trough lies between.
fn sine(x: Interval) -> Interval {
    if !x.min.is_finite() || !x.max.is_finite() || x.max - x.min >= 360.0 {
        return Interval { min: -1.0, max: 1.0 };
    }
    let crosses = |angle: f64| ((x.min - angle) / 360.0).ceil() * 360.0 + angle <= x.max;
    let ends = Interval::new(degrees::sin(x.min), degrees::sin(x.max));
    Interval { min: if crosses(270.0) { -1.0 } else { ends.min }, max: if crosses(90.0) { 1.0 } else { ends.max } }
}

/// At most the least length of a column. At least 2 |det| / (sum of squares): the other two singular values have that
/// determinant's rest as their product, which is at most half the sum of their squares.
fn smallest_singular_value(x: &[Interval]) -> Interval {
    let column = |j: usize| (0..3).map(|k| x[3 * k + j].magnitude().powi(2)).sum::<f64>();
    let squares = [column(0), column(1), column(2)];
    let least = 2.0 * determinant(x).abs().min / squares.iter().sum::<f64>();
    let most = squares.into_iter().fold(f64::INFINITY, f64::min).sqrt();
    Interval { min: if least.is_finite() { least.min(most) } else { 0.0 }, max: most }
}

/// Bounds of a 3 × 3 determinant: what its expansions along all three rows have in common.
fn determinant(x: &[Interval]) -> Interval {
    let cofactor = |i: usize, j: usize| {
        let at = |i: usize, j: usize| x[3 * (i % 3) + j % 3];
        at(i + 1, j + 1) * at(i + 2, j + 2) - at(i + 1, j + 2) * at(i + 2, j + 1)
    };
    let along =
        |i: usize| (0..3).map(|j| x[3 * i + j] * cofactor(i, j)).fold(Interval::point(0.0), |sum, term| sum + term);
    let expansions = [along(0), along(1), along(2)];
    let min = expansions.iter().map(|expansion| expansion.min).fold(f64::NEG_INFINITY, f64::max);
    let max = expansions.iter().map(|expansion| expansion.max).fold(f64::INFINITY, f64::min);
    // Rounding may part bounds that touch.
    Interval { min: min.min(max), max: max.max(min) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every function's value at points within the ranges lies in the range it claims.
    #[test]
    fn ranges_hold_at_sampled_points() {
        let functions = [
            Function::Add,
            Function::Subtract,
            Function::Multiply,
            Function::Divide,
            Function::Modulo,
            Function::Power,
            Function::Min,
            Function::Max,
            Function::Atan2,
            Function::Less,
            Function::LessEqual,
            Function::Negate,
            Function::Abs,
            Function::Sign,
            Function::Sqrt,
            Function::Exp,
            Function::Ln,
            Function::Log,
            Function::Floor,
            Function::Ceil,
            Function::Round,
            Function::Sin,
            Function::Cos,
            Function::Asin,
            Function::Acos,
            Function::Atan,
        ];
        let intervals =
            [(-3.0, -1.0), (-2.0, 3.0), (0.0, 0.5), (0.5, 2.0), (30.0, 200.0), (-400.0, -100.0), (2.0, 2.0)];
        let intervals = intervals.map(|(a, b)| Interval::new(a, b));
        let samples = |x: Interval| (0..=16).map(move |i| x.min + (x.max - x.min) * f64::from(i) / 16.0);
        for function in functions {
            for (a, b) in intervals.iter().flat_map(|a| intervals.iter().map(move |b| (*a, *b))) {
                let range = of(function, &[a, b]);
                for (x, y) in samples(a).flat_map(|x| samples(b).map(move |y| (x, y))) {
                    let value = function.value(&[x, y]);
                    let slack = 1e-9 * (1.0 + value.abs());
                    let inside = range.min - slack <= value && value <= range.max + slack;
                    assert!(inside || value.is_nan(), "{function:?}({x}, {y}) = {value} is not in {range:?}");
                }
            }
        }
    }
}
