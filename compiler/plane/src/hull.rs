//! Convex hulls.
//!
//! The hull of the ends of chords says which corners and arcs touch the true hull, and in which order; common tangents
//! of those that follow each other then bound it exactly.

use std::f64::consts::TAU;

use crate::contour::unit;
use crate::measure::{join, turn_from};
use crate::region::{Contour, Edge, Point, Region, add, cross, distance, dot, on_circle, scale, sub};

/// How far chords may be from their arcs, as a part of the diagonal of all operands.
const CHORD_TOLERANCE: f64 = 1e-5;

/// The hull of no more edges than this is worked out from all of them.
const FEW_EDGES: usize = 256;

/// The most corners of the polygon that tells which edges can't touch the hull.
const MOST_INNER_CORNERS: usize = 64;

/// The most chords that all arcs together become.
const MOST_CHORDS: usize = 4_000_000;

/// How far an angle may be beyond the end of an arc, in radians, by rounding.
const ANGLE_SLACK: f64 = 1e-9;

impl Region {
    /// The smallest convex region around all the regions; empty if it has no area.
    ///
    /// Arcs stay arcs: the hull of discs is bounded by arcs of their circles and by common tangents.
    pub fn hull(regions: &[Region]) -> Region {
        let edges: Vec<Edge> = regions.iter().flat_map(Region::edges).copied().collect();
        if !edges.iter().all(Edge::is_finite) {
            return Region::default();
        }
        let Some((min, max)) = edges.iter().map(Edge::bounds).reduce(join) else { return Region::default() };
        let size = distance(min, max);
        let edges = near_the_hull(edges, size);
        let corners = convex(touch_points(&edges, size * CHORD_TOLERANCE), size);
        let touched = touched(&edges, &corners);
        let contour = match touched.as_slice() {
            [] => Contour::default(),
            [Touched { arc: Some(arc), .. }] if arc.is_circle() => Contour { edges: vec![arc.circle()] },
            _ => outline(&touched, size),
        };
        Region::of(vec![contour])
    }
}

/// An arc as the part of a circle that faces some directions.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Facing {
    center: Point,
    radius: f64,
    /// The least angle, and how many radians anticlockwise from there the arc reaches.
    start: f64,
    sweep: f64,
}

impl Facing {
    fn of(edge: &Edge) -> Option<Facing> {
        match *edge {
            Edge::Line { .. } => None,
            Edge::Arc { center, radius, start, sweep } if sweep < 0.0 => {
                Some(Facing { center, radius, start: start + sweep, sweep: -sweep })
            }
            Edge::Arc { center, radius, start, sweep } => Some(Facing { center, radius, start, sweep }),
        }
    }

    fn is_circle(&self) -> bool {
        self.sweep > TAU - ANGLE_SLACK
    }

    fn circle(&self) -> Edge {
        Edge::Arc { center: self.center, radius: self.radius, start: 0.0, sweep: TAU }
    }

    fn faces(&self, angle: f64) -> bool {
        let turn = turn_from(self.start, angle, 1.0);
        turn <= self.sweep + ANGLE_SLACK || turn >= TAU - ANGLE_SLACK
    }
}

/// A point that may be a corner of the hull of chords, and the edge it lies on.
#[derive(Clone, Copy, Debug)]
struct TouchPoint {
    point: Point,
    edge: usize,
}

/// What the hull touches: a corner, or an arc from about `first` to about `last`.
#[derive(Clone, Copy, Debug)]
struct Touched {
    arc: Option<Facing>,
    first: Point,
    last: Point,
}

/// The edges without those that surely don't touch the hull: whose discs lie inside a polygon of points of the regions.
fn near_the_hull(edges: Vec<Edge>, size: f64) -> Vec<Edge> {
    if edges.len() <= FEW_EDGES {
        return edges;
    }
    let inner = convex(touch_points(&edges, 0.1 * size), size);
    let some = inner.iter().step_by(inner.len().div_ceil(MOST_INNER_CORNERS).max(1));
    let corners: Vec<Point> = some.map(|corner| corner.point).collect();
    let walls: Vec<(Point, Point)> = corners
        .iter()
        .zip(corners.iter().cycle().skip(1))
        .map(|(from, to)| (*from, unit([from[1] - to[1], to[0] - from[0]])))
        .collect();
    let depth = |point: Point| {
        let depths = walls.iter().map(|(from, inwards)| dot(sub(point, *from), *inwards));
        depths.fold(f64::INFINITY, f64::min)
    };
    let is_inside = |edge: &Edge| match *edge {
        Edge::Line { from, .. } => depth(from) > 0.0,
        Edge::Arc { center, radius, .. } => depth(center) > radius,
    };
    if walls.len() < 3 { edges } else { edges.into_iter().filter(|edge| !is_inside(edge)).collect() }
}

