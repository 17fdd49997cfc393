//! Chords of outlines in an integer grid, each knowing the curve it belongs to.

use std::collections::HashMap;
use std::f64::consts::{PI, TAU};

use i_overlay::core::edge_data::{EdgeDataMerge, OverlayEdgeData};
use i_overlay::core::edge_overlay::{EdgeOverlay, InputEdge};
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay::ShapeType;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::i_float::int::point::IntPoint;
use i_overlay::segm::boolean::ShapeCountBoolean;

use crate::measure::join;
use crate::recover::Recovery;
use crate::region::{Edge, Point, Region, distance, on_circle};

/// How far chords may be from their arcs, as a part of the diagonal of all operands.
const CHORD_TOLERANCE: f64 = 1e-5;

/// How near points are that count as one, as a part of that diagonal.
const SAME: f64 = 1e-10;

/// Coordinates become integers below two to this power: fine enough that the grid is far below what counts as one
/// point, coarse enough that outlines which only rounding keeps apart coincide.
const GRID_BITS: i32 = 38;

/// Where corners that count as one with a corner may be, in cells.
const NEIGHBOURS: [[i64; 2]; 9] = [[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1], [1, 1], [1, -1], [-1, 1], [-1, -1]];

/// A line or circle that outlines are made of.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Curve {
    Line { from: Point, to: Point },
    Circle { center: Point, radius: f64, chords: f64 },
}

impl Curve {
    /// The length of the chords that stand for it; 0 for a line.
    pub(crate) fn chord(&self) -> f64 {
        match *self {
            Curve::Line { .. } => 0.0,
            Curve::Circle { radius, chords, .. } => 2.0 * radius * (PI / chords).sin(),
        }
    }

    /// How far the chords that stand for it are from it; 0 for a line.
    pub(crate) fn sagitta(&self) -> f64 {
        match *self {
            Curve::Line { .. } => 0.0,
            Curve::Circle { radius, chords, .. } => radius * (1.0 - (PI / chords).cos()),
        }
    }
}

/// The index of a curve, carried by its chords.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct CurveId(u32);

impl OverlayEdgeData for CurveId {
    type Store = ();

    /// Chords that coincide mostly belong to one curve; else the choice must only be deterministic.
    fn merge(pair: EdgeDataMerge<ShapeCountBoolean, Self>, _: &mut ()) -> Self {
        CurveId(pair.lhs_data.0.min(pair.rhs_data.0))
    }
}

/// Operands on their way through the overlay.
pub(crate) struct Overlay {
    edges: EdgeOverlay<i64, CurveId>,
    grid: Grid,
    curves: Vec<Curve>,
    circles: HashMap<[i64; 3], CurveId>,
    /// The corners of the operands by their place in the grid: they keep their exact coordinates.
    corners: HashMap<IntPoint<i64>, Point>,
    /// The corners in each cell as wide as two points may be apart that count as one.
    cells: HashMap<[i64; 2], IntPoint<i64>>,
}

