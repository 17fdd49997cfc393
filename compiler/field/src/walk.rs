//! What is in a graph: the numbers, points and nodes that each of its parts refers to.

use chiaro_solid::{Material, Scalar};
use rustc_hash::FxHashSet;

use crate::graph::{Graph, MaterialId, Node, NodeId, Point, PointId};

impl Node {
    /// The nodes that it is computed from.
    pub fn children(&self) -> &[NodeId] {
        match self {
            Node::Nothing | Node::Shape(..) | Node::Outline(..) | Node::Loft(..) | Node::Polytope(..) => &[],
            Node::Boolean(_, _, children) => children,
            Node::Negate(child)
            | Node::Adjust(_, _, child)
            | Node::Extrude(_, child, _)
            | Node::Taper(_, _, child, _)
            | Node::Confine(_, _, child, _)
            | Node::Paint(_, child) => std::slice::from_ref(child),
        }
    }

    /// The point that it is asked at itself.
    pub fn point(&self) -> Option<PointId> {
        match self {
            Node::Shape(_, _, point)
            | Node::Outline(_, point)
            | Node::Loft(_, point)
            | Node::Polytope(_, point)
            | Node::Extrude(_, _, point)
            | Node::Taper(_, _, _, point)
            | Node::Confine(_, _, _, point) => Some(*point),
            Node::Nothing | Node::Boolean(..) | Node::Negate(_) | Node::Adjust(..) | Node::Paint(..) => None,
        }
    }

    /// Calls `visit` with each of its own numbers.
    pub fn visit_scalars<'a>(&'a self, mut visit: impl FnMut(&'a Scalar)) {
        match self {
            Node::Shape(_, arguments, _) | Node::Adjust(_, arguments, _) => arguments.iter().for_each(visit),
            Node::Boolean(_, Some(joint), _) => visit(&joint.radius),
            Node::Extrude(number, _, _) | Node::Confine(number, _, _, _) => visit(number),
            Node::Taper(height, scale, _, _) => {
                visit(height);
                scale.iter().for_each(visit);
            }
            Node::Nothing
            | Node::Outline(..)
            | Node::Loft(..)
            | Node::Polytope(..)
            | Node::Boolean(_, None, _)
            | Node::Negate(_)
            | Node::Paint(..) => {}
        }
    }

    fn renumber(&mut self, nodes: &[NodeId], points: &[PointId], materials: &[MaterialId]) {
        let to_node = |id: &mut NodeId| *id = nodes[id.0 as usize];
        let to_point = |id: &mut PointId| *id = points[id.0 as usize];
        match self {
            Node::Nothing => {}
            Node::Shape(_, _, point) | Node::Outline(_, point) | Node::Loft(_, point) | Node::Polytope(_, point) => {
                to_point(point)
            }
            Node::Boolean(_, _, children) => children.iter_mut().for_each(to_node),
            Node::Negate(child) | Node::Adjust(_, _, child) => to_node(child),
            Node::Extrude(_, child, point) | Node::Taper(_, _, child, point) | Node::Confine(_, _, child, point) => {
                to_node(child);
                to_point(point);
            }
            Node::Paint(material, child) => {
                *material = materials[material.0 as usize];
                to_node(child);
            }
        }
    }
}

impl Point {
    /// The point that it is computed from.
    pub fn parent(&self) -> Option<PointId> {
        match self {
            Point::World => None,
            Point::Affine(_, parent)
            | Point::Warp(_, _, parent)
            | Point::Confined(_, parent)
            | Point::Flattened(parent) => Some(*parent),
        }
    }

    /// Calls `visit` with each of its own numbers.
    pub fn visit_scalars<'a>(&'a self, mut visit: impl FnMut(&'a Scalar)) {
        match self {
            Point::World | Point::Flattened(_) => {}
            Point::Affine(map, _) => map.rows().iter().flatten().for_each(visit),
            Point::Warp(_, arguments, _) => arguments.iter().for_each(visit),
            Point::Confined(radius, _) => visit(radius),
        }
    }
}

