//! Interval arithmetic for the functions of live numbers.
//!
//! The ranges are those of values as they are computed: rounding to the nearest number never changes the order of two
//! results, so that the rounded ends bound all rounded values between. Where a function has no finite value for some
//! arguments, or a tight rule is not worth its lines, the range is everything.

use chiaro_vocabulary::Interval;

use super::Scalar;
use super::function::{Function, degrees};

/// Bounds of `function` for arguments within the ranges `x`; everything, if some of the values may not be finite.
pub(super) fn of(function: Function, x: &[Interval]) -> Interval {
    let range = match function {
        Function::Select => select(x),
        // A comparison with what is no number is false.
        Function::Less | Function::LessEqual if !x.iter().all(|x| x.is_finite()) => truth(false, false),
        _ if !x.iter().all(|x| x.is_finite()) => Interval::ALL,
        _ => of_finite(function, x),
    };
    if range.is_finite() { range } else { Interval::ALL }
}

/// Bounds of a number times itself, which is never negative.
fn square(x: Interval) -> Interval {
    let square = x.abs().increasing(|v| v * v);
    if square.is_finite() { square } else { Interval::ALL }
}

/// The same, where arguments that are equal may tell more.
pub(super) fn of_arguments(function: Function, arguments: &[Scalar], x: &[Interval]) -> Interval {
    match arguments {
        [a, b] if function == Function::Multiply && a == b => square(x[0]),
        _ => of(function, x),
    }
}

