//! How the surface looks, on the CPU: what `scene_surface` answers on the GPU.

use chiaro_solid::{Joint, Material};
use chiaro_vocabulary::Bounds;
use chiaro_vocabulary::cpu::Scratch;
use chiaro_vocabulary::rows::JOINT_WEIGHT;

use crate::evaluate::Evaluator;
use crate::extent::exponent;
use crate::graph::{Graph, Node, NodeId, Operation};
use crate::paints::{PaintId, Painted, Paints, is_cut};

/// How a surface looks at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// The material; of several in a joint, the one that counts most.
    pub paint: PaintId,
    /// Linear red, green and blue, and opacity.
    pub color: [f64; 4],
    /// From 0, a mirror, to 1, chalk.
    pub roughness: f64,
    /// 0 for a dielectric, 1 for a metal.
    pub metallic: f64,
    /// Light given off, as a multiple of the colour.
    pub emission: f64,
}

/// Answers how a scene looks at points of its surface while its live parameters have certain values.
#[derive(Debug)]
pub struct Painter<'a> {
    graph: &'a Graph,
    paints: Paints,
    /// The looks of the paints.
    looks: Vec<Look>,
    bounds: Vec<Bounds>,
    parameters: Vec<f64>,
}

impl<'a> Painter<'a> {
    /// A painter of a graph, for these values of the live parameters in the order of their ids.
    pub fn new(graph: &'a Graph, parameters: &[f64]) -> Self {
        let paints = Paints::new(graph);
        let looks = (paints.materials().iter().enumerate())
            .map(|(paint, material)| look(PaintId(paint), material, parameters))
            .collect();
        Self { graph, paints, looks, bounds: graph.bounds_at(parameters), parameters: parameters.to_vec() }
    }

    /// The look of all of the scene, if it is the same everywhere.
    pub fn only(&self) -> Option<Look> {
        match self.paints.painted(self.graph.root) {
            Painted::Nobody => Some(self.unpainted()),
            Painted::Once(PaintId(paint)) => Some(self.looks[paint]),
            Painted::Variously => None,
        }
    }

    /// The looks of all materials, by the numbers of their paints.
    pub fn materials(&self) -> &[Look] {
        &self.looks
    }

    /// The look at a point near the surface; the evaluator is of the same graph and values.
    pub fn look(&self, evaluator: &Evaluator, point: [f64; 3]) -> Look {
        self.of_node(self.graph.root, self.unpainted(), evaluator, point)
    }

    fn unpainted(&self) -> Look {
        self.looks[PaintId::UNPAINTED.0]
    }

    /// How the node looks, if what nobody painted looks as given.
    fn of_node(&self, id: NodeId, unpainted: Look, evaluator: &Evaluator, point: [f64; 3]) -> Look {
        match self.paints.painted(id) {
            Painted::Nobody => return unpainted,
            Painted::Once(PaintId(paint)) => return self.looks[paint],
            Painted::Variously => {}
        }
        match &self.graph.nodes[id.0 as usize] {
            Node::Boolean(operation, joint, operands) => {
                let look = |place: usize| self.of_operand(*operation, operands, place, unpainted, evaluator, point);
                match joint {
                    None => look(self.foremost(*operation, operands, evaluator, point)),
                    Some(joint) => {
                        let weights = self.weights(id, *operation, joint, operands, evaluator, point);
                        let counting = weights.into_iter().enumerate().filter(|(_, weight)| *weight > 0.0);
                        blend(counting.map(|(place, weight)| (weight, look(place)))).unwrap_or(unpainted)
                    }
                }
            }
            node => match node.children() {
                [child, ..] => self.of_node(*child, unpainted, evaluator, point),
                [] => unpainted,
            },
        }
    }

