//! Lowers a solid tree to a field graph.
//!
//! On the way down a [`Context`] says where one is: the point that is asked there, and by how much lengths of the
//! solid are to be multiplied to be millimetres of the world. So no distance needs to be scaled on the way up, and
//! every transform ends in one matrix at the shape below it.

mod boolean;
mod context;
mod extrude;
mod normalise;
mod plane;
mod regular;
mod shape;
mod sphere_hull;
mod warp;

use std::rc::Rc;
use std::sync::Arc;

use chiaro_solid::{Dimension, Scalar, Solid, SolidKind};
use chiaro_syntax::{Diagnostic, Severity, Span};
use chiaro_vocabulary::{Class, Row, rows};
use rustc_hash::{FxHashMap, FxHashSet};

use crate::build::Builder;
use crate::checks;
use crate::extent::WORLD;
use crate::graph::{Graph, Node, NodeId, Point};
use crate::lineage::{Lineage, Recorder};
use context::Context;

/// More nodes than this are refused: it is far beyond what any shader could hold, but within memory.
const MOST_NODES: usize = 1 << 22;

/// The greatest slope that a field may have: beyond it, values in a shader's precision say nothing.
const STEEPEST: f64 = 1e9;

/// The field graph of a scene, and what there is to say about it. If an error is among that, the graph lacks what
/// the error is about.
pub fn lower(root: &Arc<Solid>) -> (Graph, Vec<Diagnostic>) {
    let mut lowering = Lowering::new();
    let lowered = lowering.lower_root(root);
    if let Some(root) = lowered {
        lowering.check_slopes(root);
    }
    let Lowering { mut builder, mut diagnostics, .. } = lowering;
    let root = lowered.unwrap_or_else(|| builder.node(Node::Nothing, root.span, Class::Exact, 1.0));
    let root = normalise::normalised(&mut builder, root);
    let graph = builder.finish(root);
    diagnostics.extend(checks::remark(&graph));
    (graph, diagnostics)
}

/// Lowers a scene and keeps, for each of its solids, the node that it came to.
pub fn lower_with_lineage(root: &Arc<Solid>) -> Lineage {
    let mut lowering = Lowering { recorder: Some(Recorder::default()), ..Lowering::new() };
    let lowered = lowering.lower_root(root);
    let Lowering { mut builder, recorder, .. } = lowering;
    let root = lowered.unwrap_or_else(|| builder.node(Node::Nothing, root.span, Class::Exact, 1.0));
    Lineage { graph: builder.finish_whole(root), steps: recorder.unwrap_or_default().steps }
}

/// The state of lowering one tree.
struct Lowering {
    builder: Builder,
    /// What shared subtrees came to, by their address and their context. The tree outlives this.
    lowered: FxHashMap<(*const Solid, u32), Option<NodeId>>,
    contexts: u32,
    /// What it writes down, if somebody wants to know what became of each solid.
    recorder: Option<Recorder>,
    /// The contexts in which solids are measured in their own coordinates: in space and in the plane.
    probes: Option<Rc<[Context; 2]>>,
    diagnostics: Vec<Diagnostic>,
    /// What has been said, so that nothing is said twice.
    said: FxHashSet<(Option<Span>, String)>,
}

impl Lowering {
    fn new() -> Self {
        Self {
            builder: Builder::new(),
            lowered: FxHashMap::default(),
            contexts: 0,
            recorder: None,
            probes: None,
            diagnostics: Vec::new(),
            said: FxHashSet::default(),
        }
    }

    fn lower_root(&mut self, root: &Arc<Solid>) -> Option<NodeId> {
        let context = match root.dimension() {
            Some(Dimension::Plane) => self.slice_of_world(),
            Some(Dimension::Space) | None => self.context(WORLD),
        };
        self.lower(root, &context)
    }

    /// The node for a solid; none if there is nothing of it.
    fn lower(&mut self, solid: &Arc<Solid>, context: &Context) -> Option<NodeId> {
        if self.builder.len() > MOST_NODES {
            self.say(Diagnostic::error(solid.span, format!("the scene has more than {MOST_NODES} parts")));
            return self.recorded(solid, context, None);
        }
        let key = (Arc::as_ptr(solid), context.id);
        let shared = Arc::strong_count(solid) > 1 || context.probe;
        if let (true, Some(known)) = (shared, self.lowered.get(&key)) {
            return self.recorded(solid, context, *known);
        }
        self.record(context, |recorder| recorder.enter(solid));
        let node = self.lower_afresh(solid, context);
        let node = node.filter(|node| !self.builder.facts(*node).bounds.is_empty());
        self.record(context, |recorder| recorder.leave(node));
        if shared {
            self.lowered.insert(key, node);
        }
        node
    }

    /// Writes down what is known of a solid without lowering it.
    #[inline(never)]
    fn recorded(&mut self, solid: &Arc<Solid>, context: &Context, node: Option<NodeId>) -> Option<NodeId> {
        self.record(context, |recorder| {
            recorder.enter(solid);
            recorder.leave(node);
        });
        node
    }

