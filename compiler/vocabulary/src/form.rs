//! What a shape is made of: the flat and round faces that bound it, and the discs that it is the hull of.
//!
//! Faces of different shapes that lie in each other decide what a Boolean of them is, so they are compared as numbers of
//! the arguments. A face can be moved outwards, which makes a larger shape of the same row with all its other faces.

/// A number of the arguments: the sum of those with these indices, times these factors.
pub type Weights = &'static [(usize, f64)];

/// What is known of a shape's faces. The default is that nothing is.
#[derive(Clone, Copy, Debug)]
pub struct Form {
    /// Its flat faces.
    pub flats: &'static [Flat],
    /// Its round faces.
    pub rounds: &'static [Round],
    /// Whether the shape is what lies within all of these faces.
    pub is_whole: bool,
    /// Discs and balls whose convex hull holds the shape and touches every flat face that the shape does; empty if that is
    /// not known.
    pub discs: &'static [Disc],
    /// Whether the shape is the convex hull of the centres of these discs, which are points.
    pub is_polytope: bool,
}

/// A flat face: the shape has points in the plane dot(p, normal) = offset, and near them none beyond.
#[derive(Clone, Copy, Debug)]
pub struct Flat {
    /// The direction out of the shape, of length 1.
    pub normal: [f64; 3],
    /// How far the plane is from the origin.
    pub offset: Weights,
    /// How it moves; none if it can't.
    pub growth: Option<Growth>,
}

/// A round face: part of a cylinder about z, or of a sphere about the origin.
#[derive(Clone, Copy, Debug)]
pub struct Round {
    /// Whether it is of a sphere.
    pub is_sphere: bool,
    /// Whether the shape lies around it instead of within.
    pub is_hollow: bool,
    /// Its radius.
    pub radius: Weights,
    /// How it moves.
    pub growth: Growth,
}

/// How a face is moved out of the shape by a length.
#[derive(Clone, Copy, Debug)]
pub enum Growth {
    /// By adding `factor` times the length to an argument, and moving the shape by `shift` times the length along the
    /// face's normal.
    Argument {
        /// Which argument.
        index: usize,
        /// How much of the length it is changed by.
        factor: f64,
        /// How much of the length the shape moves by.
        shift: f64,
    },
    /// By other arguments, and by moving the shape along the normal: from the arguments and the length. None if it can't
    /// be moved that far.
    Constant(fn(&[f64], f64) -> Grown),
}

/// A shape's arguments when a face has moved, and how far the shape has along that face's normal; none if the face can't move
/// that far.
pub type Grown = Option<(Vec<f64>, f64)>;

/// A disc across z, grown by a ball.
#[derive(Clone, Copy, Debug)]
pub struct Disc {
    /// Its centre.
    pub center: [Weights; 3],
    /// Its radius.
    pub radius: Weights,
    /// The ball's radius.
    pub ball: Weights,
}

impl Form {
    /// Nothing is known.
    pub const UNKNOWN: Form = Form { flats: &[], rounds: &[], is_whole: false, discs: &[], is_polytope: false };

    /// The ball of the radius that is the first argument.
    pub const BALL: Form = Form {
        rounds: &[Round { is_sphere: true, ..BARREL }],
        is_whole: true,
        discs: &[Disc { ball: &[(0, 1.0)], ..POINT }],
        ..Form::UNKNOWN
    };

    /// The disc of the plane with the radius that is the first argument.
    pub const DISC: Form =
        Form { rounds: &[BARREL], is_whole: true, discs: &[Disc { radius: &[(0, 1.0)], ..POINT }], ..Form::UNKNOWN };

    /// The ring of the plane between the radii that are the first two arguments.
    pub const RING: Form = Form {
        rounds: &[
            BARREL,
            Round {
                is_hollow: true,
                radius: &[(1, 1.0)],
                growth: Growth::Argument { index: 1, factor: -1.0, shift: 0.0 },
                ..BARREL
            },
        ],
        discs: Form::DISC.discs,
        ..Form::UNKNOWN
    };