fn touch_points(edges: &[Edge], tolerance: f64) -> Vec<TouchPoint> {
    let most_chords = (MOST_CHORDS / edges.len().max(1)).max(8) as f64;
    let mut points = Vec::new();
    for (edge, curve) in edges.iter().enumerate() {
        match *curve {
            Edge::Line { from, .. } => points.push(TouchPoint { point: from, edge }),
            Edge::Arc { center, radius, start, sweep } => {
                let step = (2.0 * (1.0 - (tolerance / radius).min(0.5)).acos()).clamp(1e-7, 0.1);
                let chords = (sweep.abs() / step).ceil().clamp(1.0, most_chords) as u32;
                let angle = |k| start + sweep * f64::from(k) / f64::from(chords);
                let point = |k| TouchPoint { point: on_circle(center, radius, angle(k)), edge };
                points.extend((0..=chords).map(point));
            }
        }
    }
    points
}

/// The corners of the convex hull, anticlockwise; none if it has no area.
fn convex(mut points: Vec<TouchPoint>, size: f64) -> Vec<TouchPoint> {
    let flat = 1e-15 * size * size;
    points.sort_by(|a, b| a.point[0].total_cmp(&b.point[0]).then(a.point[1].total_cmp(&b.point[1])));
    let half = |points: &mut dyn Iterator<Item = &TouchPoint>| {
        let mut chain: Vec<TouchPoint> = Vec::new();
        for &next in points {
            while let [.., a, b] = chain.as_slice()
                && cross(sub(b.point, a.point), sub(next.point, a.point)) <= flat
            {
                chain.pop();
            }
            chain.push(next);
        }
        chain.pop();
        chain
    };
    let mut corners = half(&mut points.iter());
    corners.extend(half(&mut points.iter().rev()));
    if corners.len() < 3 { Vec::new() } else { corners }
}

/// Joins the corners that follow each other on an arc bulging outward.
fn touched(edges: &[Edge], corners: &[TouchPoint]) -> Vec<Touched> {
    let mut touched: Vec<(usize, Touched)> = Vec::new();
    for corner in corners {
        let arc = Facing::of(&edges[corner.edge]);
        match touched.last_mut() {
            Some((edge, last)) if *edge == corner.edge && follows(arc, last.last, corner.point) => {
                last.last = corner.point;
            }
            _ => touched.push((corner.edge, Touched { arc, first: corner.point, last: corner.point })),
        }
    }
    if let [(first_edge, first), .., (last_edge, last)] = touched.as_mut_slice()
        && first_edge == last_edge
        && follows(first.arc, last.last, first.first)
    {
        first.first = last.first;
        touched.pop();
    }
    touched.into_iter().map(|(_, touched)| touched).collect()
}

/// Whether the arc itself leads anticlockwise from one of its points to another not far from it.
fn follows(arc: Option<Facing>, from: Point, to: Point) -> bool {
    arc.is_some_and(|arc| {
        let angle = |p: Point| (p[1] - arc.center[1]).atan2(p[0] - arc.center[0]);
        let turn = turn_from(angle(from), angle(to), 1.0);
        let before = turn_from(arc.start, angle(from), 1.0);
        turn < 1.0 && (before + turn <= arc.sweep + ANGLE_SLACK || arc.is_circle())
    })
}

/// The outline that joins what is touched by common tangents.
fn outline(touched: &[Touched], size: f64) -> Contour {
    let next = touched.iter().cycle().skip(1);
    let tangents: Vec<[Point; 2]> = touched.iter().zip(next).map(|(from, to)| tangent(from, to)).collect();
    let mut edges = Vec::new();
    let negligible = 1e-10 * size;
    for (k, on) in touched.iter().enumerate() {
        let [arrival, departure] = [tangents[(k + tangents.len() - 1) % tangents.len()][1], tangents[k][0]];
        if let Some(arc) = on.arc
            && distance(arrival, departure) > negligible
        {
            let [from, to] = [arrival, departure].map(|p| sub(p, arc.center)).map(|d| d[1].atan2(d[0]));
            let sweep = turn_from(from, to, 1.0);
            edges.push(Edge::Arc { center: arc.center, radius: arc.radius, start: from, sweep });
        }
        let [from, to] = tangents[k];
        if distance(from, to) > negligible {
            edges.push(Edge::Line { from, to });
        }
    }
    Contour { edges }
}

