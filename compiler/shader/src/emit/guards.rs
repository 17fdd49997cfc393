//! Guards: costly operands of a sharp union are asked only from where they can be the nearest.
//!
//! From a node's facts: where p is farther from its box than growth · δ, its value is above δ. With δ the union's
//! value so far (but not below zero, since that says nothing of points in the box), leaving the node out changes
//! nothing. Real GPUs skip the branch where no lane takes it; software ones run all code under a mask, but leave
//! loops after one round.

use chiaro_field::{Bounds, NodeId, Operation};
use naga::{BinaryOperator, Block, MathFunction, Statement};

use super::{Emission, Scope};
use crate::build::Value;

/// What costs less is cheaper asked than guarded. In nodes, about: a guard costs less than one.
const WORTHWHILE: u32 = 32;

/// The operands of a union that one function reduces.
struct Guarded {
    nodes: Vec<NodeId>,
    bounds: Bounds,
    growth: f64,
}

impl Emission<'_> {
    /// The nodes with their guard, if they have one.
    fn guarded(&self, nodes: Vec<NodeId>) -> Result<Guarded, Vec<NodeId>> {
        let of_nodes = || nodes.iter().map(|node| &self.graph.facts[node.0 as usize]);
        let bounds = of_nodes().fold(Bounds::EMPTY, |all, facts| all.union(&facts.bounds));
        let growth = of_nodes().map(|facts| facts.growth).fold(0.0, f64::max);
        let is_bounded = (0..3).any(|axis| bounds.min[axis].is_finite() && bounds.max[axis].is_finite());
        // What others refer to as well is asked once, and for all.
        let is_shared = matches!(nodes[..], [node] if self.parts.is_shared(node));
        let worthwhile = self.parts.cost_of(&nodes) >= WORTHWHILE && !is_shared;
        match worthwhile && is_bounded && growth.is_finite() {
            true => Ok(Guarded { nodes, bounds, growth }),
            false => Err(nodes),
        }
    }
}

impl Scope<'_, '_> {
    /// The least of some values and of all nodes in the lists: of cheap ones by themselves, then of costly ones where they
    /// count.
    pub(super) fn least(&mut self, mut values: Vec<Value>, lists: Vec<Vec<NodeId>>) -> Value {
        let mut cheap = Vec::new();
        let mut guarded = Vec::new();
        for list in lists {
            match self.emission.guarded(list) {
                Ok(costly) => guarded.push(costly),
                Err(list) => cheap.push(list),
            }
        }
        if values.is_empty() && cheap.is_empty() && !guarded.is_empty() {
            cheap.push(guarded.remove(0).nodes);
        }
        values.extend(cheap.into_iter().map(|list| self.list(Operation::Union, list)));
        let least = self.chain(Operation::Union, &values);
        if guarded.is_empty() { least } else { self.least_guarded(least, guarded) }
    }

    fn least_guarded(&mut self, cheap: Value, guarded: Vec<Guarded>) -> Value {
        let name = self.emission.names.next("nearest");
        let nearest = self.builder.variable(name, self.builder.types.float, None);
        self.builder.store(nearest, cheap);
        let point = self.builder.argument();
        for Guarded { nodes, bounds, growth } in guarded {
            let (low, high) = (self.constants(&bounds.min), self.constants(&bounds.max));
            let gap = self.call_named("box_gap", &[point, low, high]);
            let gap = self.name(gap, "gap");
            let so_far = self.so_far(nearest);
            let zero = self.builder.literal(0.0);
            let mut reach = self.builder.math(MathFunction::Max, so_far, Some(zero));
            if growth != 1.0 {
                let growth = self.constant(growth);
                reach = self.builder.binary(BinaryOperator::Multiply, reach, growth);
            }
            let condition = self.builder.binary(BinaryOperator::LessEqual, gap, reach);
            let member = self.only_member(&nodes);

            self.builder.open();
            let value = match member {
                Some((function, arguments)) => self.builder.call(function, &arguments),
                None => self.by_part(Operation::Union, nodes),
            };
            let nearer = self.builder.math(MathFunction::Min, so_far, Some(value));
            self.builder.store(nearest, nearer);
            let accept = self.builder.close();
            self.builder.statement(Statement::If { condition, accept, reject: Block::new() });
        }
        self.so_far(nearest)
    }

    fn so_far(&mut self, nearest: Value) -> Value {
        let so_far = self.builder.load(nearest);
        self.name(so_far, "so_far")
    }
}