    /// The rectangle with half its sizes as arguments.
    pub const RECTANGLE: Form = Form {
        flats: &[side(0, 1.0), side(0, -1.0), side(1, 1.0), side(1, -1.0)],
        is_whole: true,
        discs: &[corner([-1, -1, 0]), corner([1, -1, 0]), corner([-1, 1, 0]), corner([1, 1, 0])],
        ..Form::UNKNOWN
    };

    /// The box with half its sizes as arguments.
    pub const BOX: Form = Form {
        flats: &[side(0, 1.0), side(0, -1.0), side(1, 1.0), side(1, -1.0), side(2, 1.0), side(2, -1.0)],
        is_whole: true,
        discs: BOX_CORNERS,
        ..Form::UNKNOWN
    };

    /// A shape in the box with half its sizes as arguments, of which only that is known.
    pub const IN_BOX: Form = Form { discs: BOX_CORNERS, ..Form::UNKNOWN };

    /// The cylinder about z with its radius and half its height as arguments.
    pub const CYLINDER: Form = Form {
        flats: &[end(1.0, 1), end(-1.0, 1)],
        rounds: &[BARREL],
        is_whole: true,
        discs: &[end_disc(-1.0, 1, &[(0, 1.0)]), end_disc(1.0, 1, &[(0, 1.0)])],
        ..Form::UNKNOWN
    };

    /// The frustum about z with its lower and upper radius and half its height as arguments.
    pub const CONE: Form = Form {
        flats: &[
            Flat { growth: Some(Growth::Constant(|a, by| frustum(a[0], a[1], a[2], by))), ..end(1.0, 2) },
            Flat {
                growth: Some(Growth::Constant(|a, by| {
                    let (grown, shift) = frustum(a[1], a[0], a[2], by)?;
                    Some((vec![grown[1], grown[0], grown[2]], shift))
                })),
                ..end(-1.0, 2)
            },
        ],
        discs: &[end_disc(-1.0, 2, &[(0, 1.0)]), end_disc(1.0, 2, &[(1, 1.0)])],
        ..Form::UNKNOWN
    };

    /// The ring about z with its radius and that of its profile as arguments.
    pub const TORUS: Form =
        Form { discs: &[Disc { radius: &[(0, 1.0)], ball: &[(1, 1.0)], ..POINT }], ..Form::UNKNOWN };

    /// The capsule up z with its length and radius as arguments.
    pub const CAPSULE: Form =
        Form { discs: &[ball_at(&[], &[(1, 1.0)]), ball_at(&[(0, 1.0)], &[(1, 1.0)])], ..Form::UNKNOWN };

    /// The hull of two balls up z with their radii and their distance as arguments.
    pub const ROUND_CONE: Form =
        Form { discs: &[ball_at(&[], &[(0, 1.0)]), ball_at(&[(2, 1.0)], &[(1, 1.0)])], ..Form::UNKNOWN };

    /// The half space with its normal and its offset as arguments. Its face depends on them.
    pub const HALF_SPACE: Form = Form::UNKNOWN;

    /// The part of a ball above a height, with its radius and that height as arguments.
    pub const DOME: Form = Form {
        flats: &[Flat {
            normal: [0.0, 0.0, -1.0],
            offset: &[(1, -1.0)],
            growth: Some(Growth::Argument { index: 1, factor: -1.0, shift: 0.0 }),
        }],
        rounds: Form::BALL.rounds,
        is_whole: true,
        discs: &[
            Disc { center: [&[], &[], &[(1, 1.0)]], radius: &[(0, 1.0)], ball: &[] },
            Disc { center: [&[], &[], &[(0, 1.0)]], radius: &[(0, 1.0)], ball: &[] },
        ],
        ..Form::UNKNOWN
    };

    /// The pyramid on a square with the square's edge and its height as arguments.
    pub const PYRAMID: Form = Form {
        discs: &[
            base_corner(-0.5, -0.5),
            base_corner(0.5, -0.5),
            base_corner(-0.5, 0.5),
            base_corner(0.5, 0.5),
            Disc { center: [&[], &[], &[(1, 1.0)]], ..POINT },
        ],
        ..POLYTOPE
    };

    /// The regular octahedron with the distance of its corners as argument.
    pub const OCTAHEDRON: Form = Form {
        discs: &[
            scaled([1.0, 0.0, 0.0]),
            scaled([-1.0, 0.0, 0.0]),
            scaled([0.0, 1.0, 0.0]),
            scaled([0.0, -1.0, 0.0]),
            scaled([0.0, 0.0, 1.0]),
            scaled([0.0, 0.0, -1.0]),
        ],
        ..POLYTOPE
    };

