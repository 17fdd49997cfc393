//! From the picture back to the text, and from the text to the picture.
//!
//! A [`Provenance`] knows where each solid of a scene is written and what it came to in the field. It answers which
//! expressions made the surface at a point, which solids an expression made, where they are, and what they are alone.

mod part;
mod sites;
mod tree;

use std::io;
use std::sync::{Arc, Mutex, PoisonError};

use chiaro_field::{Evaluator, Graph, Lineage, StepId};
use chiaro_solid::{Affine, Solid, SolidKind};
use chiaro_syntax::{FileId, Sources, Span};
use chiaro_vocabulary::Bounds;

use crate::scene::Scene;
use crate::with_deep_stack;
use sites::Sites;

pub use tree::Tree;

/// A solid of a scene. A loop or a module makes several of one expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SolidId(u32);

/// An expression that had a part in making a surface.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Origin {
    /// Name and arguments of the instance, such as `sphere(3)`.
    pub span: Span,
    /// Its name: a shape's, an operator's, `for`, or that of a module of the scene's.
    pub what: String,
    /// The solid that it came to here.
    pub solid: SolidId,
}

/// Why a solid has no matrix to the world: something above it bends it or projects it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bent {
    /// Where that is written.
    pub span: Span,
    /// Its name, such as `rotate_extrude`.
    pub what: String,
}

/// An affine map: the upper three rows of a 4 × 4 matrix, the last column in millimetres.
pub type Matrix = [[f64; 4]; 3];

/// What links a scene's solids to its text and to its field.
#[derive(Debug)]
pub struct Provenance {
    lineage: Lineage,
    sites: Sites,
    highlighted: Vec<SolidId>,
    /// What was made for the live numbers that were asked about last.
    moment: Mutex<Option<Arc<Moment>>>,
}

/// The field while the live numbers have certain values.
#[derive(Debug)]
struct Moment {
    parameters: Vec<f64>,
    evaluator: Evaluator,
    bounds: Vec<Bounds>,
}

/// How near to the surface counts as on it, relative to the numbers involved.
const HIT: f64 = 1e-9;
/// How many steps a ray may take.
const MOST_STEPS: usize = 20_000;
/// A point this much of the scene's size off the surface is moved onto it before its origin is asked.
const OFF_SURFACE: f64 = 0.05;

impl Scene {
    /// What links the scene to its text. It lowers the scene again, which takes about as long as the first time; the
    /// picture of a plane scene is that of a slab. An error if the system has no room for another thread.
    pub fn provenance(&self, sources: &Sources) -> io::Result<Provenance> {
        let drawn = self.drawn();
        let lineage = with_deep_stack(|| chiaro_field::lower_with_lineage(&drawn))?;
        let sites = Sites::new(&lineage, sources);
        let mut highlighted: Vec<SolidId> = sites.highlighted().flat_map(|(_, solids)| solids).copied().collect();
        highlighted.sort_unstable();
        highlighted.dedup();
        Ok(Provenance { lineage, sites, highlighted, moment: Mutex::default() })
    }
}

impl Provenance {
    /// The expressions that made the surface at a point of the world, in millimetres, the innermost first, while the live
    /// parameters have these values. A point a little off the surface counts as the nearest on it. Nothing, if there is
    /// no surface near.
    pub fn origin(&self, point: [f64; 3], parameters: &[f64]) -> Vec<Origin> {
        let moment = self.moment(parameters);
        let Some(point) = moment.on_surface(point) else { return Vec::new() };
        let path = self.lineage.made(&moment.evaluator, &moment.bounds, point);
        match path.last() {
            Some(innermost) => self.chain(SolidId(innermost.0)),
            None => Vec::new(),
        }
    }

    /// The expressions around a solid, its own first.
    pub fn chain(&self, solid: SolidId) -> Vec<Origin> {
        let mut chain: Vec<Origin> = Vec::new();
        for id in self.upwards(solid) {
            let written = &self.solid(id);
            for span in std::iter::once(written.span).chain(written.via.iter().copied()) {
                match chain.last_mut() {
                    // One instance may come to several solids in one another: the outermost is what it made.
                    Some(last) if last.span == span => last.solid = id,
                    _ if span.start == span.end => {}
                    _ => chain.push(Origin { span, what: self.sites.name(span), solid: id }),
                }
            }
        }
        chain
    }

