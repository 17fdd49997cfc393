//! Whether nodes keep apart, or lie within one another.
//!
//! All answers are sound for every value of the live numbers: what can't be decided is answered by no.

use chiaro_vocabulary::{Class, rows};

use super::face::{self, Disc, Face, Faces, MOST_HEIGHT};
use crate::build::Builder;
use crate::extent;
use crate::graph::{Node, NodeId, Operation, PointId};

/// What is asked about nodes in the coordinates of a frame.
pub(super) struct Query<'a> {
    pub(super) builder: &'a Builder,
    pub(super) frame: PointId,
    /// What is nearer than this touches.
    pub(super) tolerance: f64,
}

/// What lies beyond some faces, and within the hulls of some discs each.
pub(super) struct Body {
    beyond: Vec<Face>,
    hulls: Vec<Vec<Disc>>,
}

impl Query<'_> {
    /// The faces of a node.
    pub(super) fn faces(&self, node: NodeId) -> Faces {
        face::faces(self.builder, node, self.frame)
    }

    /// Hulls around a node, of an intersection one for each operand; none if it has no end.
    pub(super) fn body(&self, node: NodeId) -> Option<Body> {
        let hull = |id: &NodeId| face::discs(self.builder, *id, self.frame);
        let hulls: Vec<Vec<Disc>> = match self.builder.get(node) {
            Node::Boolean(Operation::Intersection, _, children) => children.iter().filter_map(hull).collect(),
            _ => hull(&node).into_iter().collect(),
        };
        (!hulls.is_empty()).then_some(Body { beyond: Vec::new(), hulls })
    }

    /// How far a node keeps from a face on its inner side, at the least; negative if it may cross it.
    pub(super) fn gap(&self, node: NodeId, face: &Face) -> f64 {
        if self.is_too_deep(node) {
            return self.gap_of_discs(node, face);
        }
        match self.builder.get(node) {
            Node::Paint(_, child) => self.gap(*child, face),
            Node::Boolean(Operation::Union, joint, children) => {
                let gaps = children.iter().map(|child| self.gap(*child, face));
                let bulge = joint
                    .as_ref()
                    .map_or(0.0, |joint| extent::bulge(joint.profile, children.len()) * joint.radius.range().max);
                gaps.fold(f64::INFINITY, f64::min) - bulge
            }
            Node::Boolean(Operation::Intersection, _, children) => {
                children.iter().map(|child| self.gap(*child, face)).fold(f64::NEG_INFINITY, f64::max)
            }
            Node::Negate(_) => f64::NEG_INFINITY,
            Node::Adjust(row, arguments, child) if **row == rows::SHELL => {
                match self.builder.facts(*child).class <= Class::ExactOutside {
                    true => self.gap(*child, face) - 0.5 * arguments[0].range().max,
                    false => self.gap_of_discs(node, face),
                }
            }
            _ => self.gap_of_discs(node, face),
        }
    }

    fn is_too_deep(&self, node: NodeId) -> bool {
        self.builder.height(node) > MOST_HEIGHT
    }

    fn gap_of_discs(&self, node: NodeId, face: &Face) -> f64 {
        match face::discs(self.builder, node, self.frame) {
            Some(discs) => least_gap(&discs, face),
            None => f64::NEG_INFINITY,
        }
    }

    /// Whether a node lies on the inner side of a face, contact allowed.
    pub(super) fn is_within(&self, node: NodeId, face: &Face) -> bool {
        self.gap(node, face) >= -self.tolerance
    }

    /// Whether a body and a node have at most their surfaces in common.
    pub(super) fn is_apart(&self, body: &Body, node: NodeId) -> bool {
        if body.beyond.iter().any(|face| self.is_within(node, face)) {
            return true;
        }
        if self.is_too_deep(node) {
            return self.is_beyond(body, node);
        }
        match self.builder.get(node) {
            Node::Paint(_, child) => self.is_apart(body, *child),
            Node::Boolean(Operation::Union, None, children) => children.iter().all(|child| self.is_apart(body, *child)),
            Node::Boolean(Operation::Intersection, _, children) => {
                children.iter().any(|child| self.is_apart(body, *child))
            }
            Node::Negate(child) => self.holds(*child, body),
            _ => self.is_beyond(body, node),
        }
    }

    /// Whether a face of a node, or a side of its box, parts it from a body.
    fn is_beyond(&self, body: &Body, node: NodeId) -> bool {
        let parts = |face: &Face| {
            // What is not a Boolean lies around all its hollow faces, and within some of the others.
            let is_inner = matches!(face, Face::Round { is_hollow: true, .. }) || self.is_within(node, face);
            is_inner && body.gap(&face.flipped()) >= -self.tolerance
        };
        self.box_faces(node).into_iter().chain(self.faces(node).list).any(|face| parts(&face))
    }

    /// The planes of a node's box that have an end.
    fn box_faces(&self, node: NodeId) -> Vec<Face> {
        let bounds = self.builder.extent_at(node, self.frame).bounds;
        let mut faces = Vec::with_capacity(6);
        for axis in 0..self.builder.dimension(self.frame) {
            for (sign, offset) in [(1.0, bounds.max[axis]), (-1.0, -bounds.min[axis])] {
                if offset.is_finite() {
                    let mut normal = [0.0; 3];
                    normal[axis] = sign;
                    faces.push(Face::Flat { normal, offset: offset.into() });
                }
            }
        }
        faces
    }

    /// Whether a body lies within a node.
    pub(super) fn holds(&self, node: NodeId, body: &Body) -> bool {
        if self.is_too_deep(node) {
            return false;
        }
        match self.builder.get(node) {
            Node::Paint(_, child) => self.holds(*child, body),
            Node::Boolean(Operation::Union, _, children) => children.iter().any(|child| self.holds(*child, body)),
            Node::Boolean(Operation::Intersection, None, children) => {
                children.iter().all(|child| self.holds(*child, body))
            }
            Node::Boolean(..) => false,
            Node::Negate(child) => self.is_apart(body, *child),
            _ => {
                let faces = self.faces(node);
                faces.are_whole && faces.list.iter().all(|face| body.gap(face) >= -self.tolerance)
            }
        }
    }
}