    /// Writes something down, if somebody wants to know and the solid is not only being measured.
    #[inline(never)]
    fn record(&mut self, context: &Context, write: impl FnOnce(&mut Recorder)) {
        if let Some(recorder) = self.recorder.as_mut().filter(|_| !context.probe) {
            write(recorder);
        }
    }

    fn lower_afresh(&mut self, solid: &Arc<Solid>, context: &Context) -> Option<NodeId> {
        let span = solid.span;
        match &solid.kind {
            SolidKind::Empty => None,
            SolidKind::Shape(row, arguments) => Some(self.shape(row, arguments, context, span)),
            SolidKind::Region(region) => self.region(region, context, span),
            SolidKind::SphereHull(spheres) => self.sphere_hull(spheres, context, span),
            SolidKind::Boolean { operation, joint, children } => {
                self.boolean(*operation, joint.as_ref(), children, context, span)
            }
            SolidKind::Transform(map, child) => {
                let below = self.derive(context, |below| {
                    below.since = below.since.after(map);
                    below.transformed_at = span;
                });
                self.lower(child, &below)
            }
            SolidKind::Paint(material, child) if !context.painted => {
                let below = self.derive(context, |below| below.painted = true);
                let node = self.lower(child, &below)?;
                let material = self.builder.material(material);
                let facts = *self.builder.facts(node);
                Some(self.builder.node(Node::Paint(material, node), span, facts.class, facts.lipschitz))
            }
            SolidKind::Paint(_, child) => self.lower(child, context),
            SolidKind::Offset(by, child) => self.adjusted((&rows::OFFSET, by), child, offset_class, context, span),
            SolidKind::Shell(thickness, child) => {
                self.adjusted((&rows::SHELL, thickness), child, shell_class, context, span)
            }
            SolidKind::Twist(rate, child) => self.twist(rate, child, context, span),
            SolidKind::Extrude { height, twist, scale, child } => {
                self.extrude([height, twist, &scale[0], &scale[1]], child, context, span)
            }
            SolidKind::Loft(loft) => self.loft(loft, context, span),
            SolidKind::Revolve { sweep, facets, child } => self.revolve(sweep.as_ref(), *facets, child, context, span),
            SolidKind::Slice(child) => self.slice(child, context),
        }
    }

    /// A solid whose distance is changed by an adjustment of the table with one length; `class` says what is left of its
    /// class.
    fn adjusted(
        &mut self,
        (row, length): (&'static Row, &Scalar),
        child: &Arc<Solid>,
        class: fn(Class, &Scalar) -> Class,
        context: &Context,
        span: Span,
    ) -> Option<NodeId> {
        let below = self.settled(context);
        let node = self.lower(child, &below)?;
        let facts = *self.builder.facts(node);
        let arguments = vec![below.length(length)];
        Some(self.builder.node(Node::Adjust(row, arguments, node), span, class(facts.class, length), facts.lipschitz))
    }

    /// The solid in its own coordinates, to measure it.
    fn probe(&mut self, solid: &Arc<Solid>) -> Option<NodeId> {
        let probes = match &self.probes {
            Some(probes) => probes.clone(),
            None => {
                let probe = |context: Context| Context { painted: true, probe: true, ..context };
                let probes = Rc::new([probe(self.context(WORLD)), probe(self.slice_of_world())]);
                // Probes within probes need the same contexts, lest what is nested be measured again at each level.
                self.probes.insert(probes).clone()
            }
        };
        let [space, plane] = &*probes;
        let context = if solid.dimension() == Some(Dimension::Plane) { plane } else { space };
        self.lower(solid, context)
    }

    /// The context of a plane scene.
    fn slice_of_world(&mut self) -> Context {
        let slice = self.builder.point(Point::Warp(&rows::SLICE, Vec::new(), WORLD));
        let context = self.context(slice);
        Context { plane: true, ..context }
    }

    /// Says where slopes multiply to more than can be drawn, none of them alone being too steep.
    fn check_slopes(&mut self, root: NodeId) {
        let is_too_steep = |id: &NodeId| self.builder.facts(*id).lipschitz > STEEPEST;
        if is_too_steep(&root) && !self.diagnostics.iter().any(|said| said.severity == Severity::Error) {
            let span = (0..=root.0).map(NodeId).find(is_too_steep).map(|id| self.builder.span(id));
            let message = format!("twists in one another make distances more than {STEEPEST:e} times too long here");
            self.say(Diagnostic::error(span, message).with_hint("twist less, or fewer things that are twisted"));
        }
    }

    fn say(&mut self, diagnostic: Diagnostic) {
        if self.said.insert((diagnostic.span, diagnostic.message.clone())) {
            self.diagnostics.push(diagnostic);
        }
    }
}

/// Outside of what is shrunk, and inside of what is grown, another point of the surface may be nearer.
fn offset_class(class: Class, by: &Scalar) -> Class {
    if by.range().min < 0.0 { Class::Bound } else { class.max(Class::ExactOutside) }
}

/// Within the wall, another point of the surface may be nearer.
fn shell_class(class: Class, _: &Scalar) -> Class {
    if class == Class::Exact { Class::ExactOutside } else { Class::Bound }
}
