//! What a program can be evaluated over.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number type. Truth values are 1 and 0 of it.
#[expect(missing_docs, reason = "the methods are those of f64")]
pub trait Number:
    Copy + Debug + Neg<Output = Self> + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// The constant `value`.
    fn of(value: f64) -> Self;
    fn abs(self) -> Self;
    /// -1, 0 or 1.
    fn sign(self) -> Self;
    fn floor(self) -> Self;
    fn sqrt(self) -> Self;
    fn sin(self) -> Self;
    fn cos(self) -> Self;
    fn exp(self) -> Self;
    fn ln(self) -> Self;
    fn min(self, other: Self) -> Self;
    fn max(self, other: Self) -> Self;
    /// The angle of the point whose y this is and whose x is given.
    fn atan2(self, x: Self) -> Self;
    /// Whether this is less.
    fn less(self, other: Self) -> Self;
    /// Whether this is not greater.
    fn less_equal(self, other: Self) -> Self;
    /// Whether both are equal.
    fn equal(self, other: Self) -> Self;
    /// One of two numbers, by a truth value.
    fn select(condition: Self, accept: Self, reject: Self) -> Self;
}

macro_rules! implement_number {
    ($number:ident, $of:expr) => {
        impl Number for $number {
            #[inline]
            fn of(value: f64) -> Self {
                $of(value)
            }
            #[inline]
            fn sign(self) -> Self {
                if self == 0.0 { 0.0 } else { self.signum() }
            }
            #[inline]
            fn abs(self) -> Self {
                $number::abs(self)
            }
            #[inline]
            fn floor(self) -> Self {
                $number::floor(self)
            }
            #[inline]
            fn sqrt(self) -> Self {
                $number::sqrt(self)
            }
            #[inline]
            fn sin(self) -> Self {
                $number::sin(self)
            }
            #[inline]
            fn cos(self) -> Self {
                $number::cos(self)
            }
            #[inline]
            fn exp(self) -> Self {
                $number::exp(self)
            }
            #[inline]
            fn ln(self) -> Self {
                $number::ln(self)
            }
            #[inline]
            fn min(self, other: Self) -> Self {
                $number::min(self, other)
            }
            #[inline]
            fn max(self, other: Self) -> Self {
                $number::max(self, other)
            }
            #[inline]
            fn atan2(self, other: Self) -> Self {
                $number::atan2(self, other)
            }
            #[inline]
            fn less(self, other: Self) -> Self {
                (self < other).into()
            }
            #[inline]
            fn less_equal(self, other: Self) -> Self {
                (self <= other).into()
            }
            #[inline]
            fn equal(self, other: Self) -> Self {
                (self == other).into()
            }
            #[inline]
            fn select(condition: Self, accept: Self, reject: Self) -> Self {
                if condition == 0.0 { reject } else { accept }
            }
        }
    };
}

implement_number!(f64, |value| value);
// As the GPU computes: every constant is rounded.
implement_number!(f32, |value| value as f32);