    /// The regular tetrahedron with the distance of its corners as argument.
    pub const TETRAHEDRON: Form =
        Form { discs: &[scaled([T, T, T]), scaled([T, -T, -T]), scaled([-T, T, -T]), scaled([-T, -T, T])], ..POLYTOPE };

    /// The regular dodecahedron with the distance of its corners as argument.
    pub const DODECAHEDRON: Form = Form {
        discs: &[
            scaled([T, T, T]),
            scaled([T, T, -T]),
            scaled([T, -T, T]),
            scaled([T, -T, -T]),
            scaled([-T, T, T]),
            scaled([-T, T, -T]),
            scaled([-T, -T, T]),
            scaled([-T, -T, -T]),
            scaled([0.0, D_LOW, D_HIGH]),
            scaled([0.0, -D_LOW, D_HIGH]),
            scaled([0.0, D_LOW, -D_HIGH]),
            scaled([0.0, -D_LOW, -D_HIGH]),
            scaled([D_LOW, D_HIGH, 0.0]),
            scaled([-D_LOW, D_HIGH, 0.0]),
            scaled([D_LOW, -D_HIGH, 0.0]),
            scaled([-D_LOW, -D_HIGH, 0.0]),
            scaled([D_HIGH, 0.0, D_LOW]),
            scaled([D_HIGH, 0.0, -D_LOW]),
            scaled([-D_HIGH, 0.0, D_LOW]),
            scaled([-D_HIGH, 0.0, -D_LOW]),
        ],
        ..POLYTOPE
    };

    /// The regular icosahedron with the distance of its corners as argument.
    pub const ICOSAHEDRON: Form = Form {
        discs: &[
            scaled([I_LOW, 0.0, I_HIGH]),
            scaled([-I_LOW, 0.0, I_HIGH]),
            scaled([I_LOW, 0.0, -I_HIGH]),
            scaled([-I_LOW, 0.0, -I_HIGH]),
            scaled([I_HIGH, I_LOW, 0.0]),
            scaled([I_HIGH, -I_LOW, 0.0]),
            scaled([-I_HIGH, I_LOW, 0.0]),
            scaled([-I_HIGH, -I_LOW, 0.0]),
            scaled([0.0, I_HIGH, I_LOW]),
            scaled([0.0, I_HIGH, -I_LOW]),
            scaled([0.0, -I_HIGH, I_LOW]),
            scaled([0.0, -I_HIGH, -I_LOW]),
        ],
        ..POLYTOPE
    };

    /// The chain's link with half its straight length, its bend's radius and its profile's as arguments.
    pub const LINK: Form = Form {
        discs: &[
            Disc { center: [&[], &[(0, 1.0)], &[]], radius: &[(1, 1.0)], ball: &[(2, 1.0)] },
            Disc { center: [&[], &[(0, -1.0)], &[]], radius: &[(1, 1.0)], ball: &[(2, 1.0)] },
        ],
        ..Form::UNKNOWN
    };
}

/// 1 / √3.
const T: f64 = 0.577_350_269_189_625_8;
/// 1 / (g √3) and g / √3 with the golden ratio g.
const D_LOW: f64 = 0.356_822_089_773_089_93;
const D_HIGH: f64 = 0.934_172_358_962_715_7;
/// 1 / √(1 + g²) and g / √(1 + g²).
const I_LOW: f64 = 0.525_731_112_119_133_6;
const I_HIGH: f64 = 0.850_650_808_352_039_9;

const POINT: Disc = Disc { center: [&[], &[], &[]], radius: &[], ball: &[] };
const POLYTOPE: Form = Form { is_polytope: true, ..Form::UNKNOWN };

/// The side of a cylinder of the radius that is the first argument.
const BARREL: Round = Round {
    is_sphere: false,
    is_hollow: false,
    radius: &[(0, 1.0)],
    growth: Growth::Argument { index: 0, factor: 1.0, shift: 0.0 },
};

