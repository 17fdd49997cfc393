//! Booleans: sharp ones are chains of minima or maxima, joints the formula of the vocabulary.

use chiaro_field::{NodeId, Operation};
use chiaro_solid::{Joint, Profile};
use chiaro_vocabulary::rows::{JOINT_CHAMFER, JOINT_FILLET, JOINT_SMOOTH, JOINT_STEP, JOINT_TERM, joint_steps};
use naga::MathFunction;

use super::Scope;
use crate::build::Value;

/// A chain gets a name this often, since printed expressions must not nest deeply.
const NAMED_EVERY: usize = 8;

/// The operands of a joint as those of a union, and what solves it.
#[derive(Clone)]
pub(super) struct Joined {
    /// The operands' distances; the opposites, of an intersection.
    pub(super) distances: Vec<Value>,
    /// The joint of these distances.
    pub(super) joint: Value,
    pub(super) radius: Value,
    pub(super) exponent: Value,
}

impl Scope<'_, '_> {
    /// The least or greatest of the children.
    pub(super) fn sharp(&mut self, id: NodeId, operation: Operation, children: &[NodeId]) -> Value {
        let value = match self.emission.crowd_of(id) {
            Some(crowd) => self.crowd_and_others(crowd),
            None => self.reduced_with(operation, Vec::new(), children),
        };
        self.name_node(value, id)
    }

    /// The least of a crowd's members and of the operands that are none.
    fn crowd_and_others(&mut self, crowd: usize) -> Value {
        let members = self.crowd_distance(crowd);
        let others = &self.emission.crowds.crowd(crowd).others;
        self.reduced_with(Operation::Union, vec![members], others)
    }

    /// The least or greatest of the values.
    pub(super) fn chain(&mut self, operation: Operation, values: &[Value]) -> Value {
        let function = extreme(operation);
        let mut values = values.iter();
        let Some(&first) = values.next() else { unreachable!("a Boolean has children") };
        values.enumerate().fold(first, |chain, (index, &value)| {
            let longer = self.builder.math(function, chain, Some(value));
            match (index + 1) % NAMED_EVERY {
                0 => self.name(longer, "so_far"),
                _ => longer,
            }
        })
    }

    /// The joint of the children of this node.
    pub(super) fn joined(&mut self, id: NodeId, operation: Operation, joint: &Joint, children: &[NodeId]) -> Value {
        let joint = self.joint(id, operation, joint, children).joint;
        match operation {
            Operation::Union => joint,
            Operation::Intersection => {
                let opposite = self.builder.negate(joint);
                self.name(opposite, "common")
            }
        }
    }

    /// The joint of the children of this node as that of a union.
    pub(super) fn joint(&mut self, id: NodeId, operation: Operation, joint: &Joint, children: &[NodeId]) -> Joined {
        if let Some(known) = self.joints.get(&id) {
            return known.clone();
        }
        let distances: Vec<Value> = (children.iter())
            .map(|child| {
                let distance = self.distance(*child);
                match operation {
                    Operation::Union => distance,
                    Operation::Intersection => self.opposite(distance),
                }
            })
            .collect();
        let radius = self.scalar(&joint.radius);
        let exponent = self.constant(match joint.profile {
            Profile::Chamfer => 1.0,
            Profile::Fillet => 2.0,
            Profile::Smooth => 3.0,
        });
        let joint = match distances[..] {
            [a, b] => {
                let function = match joint.profile {
                    Profile::Chamfer => &JOINT_CHAMFER,
                    Profile::Fillet => &JOINT_FILLET,
                    Profile::Smooth => &JOINT_SMOOTH,
                };
                self.call(function, &[a, b, radius])
            }
            _ => self.joint_of_many(&distances, radius, exponent),
        };
        let joint = self.name_node(joint, id);
        let joined = Joined { distances, joint, radius, exponent };
        self.joints.insert(id, joined.clone());
        joined
    }

    fn joint_of_many(&mut self, distances: &[Value], radius: Value, exponent: Value) -> Value {
        let least = self.chain(Operation::Union, distances);
        let least = self.name(least, "least");
        let zero = self.builder.literal(0.0);
        let start = self.builder.vector(&[zero, zero]);
        let start = self.name(start, "no_terms");
        let mut estimate = least;
        for step in 0..joint_steps(distances.len()) {
            if step > 0 {
                estimate = self.name(estimate, "estimate");
            }
            let state = distances.iter().fold(start, |state, &distance| {
                let state = self.call(&JOINT_TERM, &[state, distance, estimate, radius, exponent]);
                self.name(state, "terms")
            });
            estimate = self.call(&JOINT_STEP, &[state, estimate, radius]);
        }
        estimate
    }

    /// The opposite of a value, by a name: it is used many times.
    fn opposite(&mut self, value: Value) -> Value {
        let opposite = self.builder.negate(value);
        self.name(opposite, "opposite")
    }
}

/// The built-in function of a sharp operation.
fn extreme(operation: Operation) -> MathFunction {
    match operation {
        Operation::Union => MathFunction::Min,
        Operation::Intersection => MathFunction::Max,
    }
}
