//! Solids.

use super::{anywhere, around_zero, length, size, vec3};
use crate::bounds::Bounds;
use crate::form::Form;
use crate::interval::Interval;
use crate::table::{Class, Kind, Parameter, Row, Type, Unit};

/// A ball.
pub static SPHERE: Row = Row {
    name: "sphere",
    function: "sd_sphere",
    kind: Kind::Solid,
    parameters: &[size("r", 1.0, "radius")],
    class: Class::Exact,
    module: false,
    round: true,
    form: &Form::BALL,
    bounds: |a| Bounds::centred([a[0].max; 3]),
    manual: "The ball around the origin.",
    example: "sphere(r = 10);",
};

/// A box.
pub static BOX: Row = Row {
    name: "box",
    function: "sd_box",
    kind: Kind::Solid,
    parameters: &[vec3(size("half_size", 0.5, "how far it reaches to each side along x, y and z"))],
    class: Class::Exact,
    module: false,
    round: false,
    form: &Form::BOX,
    bounds: |a| Bounds::centred([a[0].max, a[1].max, a[2].max]),
    manual: "The box around the origin with its edges along the axes.",
    example: "",
};

/// A round cylinder.
pub static CYLINDER: Row = Row {
    name: "cylinder",
    function: "sd_cylinder",
    kind: Kind::Solid,
    parameters: &[size("r", 1.0, "radius"), size("half_height", 0.5, "how far it reaches up and down")],
    class: Class::Exact,
    module: false,
    round: false,
    form: &Form::CYLINDER,
    bounds: |a| upright(a[0], around_zero(a[1])),
    manual: "The round cylinder about z, as high above the origin as below.",
    example: "cylinder(r = 5, h = 20, center = true);",
};

/// A frustum or a cone.
pub static CONE: Row = Row {
    name: "cone",
    function: "sd_cone",
    kind: Kind::Solid,
    parameters: &[
        length("r_bottom", 1.0, "radius at the lower end; may be zero"),
        length("r_top", 0.0, "radius at the upper end; may be zero"),
        size("half_height", 0.5, "how far it reaches up and down"),
    ],
    class: Class::Exact,
    module: false,
    round: false,
    form: &Form::CONE,
    bounds: |a| upright(a[0].max(a[1]), around_zero(a[2])),
    manual: "The cone or frustum about z, as high above the origin as below.",
    example: "",
};

/// A torus.
pub static TORUS: Row = Row {
    name: "torus",
    function: "sd_torus",
    kind: Kind::Solid,
    parameters: &[
        size("major", 10.0, "radius of the circle that the ring runs around"),
        size("minor", 2.0, "radius of the ring's own round profile"),
    ],
    class: Class::Exact,
    module: true,
    round: false,
    form: &Form::TORUS,
    bounds: |a| upright(a[0] + a[1], around_zero(a[1])),
    manual: "The ring with a round profile that lies around z.",
    example: "torus(major = 20, minor = 5);",
};

/// A capsule.
pub static CAPSULE: Row = Row {
    name: "capsule",
    function: "sd_capsule",
    kind: Kind::Solid,
    parameters: &[size("h", 10.0, "distance between the centres of its ends"), size("r", 1.0, "radius")],
    class: Class::Exact,
    module: true,
    round: false,
    form: &Form::CAPSULE,
    bounds: |a| upright(a[1], Interval { min: -a[1].max, max: (a[0] + a[1]).max }),
    manual: "The cylinder with half balls as ends, from the origin up z.",
    example: "capsule(h = 20, r = 4);",
};

