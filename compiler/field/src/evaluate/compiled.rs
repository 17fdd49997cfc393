//! A graph made ready for evaluation: its numbers computed, its functions looked up.

use std::sync::Arc;

use chiaro_plane::{Edge, Loft, Region};
use chiaro_solid::{Profile, Scalar};
use chiaro_vocabulary::cpu::Program;
use chiaro_vocabulary::{Bounds, Class, Kind, Row};

use super::tree::Tree;
use crate::extent::exponent;
use crate::graph::{Graph, Node, NodeId, Operation, Point, PointId};

/// A graph at certain values of its live parameters.
#[derive(Debug)]
pub(super) struct Compiled {
    pub(super) points: Vec<Kept<Place>>,
    pub(super) nodes: Vec<Kept<Distance>>,
    pub(super) shared_points: usize,
    pub(super) shared_nodes: usize,
}

/// An item, and where to remember its value if that is asked for more than once.
#[derive(Debug)]
pub(super) struct Kept<T> {
    pub(super) item: T,
    pub(super) shared: Option<u32>,
}

/// How a point is computed. Plane points have z = 0.
#[derive(Debug)]
pub(super) enum Place {
    World,
    Space([[f64; 4]; 3], PointId),
    Plane([[f64; 3]; 2], PointId),
    Warp(Function, PointId),
    Confined(f64, PointId),
    Flattened(PointId),
}

/// A function of the vocabulary with its arguments behind the first.
#[derive(Debug)]
pub(super) struct Function {
    pub(super) program: &'static Program,
    pub(super) arguments: Vec<f64>,
}

/// How a distance is computed.
#[derive(Debug)]
pub(super) enum Distance {
    Nothing,
    Solid(Function, PointId),
    Plane(Function, PointId),
    Outline(Vec<Piece>, PointId),
    Loft(Arc<Loft>, PointId),
    Polytope(Arc<[[[f64; 3]; 3]]>, PointId),
    /// The children that have to be asked, and those that need not be where others are nearer than their boxes.
    Least(Vec<NodeId>, Option<Tree>),
    Greatest(Vec<NodeId>),
    Joint {
        operation: Operation,
        profile: Profile,
        exponent: f64,
        radius: f64,
        children: Vec<NodeId>,
    },
    Negate(NodeId),
    Adjust(Function, NodeId),
    Extrude(f64, NodeId, PointId),
    Taper([f64; 3], NodeId, PointId),
    Confine {
        radius: f64,
        lipschitz: f64,
        child: NodeId,
        point: PointId,
    },
    Same(NodeId),
}

/// A piece of an outline. Neighbours have the same numbers for the point they share.
#[derive(Debug)]
pub(super) struct Piece {
    pub(super) from: [f64; 2],
    pub(super) to: [f64; 2],
    /// Centre and sweep of an arc.
    pub(super) arc: Option<([f64; 2], f64)>,
}

impl Compiled {
    pub(super) fn new(graph: &Graph, parameters: &[f64], bounds: &[Bounds]) -> Self {
        let (point_uses, node_uses) = uses(graph);
        let mut compiler = Compiler { graph, parameters, bounds, plane: Vec::with_capacity(graph.points.len()) };
        let points = graph.points.iter().map(|point| compiler.place(point)).collect();
        let nodes = graph.nodes.iter().map(|node| compiler.distance(node)).collect();
        let (points, shared_points) = kept(points, &point_uses);
        let (nodes, shared_nodes) = kept(nodes, &node_uses);
        Self { points, nodes, shared_points, shared_nodes }
    }
}

struct Compiler<'a> {
    graph: &'a Graph,
    parameters: &'a [f64],
    bounds: &'a [Bounds],
    /// Which points are plane points.
    plane: Vec<bool>,
}

