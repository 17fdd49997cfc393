//! Puts curves back in the place of the chords that an overlay worked on.
//!
//! Consecutive chords of one curve become one edge. Where two curves meet, the point where their chords met gives way
//! to the point where the curves meet themselves. Where there is none (curves that almost touch), the arcs are bent a
//! little, by no more than their chords were off.

use std::f64::consts::TAU;

use crate::contour::unit;
use crate::intersect::{Crossing, crossings};
use crate::overlay::Curve;
use crate::region::{Contour, Edge, Point, add, cross, distance, dot, on_circle, scale, sub};

/// How often ill-placed corners are looked for, before all corners stay where the chords met.
const MAX_PASSES: usize = 8;

/// What is known of the curves behind the chords.
pub(crate) struct Recovery<'a> {
    pub(crate) curves: &'a [Curve],
    /// Points closer than this are the same, in millimetres.
    pub(crate) resolution: f64,
}

/// A stretch of a contour along one curve.
#[derive(Clone, Copy, Debug)]
struct Run {
    curve: usize,
    /// 1 if it goes anticlockwise about a circle, −1 if clockwise, 0 along a line.
    sense: f64,
    /// Where it starts.
    from: Point,
    /// Where its chords started.
    met: Point,
    /// Whether it starts at a corner of an operand.
    corner: bool,
    /// The angle it covers about the centre of its circle, signed.
    turn: f64,
}

