//! The functions that live numbers may pass through.

use chiaro_vocabulary::Interval;

use super::range;
use crate::singular;

/// A function of one or more numbers. Angles are in degrees, as in scenes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "the names say it; those that don't, do")]
pub enum Function {
    Negate,
    Add,
    Subtract,
    Multiply,
    Divide,
    /// The remainder with the dividend's sign.
    Modulo,
    Power,
    Min,
    Max,
    Abs,
    Sign,
    Sqrt,
    Exp,
    /// The natural logarithm.
    Ln,
    /// The logarithm to base 10.
    Log,
    Floor,
    Ceil,
    /// To the nearest integer, halves away from zero.
    Round,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Atan2,
    /// 1 if the first number is less than the second, else 0.
    Less,
    /// 1 if the first number is at most the second, else 0.
    LessEqual,
    /// The second number if the first is not zero, else the third.
    Select,
    /// A bound of the least singular value of a 3 × 3 matrix, given by rows and then its determinant: what it scales
    /// lengths by at the least. The determinant counts for the range alone, where it may be known better than the
    /// entries tell.
    SmallestSingularValue,
}

impl Function {
    /// Its value. There are as many arguments as the function takes.
    pub fn value(self, x: &[f64]) -> f64 {
        match self {
            Function::Negate => -x[0],
            Function::Add => x[0] + x[1],
            Function::Subtract => x[0] - x[1],
            Function::Multiply => x[0] * x[1],
            Function::Divide => x[0] / x[1],
            Function::Modulo => x[0] % x[1],
            Function::Power => x[0].powf(x[1]),
            Function::Min => x[0].min(x[1]),
            Function::Max => x[0].max(x[1]),
            Function::Abs => x[0].abs(),
            Function::Sign => sign(x[0]),
            Function::Sqrt => x[0].sqrt(),
            Function::Exp => x[0].exp(),
            Function::Ln => x[0].ln(),
            Function::Log => x[0].log10(),
            Function::Floor => x[0].floor(),
            Function::Ceil => x[0].ceil(),
            Function::Round => x[0].round(),
            Function::Sin => degrees::sin(x[0]),
            Function::Cos => degrees::cos(x[0]),
            Function::Tan => degrees::tan(x[0]),
            Function::Asin => degrees::asin(x[0]),
            Function::Acos => degrees::acos(x[0]),
            Function::Atan => degrees::atan(x[0]),
            Function::Atan2 => degrees::atan2(x[0], x[1]),
            Function::Less => f64::from(x[0] < x[1]),
            Function::LessEqual => f64::from(x[0] <= x[1]),
            Function::Select => {
                if x[0] != 0.0 {
                    x[1]
                } else {
                    x[2]
                }
            }
            Function::SmallestSingularValue => {
                singular::least(&[[x[0], x[1], x[2]], [x[3], x[4], x[5]], [x[6], x[7], x[8]]])
            }
        }
    }

    /// Bounds of its value for arguments within these ranges, if it is a finite number for all of them; else
    /// [`Interval::ALL`].
    pub fn range(self, x: &[Interval]) -> Interval {
        range::of(self, x)
    }
}

/// OpenSCAD's sign: 0 for zero.
fn sign(x: f64) -> f64 {
    if x > 0.0 {
        1.0
    } else if x < 0.0 {
        -1.0
    } else {
        0.0
    }
}

/// Trigonometry in degrees, exact where the result is a simple number.
pub mod degrees {
    /// The sine; exact at multiples of 30°. As in OpenSCAD, it is −0 at odd multiples of 180°.
    pub fn sin(angle: f64) -> f64 {
        if !angle.is_finite() {
            return f64::NAN;
        }
        // Reduce to [0, 360), then to the first quadrant, where the exact values are. Whole turns are 0, and only −0 is −0.
        let turn = if angle == 0.0 { angle } else { angle.rem_euclid(360.0) + 0.0 };
        let (half, is_negative) = if turn >= 180.0 { (turn - 180.0, true) } else { (turn, false) };
        let value = quarter_sine(if half > 90.0 { 180.0 - half } else { half });
        if is_negative { -value } else { value }
    }

