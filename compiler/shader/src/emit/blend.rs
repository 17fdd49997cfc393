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
        let groups = match self.emission.parts.is_large(id) {
            true => self.emission.groups(children),
            false => vec![children.to_vec()],
        };
        let values: Vec<Value> = groups.iter().map(|group| self.reduced(operation, group)).collect();
        let value = self.chain(operation, &values);
        let prefix = match operation {
            Operation::Union => "joined",
            Operation::Intersection => "common",
        };
        self.name_node(value, id, prefix)
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

    /// The joint of the children.
    pub(super) fn joined(&mut self, operation: Operation, joint: &Joint, children: &[NodeId]) -> Value {
        let Joined { joint, .. } = self.joint(operation, joint, children);
        match operation {
            Operation::Union => joint,
            Operation::Intersection => self.builder.negate(joint),
        }
    }

    /// The joint of the children as that of a union.
    pub(super) fn joint(&mut self, operation: Operation, joint: &Joint, children: &[NodeId]) -> Joined {
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
        Joined { distances, joint, radius, exponent }
    }

    fn joint_of_many(&mut self, distances: &[Value], radius: Value, exponent: Value) -> Value {
        let least = self.chain(Operation::Union, distances);
        let least = self.name(least, "least");
        let zero = self.builder.literal(0.0);
        (0..joint_steps(distances.len())).fold(least, |x, _| {
            let start = self.builder.vector(&[zero, zero]);
            let state = distances.iter().fold(start, |state, &distance| {
                let state = self.call(&JOINT_TERM, &[state, distance, x, radius, exponent]);
                self.name(state, "terms")
            });
            let step = self.call(&JOINT_STEP, &[state, x, radius]);
            self.name(step, "estimate")
        })
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
