//! Regions grown and shrunk.
//!
//! A region grown by d is itself together with all that its outline sweeps when it moves outward by d, and with the
//! fillings of the gaps this opens at corners; shrunk, it is itself without what the outline sweeps inward. Sweeps
//! and fillings are bounded by lines and arcs, so booleans do the rest.

use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay::ShapeType;
use i_overlay::core::overlay_rule::OverlayRule;

use crate::contour::corner_turn;
use crate::overlay::{Overlay, sensible_bounds};
use crate::region::{Contour, Edge, Point, Region, add, distance, dot, scale};

/// What a corner becomes when outlines move away from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Join {
    /// An arc about the corner: all points within the distance.
    Round,
    /// The moved edges go on until they meet, unless that is more than `limit` distances away from the corner: then
    /// as `Chamfer`.
    Miter {
        /// The longest miter, as a multiple of the distance.
        limit: f64,
    },
    /// A straight edge across the corner, at the distance from it.
    Chamfer,
}

impl Join {
    /// OpenSCAD's `offset(delta = …)`, which limits no miter that occurs in practice.
    pub const SHARP: Join = Join::Miter { limit: 1e6 };
}

impl Region {
    /// The region grown by a distance in millimetres, or shrunk by a negative one. What vanishes leaves nothing.
    pub fn offset(&self, by: f64, join: Join) -> Region {
        let region = self.normalized();
        let vanishes = -by > region.diagonal();
        if by.is_nan() || vanishes || region.is_empty() {
            return Region::default();
        }
        let swept: Vec<Contour> = region.contours.iter().flat_map(|contour| swept(contour, by, join)).collect();
        let edges = region.edges().chain(swept.iter().flat_map(|contour| &contour.edges));
        let overlay = sensible_bounds(edges).and_then(|bounds| Overlay::within(bounds, region.diagonal() + by.abs()));
        let Some(mut overlay) = overlay else { return Region::default() };
        overlay.add(&region, ShapeType::Subject);
        let (shape, rule) = if by < 0.0 {
            (ShapeType::Clip, OverlayRule::Difference)
        } else {
            (ShapeType::Subject, OverlayRule::Subject)
        };
        overlay.add(&Region { contours: swept }, shape);
        overlay.resolve(rule, FillRule::NonZero)
    }
}

/// What a contour with the region on its left sweeps, moving by a distance to the right, and the fillings at its
/// corners: all anticlockwise.
fn swept(contour: &Contour, by: f64, join: Join) -> Vec<Contour> {
    let next = contour.edges.iter().cycle().skip(1);
    let loops = contour.edges.iter().zip(next).flat_map(|(edge, next)| {
        let turn = corner_turn(edge, next);
        let gap = (turn * by > 0.0).then(|| filling(edge, next, turn, by, join));
        [Some(sweep(edge, by)), gap]
    });
    loops.flatten().map(anticlockwise).collect()
}

fn anticlockwise(edges: Vec<Edge>) -> Contour {
    let contour = Contour { edges };
    if contour.signed_area() < 0.0 { contour.reversed() } else { contour }
}

/// What an edge sweeps when it moves by a distance to the right; no more than up to the centre of an arc.
fn sweep(edge: &Edge, by: f64) -> Vec<Edge> {
    let line = |from, to| Edge::Line { from, to };
    match *edge {
        Edge::Line { from, to } => {
            let away = scale(right(edge.end_direction()), by);
            let (moved_to, moved_from) = (add(to, away), add(from, away));
            vec![*edge, line(to, moved_to), line(moved_to, moved_from), line(moved_from, from)]
        }
        Edge::Arc { center, radius, start, sweep } => {
            let moved = Edge::Arc { center, radius: radius + by.copysign(by * sweep), start, sweep };
            if moved.is_finite() {
                let back = moved.reversed();
                vec![*edge, line(edge.end(), back.start()), back, line(back.end(), edge.start())]
            } else {
                vec![*edge, line(edge.end(), center), line(center, edge.start())]
            }
        }
    }
}

/// What fills the gap between two edges that turn at a corner, once they moved by a distance to the right.
fn filling(edge: &Edge, next: &Edge, turn: f64, by: f64, join: Join) -> Vec<Edge> {
    let corner = next.start();
    let (before, after) = (edge.end_direction(), next.start_direction());
    let (from, to) = (add(corner, scale(right(before), by)), add(corner, scale(right(after), by)));
    let polygon = |points: &[Point]| Contour::polygon(points.iter().copied()).edges;
    // The length of the miter is the distance divided by this.
    let shortening = (0.5 * turn).cos();
    match join {
        Join::Round => {
            let outward = right(before).map(|x| x * by.signum());
            let start = outward[1].atan2(outward[0]);
            let arc = Edge::Arc { center: corner, radius: distance(corner, from), start, sweep: turn };
            vec![Edge::Line { from: corner, to: arc.start() }, arc, Edge::Line { from: arc.end(), to: corner }]
        }
        Join::Miter { limit } if shortening * limit >= 1.0 => {
            let sum = add(right(before), right(after));
            let tip = add(corner, scale(sum, by / (0.5 * dot(sum, sum))));
            polygon(&[corner, from, tip, to])
        }
        Join::Miter { .. } | Join::Chamfer => {
            let along = by.abs() * (0.25 * turn.abs()).tan();
            let (first, last) = (add(from, scale(before, along)), add(to, scale(after, -along)));
            polygon(&[corner, from, first, last, to])
        }
    }
}

/// The direction a quarter turn clockwise.
fn right(direction: Point) -> Point {
    [direction[1], -direction[0]]
}
