//! Whether a curve is a true curve or a polygon.

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
