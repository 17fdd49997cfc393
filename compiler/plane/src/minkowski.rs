//! Minkowski sums.
//!
//! Convex regions are summed exactly: in each direction the sum reaches as far as both together. Other sums are the
//! union of the copies of one region at points of the other, and of the sums of their edges.

use std::f64::consts::{FRAC_PI_2, TAU};

use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay::ShapeType;
use i_overlay::core::overlay_rule::OverlayRule;

use crate::contour::corner_turn;
use crate::flatten::default_tolerance;
use crate::measure::turn_from;
use crate::offset::Join;
use crate::overlay::{Overlay, sensible_bounds};
use crate::region::{Contour, Edge, Point, Region, add, distance, on_circle};

/// The most edges that the sums of edges may have in all.
const MAX_SUM_EDGES: usize = 1 << 20;

/// How many edges and crossings of edges all unions together may take.
const MAX_WORK: f64 = 3e6;

/// About how many edges of sums are united at once.
const EDGES_AT_ONCE: usize = 256;

/// Directions closer than this, in radians, are one.
const SAME_DIRECTION: f64 = 1e-12;

impl Region {
    /// All sums of a point of this region and a point of the other; empty if either is. `None` if that takes too long
    /// to work out: for jagged outlines of hundreds of edges each.
    ///
    /// The arcs of convex regions stay arcs, and so do all when one region is a disc; others become chords of the
    /// [default tolerance](crate::default_tolerance).
    pub fn minkowski(&self, other: &Region) -> Option<Region> {
        let [a, b] = [self.normalized(), other.normalized()];
        if let Some((center, radius)) = b.as_disc() {
            return Some(a.translate(center).offset(radius, Join::Round));
        }
        if let Some((center, radius)) = a.as_disc() {
            return Some(b.translate(center).offset(radius, Join::Round));
        }
        match (a.as_convex(), b.as_convex()) {
            _ if a.is_empty() || b.is_empty() => Some(Region::default()),
            (Some(a), Some(b)) => Some(Region::of(vec![convex_sum(a, b)])),
            (Some(convex), None) => general_sum(&b, &a, std::slice::from_ref(convex)),
            (None, Some(convex)) => general_sum(&a, &b, std::slice::from_ref(convex)),
            (None, None) => general_sum(&a, &b, &segments(&b)),
        }
    }

    fn as_disc(&self) -> Option<(Point, f64)> {
        match self.as_convex()?.edges.as_slice() {
            [Edge::Arc { center, radius, .. }] => Some((*center, *radius)),
            _ => None,
        }
    }

    fn as_convex(&self) -> Option<&Contour> {
        match self.contours.as_slice() {
            [contour] if contour.convex_direction() == Some(1) => Some(contour),
            _ => None,
        }
    }
}

/// The sum of any two regions, given convex parts whose outlines cover the outline of the second.
///
/// The sums of edges are united a few at a time, and the results in pairs: what lies inside vanishes early.
fn general_sum(a: &Region, b: &Region, parts: &[Contour]) -> Option<Region> {
    let strokes = segments(a);
    let part_edges: usize = parts.iter().map(|part| part.edges.len() + 2).sum();
    if strokes.len().saturating_mul(part_edges) > MAX_SUM_EDGES {
        return None;
    }
    let Some(mut unions) = Unions::within(a, b) else { return Some(Region::default()) };
    let mut united = Vec::new();
    for part in parts {
        let each = (EDGES_AT_ONCE / (part.edges.len() + 2)).max(1);
        for strokes in strokes.chunks(each) {
            united.push(unions.of(strokes.iter().map(|stroke| convex_sum(stroke, part)).collect())?);
        }
        // Where outlines do not meet, one region may lie inside a copy of the other.
        united.extend(part.edges.first().map(|edge| a.translate(edge.start())));
    }
    let places = a.contours.iter().filter(|contour| contour.signed_area() > 0.0);
    united.extend(places.filter_map(|place| place.edges.first()).map(|edge| b.translate(edge.start())));
    while united.len() > 1 {
        let pairs = united.chunks(2).map(|pair| match pair {
            [one, other] => unions.of([one.contours.as_slice(), &other.contours].concat()),
            alone => Some(Region::of(alone.iter().flat_map(|region| region.contours.clone()).collect())),
        });
        united = pairs.collect::<Option<Vec<_>>>()?;
    }
    united.pop()
}

/// Unions on one lattice, as far as the work they take is within bounds.
struct Unions {
    bounds: (Point, Point),
    /// How many edges, and crossings of edges, may follow.
    left: f64,
}