    /// The cosine; exact at multiples of 30°. As in OpenSCAD, it is 0 at 90° and −0 at 270°.
    pub fn cos(angle: f64) -> f64 {
        if !angle.is_finite() {
            return f64::NAN;
        }
        let turn = angle.rem_euclid(360.0);
        let (half, is_lower) = if turn >= 180.0 { (turn - 180.0, true) } else { (turn, false) };
        let (quarter, is_left) = if half > 90.0 { (180.0 - half, true) } else { (half, false) };
        let value = quarter_sine(90.0 - quarter);
        if is_lower != is_left { -value } else { value }
    }

    /// The sine of an angle from 0° to 90°.
    fn quarter_sine(angle: f64) -> f64 {
        match angle {
            0.0 => angle,
            30.0 => 0.5,
            90.0 => 1.0,
            45.0 => std::f64::consts::FRAC_1_SQRT_2,
            60.0 => 0.75f64.sqrt(),
            _ => angle.to_radians().sin(),
        }
    }

    /// The tangent; exact at multiples of 45°, and the nearest number at those of 30°.
    pub fn tan(angle: f64) -> f64 {
        match angle.rem_euclid(180.0) {
            0.0 => 0f64.copysign(cos(angle)),
            30.0 => 3f64.sqrt() / 3.0,
            150.0 => -3f64.sqrt() / 3.0,
            45.0 => 1.0,
            90.0 => f64::INFINITY.copysign(90.0 - angle.rem_euclid(360.0) + 1.0),
            135.0 => -1.0,
            _ => sin(angle) / cos(angle),
        }
    }

    /// The angle of that sine, from −90° to 90°.
    pub fn asin(x: f64) -> f64 {
        exact(x.asin().to_degrees(), |angle| sin(angle) == x)
    }

    /// The angle of that cosine, from 0° to 180°.
    pub fn acos(x: f64) -> f64 {
        exact(x.acos().to_degrees(), |angle| cos(angle) == x)
    }

    /// The angle of that tangent, from −90° to 90°.
    pub fn atan(x: f64) -> f64 {
        exact(x.atan().to_degrees(), |angle| tan(angle) == x)
    }

    /// The angle of the point (x, y), from −180° to 180°.
    pub fn atan2(y: f64, x: f64) -> f64 {
        let angle = y.atan2(x).to_degrees();
        exact(angle, |rounded| (rounded - angle).abs() < 1e-13 * 360.0)
    }

    /// The nearest whole degree if it fits, else the angle as it is.
    fn exact(angle: f64, fits: impl Fn(f64) -> bool) -> f64 {
        let rounded = angle.round();
        if (rounded - angle).abs() < 1e-9 && fits(rounded) { rounded } else { angle }
    }

    #[cfg(test)]
    mod tests {
        use super::*;

        #[test]
        fn simple_angles_have_simple_values() {
            assert_eq!((sin(30.0), sin(150.0), sin(210.0), sin(-30.0)), (0.5, 0.5, -0.5, -0.5));
            assert_eq!((cos(60.0), cos(90.0), cos(-120.0), cos(720.0)), (0.5, 0.0, -0.5, 1.0));
            assert_eq!((tan(45.0), tan(135.0), tan(-45.0)), (1.0, -1.0, -1.0));
            assert_eq!((tan(90.0), tan(270.0)), (f64::INFINITY, f64::NEG_INFINITY));
            assert_eq!((asin(0.5), acos(0.5), atan(1.0), atan2(1.0, -1.0)), (30.0, 60.0, 45.0, 135.0));
        }

        #[test]
        fn zeros_have_the_signs_of_openscad() {
            let signs = |function: fn(f64) -> f64, angles: &[f64]| -> Vec<f64> {
                angles.iter().map(|angle| 1.0 / function(*angle)).collect()
            };
            let (up, down) = (f64::INFINITY, f64::NEG_INFINITY);
            let sines = [-180.0, 180.0, 360.0, -360.0, -0.0, 540.0, 0.0];
            assert_eq!(signs(sin, &sines), [down, down, up, up, down, down, up]);
            assert_eq!(signs(cos, &[90.0, 270.0, -90.0, -270.0, 450.0]), [up, down, down, up, up]);
            assert_eq!(signs(tan, &[0.0, 180.0, 360.0, -180.0, -0.0, 540.0]), [up, down, up, down, up, down]);
            assert_eq!(atan2(sin(-180.0), cos(-180.0)), -180.0);
            assert_eq!((1.0 / atan2(-0.0, 1.0), 1.0 / asin(-0.0), 1.0 / atan(-0.0)), (down, down, down));
        }
    }
}