/// Where the line that keeps both on its left leaves the one and reaches the other.
fn tangent(from: &Touched, to: &Touched) -> [Point; 2] {
    // An arc that does not face the tangent's direction is touched at its end.
    let point = |center| Facing { center, radius: 0.0, start: 0.0, sweep: TAU };
    let [a, b] = [(from, from.last), (to, to.first)].map(|(on, end)| (on.arc.unwrap_or(point(end)), end));
    let direction = sub(b.1, a.1);
    let [end_a, end_b] = [nearest_end(a.0, a.1), nearest_end(b.0, b.1)].map(point);
    for [a, b] in [[a.0, b.0], [a.0, end_b], [end_a, b.0]] {
        if let Some(normal) = outward_normal(a, b, direction) {
            let angle = normal[1].atan2(normal[0]);
            if a.faces(angle) && b.faces(angle) {
                return [a, b].map(|facing| add(facing.center, scale(normal, facing.radius)));
            }
        }
    }
    // Arcs of one circle that follow each other have no common tangent, but may have a common end.
    if a.0.center == b.0.center && a.0.radius == b.0.radius && follows(Some(a.0), a.1, b.1) {
        return [b.1, b.1];
    }
    [end_a.center, end_b.center]
}

/// The end of an arc nearest to a point on it; the point itself where there are no ends.
fn nearest_end(arc: Facing, point: Point) -> Point {
    if arc.radius == 0.0 || arc.is_circle() {
        return point;
    }
    let [start, end] = [arc.start, arc.start + arc.sweep].map(|angle| on_circle(arc.center, arc.radius, angle));
    if distance(start, point) <= distance(end, point) { start } else { end }
}

/// The unit vector in which two circles reach equally far, of the two the one to the right of a direction.
fn outward_normal(a: Facing, b: Facing, direction: Point) -> Option<Point> {
    let apart = sub(b.center, a.center);
    let ratio = (a.radius - b.radius) / apart[0].hypot(apart[1]);
    if ratio.is_nan() || ratio.abs() > 1.0 + ANGLE_SLACK {
        return None;
    }
    let along = unit(apart);
    let across = [along[1], -along[0]];
    let sine = (1.0 - ratio * ratio).max(0.0).sqrt();
    let outward = [direction[1], -direction[0]];
    [sine, -sine]
        .map(|sine| add(scale(along, ratio), scale(across, sine)))
        .into_iter()
        .max_by(|a, b| dot(*a, outward).total_cmp(&dot(*b, outward)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn hulls_of_discs_have_arcs_and_tangents() {
        let hull = Region::hull(&[Region::circle(1.0), Region::disc([4.0, 0.0], 1.0)]);
        assert_eq!(hull.edges().count(), 4);
        assert!((hull.contours[0].signed_area() - (8.0 + PI)).abs() < 1e-12);

        let cone = Region::hull(&[Region::circle(3.0), Region::disc([5.0, 0.0], 0.5), Region::circle(1.0)]);
        assert_eq!(cone.edges().count(), 4);
        let (_, max) = cone.bounds().unwrap();
        assert_eq!(max, [5.5, 3.0]);

        let drop = Region::hull(&[Region::circle(3.0), Region::polygon(&[[5.0, 0.0], [0.0, 1.0], [0.0, -1.0]], None)]);
        assert_eq!(drop.edges().count(), 3);
        let tangent = drop.edges().find(|edge| edge.start() == [5.0, 0.0]).unwrap();
        assert!((tangent.length() - 4.0).abs() < 1e-12);
    }

    #[test]
    fn degenerate_hulls_are_empty_or_what_they_contain() {
        assert!(Region::hull(&[]).is_empty());
        let line = Edge::Line { from: [0.0, 0.0], to: [1.0, 1.0] };
        let flat = Region { contours: vec![Contour { edges: vec![line, line.reversed()] }] };
        assert!(Region::hull(&[flat]).is_empty());
        let inside = Region::disc([0.5, 0.5], 1.0);
        assert_eq!(Region::hull(&[inside, Region::circle(4.0)]), Region::circle(4.0));
        let square = Region::rectangle([0.0, 0.0], [2.0, 2.0]);
        let hull =
            Region::hull(&[square.clone(), Region::disc([1.0, 1.0], 0.9), Region::rectangle([0.0, 0.0], [1.0, 2.0])]);
        assert_eq!(hull.edges().count(), 4);
        let huge = Region::hull(&[Region::circle(1e300), square]);
        assert!(huge.edges().all(Edge::is_finite));
    }
}