impl Unions {
    /// Unions of parts of the sum of two regions; `None` if one of them has no sensible extent.
    fn within(a: &Region, b: &Region) -> Option<Unions> {
        let [a, b] = [sensible_bounds(a.edges())?, sensible_bounds(b.edges())?];
        Some(Unions { bounds: (add(a.0, b.0), add(a.1, b.1)), left: MAX_WORK })
    }

    /// The points around which contours wind in sum; `None` if that takes too long to work out.
    fn of(&mut self, contours: Vec<Contour>) -> Option<Region> {
        let region = Region::of(contours);
        self.left -= region.edges().count() as f64 + Region::crossings_estimate(std::slice::from_ref(&region));
        if self.left < 0.0 {
            return None;
        }
        let Some(mut overlay) = Overlay::within(self.bounds, distance(self.bounds.0, self.bounds.1)) else {
            return Some(Region::default());
        };
        overlay.add(&region, ShapeType::Subject);
        Some(overlay.resolve(OverlayRule::Subject, FillRule::NonZero))
    }
}

/// The flattened edges of a region, each as a contour there and back.
fn segments(region: &Region) -> Vec<Contour> {
    let polygons = region.flatten(default_tolerance(region));
    let edges = polygons.iter().flat_map(|corners| corners.iter().zip(corners.iter().cycle().skip(1)));
    edges
        .filter(|(from, to)| from != to)
        .map(|(&from, &to)| {
            let edge = Edge::Line { from, to };
            Contour { edges: vec![edge, edge.reversed()] }
        })
        .collect()
}

/// What a convex outline touches when approached from a range of directions: an arc about a centre, or a corner, which
/// is one of radius 0.
#[derive(Clone, Copy)]
struct Extreme {
    /// Where the range starts, as an angle in radians from 0 to a full turn.
    start: f64,
    center: Point,
    radius: f64,
}

/// The sum of two convex outlines that run anticlockwise.
fn convex_sum(a: &Contour, b: &Contour) -> Contour {
    let [a, b] = [extremes(a), extremes(b)];
    let mut turns: Vec<f64> = a.iter().chain(&b).map(|extreme| extreme.start).collect();
    turns.sort_by(f64::total_cmp);
    turns.dedup_by(|later, earlier| *later - *earlier < SAME_DIRECTION);
    let next = turns.iter().skip(1).copied().chain([turns.first().map_or(TAU, |first| first + TAU)]);
    let mut edges = Vec::new();
    let pieces: Vec<(f64, f64, Extreme)> = turns
        .iter()
        .zip(next)
        .filter_map(|(&start, end)| {
            let middle = 0.5 * (start + end);
            let (a, b) = (extreme_at(&a, middle)?, extreme_at(&b, middle)?);
            Some((start, end, Extreme { start, center: add(a.center, b.center), radius: a.radius + b.radius }))
        })
        .collect();
    for (&(start, end, on), &(next_start, _, next)) in pieces.iter().zip(pieces.iter().cycle().skip(1)) {
        if on.radius > 0.0 {
            edges.push(Edge::Arc { center: on.center, radius: on.radius, start, sweep: end - start });
        }
        let from = on_circle(on.center, on.radius, end);
        let to = on_circle(next.center, next.radius, next_start);
        if distance(from, to) > SAME_DIRECTION * (on.radius + from[0].abs() + from[1].abs()) {
            edges.push(Edge::Line { from, to });
        }
    }
    Contour { edges }
}

/// The extremes of a convex outline, by the angles they start at.
fn extremes(contour: &Contour) -> Vec<Extreme> {
    let mut extremes = Vec::new();
    for (edge, next) in contour.edges.iter().zip(contour.edges.iter().cycle().skip(1)) {
        if let Edge::Arc { center, radius, start, .. } = *edge {
            extremes.push(Extreme { start: turn_from(0.0, start, 1.0), center, radius });
        }
        if corner_turn(edge, next) > SAME_DIRECTION {
            let direction = edge.end_direction();
            let start = turn_from(0.0, direction[1].atan2(direction[0]) - FRAC_PI_2, 1.0);
            extremes.push(Extreme { start, center: next.start(), radius: 0.0 });
        }
    }
    extremes.sort_by(|a, b| a.start.total_cmp(&b.start));
    extremes
}

/// The extreme in a direction: the last one to start before it, all around.
fn extreme_at(extremes: &[Extreme], angle: f64) -> Option<Extreme> {
    let angle = turn_from(0.0, angle, 1.0);
    let after = extremes.partition_point(|extreme| extreme.start <= angle);
    extremes[..after].last().or(extremes.last()).copied()
}