fn of_finite(function: Function, x: &[Interval]) -> Interval {
    match function {
        Function::Negate => -x[0],
        Function::Add => x[0] + x[1],
        Function::Subtract => x[0] - x[1],
        Function::Multiply => x[0] * x[1],
        Function::Divide => quotient(x[0], x[1]),
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
        Function::Tan => tangent(x[0]),
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

/// Quotients by what is not zero are monotonic in each argument.
fn quotient(x: Interval, by: Interval) -> Interval {
    if by.contains(0.0) {
        return Interval::ALL;
    }
    Interval::new(x.min / by.min, x.min / by.max).hull(Interval::new(x.max / by.min, x.max / by.max))
}

/// The remainder keeps the dividend's sign and stays below the divisor, which must not be zero.
fn modulo(x: Interval, by: Interval) -> Interval {
    if by.contains(0.0) {
        return Interval::ALL;
    }
    let most = by.magnitude().min(x.magnitude());
    Interval { min: if x.min < 0.0 { -most } else { 0.0 }, max: if x.max > 0.0 { most } else { 0.0 } }
}

/// Powers with one whole exponent go up, or down and up again, or have a pole at zero. Others exist for what is not
/// negative alone, and are monotonic in each argument there, so that the corners bound them.
fn power(base: Interval, exponent: Interval) -> Interval {
    let of_base = |exponent: f64| Interval::new(base.min.powf(exponent), base.max.powf(exponent));
    let has_pole = base.contains(0.0) && exponent.min < 0.0;
    if has_pole {
        Interval::ALL
    } else if exponent.is_point() && exponent.min % 2.0 == 0.0 {
        let base = base.abs();
        Interval::new(base.min.powf(exponent.min), base.max.powf(exponent.min))
    } else if exponent.is_point() && exponent.min.fract() == 0.0 {
        of_base(exponent.min)
    } else if base.min < 0.0 {
        Interval::ALL
    } else {
        of_base(exponent.min).hull(of_base(exponent.max))
    }
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

/// The tangent of angles in degrees: it goes up between its poles at odd multiples of 90°.
fn tangent(x: Interval) -> Interval {
    let pole = ((x.min - 90.0) / 180.0).ceil() * 180.0 + 90.0;
    if pole <= x.max { Interval::ALL } else { x.increasing(degrees::tan) }
}

/// At most the least length of a column. At least |det| / ‖adj‖, as the other two singular values have a product of at
/// most the length of all the adjugate's entries together; and at least 2 |det| / (sum of squares), as that product is
/// at most half the sum of their squares. What rounding may add is left off.
fn smallest_singular_value(x: &[Interval]) -> Interval {
    const ROUNDING: f64 = 1e-12;
    let column = |j: usize| (0..3).map(|k| x[3 * k + j].magnitude().powi(2)).sum::<f64>();
    let squares = [column(0), column(1), column(2)];
    let at = |i: usize, j: usize| x[3 * (i % 3) + j % 3];
    let cofactors = || (0..9).map(|k| cofactor(x, k / 3, k % 3).magnitude());
    // How large the determinant's terms are, and so what cancelling them may leave of rounding.
    let terms: f64 = cofactors().enumerate().map(|(k, cofactor)| at(k / 3, k % 3).magnitude() * cofactor).sum();
    let determinant = determinant(x).abs().min.max(x[9].abs().min) - ROUNDING * terms;
    let adjugate = cofactors().map(|cofactor| cofactor * cofactor).sum::<f64>().sqrt();
    let least = determinant * (1.0 - ROUNDING) / adjugate.min(0.5 * squares.iter().sum::<f64>());
    let most = squares.into_iter().fold(f64::INFINITY, f64::min).sqrt() * (1.0 + ROUNDING);
    Interval { min: if least > 0.0 { least.min(most) } else { 0.0 }, max: most }
}

/// Bounds of a cofactor of a 3 × 3 matrix.
fn cofactor(x: &[Interval], i: usize, j: usize) -> Interval {
    let at = |i: usize, j: usize| x[3 * (i % 3) + j % 3];
    at(i + 1, j + 1) * at(i + 2, j + 2) - at(i + 1, j + 2) * at(i + 2, j + 1)
}

/// Bounds of a 3 × 3 determinant: what its expansions along all three rows have in common.
fn determinant(x: &[Interval]) -> Interval {
    let term = |i: usize, j: usize| x[3 * i + j] * cofactor(x, i, j);
    let along = |i: usize| (0..3).map(|j| term(i, j)).fold(Interval::point(0.0), |sum, term| sum + term);
    let expansions = [along(0), along(1), along(2)];
    let min = expansions.iter().map(|expansion| expansion.min).fold(f64::NEG_INFINITY, f64::max);
    let max = expansions.iter().map(|expansion| expansion.max).fold(f64::INFINITY, f64::min);
    // Rounding may part bounds that touch.
    Interval { min: min.min(max), max: max.max(min) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every function's value at points within the ranges lies in the range it claims; where that is finite, so are the
    /// values.
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
            Function::Tan,
            Function::Asin,
            Function::Acos,
            Function::Atan,
        ];
        let intervals = [
            (-3.0, -1.0),
            (-2.0, 3.0),
            (0.0, 0.5),
            (0.5, 2.0),
            (30.0, 200.0),
            (-400.0, -100.0),
            (700.0, 800.0),
            (-1.0, 1.0),
            (2.0, 2.0),
            (3.0, 3.0),
            (-2.0, -2.0),
            (0.0, 0.0),
        ];
        let intervals = intervals.map(|(a, b)| Interval::new(a, b));
        let samples = |x: Interval| (0..=16).map(move |i| x.min + (x.max - x.min) * f64::from(i) / 16.0);
        for function in functions {
            let mut finite = 0;
            for (a, b) in intervals.iter().flat_map(|a| intervals.iter().map(move |b| (*a, *b))) {
                let range = of(function, &[a, b]);
                finite += u32::from(range.is_finite());
                assert!(range.is_finite() || range == Interval::ALL, "{function:?} of {a:?}, {b:?}: {range:?}");
                for (x, y) in samples(a).flat_map(|x| samples(b).map(move |y| (x, y))) {
                    let value = function.value(&[x, y]);
                    let slack = 1e-12 * value.abs();
                    let inside = range.min - slack <= value && value <= range.max + slack;
                    assert!(
                        inside || range == Interval::ALL,
                        "{function:?}({x}, {y}) = {value} is not in {range:?} of {a:?}, {b:?}"
                    );
                }
            }
            assert!(finite >= 12, "{function:?} has a finite range {finite} times");
        }
    }

    #[test]
    fn what_may_be_no_number_stays_unknown() {
        let (two, small) = (Interval::new(0.0, 2.0), Interval::new(0.0, 1.0));
        let angle = of(Function::Asin, &[two]);
        assert_eq!(angle, Interval::ALL);
        for function in [Function::Sin, Function::Atan, Function::Floor, Function::Negate, Function::Sign] {
            assert_eq!(of(function, &[angle]), Interval::ALL, "{function:?}");
        }
        for function in [Function::Min, Function::Max, Function::Multiply, Function::Modulo, Function::Atan2] {
            assert_eq!(of(function, &[small, angle]), Interval::ALL, "{function:?}");
        }
        assert_eq!(of(Function::Less, &[angle, small]), small);
        assert_eq!(of(Function::Select, &[angle, two, small]), two);
        assert_eq!(of(Function::Select, &[Interval::point(0.0), angle, small]), small);
        assert_eq!(of(Function::Select, &[small, angle, small]), Interval::ALL);
        assert_eq!(of(Function::Exp, &[Interval::new(0.0, 1e3)]), Interval::ALL);
    }

    #[test]
    fn the_least_stretch_of_live_matrices_is_bounded_closely() {
        let mut state = 1u64;
        let mut unit = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64
        };
        for round in 0..400 {
            let width = [1e-9, 1e-3, 0.1, 1.0][round % 4];
            let size = [1.0, 100.0, 1e5][round % 3];
            let x: Vec<Interval> = (0..9)
                .map(|_| size * (2.0 * unit() - 1.0))
                .map(|middle| Interval::new(middle - width, middle + width))
                .collect();
            let range = of(Function::SmallestSingularValue, &[x.as_slice(), &[determinant(&x)]].concat());
            for _ in 0..20 {
                let m: Vec<f64> = x.iter().map(|entry| entry.min + unit() * (entry.max - entry.min)).collect();
                let value = Function::SmallestSingularValue.value(&m);
                assert!(range.contains(value), "{value} is not in {range:?}: {m:?}");
            }
        }
        let shear = |k: Interval| {
            let (one, zero) = (Interval::point(1.0), Interval::point(0.0));
            of(Function::SmallestSingularValue, &[one, k, zero, zero, one, zero, zero, zero, one, one])
        };
        for most in [1.0, 300.0, 1e5, 1e9] {
            let range = shear(Interval::new(0.0, most));
            let least = Function::SmallestSingularValue.value(&[1.0, most, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]);
            assert!(range.min <= least && range.min >= 0.5 * least, "{most}: {range:?}, {least}");
        }
    }
}
