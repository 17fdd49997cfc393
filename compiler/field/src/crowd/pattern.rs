//! Patterns: what members of crowds have in common.

use std::hash::Hash;

use chiaro_plane::{Contour, Edge, Region};
use chiaro_solid::{Affine, Joint, Material, ParameterId, Scalar};
use chiaro_vocabulary::{Bounds, Class, Interval, Row};
use rustc_hash::FxHashMap;

use super::Member;
use crate::extent::WORLD;
use crate::facts::Facts;
use crate::graph::{Graph, MaterialId, Node, NodeId, Point, PointId};
use crate::walk::material_scalars;

/// What fields that differ by numbers alone have in common.
#[derive(Clone, Debug)]
pub struct Pattern {
    /// The field; its numbers are live parameters, the slots, in the order of a member's numbers.
    pub graph: Graph,
    /// Whether it knows what it looks like: whether materials differ within a member.
    pub is_painted: bool,
}

impl PartialEq for Pattern {
    fn eq(&self, other: &Self) -> bool {
        self.graph.is_same_field(&other.graph) && self.is_painted == other.is_painted
    }
}

/// What is known of a pattern's nodes.
const UNKNOWN: Facts =
    Facts { bounds: Bounds::ALL, growth: f64::INFINITY, class: Class::Bound, lipschitz: f64::INFINITY };

/// Stands in keys for what was come by before.
const KNOWN: u64 = 0;

/// Collects patterns.
#[derive(Default)]
pub(super) struct Patterns {
    patterns: Vec<Pattern>,
    places: FxHashMap<Vec<u64>, usize>,
    /// The numbers of outlines and polytopes, each once.
    drawn: FxHashMap<Vec<u64>, u64>,
}

impl Patterns {
    /// An operand as a member; its pattern is the place here.
    pub(super) fn member(&mut self, graph: &Graph, node: NodeId) -> Member {
        let (material, painted) = match &graph.nodes[node.0 as usize] {
            Node::Paint(material, child) => (Some(*material), *child),
            _ => (None, node),
        };
        let mut walk = Walk::new(graph, material.is_none(), &mut self.drawn);
        walk.node(painted);
        let next = self.patterns.len();
        let pattern = match self.places.get(&walk.key) {
            Some(&known) => known,
            None => {
                self.patterns.push(walk.pattern());
                self.places.insert(walk.key, next);
                next
            }
        };
        Member { node, pattern, numbers: walk.numbers, material }
    }

    /// How many nodes a pattern stands for.
    pub(super) fn weight(&self, pattern: usize) -> u32 {
        let Pattern { graph, .. } = &self.patterns[pattern];
        weights(graph)[graph.root.0 as usize]
    }

    /// The patterns of these places, each once, and where each is among them.
    pub(super) fn used(self, places: impl Iterator<Item = usize>) -> (Vec<Pattern>, FxHashMap<usize, usize>) {
        let mut used = Vec::new();
        let mut moved = FxHashMap::default();
        for place in places {
            moved.entry(place).or_insert_with(|| {
                used.push(self.patterns[place].clone());
                used.len() - 1
            });
        }
        (used, moved)
    }
}

/// How many nodes each node stands for, shared ones counted every time, and large outlines as several.
pub(super) fn weights(graph: &Graph) -> Vec<u32> {
    const PIECES_OF_A_NODE: usize = 4;
    const MOST_PIECES: usize = 48;
    let mut weights: Vec<u32> = Vec::with_capacity(graph.nodes.len());
    for node in &graph.nodes {
        let pieces = match node {
            Node::Outline(region, _) => region.edges().count(),
            Node::Polytope(triangles, _) => triangles.len(),
            _ => 0,
        };
        let own = 1 + (pieces.min(MOST_PIECES) / PIECES_OF_A_NODE) as u32;
        let children = node.children().iter().map(|child| weights[child.0 as usize]);
        weights.push(children.fold(own, u32::saturating_add));
    }
    weights
}

/// What a walk came by, in the order in which it was finished: what refers stands behind what it refers to.
struct Visited<T> {
    /// Each item with the number of the first of its own numbers.
    order: Vec<(T, usize)>,
    places: FxHashMap<T, u32>,
}

impl<T: Copy + Eq + Hash> Visited<T> {
    fn new() -> Self {
        Self { order: Vec::new(), places: FxHashMap::default() }
    }

    fn finish(&mut self, item: T, first_number: usize) {
        self.places.insert(item, self.order.len() as u32);
        self.order.push((item, first_number));
    }
}

