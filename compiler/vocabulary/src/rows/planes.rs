//! Plane shapes. Their boxes are all of z.

use super::{angle, anywhere, around_zero, number, size, vec2};
use crate::bounds::Bounds;
use crate::interval::Interval;
use crate::table::{Class, Kind, Row};

/// A disc.
pub static CIRCLE: Row = Row {
    name: "circle",
    function: "sd_circle",
    kind: Kind::Plane,
    parameters: &[size("r", 1.0, "radius")],
    class: Class::Exact,
    module: false,
    round: true,
    bounds: |a| flat(a[0].max, a[0].max),
    manual: "The disc around the origin.",
    example: "circle(r = 10);",
};

/// A rectangle.
pub static RECTANGLE: Row = Row {
    name: "rectangle",
    function: "sd_rectangle",
    kind: Kind::Plane,
    parameters: &[vec2(size("half_size", 0.5, "how far it reaches to each side along x and y"))],
    class: Class::Exact,
    module: false,
    round: false,
    bounds: |a| flat(a[0].max, a[1].max),
    manual: "The rectangle around the origin with its edges along the axes.",
    example: "",
};

/// A regular polygon.
pub static NGON: Row = Row {
    name: "ngon",
    function: "sd_ngon",
    kind: Kind::Plane,
    parameters: &[
        size("r", 10.0, "distance of its corners from the origin"),
        number("n", Some(6.0), "number of sides, 3 or more"),
    ],
    class: Class::Exact,
    module: false,
    round: false,
    bounds: |a| flat(a[0].max, a[0].max),
    manual: "The regular polygon around the origin, its first corner on the x axis.",
    example: "",
};

/// An ellipse.
pub static ELLIPSE: Row = Row {
    name: "ellipse",
    function: "sd_ellipse",
    kind: Kind::Plane,
    parameters: &[vec2(size("radii", 1.0, "radii along x and y"))],
    class: Class::ExactOutside,
    module: true,
    round: false,
    bounds: |a| flat(a[0].max, a[1].max),
    manual: "The disc stretched along the axes.",
    example: "linear_extrude(5) ellipse(radii = [20, 10]);",
};

/// A ring.
pub static RING: Row = Row {
    name: "ring",
    function: "sd_ring",
    kind: Kind::Plane,
    parameters: &[size("outer", 10.0, "outer radius"), size("inner", 8.0, "inner radius, less than the outer one")],
    class: Class::Exact,
    module: true,
    round: true,
    bounds: |a| flat(a[0].max, a[0].max),
    manual: "The ring between two circles around the origin.",
    example: "linear_extrude(5) ring(outer = 20, inner = 15);",
};

/// A star.
pub static STAR: Row = Row {
    name: "star",
    function: "sd_star",
    kind: Kind::Plane,
    parameters: &[
        size("outer", 10.0, "distance of its points from the origin"),
        size("inner", 5.0, "distance of its notches from the origin, less than its points'"),
        number("n", Some(5.0), "number of points, 2 or more"),
    ],
    class: Class::Exact,
    module: true,
    round: false,
    bounds: |a| flat(a[0].max(a[1]).max, a[0].max(a[1]).max),
    manual: "The star around the origin, its first point on the x axis.",
    example: "linear_extrude(5) star(outer = 20, inner = 9, n = 5);",
};

/// A sector of the plane.
pub static WEDGE: Row = Row {
    name: "wedge",
    function: "sd_wedge",
    kind: Kind::Plane,
    parameters: &[angle("start", "where it starts"), angle("sweep", "how far it goes, anticlockwise")],
    class: Class::Exact,
    module: false,
    round: false,
    bounds: anywhere,
    manual: "The endless sector of the plane with its apex at the origin.",
    example: "",
};

/// The box of what reaches so far to each side along x and y.
fn flat(half_x: f64, half_y: f64) -> Bounds {
    Bounds::new(around_zero(Interval::point(half_x)), around_zero(Interval::point(half_y)), Interval::ALL)
}