/// The numbers of a material.
pub(crate) fn material_scalars(material: &Material) -> impl Iterator<Item = &Scalar> {
    let Material { color, roughness, metallic, emission } = material;
    color.iter().chain([roughness, metallic, emission])
}

/// The distinct live numbers of a graph, in the order of its points, nodes and materials.
pub(crate) fn slots(graph: &Graph) -> Vec<Scalar> {
    let mut seen = FxHashSet::default();
    let mut slots = Vec::new();
    let mut visit = |number: &Scalar| {
        if number.constant().is_none() && seen.insert(number.clone()) {
            slots.push(number.clone());
        }
    };
    graph.points.iter().for_each(|point| point.visit_scalars(&mut visit));
    graph.nodes.iter().for_each(|node| node.visit_scalars(&mut visit));
    graph.materials.iter().flat_map(material_scalars).for_each(&mut visit);
    slots
}

/// The same graph without what its root does not need.
pub(crate) fn compacted(graph: Graph) -> Graph {
    let mut node_used = vec![false; graph.nodes.len()];
    let mut point_used = vec![false; graph.points.len()];
    let mut material_used = vec![false; graph.materials.len()];
    node_used[graph.root.0 as usize] = true;
    point_used[0] = true;
    // What refers stands behind what it refers to.
    for (index, node) in graph.nodes.iter().enumerate().rev() {
        if node_used[index] {
            node.children().iter().for_each(|child| node_used[child.0 as usize] = true);
            node.point().into_iter().for_each(|point| point_used[point.0 as usize] = true);
            if let Node::Paint(material, _) = node {
                material_used[material.0 as usize] = true;
            }
        }
    }
    for (index, point) in graph.points.iter().enumerate().rev() {
        if let (true, Some(parent)) = (point_used[index], point.parent()) {
            point_used[parent.0 as usize] = true;
        }
    }
    let nodes: Vec<NodeId> = numbers(&node_used).map(NodeId).collect();
    let points: Vec<PointId> = numbers(&point_used).map(PointId).collect();
    let materials: Vec<MaterialId> = numbers(&material_used).map(MaterialId).collect();
    let mut compacted = Graph {
        points: retained(graph.points, &point_used),
        nodes: retained(graph.nodes, &node_used),
        facts: retained(graph.facts, &node_used),
        spans: retained(graph.spans, &node_used),
        root: nodes[graph.root.0 as usize],
        materials: retained(graph.materials, &material_used),
        slots: graph.slots,
    };
    for point in &mut compacted.points {
        if let Point::Affine(_, parent)
        | Point::Warp(_, _, parent)
        | Point::Confined(_, parent)
        | Point::Flattened(parent) = point
        {
            *parent = points[parent.0 as usize];
        }
    }
    compacted.nodes.iter_mut().for_each(|node| node.renumber(&nodes, &points, &materials));
    compacted
}

/// Below tapers, values are in other units than boxes.
pub(crate) fn forget_growth_below_tapers(graph: &mut Graph) {
    let mut below = vec![false; graph.nodes.len()];
    // What refers stands behind what it refers to.
    for (index, node) in graph.nodes.iter().enumerate().rev() {
        if below[index] {
            graph.facts[index].growth = f64::INFINITY;
        }
        if below[index] || matches!(node, Node::Taper(..)) {
            node.children().iter().for_each(|child| below[child.0 as usize] = true);
        }
    }
}

/// The number each used item gets.
fn numbers(used: &[bool]) -> impl Iterator<Item = u32> {
    used.iter().scan(0, |next, used| {
        let number = *next;
        *next += u32::from(*used);
        Some(number)
    })
}

fn retained<T>(items: Vec<T>, used: &[bool]) -> Vec<T> {
    items.into_iter().zip(used).filter(|(_, used)| **used).map(|(item, _)| item).collect()
}