/// A round cone.
pub static ROUND_CONE: Row = Row {
    name: "round_cone",
    function: "sd_round_cone",
    kind: Kind::Solid,
    parameters: &[
        size("r_bottom", 2.0, "radius of the ball at the origin"),
        size("r_top", 1.0, "radius of the ball at the top"),
        size("h", 10.0, "height of the upper ball's centre"),
    ],
    class: Class::Exact,
    module: true,
    round: false,
    form: &Form::ROUND_CONE,
    bounds: |a| {
        let (bottom, top) = (a[0].max, (a[1] + a[2]).max);
        upright(a[0].max(a[1]), Interval { min: (-bottom).min(a[2].min - a[1].max), max: top.max(bottom) })
    },
    manual: "The convex hull of two balls, one at the origin and one above it.",
    example: "round_cone(r_bottom = 8, r_top = 3, h = 20);",
};

/// An ellipsoid.
pub static ELLIPSOID: Row = Row {
    name: "ellipsoid",
    function: "sd_ellipsoid",
    kind: Kind::Solid,
    parameters: &[vec3(size("radii", 1.0, "radii along x, y and z"))],
    class: Class::ExactOutside,
    module: true,
    round: false,
    form: &Form::IN_BOX,
    bounds: |a| Bounds::centred([a[0].max, a[1].max, a[2].max]),
    manual: "The ball stretched along the axes.",
    example: "ellipsoid(radii = [20, 10, 5]);",
};

/// A half space.
pub static HALF_SPACE: Row = Row {
    name: "half_space",
    function: "sd_half_space",
    kind: Kind::Solid,
    parameters: &[
        Parameter {
            name: "normal",
            ty: Type::Vec3,
            unit: Unit::Direction,
            default: None,
            manual: "direction out of the solid, at a right angle to its plane",
        },
        length("offset", 0.0, "how far the plane lies from the origin, along the normal"),
    ],
    class: Class::Exact,
    module: true,
    round: false,
    form: &Form::UNKNOWN,
    bounds: half_space,
    manual: "Everything to one side of a plane.",
    example: "intersection() { sphere(10); half_space(normal = [0, 0, 1], offset = 4); }",
};

/// The edges of a box.
pub static BOX_FRAME: Row = Row {
    name: "box_frame",
    function: "sd_box_frame",
    kind: Kind::Solid,
    parameters: &[
        vec3(size("half_size", 5.0, "how far it reaches to each side along x, y and z")),
        size("thickness", 1.0, "thickness of its bars, less than half_size"),
    ],
    class: Class::ExactOutside,
    module: true,
    round: false,
    form: &Form::IN_BOX,
    bounds: |a| Bounds::centred([a[0].max, a[1].max, a[2].max]),
    manual: "The twelve edges of a box, as bars of square profile.",
    example: "box_frame(half_size = [15, 10, 10], thickness = 2);",
};

/// An octahedron.
pub static OCTAHEDRON: Row = Row {
    name: "octahedron",
    function: "sd_octahedron",
    kind: Kind::Solid,
    parameters: &[size("r", 10.0, "distance of its corners from the origin")],
    class: Class::Exact,
    module: true,
    round: false,
    form: &Form::OCTAHEDRON,
    bounds: |a| Bounds::centred([a[0].max; 3]),
    manual: "The regular octahedron with its corners on the axes.",
    example: "octahedron(r = 10);",
};

/// A dome.
pub static DOME: Row = Row {
    name: "dome",
    function: "sd_dome",
    kind: Kind::Solid,
    parameters: &[size("r", 10.0, "radius of the ball"), length("cut", 0.0, "height at which it is cut, from -r to r")],
    class: Class::Exact,
    module: true,
    round: false,
    form: &Form::DOME,
    bounds: |a| {
        let cut = a[1].min.max(-a[0].max);
        upright(a[0], Interval { min: cut.min(a[0].max), max: a[0].max })
    },
    manual: "The part of a ball above a plane.",
    example: "dome(r = 15, cut = 5);",
};

/// A tetrahedron.
pub static TETRAHEDRON: Row = Row {
    name: "tetrahedron",
    function: "sd_tetrahedron",
    kind: Kind::Solid,
    parameters: &[size("r", 10.0, "distance of its corners from the origin")],
    class: Class::Exact,
    module: true,
    round: false,
    form: &Form::TETRAHEDRON,
    bounds: |a| Bounds::centred([a[0].max; 3]),
    manual: "The regular tetrahedron, a corner in the direction [1, 1, 1].",
    example: "tetrahedron(r = 10);",
};

