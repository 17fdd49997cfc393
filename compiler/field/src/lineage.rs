//! What became of each solid: the tree of solids beside the graph, for going back from a surface to the text.
//!
//! The graph alone would not do: it shares what is equal, takes nested unions apart and leaves out what is not seen.

use std::sync::Arc;

use chiaro_solid::{Boolean, Solid, SolidKind};
use chiaro_vocabulary::Bounds;

use crate::evaluate::Evaluator;
use crate::graph::{Graph, NodeId};

/// The number of a [`Step`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct StepId(pub u32);

/// A lowered scene, with the way from its solids to its nodes.
#[derive(Clone, Debug)]
pub struct Lineage {
    /// The scene's field, with everything that was made on the way and not normalised: any node can be asked alone.
    pub graph: Graph,
    /// The solids; each stands behind the one around it, the first is the root.
    pub steps: Vec<Step>,
}

/// A solid where it stands in the scene.
#[derive(Clone, Debug)]
pub struct Step {
    /// The solid.
    pub solid: Arc<Solid>,
    /// Its distance, asked at a point of the world; none if there is nothing of it. (Below a twist or an extrusion it is
    /// the distance at the point that is asked there.)
    pub node: Option<NodeId>,
    /// The solid around it.
    pub parent: Option<StepId>,
    /// Its operands, in the order of the text.
    pub children: Vec<StepId>,
}

/// Writes steps down while a tree is lowered.
#[derive(Debug, Default)]
pub(crate) struct Recorder {
    pub(crate) steps: Vec<Step>,
    /// The solids being lowered, the innermost last.
    open: Vec<StepId>,
}

impl Recorder {
    /// A solid is about to be lowered.
    pub(crate) fn enter(&mut self, solid: &Arc<Solid>) {
        let id = StepId(self.steps.len() as u32);
        let parent = self.open.last().copied();
        self.steps.push(Step { solid: solid.clone(), node: None, parent, children: Vec::new() });
        self.open.push(id);
    }

    /// It came to this node.
    pub(crate) fn leave(&mut self, node: Option<NodeId>) {
        let Some(id) = self.open.pop() else { return };
        self.steps[id.0 as usize].node = node;
        let Some(parent) = self.open.last() else { return };
        let siblings = &mut self.steps[parent.0 as usize];
        // What is lowered twice, to find out more about it, counts as it was lowered last.
        if !matches!(siblings.solid.kind, SolidKind::Boolean { .. }) {
            siblings.children.clear();
        }
        siblings.children.push(id);
    }
}

impl Lineage {
    /// The step of that number.
    pub fn step(&self, id: StepId) -> &Step {
        &self.steps[id.0 as usize]
    }

    /// The solids that made the surface at a point, from the root to the innermost.
    ///
    /// Theory: the value of a hard union is that of its least operand, of an intersection that of its greatest, of a
    /// difference that of the base or of the complement of what is taken away; of a joint the same operand has the
    /// greatest weight. All else has one operand. So the way down follows the values at the point.
    /// Practice: an operand that the facts prove to be farther than the value is not asked. Of operands that share a
    /// surface, the first made it.
    pub fn made(&self, evaluator: &Evaluator, bounds: &[Bounds], point: [f64; 3]) -> Vec<StepId> {
        let Some(root) = self.steps.first().filter(|root| root.node.is_some()) else { return Vec::new() };
        let reach = point.iter().fold(1.0_f64, |reach, coordinate| reach.max(coordinate.abs()));
        let mut descent = Descent { lineage: self, evaluator, bounds, point, tolerance: 1e-6 * reach, side: true };
        let mut path = vec![StepId(0)];
        let mut step = root;
        while let Some(next) = descent.next(step) {
            path.push(next);
            step = self.step(next);
        }
        path
    }
}

/// The way down to what made a surface.
struct Descent<'a> {
    lineage: &'a Lineage,
    evaluator: &'a Evaluator,
    /// The nodes' boxes while the live numbers have their values.
    bounds: &'a [Bounds],
    point: [f64; 3],
    /// Values nearer to each other than this are equal.
    tolerance: f64,
    /// Whether the surface is made by the border of what is below; on the flat ends of an extrusion it is not.
    side: bool,
}

impl Descent<'_> {
    fn next(&mut self, step: &Step) -> Option<StepId> {
        if let SolidKind::Boolean { operation, joint, .. } = &step.solid.kind {
            return self.operand(step, *operation, joint.is_some());
        }
        let child = *step.children.last()?;
        if matches!(step.solid.kind, SolidKind::Extrude { .. } | SolidKind::Revolve { .. }) {
            self.side &= self.value(child)? >= self.evaluator.value(step.node?, self.point) - self.tolerance;
        }
        self.lineage.step(child).node.map(|_| child)
    }

    /// The operand whose surface a Boolean's is.
    fn operand(&self, step: &Step, operation: Boolean, joined: bool) -> Option<StepId> {
        let (sign, operands) = match operation {
            Boolean::Union => (1.0, step.children.as_slice()),
            Boolean::Intersection => (-1.0, step.children.as_slice()),
            Boolean::Difference => {
                let (base, taken) = step.children.split_first()?;
                let outer = self.evaluator.value(step.node?, self.point);
                let is_base = |value: f64| !joined && value >= outer - self.tolerance;
                let base_value = self.value(*base)?;
                if !self.side || is_base(base_value) {
                    return Some(*base);
                }
                let Some(cut) = self.least(taken, if joined { f64::INFINITY } else { -outer }) else {
                    return Some(*base);
                };
                return Some(if -cut.1 > base_value + self.tolerance { cut.0 } else { *base });
            }
        };
        let value = sign * self.evaluator.value(step.node?, self.point);
        if sign > 0.0 && !joined {
            return self.least(operands, value).map(|(operand, _)| operand);
        }
        let values = operands.iter().filter_map(|id| Some((*id, sign * self.value(*id)?)));
        values.reduce(|best, next| if next.1 < best.1 - self.tolerance { next } else { best }).map(|(id, _)| id)
    }

    /// The first operand whose value is at most `enough`, or else the one of the least value; with that.
    fn least(&self, operands: &[StepId], enough: f64) -> Option<(StepId, f64)> {
        let mut least: Option<(StepId, f64)> = None;
        for id in operands {
            let Some(node) = self.lineage.step(*id).node else { continue };
            // Farther than this from its box, a value is greater than the least so far.
            let most = least.map_or(f64::INFINITY, |(_, value)| value).min(enough + 2.0 * self.tolerance).max(0.0);
            let growth = self.lineage.graph.facts[node.0 as usize].growth;
            let gap = (0..3).map(|axis| self.beyond(node, axis)).fold(0.0, f64::max);
            if growth.is_finite() && most.is_finite() && gap > most * growth + self.tolerance {
                continue;
            }
            let value = self.evaluator.value(node, self.point);
            if least.is_none_or(|(_, least)| value < least) {
                least = Some((*id, value));
            }
            if enough.is_finite() && value <= enough + self.tolerance {
                break;
            }
        }
        least
    }

    /// How far the point is outside of a node's box along an axis.
    fn beyond(&self, node: NodeId, axis: usize) -> f64 {
        let bounds = &self.bounds[node.0 as usize];
        (bounds.min[axis] - self.point[axis]).max(self.point[axis] - bounds.max[axis])
    }

    fn value(&self, id: StepId) -> Option<f64> {
        let node = self.lineage.step(id).node?;
        Some(self.evaluator.value(node, self.point))
    }
}
