//! Whether a curve is a true curve or a polygon.

use chiaro_solid::Scalar;
use chiaro_syntax::Diagnostic;

use super::instance::Instance;
use super::{Stop, decide};
use crate::value::Value;

/// What an explicit `$fn` does to curves. `$fa` and `$fs` never make facets.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Facets {
    /// From 3 to 12 it means a shape, such as a hexagonal nut, and more stands for a true curve.
    #[default]
    Auto,
    /// Every `$fn` makes a polygon of that many sides, as in OpenSCAD.
    Exact,
    /// Curves are always true curves.
    Smooth,
}

/// Up to how many sides a polygon is taken for a shape.
pub(super) const MOST_SIDES_OF_A_SHAPE: f64 = 12.0;

/// From how many sides on nobody sees a difference: their corners stand out by 0.0005 % of the radius.
const MOST_SIDES: f64 = 1000.0;

impl Instance<'_> {
    /// The number of flat sides of a full turn, if a curve here is not a true curve.
    pub(super) fn sides(&mut self) -> Result<Option<u32>, Stop> {
        let Value::Number(number) = &self.number_of_sides else { return Ok(None) };
        if self.facets == Facets::Smooth {
            return Ok(None);
        }
        let number = decide::constant(number, self.head, "`$fn`, the number of sides of a curve")?;
        if number.is_nan() || number <= 0.0 {
            return Ok(None);
        }
        let sides = number.max(3.0).ceil();
        match self.facets {
            Facets::Auto if sides > MOST_SIDES_OF_A_SHAPE => Ok(None),
            _ if sides > MOST_SIDES => {
                let message = format!("`$fn` is taken for a true curve, being more than {MOST_SIDES}");
                self.report(Diagnostic::warning(self.head, message));
                Ok(None)
            }
            _ => Ok(Some(sides as u32)),
        }
    }
}

/// How much less than its radius a polygon reaches to the middle of its sides.
pub(super) fn apothem_factor(sides: u32) -> Scalar {
    Scalar::from((std::f64::consts::PI / f64::from(sides)).cos())
}
