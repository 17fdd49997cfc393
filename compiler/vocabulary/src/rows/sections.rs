//! Warps, and sections of solids made from plane shapes. What they do to bounds is the field's to say: it depends on
//! the bounds of what they are given.

use super::{angle, anywhere, number, size, vec2};
use crate::form::Form;
use crate::table::{Class, Kind, Row};

/// A twist about z.
pub static TWIST: Row = Row {
    name: "twist",
    function: "warp_twist",
    kind: Kind::Warp,
    parameters: &[angle("rate", None, "how far it turns for each millimetre of height, anticlockwise seen from above")],
    class: Class::Bound,
    module: false,
    round: false,
    form: &Form::UNKNOWN,
    bounds: anywhere,
    manual: "Turns a solid about z in proportion to the height.",
    example: "",
};

/// A full turn about z.
pub static REVOLVE: Row = Row {
    name: "revolve",
    function: "section_revolve",
    kind: Kind::Section,
    parameters: &[],
    class: Class::Exact,
    module: false,
    round: false,
    form: &Form::UNKNOWN,
    bounds: anywhere,
    manual: "Turns a plane shape about z: its x is the distance from the axis, its y the height.",
    example: "",
};

/// A turn about z with flat sides.
pub static REVOLVE_FACETS: Row = Row {
    name: "revolve_facets",
    function: "section_revolve_facets",
    kind: Kind::Section,
    parameters: &[number("n", None, "number of sides, 3 or more")],
    class: Class::Bound,
    module: false,
    round: false,
    form: &Form::UNKNOWN,
    bounds: anywhere,
    manual: "Turns a plane shape about z along a regular polygon; its Lipschitz constant is 1 / cos(180° / n).",
    example: "",
};

/// An upright solid.
pub static SLICE: Row = Row {
    name: "slice",
    function: "section_slice",
    kind: Kind::Section,
    parameters: &[],
    class: Class::Exact,
    module: false,
    round: false,
    form: &Form::UNKNOWN,
    bounds: anywhere,
    manual: "Draws a plane shape out along z without end.",
    example: "",
};

/// An upright solid that is turned, and then scaled.
pub static EXTRUDE: Row = Row {
    name: "extrude",
    function: "section_extrude",
    kind: Kind::Section,
    parameters: &[
        size("height", 1.0, "the height at which twist and scale are reached"),
        angle("twist", None, "how far the top is turned against the bottom, anticlockwise seen from above"),
        vec2(number("scale_top", Some(1.0), "how the top is scaled against the bottom, in x and y; not negative")),
    ],
    class: Class::Bound,
    module: false,
    round: false,
    form: &Form::UNKNOWN,
    bounds: anywhere,
    manual: "Draws a plane shape out along z, turned and then scaled with the height.",
    example: "",
};
