//! Unions, intersections and differences.

use std::sync::Arc;

use chiaro_solid::{Boolean, Joint, Solid};
use chiaro_syntax::Span;
use chiaro_vocabulary::Class;
use rustc_hash::FxHashSet;

use super::Lowering;
use super::context::Context;
use crate::graph::{Node, NodeId, Operation};

impl Lowering {
    pub(super) fn boolean(
        &mut self,
        operation: Boolean,
        joint: Option<&Joint>,
        children: &[Arc<Solid>],
        context: &Context,
        span: Span,
    ) -> Option<NodeId> {
        let moved = self.moved(context);
        let context = moved.as_deref().unwrap_or(context);
        let settled = joint.map(|_| self.settled(context));
        let below = settled.as_deref().unwrap_or(context);
        let joint = joint.map(|joint| Joint { profile: joint.profile, radius: below.length(&joint.radius) });
        let mut operands = children.iter().map(|child| self.lower(child, below)).collect::<Vec<_>>().into_iter();
        match operation {
            Boolean::Union => {
                let operands = operands.flatten().collect();
                match joint {
                    Some(joint) => self.joined(Operation::Union, operands, joint, below, span),
                    None => {
                        let flat = self.flattened(operands, Operation::Union);
                        let merged = self.merged(flat, below, span);
                        self.union(merged, None, span)
                    }
                }
            }
            Boolean::Intersection => {
                let operands = operands.collect::<Option<Vec<_>>>()?;
                let operands = self.meet(operands, below)?;
                match joint {
                    Some(joint) => self.joined(Operation::Intersection, operands, joint, below, span),
                    None => self.intersection(operands, None, span),
                }
            }
            Boolean::Difference => {
                let minuend = operands.next()??;
                let subtrahends = operands.flatten().collect();
                self.difference(minuend, subtrahends, joint, below, span)
            }
        }
    }

    /// The union of nodes; none of none.
    pub(super) fn union(&mut self, operands: Vec<NodeId>, joint: Option<Joint>, span: Span) -> Option<NodeId> {
        let operands = match joint {
            None => self.flattened(operands, Operation::Union),
            Some(_) => operands,
        };
        self.reduced(Operation::Union, joint, operands, span)
    }

    /// The intersection of nodes, one at least.
    pub(super) fn intersection(&mut self, operands: Vec<NodeId>, joint: Option<Joint>, span: Span) -> Option<NodeId> {
        let operands = match joint {
            None => self.flattened(operands, Operation::Intersection),
            Some(_) => operands,
        };
        self.reduced(Operation::Intersection, joint, operands, span)
    }

    /// What is left of a node without others. Those that don't reach it are left out: where they are, the value is
    /// less than it would be with them, but the solid is the same.
    fn difference(
        &mut self,
        minuend: NodeId,
        subtrahends: Vec<NodeId>,
        joint: Option<Joint>,
        context: &Context,
        span: Span,
    ) -> Option<NodeId> {
        let kept = self.builder.extent(minuend).bounds;
        let reach = joint.as_ref().map_or(0.0, |joint| joint.radius.range().max);
        let subtrahends = match joint {
            None => self.flattened(subtrahends, Operation::Union),
            Some(_) => subtrahends,
        };
        let meets = |id: &NodeId| !self.builder.extent(*id).within(reach).intersection(&kept).is_empty();
        let subtrahends: Vec<NodeId> = subtrahends.into_iter().filter(meets).collect();
        let subtrahends = match joint {
            None => self.merged(subtrahends, context, span),
            Some(_) => subtrahends,
        };
        self.cut(minuend, subtrahends, joint.as_ref(), context, span)
    }

    /// What is left of a node without others.
    pub(super) fn without(
        &mut self,
        minuend: NodeId,
        subtrahends: Vec<NodeId>,
        joint: Option<&Joint>,
        span: Span,
    ) -> Option<NodeId> {
        if subtrahends.is_empty() {
            return Some(minuend);
        }
        let mut operands = vec![minuend];
        match joint {
            None => {
                let together = self.union(subtrahends, None, span)?;
                operands.push(self.complement(together, span));
            }
            Some(_) => operands.extend(subtrahends.into_iter().map(|id| self.complement(id, span))),
        }
        self.intersection(operands, joint.cloned(), span)
    }

    pub(super) fn complement(&mut self, id: NodeId, span: Span) -> NodeId {
        let facts = *self.builder.facts(id);
        // The inside becomes the outside, where only an exact distance is known well.
        let class = if facts.class == Class::Exact { Class::Exact } else { Class::Bound };
        self.builder.node(Node::Negate(id), span, class, facts.lipschitz)
    }

    pub(super) fn reduced(
        &mut self,
        operation: Operation,
        joint: Option<Joint>,
        operands: Vec<NodeId>,
        span: Span,
    ) -> Option<NodeId> {
        if operands.len() < 2 {
            return operands.first().copied();
        }
        let facts = || operands.iter().map(|id| self.builder.facts(*id));
        let lipschitz = facts().map(|facts| facts.lipschitz).fold(0.0, f64::max);
        let class = match (operation, &joint) {
            (Operation::Union, None) => facts().map(|facts| facts.class).fold(Class::ExactOutside, Class::max),
            _ => Class::Bound,
        };
        Some(self.builder.node(Node::Boolean(operation, joint, operands), span, class, lipschitz))
    }

    /// The operands with those that are the same operation taken apart, each once.
    fn flattened(&self, operands: Vec<NodeId>, operation: Operation) -> Vec<NodeId> {
        let mut seen = FxHashSet::default();
        let mut flat = Vec::with_capacity(operands.len());
        for operand in operands {
            let parts = match self.builder.get(operand) {
                Node::Boolean(of, None, parts) if *of == operation => parts.as_slice(),
                _ => &[operand],
            };
            flat.extend(parts.iter().copied().filter(|part| seen.insert(*part)));
        }
        flat
    }
}