impl Body {
    /// How far the body keeps from a face on its inner side, at the least.
    fn gap(&self, face: &Face) -> f64 {
        self.hulls.iter().map(|discs| least_gap(discs, face)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The same body, which is known to lie beyond a face.
    pub(super) fn beyond(mut self, face: Face) -> Body {
        self.beyond.push(face);
        self
    }
}

fn least_gap(discs: &[Disc], face: &Face) -> f64 {
    discs.iter().map(|disc| face.gap(disc)).fold(f64::INFINITY, f64::min)
}

impl Query<'_> {
    /// The parts of a node, not taken away from it, that have a face.
    pub(super) fn parts_with(&self, node: NodeId, face: &Face) -> Vec<NodeId> {
        if self.is_too_deep(node) {
            return Vec::new();
        }
        match self.builder.get(node) {
            Node::Paint(_, child) => self.parts_with(*child, face),
            Node::Boolean(_, _, children) => children.iter().flat_map(|child| self.parts_with(*child, face)).collect(),
            _ => match self.faces(node).list.iter().any(|own| own.is(face, self.tolerance)) {
                true => vec![node],
                false => Vec::new(),
            },
        }
    }

    /// Whether the boxes of two nodes with a face in common have more than an edge of it in common.
    pub(super) fn share_area(&self, a: NodeId, b: NodeId, face: &Face) -> bool {
        let bounds = |id: NodeId| self.builder.extent_at(id, self.frame).bounds;
        let sizes = bounds(a).intersection(&bounds(b).inflate(self.tolerance)).size();
        let across = match face {
            Face::Flat { normal, .. } => *normal,
            Face::Round { .. } => return sizes.iter().all(|size| *size > 2.0 * self.tolerance),
        };
        let dimension = self.builder.dimension(self.frame);
        (0..dimension).all(|axis| sizes[axis] > 2.5 * self.tolerance || across[axis].abs() > 0.1)
    }
}
