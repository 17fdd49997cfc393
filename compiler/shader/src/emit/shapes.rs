//! Nodes: distances.

use chiaro_field::{Graph, Node, NodeId, Operation, PointId};
use chiaro_solid::Scalar;
use chiaro_vocabulary::rows::{CONFINE_JOIN, OP_EXTRUDE, OP_TAPER};
use chiaro_vocabulary::{Kind, Row, Type};
use naga::{BinaryOperator, MathFunction};

use super::Scope;
use crate::build::Value;

/// The distance to nothing, in millimetres: the vocabulary's FAR.
pub(super) const FAR: f32 = 1e15;

/// What a node is, as its values are called.
pub(super) fn kind(graph: &Graph, id: NodeId) -> &'static str {
    let is_cut = |child: &NodeId| matches!(graph.nodes[child.0 as usize], Node::Negate(_));
    match &graph.nodes[id.0 as usize] {
        Node::Nothing => "nothing",
        Node::Shape(row, ..) | Node::Adjust(row, ..) => row.name,
        Node::Outline(..) => "outline",
        Node::Loft(..) => "loft",
        Node::Polytope(..) => "polytope",
        Node::Boolean(_, Some(_), _) => "joint",
        Node::Boolean(Operation::Union, None, _) => "union",
        Node::Boolean(Operation::Intersection, None, operands) if operands.iter().any(is_cut) => "difference",
        Node::Boolean(Operation::Intersection, None, _) => "intersection",
        Node::Negate(_) => "complement",
        Node::Extrude(..) => "extrude",
        Node::Taper(..) => "taper",
        Node::Confine(..) => "confine",
        Node::Paint(_, child) => kind(graph, *child),
    }
}

impl Scope<'_, '_> {
    /// The node's distance: evaluated here, by the function of its series, or by one of its own if it is large and asked more
    /// than once.
    pub(super) fn distance(&mut self, id: NodeId) -> Value {
        if let Some(&value) = self.distances.get(&id) {
            return value;
        }
        let value = match (self.emission.series.of_member(id), self.emission.parts.is_apart(id)) {
            (Some(member), _) => self.member_distance(id, member),
            (None, true) => self.distance_by_part(id),
            (None, false) => self.distance_here(id),
        };
        self.distances.insert(id, value);
        value
    }

    /// The node's distance, evaluated here.
    pub(super) fn distance_here(&mut self, id: NodeId) -> Value {
        let graph = self.emission.graph;
        let span = graph.spans.get(id.0 as usize).copied();
        let outer = std::mem::replace(&mut self.emission.current, span);
        let value = match &graph.nodes[id.0 as usize] {
            Node::Boolean(operation, None, children) => self.sharp(id, *operation, children),
            Node::Boolean(operation, Some(joint), children) => self.joined(id, *operation, joint, children),
            Node::Negate(child) => {
                let distance = self.distance(*child);
                let opposite = self.builder.negate(distance);
                match self.emission.parts.is_shared(id) {
                    true => self.name_node(opposite, id),
                    false => opposite,
                }
            }
            Node::Adjust(row, arguments, child) => {
                let distance = self.distance(*child);
                let adjusted = self.call_row(row, distance, arguments);
                self.name_node(adjusted, id)
            }
            Node::Extrude(height, child, point) => {
                let distance = self.distance(*child);
                let point = self.space_point(*point);
                let z = self.builder.component(point, 2);
                let height = self.scalar(height);
                let extruded = self.call(&OP_EXTRUDE, &[distance, z, height]);
                self.name_node(extruded, id)
            }
            Node::Taper(height, scale, child, point) => {
                let distance = self.distance(*child);
                let point = self.space_point(*point);
                let z = self.builder.component(point, 2);
                let [height, scale] = [self.scalar(height), self.vector(scale)];
                let tapered = self.call(&OP_TAPER, &[distance, z, height, scale]);
                self.name_node(tapered, id)
            }
            Node::Confine(radius, lipschitz, child, point) => {
                let distance = self.distance(*child);
                let gap = self.gap(*point, radius);
                let lipschitz = self.constant(*lipschitz);
                let joined = self.call(&CONFINE_JOIN, &[distance, gap, lipschitz]);
                self.name_node(joined, id)
            }
            Node::Paint(_, child) => self.distance(*child),
            leaf => self.leaf(id, leaf),
        };
        self.emission.current = outer;
        value
    }

    /// The distance to what has no nodes below it. A function of its own, so that the frames of deep scenes stay small.
    #[inline(never)]
    fn leaf(&mut self, id: NodeId, node: &Node) -> Value {
        match node {
            Node::Nothing => self.builder.literal(FAR),
            Node::Shape(row, arguments, point) => {
                let point = match row.kind {
                    Kind::Plane => self.plane_point(*point),
                    _ => self.space_point(*point),
                };
                let distance = self.call_row(row, point, arguments);
                self.name_node(distance, id)
            }
            Node::Outline(region, point) => {
                let point = self.plane_point(*point);
                let distance = self.outline(region, point);
                self.name_node(distance, id)
            }
            Node::Loft(loft, point) => {
                let point = self.space_point(*point);
                let distance = self.loft(loft, point);
                self.name_node(distance, id)
            }
            Node::Polytope(triangles, point) => {
                let point = self.space_point(*point);
                let distance = self.polytope(triangles, point);
                self.name_node(distance, id)
            }
            _ => {
                self.emission.fail("a node of the field graph is no shape");
                self.builder.literal(FAR)
            }
        }
    }

    /// Calls a row's function with its first argument and its flattened arguments.
    pub(super) fn call_row(&mut self, row: &Row, first: Value, arguments: &[Scalar]) -> Value {
        let mut values = vec![first];
        let mut rest = arguments;
        for parameter in row.parameters {
            let Some((own, others)) = rest.split_at_checked(parameter.ty.len()) else {
                self.emission.fail("a shape of the field graph has too few arguments");
                return first;
            };
            rest = others;
            values.push(match parameter.ty {
                Type::Float => self.scalar(&own[0]),
                Type::Vec2 | Type::Vec3 => self.vector(own),
            });
        }
        self.call(row, &values)
    }

    /// How far the point lies outside of the cylinder of this radius about z; negative inside.
    fn gap(&mut self, point: PointId, radius: &Scalar) -> Value {
        let across = self.plane_point(point);
        let length = self.builder.math(MathFunction::Length, across, None);
        let radius = self.scalar(radius);
        self.builder.binary(BinaryOperator::Subtract, length, radius)
    }
}
