//! Closed intervals of numbers, for facts that hold for every value of a live number.

use std::ops::{Add, Mul, Neg, Sub};

/// All numbers from `min` to `max`, both included. Ends may be infinite; `min <= max` always.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The least number.
    pub min: f64,
    /// The greatest number.
    pub max: f64,
}

impl Interval {
    /// Every number.
    pub const ALL: Interval = Interval { min: f64::NEG_INFINITY, max: f64::INFINITY };

    /// The numbers between `a` and `b`, in whichever order they come. A NaN makes it [`ALL`](Self::ALL).
    pub fn new(a: f64, b: f64) -> Self {
        if a.is_nan() || b.is_nan() { Self::ALL } else { Self { min: a.min(b), max: a.max(b) } }
    }

    /// The one number `value`.
    pub fn point(value: f64) -> Self {
        Self::new(value, value)
    }

    /// Whether it is a single number.
    pub fn is_point(self) -> bool {
        self.min == self.max
    }

    /// Whether both ends are finite.
    pub fn is_finite(self) -> bool {
        self.min.is_finite() && self.max.is_finite()
    }

    /// Whether `value` lies in it.
    pub fn contains(self, value: f64) -> bool {
        self.min <= value && value <= self.max
    }

    /// The smallest interval that holds both.
    pub fn hull(self, other: Interval) -> Interval {
        Interval { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// The greatest absolute value in it.
    pub fn magnitude(self) -> f64 {
        self.min.abs().max(self.max.abs())
    }

    /// The values of a function that never decreases.
    pub fn increasing(self, f: impl Fn(f64) -> f64) -> Interval {
        Interval::new(f(self.min), f(self.max))
    }

    /// The absolute values.
    pub fn abs(self) -> Interval {
        if self.min >= 0.0 {
            self
        } else if self.max <= 0.0 {
            -self
        } else {
            Interval { min: 0.0, max: self.magnitude() }
        }
    }

    /// The lesser of two numbers, one of each.
    pub fn min(self, other: Interval) -> Interval {
        Interval { min: self.min.min(other.min), max: self.max.min(other.max) }
    }

    /// The greater of two numbers, one of each.
    pub fn max(self, other: Interval) -> Interval {
        Interval { min: self.min.max(other.min), max: self.max.max(other.max) }
    }

    /// The interval spanned by some numbers.
    fn spanned(values: [f64; 4]) -> Interval {
        let min = values.iter().fold(f64::INFINITY, |least, value| least.min(*value));
        let max = values.iter().fold(f64::NEG_INFINITY, |most, value| most.max(*value));
        Interval::new(min, max)
    }
}

impl Neg for Interval {
    type Output = Interval;
    fn neg(self) -> Interval {
        Interval { min: -self.max, max: -self.min }
    }
}

impl Add for Interval {
    type Output = Interval;
    fn add(self, other: Interval) -> Interval {
        Interval::new(self.min + other.min, self.max + other.max)
    }
}

impl Sub for Interval {
    type Output = Interval;
    fn sub(self, other: Interval) -> Interval {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Interval;
    fn mul(self, other: Interval) -> Interval {
        // An end may be infinite and the other zero: as a limit of finite products that is zero.
        let product = |a: f64, b: f64| if a == 0.0 || b == 0.0 { 0.0 } else { a * b };
        Interval::spanned([
            product(self.min, other.min),
            product(self.min, other.max),
            product(self.max, other.min),
            product(self.max, other.max),
        ])
    }
}
