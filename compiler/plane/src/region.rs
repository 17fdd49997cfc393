//! Regions of the plane.

/// A point of the plane, in millimetres.
pub type Point = [f64; 2];

/// A piece of a region's outline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Edge {
    /// A straight edge.
    Line {
        /// Where it starts.
        from: Point,
        /// Where it ends.
        to: Point,
    },
    /// An arc of a circle.
    Arc {
        /// The circle's centre.
        center: Point,
        /// The circle's radius, in millimetres; positive.
        radius: f64,
        /// The angle it starts at, in radians anticlockwise from the x axis.
        start: f64,
        /// How far it goes, in radians; negative if clockwise; at most a full turn.
        sweep: f64,
    },
}

/// A closed outline: each edge starts where the one before it ends.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Contour {
    /// Its edges.
    pub edges: Vec<Edge>,
}

/// The points with an odd number of contours around them. So holes need no direction, and contours that cover each
/// other cancel, as OpenSCAD's `polygon` has it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Region {
    /// Its outlines.
    pub contours: Vec<Contour>,
}

impl Edge {
    /// The point it starts at.
    pub fn start(&self) -> Point {
        match *self {
            Edge::Line { from, .. } => from,
            Edge::Arc { center, radius, start, .. } => on_circle(center, radius, start),
        }
    }

    /// The point it ends at.
    pub fn end(&self) -> Point {
        match *self {
            Edge::Line { to, .. } => to,
            Edge::Arc { center, radius, start, sweep } => on_circle(center, radius, start + sweep),
        }
    }

    /// The same points, walked the other way.
    pub fn reversed(&self) -> Edge {
        match *self {
            Edge::Line { from, to } => Edge::Line { from: to, to: from },
            Edge::Arc { center, radius, start, sweep } => {
                Edge::Arc { center, radius, start: start + sweep, sweep: -sweep }
            }
        }
    }

    /// How long it is, in millimetres.
    pub fn length(&self) -> f64 {
        match *self {
            Edge::Line { from, to } => distance(from, to),
            Edge::Arc { radius, sweep, .. } => radius * sweep.abs(),
        }
    }

    /// Whether all its numbers are finite and an arc's radius is positive.
    pub fn is_finite(&self) -> bool {
        match *self {
            Edge::Line { from, to } => from.iter().chain(&to).all(|x| x.is_finite()),
            Edge::Arc { center, radius, start, sweep } => {
                center.iter().chain(&[radius, start, sweep]).all(|x| x.is_finite()) && radius > 0.0
            }
        }
    }
}

impl Region {
    /// Whether it has no outline at all, so no points. (A region whose outlines cancel is not recognised.)
    pub fn is_empty(&self) -> bool {
        self.contours.iter().all(|contour| contour.edges.is_empty())
    }

    /// The edges of all its outlines.
    pub fn edges(&self) -> impl Iterator<Item = &Edge> {
        self.contours.iter().flat_map(|contour| &contour.edges)
    }
}

/// The point of a circle at an angle in radians.
pub(crate) fn on_circle(center: Point, radius: f64, angle: f64) -> Point {
    let (sin, cos) = angle.sin_cos();
    [center[0] + radius * cos, center[1] + radius * sin]
}

pub(crate) fn add(a: Point, b: Point) -> Point {
    [a[0] + b[0], a[1] + b[1]]
}

pub(crate) fn sub(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

pub(crate) fn scale(a: Point, factor: f64) -> Point {
    [a[0] * factor, a[1] * factor]
}

pub(crate) fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Positive where `b` is anticlockwise of `a`.
pub(crate) fn cross(a: Point, b: Point) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

pub(crate) fn distance(a: Point, b: Point) -> f64 {
    (b[0] - a[0]).hypot(b[1] - a[1])
}
