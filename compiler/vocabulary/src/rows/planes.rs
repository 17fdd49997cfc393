//! Plane shapes. Their boxes are all of z.

use super::{angle, anywhere, around_zero, number, size, vec2};
use crate::bounds::Bounds;
use crate::form::Form;
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
    form: &Form::DISC,
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
    form: &Form::RECTANGLE,
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
    form: &Form::UNKNOWN,
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
    form: &Form::UNKNOWN,
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
    form: &Form::RING,
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
    form: &Form::UNKNOWN,
    bounds: |a| flat(a[0].max(a[1]).max, a[0].max(a[1]).max),
    manual: "The star around the origin, its first point on the x axis.",
    example: "linear_extrude(5) star(outer = 20, inner = 9, n = 5);",
};

/// A thick arc.
pub static ARC: Row = Row {
    name: "arc",
    function: "sd_arc",
    kind: Kind::Plane,
    parameters: &[
        size("r", 10.0, "radius of its middle line"),
        size("thickness", 1.0, "thickness"),
        angle("start", Some(0.0), "where it starts"),
        angle("sweep", Some(90.0), "how far it goes, anticlockwise"),
    ],
    class: Class::ExactOutside,
    module: true,
    round: false,
    form: &Form::UNKNOWN,
    bounds: |a| flat(a[0].max + 0.5 * a[1].max, a[0].max + 0.5 * a[1].max),
    manual: "The arc around the origin with round ends.",
    example: "linear_extrude(5) arc(r = 20, thickness = 4, start = 30, sweep = 240);",
};

/// A sector of a disc.
pub static PIE: Row = Row {
    name: "pie",
    function: "sd_pie",
    kind: Kind::Plane,
    parameters: &[
        size("r", 10.0, "radius"),
        angle("start", Some(0.0), "where it starts"),
        angle("sweep", Some(90.0), "how far it goes, anticlockwise; less than a full turn"),
    ],
    class: Class::Exact,
    module: true,
    round: false,
    form: &Form::UNKNOWN,
    bounds: |a| flat(a[0].max, a[0].max),
    manual: "The sector of a disc around the origin.",
    example: "linear_extrude(5) pie(r = 20, start = 30, sweep = 300);",
};

/// An egg.
pub static EGG: Row = Row {
    name: "egg",
    function: "sd_egg",
    kind: Kind::Plane,
    parameters: &[
        size("r_bottom", 8.0, "radius of the disc at the origin"),
        size("r_top", 4.0, "radius of the upper disc"),
        size("h", 10.0, "how far up y the upper disc's centre is"),
    ],
    class: Class::Exact,
    module: true,
    round: false,
    form: &Form::UNKNOWN,
    bounds: |a| {
        let reach = a[0].max.max(a[1].max);
        let top = a[0].max.max(a[1].max + a[2].max);
        let bottom = (-a[0].max).min(a[2].min - a[1].max);
        Bounds::new(around_zero(Interval::point(reach)), Interval { min: bottom, max: top }, Interval::ALL)
    },
    manual: "The convex hull of two discs, one at the origin and one above it.",
    example: "linear_extrude(5) egg(r_bottom = 10, r_top = 5, h = 10);",
};

/// A pointed oval.
pub static VESICA: Row = Row {
    name: "vesica",
    function: "sd_vesica",
    kind: Kind::Plane,
    parameters: &[size("r", 10.0, "radius of the discs"), size("apart", 10.0, "distance of their centres, along x")],
    class: Class::Exact,
    module: true,
    round: false,
    form: &Form::UNKNOWN,
    bounds: |a| flat(a[0].max, a[0].max),
    manual: "The pointed oval that two discs have in common.",
    example: "linear_extrude(5) vesica(r = 20, apart = 20);",
};

/// A sector of the plane.
pub static WEDGE: Row = Row {
    name: "wedge",
    function: "sd_wedge",
    kind: Kind::Plane,
    parameters: &[angle("start", None, "where it starts"), angle("sweep", None, "how far it goes, anticlockwise")],
    class: Class::Exact,
    module: false,
    round: false,
    form: &Form::UNKNOWN,
    bounds: anywhere,
    manual: "The endless sector of the plane with its apex at the origin.",
    example: "",
};

/// The box of what reaches so far to each side along x and y.
fn flat(half_x: f64, half_y: f64) -> Bounds {
    Bounds::new(around_zero(Interval::point(half_x)), around_zero(Interval::point(half_y)), Interval::ALL)
}
