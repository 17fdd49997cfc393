//! Decisions that numbers make. A live number decides only if all values it may take decide alike.

use chiaro_solid::Scalar;
use chiaro_syntax::Span;

use super::instance::{Instance, error};
use super::{Demotion, Stop};

/// On which side of zero a number lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sign {
    Negative,
    /// Zero, or no number at all.
    Zero,
    Positive,
}

impl Sign {
    pub(super) fn is_positive(self) -> bool {
        self == Sign::Positive
    }
}

/// The sign of a number, which decides what `reason` says.
pub(super) fn sign(number: &Scalar, span: Span, reason: &'static str) -> Result<Sign, Stop> {
    let range = number.range();
    match number.constant() {
        Some(value) if value > 0.0 => Ok(Sign::Positive),
        Some(value) if value < 0.0 => Ok(Sign::Negative),
        Some(_) => Ok(Sign::Zero),
        None if range.min > 0.0 => Ok(Sign::Positive),
        None if range.max < 0.0 => Ok(Sign::Negative),
        None if range.min == 0.0 && range.max == 0.0 => Ok(Sign::Zero),
        None => Err(demote(number.clone(), span, reason)),
    }
}

/// Whether a number is negative; zero may be among the values of a live one.
pub(super) fn is_negative(number: &Scalar, span: Span, reason: &'static str) -> Result<bool, Stop> {
    let range = number.range();
    match number.constant() {
        Some(value) => Ok(value < 0.0),
        None if range.min >= 0.0 => Ok(false),
        None if range.max < 0.0 => Ok(true),
        None => Err(demote(number.clone(), span, reason)),
    }
}

/// Asks for a live number to be known that may have no finite value.
pub(super) fn finite(number: &Scalar, span: Span) -> Result<(), Stop> {
    match number {
        Scalar::Live(_) if !number.is_finite() => Err(demote(number.clone(), span, "a finite number")),
        _ => Ok(()),
    }
}

/// Whether numbers are finite. Asks for live ones to be known that may not be.
pub(super) fn are_finite<'a>(mut numbers: impl Iterator<Item = &'a Scalar> + Clone, span: Span) -> Result<bool, Stop> {
    numbers.clone().try_for_each(|number| finite(number, span))?;
    Ok(numbers.all(Scalar::is_finite))
}

/// The constant value of a number.
pub(super) fn constant(number: &Scalar, span: Span, reason: &'static str) -> Result<f64, Stop> {
    number.constant().ok_or_else(|| demote(number.clone(), span, reason))
}

/// Asks for the number's parameters to become structural.
pub(super) fn demote(number: Scalar, span: Span, reason: &'static str) -> Stop {
    Stop::Demote(Box::new(Demotion { number, span, reason }))
}

impl Instance<'_> {
    /// Whether all these sizes are positive and finite. If not, there is nothing; that is worth a warning unless a
    /// size is zero.
    pub(super) fn are_sizes(&mut self, sizes: &[Scalar], span: Span) -> Result<bool, Stop> {
        for size in sizes {
            if !size.is_finite() && size.constant().is_some() {
                self.warn(span, "this size is not finite, so that there is nothing");
                return Ok(false);
            }
            match sign(size, span, "whether a size is positive")? {
                Sign::Positive => {}
                Sign::Zero => return Ok(false),
                Sign::Negative => {
                    self.warn(span, "this size is negative, so that there is nothing");
                    return Ok(false);
                }
            }
        }
        Ok(true)
    }

    /// The radius that edges are rounded with, if they are. More than `most` does not fit.
    pub(super) fn rounding(&mut self, parameter: &str, most: &Scalar) -> Result<Option<Scalar>, Stop> {
        let Some(radius) = self.finite_number(parameter)? else { return Ok(None) };
        let span = self.place(parameter);
        match sign(&radius, span, "whether edges are rounded")? {
            Sign::Zero => return Ok(None),
            Sign::Negative => {
                return Err(error(
                    span,
                    format!("`{parameter}` is the radius of rounded edges and cannot be negative"),
                ));
            }
            Sign::Positive => {}
        }
        if is_negative(&(most.clone() - radius.clone()), span, "whether rounded edges fit the shape")? {
            let most =
                most.constant().map_or(String::new(), |most| format!(": at most {}", (most * 1e6).floor() / 1e6));
            return Err(error(span, format!("edges of this radius do not fit the shape{most}")));
        }
        Ok(Some(radius))
    }
}