/// A walk through a member: what it is but for its numbers, and these.
struct Walk<'a> {
    graph: &'a Graph,
    /// Whether materials count.
    keeps_paint: bool,
    drawn: &'a mut FxHashMap<Vec<u64>, u64>,
    key: Vec<u64>,
    numbers: Vec<Scalar>,
    nodes: Visited<NodeId>,
    points: Visited<PointId>,
    materials: Visited<MaterialId>,
}

impl<'a> Walk<'a> {
    fn new(graph: &'a Graph, keeps_paint: bool, drawn: &'a mut FxHashMap<Vec<u64>, u64>) -> Self {
        let (nodes, points, materials) = (Visited::new(), Visited::new(), Visited::new());
        let mut walk =
            Self { graph, keeps_paint, drawn, key: Vec::new(), numbers: Vec::new(), nodes, points, materials };
        walk.points.finish(WORLD, 0);
        walk
    }

    fn node(&mut self, id: NodeId) {
        let graph = self.graph;
        if let Some(&place) = self.nodes.places.get(&id) {
            return self.key.extend([KNOWN, u64::from(place)]);
        }
        let node = &graph.nodes[id.0 as usize];
        if let (Node::Paint(_, child), false) = (node, self.keeps_paint) {
            return self.node(*child);
        }
        self.node_itself(node);
        node.children().iter().for_each(|child| self.node(*child));
        node.point().into_iter().for_each(|point| self.point(point));
        if let Node::Paint(material, _) = node {
            self.material(*material);
        }
        let first = self.numbers.len();
        node.visit_scalars(|number| self.numbers.push(number.clone()));
        self.nodes.finish(id, first);
    }

    /// Notes what a node is by itself, but for its numbers.
    fn node_itself(&mut self, node: &Node) {
        match node {
            Node::Nothing => self.key.push(1),
            Node::Shape(row, ..) => self.row(2, row),
            Node::Outline(region, _) => {
                let drawn = self.drawn(outline_numbers(region));
                self.key.extend([3, drawn]);
            }
            Node::Polytope(triangles, _) => {
                let drawn = self.drawn(triangles.iter().flatten().flatten().map(|x| x.to_bits()).collect());
                self.key.extend([4, drawn]);
            }
            Node::Boolean(operation, joint, children) => {
                let profile = joint.as_ref().map_or(0, |joint| 1 + joint.profile as u64);
                self.key.extend([5, *operation as u64, profile, children.len() as u64]);
            }
            Node::Negate(_) => self.key.push(6),
            Node::Adjust(row, ..) => self.row(7, row),
            Node::Extrude(..) => self.key.push(8),
            Node::Taper(..) => self.key.push(9),
            Node::Confine(_, lipschitz, ..) => self.key.extend([10, lipschitz.to_bits()]),
            Node::Paint(..) => self.key.push(11),
        }
    }

    fn point(&mut self, id: PointId) {
        let graph = self.graph;
        if let Some(&place) = self.points.places.get(&id) {
            return self.key.extend([KNOWN, u64::from(place)]);
        }
        let point = &graph.points[id.0 as usize];
        match point {
            Point::World => {}
            Point::Affine(map, _) => self.key.extend([12, u64::from(map.is_translation())]),
            Point::Warp(row, ..) => self.row(13, row),
            Point::Confined(..) => self.key.push(14),
            Point::Flattened(_) => self.key.push(15),
        }
        point.parent().into_iter().for_each(|parent| self.point(parent));
        let first = self.numbers.len();
        match point {
            Point::Affine(map, _) if map.is_translation() => {
                self.numbers.extend(map.rows().iter().map(|row| row[3].clone()));
            }
            _ => point.visit_scalars(|number| self.numbers.push(number.clone())),
        }
        self.points.finish(id, first);
    }

    fn material(&mut self, id: MaterialId) {
        if let Some(&place) = self.materials.places.get(&id) {
            return self.key.extend([KNOWN, u64::from(place)]);
        }
        self.key.push(16);
        let first = self.numbers.len();
        self.numbers.extend(material_scalars(&self.graph.materials[id.0 as usize]).cloned());
        self.materials.finish(id, first);
    }

    fn row(&mut self, tag: u64, row: &Row) {
        self.key.extend([tag, row.kind as u64, row.name.len() as u64]);
        self.key.extend(row.name.bytes().map(u64::from));
    }

    fn drawn(&mut self, numbers: Vec<u64>) -> u64 {
        let next = self.drawn.len() as u64;
        *self.drawn.entry(numbers).or_insert(next)
    }

