//! The direction and the turning of contours.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::region::{Contour, Edge, Point, cross, dot, sub};

/// Turns smaller than this, in radians, are no corners.
pub(crate) const STRAIGHT: f64 = 1e-9;

impl Contour {
    /// The same points, walked the other way.
    pub fn reversed(&self) -> Contour {
        Contour { edges: self.edges.iter().rev().map(Edge::reversed).collect() }
    }

    /// 1 if it is convex, does not cross itself and runs anticlockwise; −1 if so clockwise; else `None`.
    pub(crate) fn convex_direction(&self) -> Option<i32> {
        let mut total = 0.0;
        let (mut left, mut right) = (false, false);
        for (edge, next) in self.edges.iter().zip(self.edges.iter().cycle().skip(1)) {
            if corner_turn(edge, next).abs() > PI - STRAIGHT {
                // It walks back on itself: there may be nothing inside.
                return None;
            }
            for turn in [edge.turn(), corner_turn(edge, next)] {
                left |= turn > STRAIGHT;
                right |= turn < -STRAIGHT;
                total += turn;
            }
        }
        let once = (total.abs() - TAU).abs() < 1e-6;
        match (left, right) {
            (true, false) if once => Some(1),
            (false, true) if once => Some(-1),
            _ => None,
        }
    }
}

impl Edge {
    /// How far its direction turns along it, in radians; positive if anticlockwise.
    pub(crate) fn turn(&self) -> f64 {
        match *self {
            Edge::Line { .. } => 0.0,
            Edge::Arc { sweep, .. } => sweep,
        }
    }

    /// The unit vector it starts along.
    pub(crate) fn start_direction(&self) -> Point {
        match *self {
            Edge::Line { from, to } => unit(sub(to, from)),
            Edge::Arc { start, sweep, .. } => along_circle(start, sweep),
        }
    }

    /// The unit vector it ends along.
    pub(crate) fn end_direction(&self) -> Point {
        match *self {
            Edge::Line { from, to } => unit(sub(to, from)),
            Edge::Arc { start, sweep, .. } => along_circle(start + sweep, sweep),
        }
    }
}

/// How far one turns from the end of an edge to the start of the next, in radians between −π and π.
pub(crate) fn corner_turn(edge: &Edge, next: &Edge) -> f64 {
    let (before, after) = (edge.end_direction(), next.start_direction());
    let turn = cross(before, after).atan2(dot(before, after));
    if turn == -PI { PI } else { turn }
}

/// A vector of length 1 in the same direction; zero for the zero vector.
pub(crate) fn unit(vector: Point) -> Point {
    let length = vector[0].hypot(vector[1]);
    if length > 0.0 { [vector[0] / length, vector[1] / length] } else { [0.0, 0.0] }
}

/// The direction in which one walks along a circle where it has an angle.
fn along_circle(angle: f64, sweep: f64) -> Point {
    let (sin, cos) = (angle + FRAC_PI_2.copysign(sweep)).sin_cos();
    [cos, sin]
}