impl Compiler<'_> {
    fn place(&mut self, point: &Point) -> Place {
        let is_plane = |id: &PointId| self.plane[id.0 as usize];
        let (place, plane) = match point {
            Point::World => (Place::World, false),
            Point::Affine(map, from) => {
                let rows = map.value(self.parameters);
                if is_plane(from) {
                    let row = |i: usize| [rows[i][0], rows[i][1], rows[i][3]];
                    (Place::Plane([row(0), row(1)], *from), true)
                } else {
                    (Place::Space(rows, *from), false)
                }
            }
            Point::Warp(row, arguments, from) => {
                (Place::Warp(self.function(row, arguments), *from), row.kind == Kind::Section)
            }
            Point::Confined(radius, from) => (Place::Confined(self.value(radius), *from), is_plane(from)),
            Point::Flattened(from) => (Place::Flattened(*from), false),
        };
        self.plane.push(plane);
        place
    }

    fn distance(&self, node: &Node) -> Distance {
        match node {
            Node::Nothing => Distance::Nothing,
            Node::Shape(row, arguments, point) => {
                let function = self.function(row, arguments);
                match row.kind {
                    Kind::Plane => Distance::Plane(function, *point),
                    _ => Distance::Solid(function, *point),
                }
            }
            Node::Outline(region, point) => Distance::Outline(pieces(region), *point),
            Node::Loft(loft, point) => Distance::Loft(loft.clone(), *point),
            Node::Polytope(triangles, point) => Distance::Polytope(triangles.clone(), *point),
            Node::Boolean(Operation::Union, None, children) => self.least(children),
            Node::Boolean(Operation::Intersection, None, children) => Distance::Greatest(children.clone()),
            Node::Boolean(operation, Some(joint), children) => Distance::Joint {
                operation: *operation,
                profile: joint.profile,
                exponent: f64::from(exponent(joint.profile)),
                radius: self.value(&joint.radius),
                children: children.clone(),
            },
            Node::Negate(child) => Distance::Negate(*child),
            Node::Adjust(row, arguments, child) => Distance::Adjust(self.function(row, arguments), *child),
            Node::Extrude(height, child, point) => Distance::Extrude(self.value(height), *child, *point),
            Node::Taper(height, scale, child, point) => {
                let arguments = [self.value(height), self.value(&scale[0]), self.value(&scale[1])];
                Distance::Taper(arguments, *child, *point)
            }
            Node::Confine(radius, lipschitz, child, point) => {
                Distance::Confine { radius: self.value(radius), lipschitz: *lipschitz, child: *child, point: *point }
            }
            Node::Paint(_, child) => Distance::Same(*child),
        }
    }

    /// A union. A child whose value is a true distance outside is at least as far away as its box.
    fn least(&self, children: &[NodeId]) -> Distance {
        const WORTH_A_TREE: usize = 6;
        let prunable = |id: &NodeId| {
            let facts = &self.graph.facts[id.0 as usize];
            facts.class != Class::Bound && facts.lipschitz <= 1.0 && self.bounds[id.0 as usize].is_finite()
        };
        let (far, near): (Vec<NodeId>, Vec<NodeId>) = children.iter().partition(|id| prunable(id));
        if far.len() < WORTH_A_TREE {
            return Distance::Least(children.to_vec(), None);
        }
        let boxed = far.into_iter().map(|id| (self.bounds[id.0 as usize], id)).collect();
        Distance::Least(near, Some(Tree::new(boxed)))
    }

    fn function(&self, row: &Row, arguments: &[Scalar]) -> Function {
        Function { program: row.program(), arguments: arguments.iter().map(|number| self.value(number)).collect() }
    }

    fn value(&self, number: &Scalar) -> f64 {
        number.value(self.parameters)
    }
}

fn pieces(region: &Region) -> Vec<Piece> {
    let mut pieces = Vec::new();
    for contour in &region.contours {
        let next = contour.edges.iter().cycle().skip(1);
        for (edge, next) in contour.edges.iter().zip(next) {
            let arc = match *edge {
                Edge::Line { .. } => None,
                Edge::Arc { center, sweep, .. } => Some((center, sweep)),
            };
            pieces.push(Piece { from: edge.start(), to: next.start(), arc });
        }
    }
    pieces
}

/// How often each point and each node is asked for at the most.
fn uses(graph: &Graph) -> (Vec<u32>, Vec<u32>) {
    let mut points = vec![0u32; graph.points.len()];
    let mut nodes = vec![0u32; graph.nodes.len()];
    for node in &graph.nodes {
        node.children().iter().for_each(|child| nodes[child.0 as usize] += 1);
        node.point().into_iter().for_each(|point| points[point.0 as usize] += 1);
    }
    for point in &graph.points {
        point.parent().into_iter().for_each(|parent| points[parent.0 as usize] += 1);
    }
    (points, nodes)
}

fn kept<T>(items: Vec<T>, uses: &[u32]) -> (Vec<Kept<T>>, usize) {
    let mut shared = 0;
    let kept = items.into_iter().zip(uses).map(|(item, uses)| {
        let place = (*uses > 1).then_some(shared);
        shared += u32::from(*uses > 1);
        Kept { item, shared: place }
    });
    let kept = kept.collect();
    (kept, shared as usize)
}