impl Recovery<'_> {
    /// The contour through `points`: each with whether it is a corner of an operand, and the index of the curve whose
    /// chord starts there. `None` if nothing worth keeping is inside.
    pub(crate) fn contour(&self, points: Vec<(Point, bool, usize)>) -> Option<Contour> {
        let mut runs = self.merge(self.runs(&points));
        if let Some(circle) = self.full_circle(&runs) {
            return Some(Contour { edges: vec![circle] });
        }
        self.place_corners(&mut runs);
        let runs = self.merge(self.without_points(runs));
        if let Some(circle) = self.full_circle(&runs) {
            return Some(Contour { edges: vec![circle] });
        }
        let contour = Contour { edges: self.edges(&runs) };
        let worth_keeping = contour.signed_area().abs() > self.area_in_doubt(&runs, contour.length());
        worth_keeping.then_some(contour)
    }

    /// The area that a contour may owe to chords being off their arcs, and to rounding.
    fn area_in_doubt(&self, runs: &[Run], length: f64) -> f64 {
        let between_chords_and_arc = |run: &Run| match self.curves[run.curve] {
            Curve::Line { .. } => 0.0,
            Curve::Circle { radius, .. } => self.curves[run.curve].sagitta() * radius * run.turn.abs(),
        };
        runs.iter().map(between_chords_and_arc).sum::<f64>() + self.resolution * length
    }

    fn runs(&self, points: &[(Point, bool, usize)]) -> Vec<Run> {
        let next = points.iter().cycle().skip(1);
        let run = |(&(from, corner, curve), &(to, ..)): (&(Point, bool, usize), &(Point, bool, usize))| {
            let turn = match self.curves[curve] {
                Curve::Line { .. } => 0.0,
                Curve::Circle { center, .. } => angle_between(sub(from, center), sub(to, center)),
            };
            let sense = if turn == 0.0 { 0.0 } else { turn.signum() };
            Run { curve, sense, from, met: from, corner, turn }
        };
        points.iter().zip(next).map(run).collect()
    }

    /// Joins consecutive runs that continue each other.
    fn merge(&self, mut runs: Vec<Run>) -> Vec<Run> {
        let count = runs.len();
        let break_at = (0..count).find(|&k| {
            let (before, after) = (&runs[(k + count - 1) % count], runs[(k + 1) % count].from);
            !self.continues(before, &runs[k], after)
        });
        runs.rotate_left(break_at.unwrap_or(0));
        let mut merged: Vec<Run> = Vec::new();
        for k in 0..count {
            let after = runs[(k + 1) % count].from;
            match merged.last_mut() {
                Some(last) if self.continues(last, &runs[k], after) => last.turn += runs[k].turn,
                _ => merged.push(runs[k]),
            }
        }
        merged
    }

    /// Whether a run goes on along the curve of the one before it, up to the point `to`.
    fn continues(&self, before: &Run, run: &Run, to: Point) -> bool {
        match (self.curves[before.curve], self.curves[run.curve]) {
            (Curve::Circle { .. }, Curve::Circle { .. }) => before.curve == run.curve && before.sense == run.sense,
            (Curve::Line { .. }, Curve::Line { .. }) => {
                let (first, second) = (sub(run.from, before.from), sub(to, run.from));
                let whole = unit(sub(to, before.from));
                dot(first, second) > 0.0 && cross(whole, first).abs() <= self.resolution
            }
            _ => false,
        }
    }

    fn full_circle(&self, runs: &[Run]) -> Option<Edge> {
        let [Run { curve, turn, sense, .. }] = *runs else { return None };
        match self.curves[curve] {
            Curve::Circle { center, radius, .. } if turn.abs() > TAU - 1e-6 => {
                Some(Edge::Arc { center, radius, start: 0.0, sweep: TAU * sense })
            }
            _ => None,
        }
    }

    /// Moves the corners of the runs to where their curves meet.
    fn place_corners(&self, runs: &mut [Run]) {
        let count = runs.len();
        let before = |k: usize| (k + count - 1) % count;
        for k in 0..count {
            if !runs[k].corner {
                let curves = [self.curves[runs[before(k)].curve], self.curves[runs[k].curve]];
                runs[k].from = self.crossing_near(runs[k].met, curves).unwrap_or(runs[k].met);
            }
        }
        for pass in 0..MAX_PASSES {
            let turned: Vec<usize> = (0..count).filter(|&k| self.is_turned(runs, k)).collect();
            let astray: Vec<usize> = if pass + 1 == MAX_PASSES { (0..count).collect() } else { turned };
            if astray.is_empty() {
                break;
            }
            for k in astray {
                for end in [k, (k + 1) % count] {
                    if !runs[end].corner {
                        runs[end].from = runs[end].met;
                    }
                }
            }
        }
        for k in 0..count {
            if let Curve::Circle { center, .. } = self.curves[runs[k].curve] {
                runs[k].turn =
                    turn_like(runs[k].turn, sub(runs[k].from, center), sub(runs[(k + 1) % count].from, center));
            }
        }
    }

    /// The point nearest to where chords met in which their curves meet, if it is plausibly near.
    fn crossing_near(&self, met: Point, curves: [Curve; 2]) -> Option<Point> {
        let slack = curves[0].sagitta() + curves[1].sagitta() + self.resolution;
        let reach = 2.0 * curves[0].chord().max(curves[1].chord()) + 256.0 * self.resolution;
        let Crossing { points } = crossings(curves, slack);
        let nearest = points.into_iter().flatten().min_by(|a, b| distance(*a, met).total_cmp(&distance(*b, met)))?;
        (distance(nearest, met) <= reach).then_some(nearest)
    }

    /// Whether a run has come to go backwards, or to cover quite another angle than its chords.
    fn is_turned(&self, runs: &[Run], k: usize) -> bool {
        let (run, next) = (&runs[k], &runs[(k + 1) % runs.len()]);
        match self.curves[run.curve] {
            Curve::Line { .. } => {
                distance(run.from, next.from) > self.resolution
                    && dot(sub(next.from, run.from), sub(next.met, run.met)) < 0.0
            }
            Curve::Circle { center, radius, chords } => {
                let turn = turn_like(run.turn, sub(run.from, center), sub(next.from, center));
                turn * run.sense * radius < -self.resolution || (turn - run.turn).abs() > 8.0 * TAU / chords
            }
        }
    }

    /// Leaves out the runs without length.
    fn without_points(&self, runs: Vec<Run>) -> Vec<Run> {
        let count = runs.len();
        let mut kept: Vec<Run> = Vec::new();
        for k in 0..count {
            let short = distance(runs[k].from, runs[(k + 1) % count].from) <= self.resolution;
            let around = match self.curves[runs[k].curve] {
                Curve::Circle { radius, .. } => radius * runs[k].turn.abs() > 4.0 * self.resolution,
                Curve::Line { .. } => false,
            };
            if !short || around {
                kept.push(runs[k]);
            }
        }
        kept
    }

    fn edges(&self, runs: &[Run]) -> Vec<Edge> {
        let mut edges = Vec::with_capacity(runs.len());
        for (run, next) in runs.iter().zip(runs.iter().cycle().skip(1)) {
            match self.curves[run.curve] {
                Curve::Line { .. } => edges.push(Edge::Line { from: run.from, to: next.from }),
                Curve::Circle { center, radius, .. } => {
                    self.push_arc(center, radius, run.turn, [run.from, next.from], &mut edges);
                }
            }
        }
        edges
    }

    /// Appends the arc of a circle between two points, bent where these are not on the circle.
    fn push_arc(&self, center: Point, radius: f64, turn: f64, [from, to]: [Point; 2], edges: &mut Vec<Edge>) {
        let is_on = |point| (distance(point, center) - radius).abs() <= self.resolution;
        let offset = sub(from, center);
        let start = offset[1].atan2(offset[0]);
        if is_on(from) && is_on(to) {
            edges.push(Edge::Arc { center, radius, start, sweep: turn });
            return;
        }
        let pieces = (turn.abs() / 1.5).ceil().max(1.0) as u32;
        let mut last = from;
        for k in 1..=pieces {
            let angle = start + turn * f64::from(k) / f64::from(pieces);
            let next = if k == pieces { to } else { on_circle(center, radius, angle) };
            edges.push(arc_between(last, next, radius, turn.signum()));
            last = next;
        }
    }
}

/// The arc of at most half a turn between two points, with about the given radius.
fn arc_between(from: Point, to: Point, radius: f64, sense: f64) -> Edge {
    let half = distance(from, to) / 2.0;
    let radius = radius.max(half);
    let across = unit(sub(to, from));
    let height = (radius * radius - half * half).sqrt() * sense;
    let center = add(scale(add(from, to), 0.5), [-across[1] * height, across[0] * height]);
    let offset = sub(from, center);
    Edge::Arc { center, radius, start: offset[1].atan2(offset[0]), sweep: sense * 2.0 * (half / radius).asin() }
}

/// The angle from one vector to another, between −π and π.
fn angle_between(from: Point, to: Point) -> f64 {
    cross(from, to).atan2(dot(from, to))
}

/// The angle from one vector to another, with as many full turns as make it most like a known one.
fn turn_like(known: f64, from: Point, to: Point) -> f64 {
    let angle = angle_between(from, to);
    angle + TAU * ((known - angle) / TAU).round()
}
