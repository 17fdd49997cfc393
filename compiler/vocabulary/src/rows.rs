//! The rows of the table.
//!
//! Each row is a static of its own, so that the compiler's stages can name the ones they need, and [`rows`] lists them
//! all in the order of the manual.

mod adjustments;
mod helpers;
mod planes;
mod sections;
mod solids;

pub use adjustments::{OFFSET, SCALE, SHELL};
pub use helpers::{
    CONFINE_DISC, CONFINE_JOIN, JOINT_CHAMFER, JOINT_FILLET, JOINT_SMOOTH, JOINT_STEP, JOINT_TERM, JOINT_WEIGHT,
    LOFT_LEVEL, LOFT_SIDE, OP_EXTRUDE, OP_TAPER, OUTLINE_ARC, OUTLINE_END, OUTLINE_LINE, OUTLINE_START, PLANE_POINT,
    POLYTOPE_END, POLYTOPE_START, POLYTOPE_TRIANGLE, joint_steps,
};
pub use planes::{ARC, CIRCLE, EGG, ELLIPSE, NGON, PIE, RECTANGLE, RING, STAR, VESICA, WEDGE};
pub use sections::{EXTRUDE, REVOLVE, REVOLVE_FACETS, SLICE, TWIST};
pub use solids::{
    BOX, BOX_FRAME, CAPSULE, CONE, CYLINDER, DODECAHEDRON, DOME, ELLIPSOID, GYROID, HALF_SPACE, ICOSAHEDRON, LINK,
    OCTAHEDRON, PYRAMID, ROUND_CONE, SPHERE, TETRAHEDRON, TORUS,
};

use crate::bounds::Bounds;
use crate::interval::Interval;
use crate::table::{Parameter, Row, Type, Unit};

static ROWS: &[&Row] = &[
    &SPHERE,
    &BOX,
    &CYLINDER,
    &CONE,
    &TORUS,
    &CAPSULE,
    &ROUND_CONE,
    &ELLIPSOID,
    &HALF_SPACE,
    &BOX_FRAME,
    &TETRAHEDRON,
    &OCTAHEDRON,
    &DODECAHEDRON,
    &ICOSAHEDRON,
    &LINK,
    &PYRAMID,
    &DOME,
    &GYROID,
    &CIRCLE,
    &RECTANGLE,
    &NGON,
    &ELLIPSE,
    &RING,
    &STAR,
    &ARC,
    &PIE,
    &EGG,
    &VESICA,
    &WEDGE,
    &TWIST,
    &REVOLVE,
    &REVOLVE_FACETS,
    &SLICE,
    &EXTRUDE,
    &OFFSET,
    &SHELL,
    &SCALE,
    &PLANE_POINT,
    &CONFINE_DISC,
    &CONFINE_JOIN,
    &OP_EXTRUDE,
    &OP_TAPER,
    &JOINT_CHAMFER,
    &JOINT_FILLET,
    &JOINT_SMOOTH,
    &JOINT_TERM,
    &JOINT_STEP,
    &JOINT_WEIGHT,
    &OUTLINE_START,
    &OUTLINE_LINE,
    &OUTLINE_ARC,
    &LOFT_LEVEL,
    &LOFT_SIDE,
    &OUTLINE_END,
    &POLYTOPE_START,
    &POLYTOPE_TRIANGLE,
    &POLYTOPE_END,
];

/// Every row, in the order of the manual.
pub fn rows() -> &'static [&'static Row] {
    ROWS
}

/// The row of this name.
pub fn row(name: &str) -> Option<&'static Row> {
    ROWS.iter().copied().find(|row| row.name == name)
}

/// A parameter that has to be positive.
const fn size(name: &'static str, default: f64, manual: &'static str) -> Parameter {
    Parameter { name, ty: Type::Float, unit: Unit::Size, default: Some(default), manual }
}

/// A length of either sign.
const fn length(name: &'static str, default: f64, manual: &'static str) -> Parameter {
    Parameter { name, ty: Type::Float, unit: Unit::Length, default: Some(default), manual }
}

/// An angle.
const fn angle(name: &'static str, default: Option<f64>, manual: &'static str) -> Parameter {
    Parameter { name, ty: Type::Float, unit: Unit::Angle, default, manual }
}

/// A plain number.
const fn number(name: &'static str, default: Option<f64>, manual: &'static str) -> Parameter {
    Parameter { name, ty: Type::Float, unit: Unit::Number, default, manual }
}

/// The same parameter with two components.
const fn vec2(parameter: Parameter) -> Parameter {
    Parameter { ty: Type::Vec2, ..parameter }
}

/// The same parameter with three components.
const fn vec3(parameter: Parameter) -> Parameter {
    Parameter { ty: Type::Vec3, ..parameter }
}

/// The bounds rule of what may be anywhere, and of what is no shape.
fn anywhere(_: &[Interval]) -> Bounds {
    Bounds::ALL
}

/// The interval from `-half` to `half`, for the greatest of its values.
fn around_zero(half: Interval) -> Interval {
    Interval { min: -half.max, max: half.max }
}