    /// The pattern that the member follows.
    fn pattern(&self) -> Pattern {
        let graph = self.graph;
        let points = self.points.order.iter().map(|(id, first)| self.patterned_point(*id, *first)).collect();
        let nodes: Vec<Node> = self.nodes.order.iter().map(|(id, first)| self.patterned_node(*id, *first)).collect();
        Pattern {
            graph: Graph {
                points,
                facts: vec![UNKNOWN; nodes.len()],
                spans: self.nodes.order.iter().filter_map(|(id, _)| graph.spans.get(id.0 as usize).copied()).collect(),
                root: NodeId(nodes.len() as u32 - 1),
                nodes,
                materials: self.materials.order.iter().map(|(_, first)| patterned_material(*first)).collect(),
                slots: (0..self.numbers.len()).map(parameter).collect(),
            },
            is_painted: !self.materials.order.is_empty(),
        }
    }

    fn patterned_point(&self, id: PointId, first: usize) -> Point {
        let from = |parent: &PointId| PointId(self.points.places[parent]);
        match &self.graph.points[id.0 as usize] {
            Point::World => Point::World,
            Point::Affine(map, parent) if map.is_translation() => {
                Point::Affine(Affine::translation([0, 1, 2].map(|axis| parameter(first + axis))), from(parent))
            }
            Point::Affine(_, parent) => {
                let rows = [0, 4, 8].map(|row| [0, 1, 2, 3].map(|column| parameter(first + row + column)));
                Point::Affine(Affine::new(rows), from(parent))
            }
            Point::Warp(row, arguments, parent) => Point::Warp(row, parameters(first, arguments.len()), from(parent)),
            Point::Confined(_, parent) => Point::Confined(parameter(first), from(parent)),
            Point::Flattened(parent) => Point::Flattened(from(parent)),
        }
    }

    fn patterned_node(&self, id: NodeId, first: usize) -> Node {
        let at = |point: &PointId| PointId(self.points.places[point]);
        let of = |child: &NodeId| self.nodes.places[&self.unpainted(*child)];
        let of = |child: &NodeId| NodeId(of(child));
        match &self.graph.nodes[id.0 as usize] {
            Node::Nothing => Node::Nothing,
            Node::Shape(row, arguments, point) => Node::Shape(row, parameters(first, arguments.len()), at(point)),
            Node::Outline(region, point) => Node::Outline(region.clone(), at(point)),
            Node::Polytope(triangles, point) => Node::Polytope(triangles.clone(), at(point)),
            Node::Boolean(operation, joint, children) => {
                let joint = joint.as_ref().map(|joint| Joint { radius: parameter(first), ..joint.clone() });
                Node::Boolean(*operation, joint, children.iter().map(of).collect())
            }
            Node::Negate(child) => Node::Negate(of(child)),
            Node::Adjust(row, arguments, child) => Node::Adjust(row, parameters(first, arguments.len()), of(child)),
            Node::Extrude(_, child, point) => Node::Extrude(parameter(first), of(child), at(point)),
            Node::Taper(_, _, child, point) => {
                Node::Taper(parameter(first), [1, 2].map(|k| parameter(first + k)), of(child), at(point))
            }
            Node::Confine(_, lipschitz, child, point) => {
                Node::Confine(parameter(first), *lipschitz, of(child), at(point))
            }
            Node::Paint(material, child) => Node::Paint(MaterialId(self.materials.places[material]), of(child)),
        }
    }

    /// The node itself, or what was painted if materials don't count.
    fn unpainted(&self, id: NodeId) -> NodeId {
        match &self.graph.nodes[id.0 as usize] {
            Node::Paint(_, child) if !self.keeps_paint => self.unpainted(*child),
            _ => id,
        }
    }
}

/// All that an outline consists of.
fn outline_numbers(region: &Region) -> Vec<u64> {
    let edge = |edge: &Edge| match *edge {
        Edge::Line { from, to } => [from[0], from[1], to[0], to[1], f64::NAN],
        Edge::Arc { center, radius, start, sweep } => [center[0], center[1], radius, start, sweep],
    };
    let contour = |contour: &Contour| {
        let numbers = contour.edges.iter().flat_map(edge).map(f64::to_bits);
        [contour.edges.len() as u64].into_iter().chain(numbers).collect::<Vec<u64>>()
    };
    region.contours.iter().flat_map(contour).collect()
}

fn patterned_material(first: usize) -> Material {
    let color = [0, 1, 2, 3].map(|channel| parameter(first + channel));
    let [roughness, metallic, emission] = [4, 5, 6].map(|k| parameter(first + k));
    Material { color, roughness, metallic, emission }
}

fn parameters(first: usize, count: usize) -> Vec<Scalar> {
    (first..first + count).map(parameter).collect()
}

/// A pattern's parameter, of which nothing is known.
fn parameter(place: usize) -> Scalar {
    Scalar::parameter(ParameterId(place as u32), Interval::ALL)
}
