//! Smooth curves as chains of circular arcs: pairs of arcs that share a tangent where they meet.

use crate::contour::unit;
use crate::region::{Edge, Point, add, cross, dot, scale, sub};

/// An arc whose chord leaves it at a smaller angle, in radians, becomes a line: it strays from the chord by less than
/// its length divided by 400,000, while the ends of an arc about a centre so far away would be inexact.
const STRAIGHT: f64 = 1e-5;

/// How often a piece of a curve is halved at most.
const MAX_DEPTH: u32 = 10;

/// Where between the ends of a piece its distance from the arcs is looked at.
const PROBES: [f64; 4] = [0.125, 0.375, 0.625, 0.875];

/// Arcs within about `tolerance` of the curve that `at` gives, as point and unit tangent, for parameters from 0 to 1.
/// The curve is cut into equal pieces first, each of which must turn less than half a turn.
pub(crate) fn approximate(at: impl Fn(f64) -> (Point, Point), pieces: u32, tolerance: f64) -> Vec<Edge> {
    let mut edges = Vec::new();
    for k in 0..pieces {
        let [from, to] = [k, k + 1].map(|k| f64::from(k) / f64::from(pieces));
        refine(&at, [from, to], tolerance, MAX_DEPTH, &mut edges);
    }
    edges
}

fn refine(
    at: &impl Fn(f64) -> (Point, Point),
    [from, to]: [f64; 2],
    tolerance: f64,
    depth: u32,
    edges: &mut Vec<Edge>,
) {
    let pair = biarc(at(from), at(to));
    let is_off = |part: f64| {
        let (point, _) = at(from + part * (to - from));
        pair.iter().map(|edge| edge.distance(point)).fold(f64::INFINITY, f64::min) > tolerance
    };
    if depth > 0 && PROBES.into_iter().any(is_off) {
        let middle = 0.5 * (from + to);
        refine(at, [from, middle], tolerance, depth - 1, edges);
        refine(at, [middle, to], tolerance, depth - 1, edges);
    } else {
        edges.extend(pair);
    }
}

/// Two arcs that leave a point in one direction and arrive at another in another, their tangents equally long.
fn biarc((from, leaving): (Point, Point), (to, arriving): (Point, Point)) -> [Edge; 2] {
    let (way, sum) = (sub(to, from), add(leaving, arriving));
    let along = dot(way, sum);
    let root = (along * along + 2.0 * (1.0 - dot(leaving, arriving)) * dot(way, way)).max(0.0).sqrt();
    let tangent = dot(way, way) / (along + root);
    let middle = scale(add(add(from, scale(leaving, tangent)), sub(to, scale(arriving, tangent))), 0.5);
    [arc(from, leaving, middle), arc(to, scale(arriving, -1.0), middle).reversed()]
}

/// The arc from a point, in a direction, to another point.
fn arc(from: Point, direction: Point, to: Point) -> Edge {
    let way = sub(to, from);
    let sine = cross(direction, unit(way));
    let curvature = 2.0 * sine / way[0].hypot(way[1]);
    let radius = 1.0 / curvature;
    if sine.abs() < STRAIGHT || !radius.is_finite() {
        return Edge::Line { from, to };
    }
    let center = add(from, scale([-direction[1], direction[0]], radius));
    let offset = sub(from, center);
    let sweep = 2.0 * cross(direction, way).atan2(dot(direction, way));
    Edge::Arc { center, radius: radius.abs(), start: offset[1].atan2(offset[0]), sweep }
}