    /// The solids that the innermost expression about this place of a file made: all of them, if it is in a loop or a
    /// module. If it made none, those of the expression around it; in a module's definition, all that the module made.
    pub fn nodes_at(&self, file: FileId, offset: u32) -> Vec<SolidId> {
        self.sites.at(file, offset)
    }

    /// The solids of the instances that `#` marks. They are a part of the scene like any other;
    /// whoever draws may show them besides.
    pub fn highlighted(&self) -> &[SolidId] {
        &self.highlighted
    }

    /// Where `#` marks an instance that came to solids: the sign, with others that stand beside it.
    pub fn highlights(&self) -> impl Iterator<Item = Span> {
        self.sites.highlighted().map(|(sign, _)| sign)
    }

    /// The head of the innermost expression about this place of a file that made solids; of a module's definition, the
    /// name.
    pub fn expression_at(&self, file: FileId, offset: u32) -> Option<Span> {
        self.sites.expression(file, offset)
    }

    /// The field of a solid by itself, with what moves, bends and thickens it, and without what it is joined with or cut
    /// by. An error if the system has no room for another thread.
    pub fn part(&self, solid: SolidId) -> io::Result<Graph> {
        self.parts(&[solid])
    }

    /// The field of several solids together, as of [`part`](Self::part): of all that an expression made, to be looked for
    /// at once.
    pub fn parts(&self, solids: &[SolidId]) -> io::Result<Graph> {
        let alone = self.alone(solids);
        with_deep_stack(|| chiaro_field::lower(&alone).0)
    }

    /// The map from the coordinates that a solid is written in to the world, while the live parameters have these values.
    pub fn placement(&self, solid: SolidId, parameters: &[f64]) -> Result<Matrix, Bent> {
        let mut placement = Affine::identity();
        for id in self.upwards(solid).skip(1) {
            let above = self.solid(id);
            match &above.kind {
                SolidKind::Transform(map, _) => placement = map.after(&placement),
                kind if bends(kind) => return Err(Bent { span: above.span, what: self.sites.name(above.span) }),
                _ => {}
            }
        }
        Ok(placement.value(parameters))
    }

    /// The point where a ray first meets the scene's surface, in millimetres, while the live parameters have these
    /// values. The direction need not have a length of 1.
    pub fn hit(&self, eye: [f64; 3], direction: [f64; 3], parameters: &[f64]) -> Option<[f64; 3]> {
        self.moment(parameters).hit(eye, direction)
    }

    /// A solid's box in the world while the live parameters have these values; empty if there is nothing of it.
    pub fn bounds(&self, solid: SolidId, parameters: &[f64]) -> Bounds {
        let node = self.lineage.step(StepId(solid.0)).node;
        node.map_or(Bounds::EMPTY, |node| self.moment(parameters).bounds[node.0 as usize])
    }

    /// A solid's box in the coordinates that it is written in, while the live parameters have these values. It is lowered
    /// alone, which is quick for a shape.
    pub fn local_bounds(&self, solid: SolidId, parameters: &[f64]) -> Bounds {
        let (graph, _) = chiaro_field::lower(self.solid(solid));
        graph.bounds_at(parameters)[graph.root.0 as usize]
    }

    /// The scene's solids as they are written, with facts about their field, while the live parameters have these values.
    pub fn tree(&self, parameters: &[f64]) -> Tree {
        tree::tree(&self.lineage, &self.sites, &self.moment(parameters).bounds)
    }

    /// A solid as the evaluator made it.
    pub fn solid(&self, id: SolidId) -> &Arc<Solid> {
        &self.lineage.step(StepId(id.0)).solid
    }

    /// A solid and those around it, from the inside out.
    fn upwards(&self, solid: SolidId) -> impl Iterator<Item = SolidId> {
        let around = |id: &StepId| self.lineage.step(*id).parent;
        std::iter::successors(Some(StepId(solid.0)), around).map(|id| SolidId(id.0))
    }