const ARGUMENTS: [Weights; 3] = [&[(0, 1.0)], &[(1, 1.0)], &[(2, 1.0)]];
const OPPOSITES: [Weights; 3] = [&[(0, -1.0)], &[(1, -1.0)], &[(2, -1.0)]];

const BOX_CORNERS: &[Disc] = &[
    corner([-1, -1, -1]),
    corner([1, -1, -1]),
    corner([-1, 1, -1]),
    corner([1, 1, -1]),
    corner([-1, -1, 1]),
    corner([1, -1, 1]),
    corner([-1, 1, 1]),
    corner([1, 1, 1]),
];

/// The side of a box across an axis, half of whose size there is the argument of that number.
const fn side(axis: usize, sign: f64) -> Flat {
    let mut normal = [0.0; 3];
    normal[axis] = sign;
    let growth = Growth::Argument { index: axis, factor: 0.5, shift: 0.5 };
    Flat { normal, offset: ARGUMENTS[axis], growth: Some(growth) }
}

/// The corner of a box with half its sizes as arguments.
const fn corner(signs: [i8; 3]) -> Disc {
    const fn at(axis: usize, sign: i8) -> Weights {
        match sign {
            -1 => OPPOSITES[axis],
            1 => ARGUMENTS[axis],
            _ => &[],
        }
    }
    Disc { center: [at(0, signs[0]), at(1, signs[1]), at(2, signs[2])], ..POINT }
}

/// The end of a shape about z, half of whose height is an argument.
const fn end(sign: f64, index: usize) -> Flat {
    let growth = Growth::Argument { index, factor: 0.5, shift: 0.5 };
    Flat { normal: [0.0, 0.0, sign], offset: ARGUMENTS[index], growth: Some(growth) }
}

/// The disc at such an end.
const fn end_disc(sign: f64, index: usize, radius: Weights) -> Disc {
    let height = if sign < 0.0 { OPPOSITES[index] } else { ARGUMENTS[index] };
    Disc { center: [&[], &[], height], radius, ball: &[] }
}

/// A ball on z.
const fn ball_at(z: Weights, radius: Weights) -> Disc {
    Disc { center: [&[], &[], z], radius: &[], ball: radius }
}

/// A corner of the square in the plane z = 0 with its edge as the first argument.
const fn base_corner(x: f64, y: f64) -> Disc {
    const HALVES: [Weights; 2] = [&[(0, -0.5)], &[(0, 0.5)]];
    Disc { center: [HALVES[(x > 0.0) as usize], HALVES[(y > 0.0) as usize], &[]], ..POINT }
}

/// The point in a direction whose distance is the first argument.
const fn scaled(direction: [f64; 3]) -> Disc {
    const fn along(part: f64) -> Weights {
        // The parts that occur, since what is borrowed for ever can't be computed.
        if part == 1.0 {
            &[(0, 1.0)]
        } else if part == -1.0 {
            &[(0, -1.0)]
        } else if part == T {
            &[(0, T)]
        } else if part == -T {
            &[(0, -T)]
        } else if part == D_LOW {
            &[(0, D_LOW)]
        } else if part == -D_LOW {
            &[(0, -D_LOW)]
        } else if part == D_HIGH {
            &[(0, D_HIGH)]
        } else if part == -D_HIGH {
            &[(0, -D_HIGH)]
        } else if part == I_LOW {
            &[(0, I_LOW)]
        } else if part == -I_LOW {
            &[(0, -I_LOW)]
        } else if part == I_HIGH {
            &[(0, I_HIGH)]
        } else if part == -I_HIGH {
            &[(0, -I_HIGH)]
        } else {
            &[]
        }
    }
    Disc { center: [along(direction[0]), along(direction[1]), along(direction[2])], ..POINT }
}

/// A frustum drawn out beyond the end with the radius `top`, along its slant; not to its tip.
fn frustum(bottom: f64, top: f64, half_height: f64, by: f64) -> Grown {
    let slope = 0.5 * (top - bottom) / half_height;
    // What narrows is drawn out by half of what is left of it at the most.
    let by = if slope < 0.0 { by.min(-0.5 * top / slope) } else { by };
    let grown = top + slope * by;
    (grown > 0.0 && by != 0.0).then(|| (vec![bottom, grown, half_height + 0.5 * by], 0.5 * by))
}
