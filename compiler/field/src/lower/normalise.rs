//! Normalising: values near the root divided by their Lipschitz constants.
//!
//! Marching divides by the root's constant, so one steep part would make every step short. Nothing between the root
//! and the first joint or adjustment below it consumes a value as a length, so each steep part there is scaled by
//! itself. That alone would make it look near from everywhere: it is also intersected with the box around it, whose
//! distance is right, and so only rays that enter the box march slowly.

use chiaro_solid::{Affine, Scalar};
use chiaro_syntax::Span;
use chiaro_vocabulary::{Bounds, Class, rows};

use crate::build::Builder;
use crate::extent::WORLD;
use crate::graph::{Node, NodeId, Operation};

/// What is less steep is not worth a box.
const STEEP: f64 = 1.25;
/// Boxes are larger by this part of their diagonal: at the surface, what is in them counts and not they.
const MARGIN: f64 = 1e-3;

/// The node with all that is steeper than 1 scaled down below its hard Booleans, complements and paints.
pub(super) fn normalised(builder: &mut Builder, root: NodeId) -> NodeId {
    let is_steep = |builder: &Builder, id: NodeId| builder.facts(id).lipschitz > 1.0;
    if !is_steep(builder, root) {
        return root;
    }
    // Nodes stand behind their children, so two sweeps do what recursion, as deep as the scene, would.
    let count = root.0 as usize + 1;
    let mut reached = vec![false; count];
    reached[count - 1] = true;
    for index in (0..count).rev() {
        let id = NodeId(index as u32);
        if reached[index] && is_steep(builder, id) && is_transparent(builder.get(id)) {
            builder.get(id).children().iter().for_each(|child| reached[child.0 as usize] = true);
        }
    }
    let mut normal: Vec<NodeId> = (0..count as u32).map(NodeId).collect();
    for index in (0..count).filter(|index| reached[*index]) {
        let id = NodeId(index as u32);
        if is_steep(builder, id) {
            normal[index] = flattened(builder, id, &normal);
        }
    }
    normal[count - 1]
}

/// Whether the node's value is one of its children's, or the opposite.
fn is_transparent(node: &Node) -> bool {
    matches!(node, Node::Boolean(_, None, _) | Node::Negate(_) | Node::Paint(..))
}

/// The steep node with a slope of at most 1, where the nodes before it have been replaced by these.
fn flattened(builder: &mut Builder, id: NodeId, normal: &[NodeId]) -> NodeId {
    let (facts, span) = (*builder.facts(id), builder.span(id));
    let replaced = |child: &NodeId| normal[child.0 as usize];
    let node = match builder.get(id) {
        Node::Boolean(operation, None, children) => {
            Node::Boolean(*operation, None, children.iter().map(replaced).collect())
        }
        Node::Negate(child) => Node::Negate(replaced(child)),
        Node::Paint(material, child) => Node::Paint(*material, replaced(child)),
        Node::Adjust(row, arguments, child) if **row == rows::SCALE && arguments.len() == 1 => {
            let factor = arguments[0].clone() / Scalar::from(facts.lipschitz);
            Node::Adjust(&rows::SCALE, vec![factor], *child)
        }
        _ => Node::Adjust(&rows::SCALE, vec![Scalar::from(1.0 / facts.lipschitz)], id),
    };
    let is_part = matches!(node, Node::Adjust(..));
    let flat = builder.node(node, span, facts.class, 1.0);
    match is_part && facts.lipschitz > STEEP && facts.bounds.is_finite() {
        true => boxed(builder, flat, &facts.bounds, span),
        false => flat,
    }
}

/// The node within a box that is not empty.
fn boxed(builder: &mut Builder, id: NodeId, bounds: &Bounds, span: Span) -> NodeId {
    let bounds = bounds.inflate(MARGIN * bounds.diagonal());
    let forward = Affine::translation(bounds.center().map(Scalar::from));
    let back = Affine::translation(bounds.center().map(|coordinate| Scalar::from(-coordinate)));
    let point = builder.affine(back, forward, WORLD);
    let half_size = bounds.size().map(|edge| Scalar::from(0.5 * edge)).to_vec();
    let around = builder.node(Node::Shape(&rows::BOX, half_size, point), span, Class::Exact, 1.0);
    builder.node(Node::Boolean(Operation::Intersection, None, vec![id, around]), span, Class::Bound, 1.0)
}
