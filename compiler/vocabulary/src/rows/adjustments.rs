//! Adjustments of distances.

use super::{anywhere, length, number, size};
use crate::form::Form;
use crate::table::{Class, Kind, Parameter, Row};

/// Growing.
pub static OFFSET: Row = adjustment(
    "offset",
    "adjust_offset",
    &[length("r", 0.0, "by how much; negative shrinks")],
    Class::ExactOutside,
    "Grows a solid by a distance in every direction.",
);

/// Hollowing.
pub static SHELL: Row = adjustment(
    "shell",
    "adjust_shell",
    &[size("thickness", 1.0, "thickness of the wall")],
    Class::ExactOutside,
    "The wall that lies half to each side of a solid's surface.",
);

/// Scaling.
pub static SCALE: Row = adjustment(
    "scale",
    "adjust_scale",
    &[number("factor", None, "how many times as large; positive")],
    Class::Exact,
    "Turns the distances of a solid into those of the solid made larger, asked at the point made smaller.",
);

const fn adjustment(
    name: &'static str,
    function: &'static str,
    parameters: &'static [Parameter],
    class: Class,
    manual: &'static str,
) -> Row {
    Row {
        name,
        function,
        kind: Kind::Adjust,
        parameters,
        class,
        module: false,
        round: false,
        form: &Form::UNKNOWN,
        bounds: anywhere,
        manual,
        example: "",
    }
}
