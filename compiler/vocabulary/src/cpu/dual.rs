//! Dual numbers: values with their gradients.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::number::Number;

/// A number with its gradient by the three coordinates of a point. Where a function has a kink, the gradient is that of
/// one side; the gradient of a square root at zero counts as zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual {
    /// The number.
    pub value: f64,
    /// How it changes along x, y and z.
    pub gradient: [f64; 3],
}

impl Dual {
    /// The coordinate `axis` of a point: it changes along that axis.
    pub fn coordinate(value: f64, axis: usize) -> Self {
        Self { value, gradient: std::array::from_fn(|index| if index == axis { 1.0 } else { 0.0 }) }
    }

    /// The coordinates of a point.
    pub fn point<const DIMENSION: usize>(point: [f64; DIMENSION]) -> [Self; DIMENSION] {
        std::array::from_fn(|axis| Self::coordinate(point[axis], axis))
    }

    /// The length of the gradient.
    pub fn slope(self) -> f64 {
        self.gradient.iter().map(|g| g * g).sum::<f64>().sqrt()
    }

    /// A function of this number, from its value and derivative there.
    #[inline]
    fn chain(self, value: f64, derivative: f64) -> Self {
        Self { value, gradient: self.gradient.map(|g| g * derivative) }
    }

    /// A function of two numbers, from its value and its derivatives by either.
    #[inline]
    fn chain_two(self, other: Self, value: f64, by_self: f64, by_other: f64) -> Self {
        let along = |axis: usize| self.gradient[axis] * by_self + other.gradient[axis] * by_other;
        Self { value, gradient: [along(0), along(1), along(2)] }
    }
}

impl Neg for Dual {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.chain(-self.value, -1.0)
    }
}

impl Add for Dual {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        self.chain_two(other, self.value + other.value, 1.0, 1.0)
    }
}

impl Sub for Dual {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self.chain_two(other, self.value - other.value, 1.0, -1.0)
    }
}

impl Mul for Dual {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        self.chain_two(other, self.value * other.value, other.value, self.value)
    }
}

impl Div for Dual {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        self.chain_two(other, quotient, 1.0 / other.value, -quotient / other.value)
    }
}

impl Number for Dual {
    #[inline]
    fn of(value: f64) -> Self {
        Self { value, gradient: [0.0; 3] }
    }

    #[inline]
    fn abs(self) -> Self {
        if self.value < 0.0 { -self } else { self }
    }

    #[inline]
    fn sign(self) -> Self {
        Self::of(Number::sign(self.value))
    }

    #[inline]
    fn floor(self) -> Self {
        Self::of(self.value.floor())
    }

    #[inline]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, if root > 0.0 { 0.5 / root } else { 0.0 })
    }

    #[inline]
    fn sin(self) -> Self {
        let (sine, cosine) = self.value.sin_cos();
        self.chain(sine, cosine)
    }

    #[inline]
    fn cos(self) -> Self {
        let (sine, cosine) = self.value.sin_cos();
        self.chain(cosine, -sine)
    }

    #[inline]
    fn exp(self) -> Self {
        let value = self.value.exp();
        self.chain(value, value)
    }

    #[inline]
    fn ln(self) -> Self {
        self.chain(self.value.ln(), 1.0 / self.value)
    }

    #[inline]
    fn min(self, other: Self) -> Self {
        if other.value < self.value { other } else { self }
    }

    #[inline]
    fn max(self, other: Self) -> Self {
        if other.value > self.value { other } else { self }
    }

    #[inline]
    fn atan2(self, x: Self) -> Self {
        let squared = self.value * self.value + x.value * x.value;
        let scale = if squared > 0.0 { 1.0 / squared } else { 0.0 };
        self.chain_two(x, self.value.atan2(x.value), x.value * scale, -self.value * scale)
    }

    #[inline]
    fn less(self, other: Self) -> Self {
        Self::of(self.value.less(other.value))
    }

    #[inline]
    fn less_equal(self, other: Self) -> Self {
        Self::of(self.value.less_equal(other.value))
    }

    #[inline]
    fn equal(self, other: Self) -> Self {
        Self::of(self.value.equal(other.value))
    }

    #[inline]
    fn select(condition: Self, accept: Self, reject: Self) -> Self {
        if condition.value == 0.0 { reject } else { accept }
    }
}