impl Overlay {
    /// An empty overlay for operands within the bounds of some regions, or `None` if those have no sensible extent.
    pub(crate) fn around<'a>(regions: impl IntoIterator<Item = &'a Region>) -> Option<Overlay> {
        let bounds = sensible_bounds(regions.into_iter().flat_map(Region::edges))?;
        Overlay::within(bounds, distance(bounds.0, bounds.1))
    }

    /// An empty overlay for operands within some bounds, whose arcs matter relative to `size` millimetres.
    pub(crate) fn within(bounds: (Point, Point), size: f64) -> Option<Overlay> {
        Some(Overlay {
            edges: EdgeOverlay::new(64),
            grid: Grid::around(bounds, size)?,
            curves: Vec::new(),
            circles: HashMap::new(),
            corners: HashMap::new(),
            cells: HashMap::new(),
        })
    }

    /// Adds the contours of a region.
    pub(crate) fn add(&mut self, region: &Region, shape: ShapeType) {
        for contour in &region.contours {
            self.add_loop(&contour.edges, shape);
        }
    }

    /// Adds a closed loop of edges.
    pub(crate) fn add_loop(&mut self, edges: &[Edge], shape: ShapeType) {
        let mut walk: Vec<(IntPoint<i64>, CurveId)> = Vec::with_capacity(edges.len());
        for edge in edges {
            let curve = self.curve_of(edge);
            walk.push((self.corner(edge.start()), curve));
            self.walk_arc(edge, curve, &mut walk);
        }
        for (k, &(a, data)) in walk.iter().enumerate() {
            let b = walk[(k + 1) % walk.len()].0;
            self.edges.add_edge(InputEdge { a, b, data }, shape);
        }
    }

    /// The region that a rule makes of what was added.
    pub(crate) fn resolve(mut self, rule: OverlayRule, fill: FillRule) -> Region {
        let shapes = self.edges.build_vector_shapes(rule, fill);
        let recovery = Recovery { curves: &self.curves, resolution: self.grid.resolution() };
        let contours = shapes.iter().flatten().filter_map(|contour| {
            let points = contour.iter().map(|edge| {
                let (point, corner) = match self.corners.get(&edge.a) {
                    Some(&point) => (point, true),
                    None => (self.grid.point(edge.a), false),
                };
                (point, corner, edge.data.0 as usize)
            });
            recovery.contour(points.collect())
        });
        Region { contours: contours.collect() }
    }

    /// Adds the ends of an arc's chords, but for the arc's own ends. They only depend on the circle, so arcs of one
    /// circle have chords in common.
    fn walk_arc(&self, edge: &Edge, curve: CurveId, walk: &mut Vec<(IntPoint<i64>, CurveId)>) {
        let Edge::Arc { start, sweep, .. } = *edge else { return };
        let Curve::Circle { center, radius, chords } = self.curves[curve.0 as usize] else { return };
        let step = TAU / chords;
        let (first, last) = if sweep < 0.0 { (start + sweep, start) } else { (start, start + sweep) };
        // A division point next to an end would only make a chord too short to be of use.
        let least = (first / step + 0.01).ceil() as i64;
        let greatest = (last / step - 0.01).floor() as i64;
        let snap = |k: i64| (self.grid.snap(on_circle(center, radius, k as f64 * step)), curve);
        if sweep < 0.0 {
            walk.extend((least..=greatest).rev().map(snap));
        } else {
            walk.extend((least..=greatest).map(snap));
        }
    }

    /// The place in the grid of a corner; the same for corners that count as one.
    fn corner(&mut self, point: Point) -> IntPoint<i64> {
        let cell = point.map(|x| (x / self.grid.resolution()).floor() as i64);
        for [dx, dy] in NEIGHBOURS {
            if let Some(&known) = self.cells.get(&[cell[0] + dx, cell[1] + dy])
                && distance(self.corners[&known], point) <= self.grid.resolution()
            {
                return known;
            }
        }
        let place = self.grid.snap(point);
        self.cells.insert(cell, place);
        self.corners.entry(place).or_insert(point);
        place
    }

    fn curve_of(&mut self, edge: &Edge) -> CurveId {
        let next = CurveId(self.curves.len() as u32);
        match *edge {
            Edge::Line { from, to } => {
                self.curves.push(Curve::Line { from, to });
                next
            }
            Edge::Arc { center, radius, .. } => {
                let key = [center[0], center[1], radius].map(|x| (x / self.grid.resolution()).round() as i64);
                let curves = &mut self.curves;
                let chords = self.grid.chords(radius);
                *self.circles.entry(key).or_insert_with(|| {
                    curves.push(Curve::Circle { center, radius, chords });
                    next
                })
            }
        }
    }
}

/// The smallest box around some edges; `None` if there are none, or one of them is not finite.
pub(crate) fn sensible_bounds<'a>(edges: impl IntoIterator<Item = &'a Edge>) -> Option<(Point, Point)> {
    let mut bounds = None;
    for edge in edges {
        if !edge.is_finite() {
            return None;
        }
        bounds = Some(bounds.map_or(edge.bounds(), |bounds| join(bounds, edge.bounds())));
    }
    bounds
}

/// The lattice of points the overlay works on.
struct Grid {
    /// Grid steps per millimetre, a power of two.
    scale: f64,
    /// The extent of what matters, in millimetres.
    size: f64,
}

impl Grid {
    fn around((min, max): (Point, Point), size: f64) -> Option<Grid> {
        let reach = min.iter().chain(&max).fold(0.0, |reach: f64, x| reach.max(x.abs()));
        let sensible = (1e-60..1e60).contains(&reach);
        let scale = 2f64.powi(GRID_BITS - reach.log2().ceil() as i32);
        sensible.then_some(Grid { scale, size })
    }

    /// Points closer than this, in millimetres, are the same.
    fn resolution(&self) -> f64 {
        (8.0 / self.scale).max(self.size * SAME)
    }

    fn snap(&self, point: Point) -> IntPoint<i64> {
        let [x, y] = point.map(|x| (x * self.scale).round() as i64);
        IntPoint::new(x, y)
    }

    fn point(&self, point: IntPoint<i64>) -> Point {
        [point.x as f64 / self.scale, point.y as f64 / self.scale]
    }

    /// How many chords stand for a whole circle.
    fn chords(&self, radius: f64) -> f64 {
        let step = 2.0 * (1.0 - (self.size * CHORD_TOLERANCE / radius).min(0.5)).acos();
        // Where the radius exceeds all bounds the step may round to zero.
        let chords = (TAU / step.max(1e-7)).max(64.0);
        4.0 * (chords / 4.0).ceil()
    }
}