    fn moment(&self, parameters: &[f64]) -> Arc<Moment> {
        let mut kept = self.moment.lock().unwrap_or_else(PoisonError::into_inner);
        match &*kept {
            Some(moment) if moment.parameters == parameters => moment.clone(),
            _ => kept.insert(Arc::new(Moment::new(&self.lineage.graph, parameters))).clone(),
        }
    }
}

/// Whether what is below a solid comes to the world other than by one matrix.
fn bends(kind: &SolidKind) -> bool {
    match kind {
        SolidKind::Twist(rate, _) => !rate.is(0.0),
        SolidKind::Extrude { twist, scale, .. } => !(twist.is(0.0) && scale.iter().all(|factor| factor.is(1.0))),
        SolidKind::Revolve { .. } | SolidKind::Slice(_) => true,
        _ => false,
    }
}

impl Moment {
    fn new(graph: &Graph, parameters: &[f64]) -> Self {
        Self {
            parameters: parameters.to_vec(),
            evaluator: Evaluator::new(graph, parameters),
            bounds: graph.bounds_at(parameters),
        }
    }

    /// The point moved along the field's gradient onto the surface, if that is near.
    fn on_surface(&self, point: [f64; 3]) -> Option<[f64; 3]> {
        let size = self.evaluator.bounds().diagonal();
        let reach = if size.is_finite() { OFF_SURFACE * size } else { f64::INFINITY };
        if !point.iter().all(|coordinate| coordinate.is_finite()) || self.evaluator.distance(point).abs() > reach {
            return None;
        }
        let mut on = point;
        for _ in 0..8 {
            let value = self.evaluator.gradient(on);
            let square: f64 = value.gradient.iter().map(|slope| slope * slope).sum();
            if square < 1e-12 || value.value.abs() <= HIT * magnitude(on) {
                break;
            }
            on = [0, 1, 2].map(|axis| on[axis] - value.value * value.gradient[axis] / square);
        }
        let near = self.evaluator.distance(on).abs() <= self.evaluator.distance(point).abs();
        Some(if near { on } else { point })
    }

    /// Sphere tracing (Hart 1996) in double precision.
    fn hit(&self, eye: [f64; 3], direction: [f64; 3]) -> Option<[f64; 3]> {
        let length = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
        let direction = direction.map(|x| x / length);
        let (enter, leave) = crossing(&self.evaluator.bounds(), eye, direction)?;
        let lipschitz = self.evaluator.lipschitz().max(f64::MIN_POSITIVE);
        let mut t = enter;
        for _ in 0..MOST_STEPS {
            let point = [0, 1, 2].map(|axis| eye[axis] + t * direction[axis]);
            let distance = self.evaluator.distance(point);
            let near = 1e3 * HIT * magnitude(point).max(t);
            // Only where the sign changes there is a surface.
            if distance < 0.0 {
                return Some(point);
            }
            t += distance / lipschitz + near;
            if t.is_nan() || t > leave {
                return None;
            }
        }
        None
    }
}

/// Where a ray enters a box, not before its start, and where it leaves it.
fn crossing(bounds: &Bounds, eye: [f64; 3], direction: [f64; 3]) -> Option<(f64, f64)> {
    let (mut enter, mut leave) = (0.0_f64, f64::MAX);
    for axis in 0..3 {
        let to = |plane: f64| (plane - eye[axis]) / direction[axis];
        if direction[axis] != 0.0 {
            let (a, b) = (to(bounds.min[axis]), to(bounds.max[axis]));
            enter = enter.max(a.min(b));
            leave = leave.min(a.max(b));
        } else if eye[axis] < bounds.min[axis] || eye[axis] > bounds.max[axis] {
            return None;
        }
    }
    (enter <= leave).then_some((enter, leave))
}

fn magnitude(point: [f64; 3]) -> f64 {
    point.iter().fold(1.0_f64, |most, coordinate| most.max(coordinate.abs()))
}