/// A dodecahedron.
pub static DODECAHEDRON: Row = Row {
    name: "dodecahedron",
    function: "sd_dodecahedron",
    kind: Kind::Solid,
    parameters: &[size("r", 10.0, "distance of its corners from the origin")],
    class: Class::Exact,
    module: true,
    round: false,
    form: &Form::DODECAHEDRON,
    bounds: |a| Bounds::centred([a[0].max; 3]),
    manual: "The regular dodecahedron, its edges across the axes.",
    example: "dodecahedron(r = 10);",
};

/// A icosahedron.
pub static ICOSAHEDRON: Row = Row {
    name: "icosahedron",
    function: "sd_icosahedron",
    kind: Kind::Solid,
    parameters: &[size("r", 10.0, "distance of its corners from the origin")],
    class: Class::Exact,
    module: true,
    round: false,
    form: &Form::ICOSAHEDRON,
    bounds: |a| Bounds::centred([a[0].max; 3]),
    manual: "The regular icosahedron, its edges across the axes.",
    example: "icosahedron(r = 10);",
};

/// A link of a chain.
pub static LINK: Row = Row {
    name: "link",
    function: "sd_link",
    kind: Kind::Solid,
    parameters: &[
        size("half_length", 5.0, "half the length of its straight parts"),
        size("major", 5.0, "radius of the circle that its bends run around"),
        size("minor", 1.5, "radius of its own round profile"),
    ],
    class: Class::Exact,
    module: true,
    round: false,
    form: &Form::LINK,
    bounds: |a| {
        let across = (a[1] + a[2]).max;
        Bounds::centred([across, across + a[0].max, a[2].max])
    },
    manual: "A chain's link: a ring drawn out along y.",
    example: "link(half_length = 8, major = 6, minor = 2);",
};

/// A square pyramid.
pub static PYRAMID: Row = Row {
    name: "pyramid",
    function: "sd_pyramid",
    kind: Kind::Solid,
    parameters: &[size("base", 10.0, "length of the edges of its square base"), size("h", 10.0, "height")],
    class: Class::Exact,
    module: true,
    round: false,
    form: &Form::PYRAMID,
    bounds: |a| {
        let half = around_zero(Interval::point(0.5 * a[0].max));
        Bounds::new(half, half, Interval { min: 0.0, max: a[1].max })
    },
    manual: "The pyramid on a square in the plane z = 0.",
    example: "pyramid(base = 20, h = 15);",
};

/// A gyroid wall.
pub static GYROID: Row = Row {
    name: "gyroid",
    function: "sd_gyroid",
    kind: Kind::Solid,
    parameters: &[
        size("period", 10.0, "after how much it repeats, along each axis"),
        size("thickness", 1.0, "thickness of the wall where it is thinnest"),
    ],
    class: Class::Bound,
    module: true,
    round: false,
    form: &Form::UNKNOWN,
    bounds: anywhere,
    manual: "An endless wall that curves through all of space; intersect it with a solid.",
    example: "intersection() { sphere(20); gyroid(period = 15, thickness = 1.5); }",
};

/// The box of what reaches `radius` to each side of the z axis, and along it over `z`.
fn upright(radius: Interval, z: Interval) -> Bounds {
    let across = around_zero(radius);
    Bounds::new(across, across, z)
}

/// Bounded on one side if its normal is along an axis.
fn half_space(a: &[Interval]) -> Bounds {
    let mut bounds = Bounds::ALL;
    let along = |axis: usize, sign: f64| (0..3).all(|i| a[i] == Interval::point(if i == axis { sign } else { 0.0 }));
    for axis in 0..3 {
        if along(axis, 1.0) {
            bounds.max[axis] = a[3].max;
        } else if along(axis, -1.0) {
            bounds.min[axis] = -a[3].max;
        }
    }
    bounds
}
