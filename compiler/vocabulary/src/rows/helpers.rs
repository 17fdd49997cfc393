//! Building blocks that the field calls by name. Their parameters are all their arguments.

use super::{angle, anywhere, number, vec2, vec3};
use crate::form::Form;
use crate::table::{Class, Kind, Parameter, Row};

/// How many steps of [`JOINT_STEP`] bring a joint of so many operands within a hundred thousandth of its radius, for
/// each exponent: Newton's method about halves the distance to the joint of n equal operands, until it is near.
pub const fn joint_steps(operands: usize) -> u32 {
    2 + operands.next_power_of_two().ilog2()
}

/// The point moved into the plane z = 0, where a slice asks its solid.
pub static PLANE_POINT: Row = helper(
    "plane_point",
    &[vec3(number("p", None, "the point"))],
    "The point moved into the plane z = 0, where a slice asks its solid.",
);

/// The point moved towards z into a cylinder.
pub static CONFINE_DISC: Row = helper(
    "confine_disc",
    &[vec3(number("p", None, "the point")), number("radius", None, "radius of the cylinder")],
    "The point moved towards z into a cylinder.",
);

/// The distance at the point before it was moved.
pub static CONFINE_JOIN: Row = helper(
    "confine_join",
    &[
        number("d", None, "distance at the confined point"),
        number("gap", None, "how far the point was moved"),
        number("lipschitz", None, "the distance's Lipschitz constant"),
    ],
    "The distance at the point before it was moved.",
);

/// The distance to a solid of a given height, from that to its plane shape.
pub static OP_EXTRUDE: Row = helper(
    "op_extrude",
    &[
        number("d", None, "distance in the plane"),
        number("z", None, "height of the point"),
        number("height", None, "height of the solid"),
    ],
    "The distance to a solid of a given height, from that to its plane shape.",
);

/// The distance at a point, from that in its section of a tapering solid.
pub static OP_TAPER: Row = helper(
    "op_taper",
    &[
        number("d", None, "distance in the section"),
        number("z", None, "height of the point"),
        number("height", None, "height of the solid"),
        vec2(number("scale_top", None, "how the top is scaled against the bottom, in x and y")),
    ],
    "The distance at a point, from that in its section of a tapering solid.",
);

/// The joint of two distances with exponent 1.
pub static JOINT_CHAMFER: Row = helper(
    "joint_chamfer",
    &[number("a", None, "one distance"), number("b", None, "the other"), number("r", None, "radius")],
    "The joint of two distances with exponent 1.",
);

/// The joint of two distances with exponent 2.
pub static JOINT_FILLET: Row = helper(
    "joint_fillet",
    &[number("a", None, "one distance"), number("b", None, "the other"), number("r", None, "radius")],
    "The joint of two distances with exponent 2.",
);

/// The joint of two distances with exponent 3.
pub static JOINT_SMOOTH: Row = helper(
    "joint_smooth",
    &[number("a", None, "one distance"), number("b", None, "the other"), number("r", None, "radius")],
    "The joint of two distances with exponent 3.",
);

/// Adds an operand to the sum of Newton's method for a joint.
pub static JOINT_TERM: Row = helper(
    "joint_term",
    &[
        vec2(number("state", None, "the sum so far and its slope")),
        number("d", None, "an operand's distance"),
        number("x", None, "the joint so far"),
        number("r", None, "radius"),
        number("exponent", None, "1, 2 or 3"),
    ],
    "Adds an operand to the sum of Newton's method for a joint.",
);

/// A step of Newton's method for a joint.
pub static JOINT_STEP: Row = helper(
    "joint_step",
    &[
        vec2(number("state", None, "the sum over all operands and its slope")),
        number("x", None, "the joint so far"),
        number("r", None, "radius"),
    ],
    "A step of Newton's method for a joint.",
);

/// How much an operand counts in a joint, to be divided by the sum over all.
pub static JOINT_WEIGHT: Row = helper(
    "joint_weight",
    &[
        number("d", None, "an operand's distance"),
        number("x", None, "the joint"),
        number("r", None, "radius"),
        number("exponent", None, "1, 2 or 3"),
    ],
    "How much an operand counts in a joint, to be divided by the sum over all.",
);

/// The state of an outline without pieces.
pub static OUTLINE_START: Row = helper("outline_start", &[], "The state of an outline without pieces.");

/// Adds a line to an outline.
pub static OUTLINE_LINE: Row = helper(
    "outline_line",
    &[
        vec2(number("state", None, "the state")),
        vec2(number("p", None, "the point")),
        vec2(number("a", None, "where the line starts")),
        vec2(number("b", None, "where it ends")),
    ],
    "Adds a line to an outline.",
);

/// Adds an arc to an outline.
pub static OUTLINE_ARC: Row = helper(
    "outline_arc",
    &[
        vec2(number("state", None, "the state")),
        vec2(number("p", None, "the point")),
        vec2(number("a", None, "where the arc starts")),
        vec2(number("b", None, "where it ends")),
        vec2(number("pivot", None, "its centre")),
        angle("sweep", None, "how far it goes, anticlockwise if positive"),
    ],
    "Adds an arc to an outline.",
);

/// Which stage of a solid is asked at a height, and how far up in it.
pub static LOFT_LEVEL: Row = helper(
    "loft_level",
    &[
        number("z", None, "height of the point"),
        number("height", None, "height of all stages together"),
        number("stages", None, "how many there are"),
    ],
    "Which stage of a solid is asked at a height, and how far up in it.",
);

/// Adds a line to an outline that changes with the height.
pub static LOFT_SIDE: Row = helper(
    "loft_side",
    &[
        vec2(number("state", None, "the state")),
        vec2(number("p", None, "the point")),
        number("t", None, "how far up in the stage"),
        vec2(number("a_below", None, "where the line starts at the bottom of the stage")),
        vec2(number("a_above", None, "where it starts at the top")),
        vec2(number("b_below", None, "where it ends at the bottom")),
        vec2(number("b_above", None, "where it ends at the top")),
    ],
    "Adds a line to an outline that changes with the height.",
);

/// The distance to an outline.
pub static OUTLINE_END: Row =
    helper("outline_end", &[vec2(number("state", None, "the state"))], "The distance to an outline.");

/// The state of a polytope without faces.
pub static POLYTOPE_START: Row = helper("polytope_start", &[], "The state of a polytope without faces.");

/// Adds a triangle to a convex polytope.
pub static POLYTOPE_TRIANGLE: Row = helper(
    "polytope_triangle",
    &[
        vec2(number("state", None, "the state")),
        vec3(number("p", None, "the point")),
        vec3(number("a", None, "a corner")),
        vec3(number("b", None, "the next corner, anticlockwise seen from outside")),
        vec3(number("c", None, "the last corner")),
    ],
    "Adds a triangle to a convex polytope.",
);

/// The distance to a convex polytope.
pub static POLYTOPE_END: Row =
    helper("polytope_end", &[vec2(number("state", None, "the state"))], "The distance to a convex polytope.");

const fn helper(function: &'static str, parameters: &'static [Parameter], manual: &'static str) -> Row {
    Row {
        name: function,
        function,
        kind: Kind::Helper,
        parameters,
        class: Class::Bound,
        module: false,
        round: false,
        form: &Form::UNKNOWN,
        bounds: anywhere,
        manual,
        example: "",
    }
}