    /// How an operand looks: a complement that nobody painted like what it is cut from.
    fn of_operand(
        &self,
        operation: Operation,
        operands: &[NodeId],
        place: usize,
        unpainted: Look,
        evaluator: &Evaluator,
        point: [f64; 3],
    ) -> Look {
        let is_base = |operand: &&NodeId| !is_cut(self.graph, operation, **operand);
        let unpainted = match operands[..place].iter().rev().find(is_base) {
            Some(base) if is_cut(self.graph, operation, operands[place]) => {
                self.of_node(*base, unpainted, evaluator, point)
            }
            _ => unpainted,
        };
        self.of_node(operands[place], unpainted, evaluator, point)
    }

    /// The place of the nearest operand of a union or the farthest of an intersection; the first of several.
    fn foremost(&self, operation: Operation, operands: &[NodeId], evaluator: &Evaluator, point: [f64; 3]) -> usize {
        let mut best = (0, f64::INFINITY);
        for (place, operand) in operands.iter().enumerate() {
            if operation == Operation::Union && self.is_farther(*operand, best.1, point) {
                continue;
            }
            let value = evaluator.value(*operand, point);
            let value = if operation == Operation::Union { value } else { -value };
            if value < best.1 {
                best = (place, value);
            }
        }
        best.0
    }

    /// Whether the point is so far from a node's box that its value is greater.
    fn is_farther(&self, id: NodeId, value: f64, point: [f64; 3]) -> bool {
        let (bounds, growth) = (&self.bounds[id.0 as usize], self.graph.facts[id.0 as usize].growth);
        let beyond = |axis: usize| (bounds.min[axis] - point[axis]).max(point[axis] - bounds.max[axis]);
        let gap = (0..3).map(beyond).fold(0.0, f64::max);
        growth.is_finite() && gap > value.max(0.0) * growth
    }

    /// How much each operand counts in a joint.
    fn weights(
        &self,
        id: NodeId,
        operation: Operation,
        joint: &Joint,
        operands: &[NodeId],
        evaluator: &Evaluator,
        point: [f64; 3],
    ) -> Vec<f64> {
        let sign = if operation == Operation::Union { 1.0 } else { -1.0 };
        let value = sign * evaluator.value(id, point);
        let radius = joint.radius.value(&self.parameters);
        let exponent = f64::from(exponent(joint.profile));
        let program = JOINT_WEIGHT.program();
        let mut scratch = Scratch::new();
        let weight = |operand: &NodeId| {
            let distance = sign * evaluator.value(*operand, point);
            program.call(&[distance, value, radius, exponent], &mut scratch)[0]
        };
        operands.iter().map(weight).collect()
    }
}

fn look(paint: PaintId, material: &Material, parameters: &[f64]) -> Look {
    let [red, green, blue, opacity] = [0, 1, 2, 3].map(|channel| material.color[channel].value(parameters));
    Look {
        paint,
        color: [linear_from_srgb(red), linear_from_srgb(green), linear_from_srgb(blue), opacity],
        roughness: material.roughness.value(parameters),
        metallic: material.metallic.value(parameters),
        emission: material.emission.value(parameters),
    }
}

/// The looks, each by its weight; none if there are none.
fn blend(weighted: impl Iterator<Item = (f64, Look)>) -> Option<Look> {
    let mut weighted = weighted.peekable();
    let mut foremost = *weighted.peek()?;
    let (mut total, mut sum) = (0.0, [0.0; 7]);
    for (weight, look) in weighted {
        if weight > foremost.0 {
            foremost = (weight, look);
        }
        total += weight;
        let [red, green, blue, opacity] = look.color;
        let numbers = [red, green, blue, opacity, look.roughness, look.metallic, look.emission];
        sum = std::array::from_fn(|index| sum[index] + weight * numbers[index]);
    }
    let [red, green, blue, opacity, roughness, metallic, emission] = sum.map(|sum| sum / total);
    Some(Look { paint: foremost.1.paint, color: [red, green, blue, opacity], roughness, metallic, emission })
}

/// Linear light from a channel of sRGB (IEC 61966-2-1).
pub fn linear_from_srgb(channel: f64) -> f64 {
    if channel <= 0.04045 { channel.max(0.0) / 12.92 } else { ((channel + 0.055) / 1.055).powf(2.4) }
}
