//! Patterns: what fields have in common that differ by numbers alone.

use std::hash::Hash;

use chiaro_plane::{Contour, Edge, Region};
use chiaro_solid::{Affine, Joint, Material, ParameterId, Scalar};
use chiaro_vocabulary::{Bounds, Class, Interval, Row};
use rustc_hash::FxHashMap;

use crate::extent::WORLD;
use crate::facts::Facts;
use crate::graph::{Graph, MaterialId, Node, NodeId, Point, PointId};
use crate::walk::material_scalars;

/// What fields that differ by numbers alone have in common.
#[derive(Clone, Debug)]
pub struct Pattern {
    /// The field; what tells its members apart are live parameters, the slots, in the order of a member's numbers.
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

/// How many nodes each node stands for, shared ones counted every time, and large outlines as several.
pub(crate) fn weights(graph: &Graph) -> Vec<u32> {
    const PIECES_OF_A_NODE: usize = 4;
    const MOST_PIECES: usize = 48;
    let mut weights: Vec<u32> = Vec::with_capacity(graph.nodes.len());
    for node in &graph.nodes {
        let pieces = match node {
            Node::Outline(region, _) => region.edges().count(),
            Node::Loft(loft, _) => loft.sides(),
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

/// The numbers of outlines and polytopes, each once.
#[derive(Default)]
pub(crate) struct Drawings(FxHashMap<Vec<u64>, u64>);

impl Drawings {
    /// What stands in keys for the one of these numbers.
    fn place(&mut self, numbers: Vec<u64>) -> u64 {
        let next = self.0.len() as u64;
        *self.0.entry(numbers).or_insert(next)
    }
}

/// A map from a base to where something is asked.
#[derive(Clone, Debug)]
pub(crate) struct LocalMap {
    pub(crate) map: Affine,
    /// Whether only round shapes are asked there, of which maps say no more than where the centre is.
    pub(crate) is_round: bool,
}

/// A walk through a field: what it is but for its numbers, and these.
pub(crate) struct Walk<'a> {
    graph: &'a Graph,
    /// Whether materials count.
    keeps_paint: bool,
    /// The point whose maps are told apart from other numbers.
    base: Option<PointId>,
    /// What it is but for its numbers and maps: fields with equal keys follow the same pattern.
    pub(crate) key: Vec<u64>,
    /// The numbers, without those of the maps.
    pub(crate) numbers: Vec<Scalar>,
    /// If maps are told apart, those from the base to where shapes are asked, each once.
    pub(crate) maps: Vec<LocalMap>,
    nodes: Visited<NodeId>,
    points: Visited<PointId>,
    materials: Visited<MaterialId>,
}

impl<'a> Walk<'a> {
    /// Through a node. All its maps are numbers as others.
    pub(crate) fn through(graph: &'a Graph, keeps_paint: bool, id: NodeId, drawings: &mut Drawings) -> Self {
        let mut walk = Self::new(graph, keeps_paint, None);
        walk.points.finish(WORLD, 0);
        walk.node(id, drawings);
        walk
    }

    /// Through a node whose points are all computed from one, which stands for the world. Its maps are told apart: where there
    /// is none, it is the one that changes nothing.
    pub(crate) fn from(
        base: PointId,
        graph: &'a Graph,
        keeps_paint: bool,
        id: NodeId,
        drawings: &mut Drawings,
    ) -> Self {
        let mut walk = Self::new(graph, keeps_paint, Some(base));
        walk.node(id, drawings);
        walk
    }

    fn new(graph: &'a Graph, keeps_paint: bool, base: Option<PointId>) -> Self {
        Self {
            graph,
            keeps_paint,
            base,
            key: Vec::new(),
            numbers: Vec::new(),
            maps: Vec::new(),
            nodes: Visited::new(),
            points: Visited::new(),
            materials: Visited::new(),
        }
    }

    /// The pattern of all fields with this key.
    pub(crate) fn pattern_of_all(&self) -> Pattern {
        let parameters: Vec<Scalar> = (0..self.numbers.len() as u32).map(parameter).collect();
        self.pattern(&parameters, &[], parameters.clone())
    }

    /// The pattern with these in the place of the numbers and of the maps, among which are these parameters.
    pub(crate) fn pattern(&self, numbers: &[Scalar], maps: &[Affine], slots: Vec<Scalar>) -> Pattern {
        let graph = self.graph;
        let pattern = Patterned { walk: self, numbers, maps };
        let world = self.base.map(|_| Point::World);
        let points = self.points.order.iter().map(|(id, first)| pattern.point(*id, *first));
        let nodes: Vec<Node> = self.nodes.order.iter().map(|(id, first)| pattern.node(*id, *first)).collect();
        Pattern {
            graph: Graph {
                points: world.into_iter().chain(points).collect(),
                facts: vec![UNKNOWN; nodes.len()],
                spans: self.nodes.order.iter().filter_map(|(id, _)| graph.spans.get(id.0 as usize).copied()).collect(),
                root: NodeId(nodes.len() as u32 - 1),
                nodes,
                materials: self.materials.order.iter().map(|(_, first)| pattern.material(*first)).collect(),
                slots,
            },
            is_painted: !self.materials.order.is_empty(),
        }
    }

    fn node(&mut self, id: NodeId, drawings: &mut Drawings) {
        let graph = self.graph;
        if let Some(&place) = self.nodes.places.get(&id) {
            return self.key.extend([KNOWN, u64::from(place)]);
        }
        let node = &graph.nodes[id.0 as usize];
        if let (Node::Paint(_, child), false) = (node, self.keeps_paint) {
            return self.node(*child, drawings);
        }
        self.node_itself(node, drawings);
        node.children().iter().for_each(|child| self.node(*child, drawings));
        if let Some(point) = node.point() {
            self.point(point);
            self.asked(point, matches!(node, Node::Shape(row, ..) if row.round));
        }
        if let Node::Paint(material, _) = node {
            self.material(*material);
        }
        let first = self.numbers.len();
        node.visit_scalars(|number| self.numbers.push(number.clone()));
        self.nodes.finish(id, first);
    }

    /// Notes what a node is by itself, but for its numbers.
    fn node_itself(&mut self, node: &Node, drawings: &mut Drawings) {
        match node {
            Node::Nothing => self.key.push(1),
            Node::Shape(row, ..) => self.row(2, row),
            Node::Outline(region, _) => self.key.extend([3, drawings.place(outline_numbers(region))]),
            Node::Loft(loft, _) => self.key.extend([18, drawings.place(loft.numbers().map(f64::to_bits).collect())]),
            Node::Polytope(triangles, _) => {
                let numbers = triangles.iter().flatten().flatten().map(|x| x.to_bits()).collect();
                self.key.extend([4, drawings.place(numbers)]);
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
        if let Some(map) = self.map_of_base(id) {
            self.key.push(17);
            self.maps.push(LocalMap { map, is_round: true });
            return self.points.finish(id, self.maps.len() - 1);
        }
        match point {
            Point::World => {}
            Point::Affine(map, _) => self.key.extend([12, u64::from(map.is_translation())]),
            Point::Warp(row, ..) => self.row(13, row),
            Point::Confined(..) => self.key.push(14),
            Point::Flattened(_) => self.key.push(15),
        }
        if let Some(parent) = point.parent() {
            self.point(parent);
            self.asked(parent, false);
        }
        let first = self.numbers.len();
        match point {
            Point::Affine(map, _) if map.is_translation() => {
                self.numbers.extend(map.rows().iter().map(|row| row[3].clone()));
            }
            _ => point.visit_scalars(|number| self.numbers.push(number.clone())),
        }
        self.points.finish(id, first);
    }

    /// Notes what is asked at a point.
    fn asked(&mut self, id: PointId, is_round: bool) {
        if self.map_of_base(id).is_some() {
            let (_, map) = self.points.order[self.points.places[&id] as usize];
            self.maps[map].is_round &= is_round;
        }
    }

    /// The map from the base, if the point is no more than that.
    fn map_of_base(&self, id: PointId) -> Option<Affine> {
        match &self.graph.points[id.0 as usize] {
            _ if self.base == Some(id) => Some(Affine::identity()),
            Point::Affine(map, parent) if self.base == Some(*parent) => Some(match self.graph.dimension(*parent) {
                3 => map.clone(),
                _ => plane_map(map),
            }),
            _ => None,
        }
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
}

/// What counts of a map of a plane point.
fn plane_map(map: &Affine) -> Affine {
    let [[a, b, _, x], [c, d, _, y], _] = map.rows().clone();
    let (zero, one) = (|| Scalar::ZERO, Scalar::ONE);
    Affine::new([[a, b, zero(), x], [c, d, zero(), y], [zero(), zero(), one, zero()]])
}

/// What a walk went through, with other numbers and maps.
struct Patterned<'a> {
    walk: &'a Walk<'a>,
    numbers: &'a [Scalar],
    maps: &'a [Affine],
}

impl Patterned<'_> {
    fn point(&self, id: PointId, first: usize) -> Point {
        let point = &self.walk.graph.points[id.0 as usize];
        if self.walk.map_of_base(id).is_some() {
            return match &self.maps[first] {
                map if *map == Affine::identity() => Point::World,
                map => Point::Affine(map.clone(), WORLD),
            };
        }
        match point {
            Point::World => Point::World,
            Point::Affine(map, parent) if map.is_translation() => {
                Point::Affine(Affine::translation(self.some(first)), self.place(*parent))
            }
            Point::Affine(_, parent) => {
                let rows = [0, 4, 8].map(|row| self.some(first + row));
                Point::Affine(Affine::new(rows), self.place(*parent))
            }
            Point::Warp(row, arguments, parent) => {
                Point::Warp(row, self.several(first, arguments.len()), self.place(*parent))
            }
            Point::Confined(_, parent) => Point::Confined(self.numbers[first].clone(), self.place(*parent)),
            Point::Flattened(parent) => Point::Flattened(self.place(*parent)),
        }
    }

    fn node(&self, id: NodeId, first: usize) -> Node {
        let at = |point: &PointId| self.place(*point);
        let of = |child: &NodeId| NodeId(self.walk.nodes.places[&self.unpainted(*child)]);
        let number = |place: usize| self.numbers[first + place].clone();
        match &self.walk.graph.nodes[id.0 as usize] {
            Node::Nothing => Node::Nothing,
            Node::Shape(row, arguments, point) => Node::Shape(row, self.several(first, arguments.len()), at(point)),
            Node::Outline(region, point) => Node::Outline(region.clone(), at(point)),
            Node::Loft(loft, point) => Node::Loft(loft.clone(), at(point)),
            Node::Polytope(triangles, point) => Node::Polytope(triangles.clone(), at(point)),
            Node::Boolean(operation, joint, children) => {
                let joint = joint.as_ref().map(|joint| Joint { radius: number(0), ..joint.clone() });
                Node::Boolean(*operation, joint, children.iter().map(of).collect())
            }
            Node::Negate(child) => Node::Negate(of(child)),
            Node::Adjust(row, arguments, child) => Node::Adjust(row, self.several(first, arguments.len()), of(child)),
            Node::Extrude(_, child, point) => Node::Extrude(number(0), of(child), at(point)),
            Node::Taper(_, _, child, point) => Node::Taper(number(0), [number(1), number(2)], of(child), at(point)),
            Node::Confine(_, lipschitz, child, point) => Node::Confine(number(0), *lipschitz, of(child), at(point)),
            Node::Paint(material, child) => Node::Paint(MaterialId(self.walk.materials.places[material]), of(child)),
        }
    }

    fn material(&self, first: usize) -> Material {
        let [roughness, metallic, emission] = self.some(first + 4);
        Material { color: self.some(first), roughness, metallic, emission }
    }

    /// Where a point is in the pattern.
    fn place(&self, id: PointId) -> PointId {
        PointId(self.walk.points.places[&id] + u32::from(self.walk.base.is_some()))
    }

    /// The node itself, or what was painted if materials don't count.
    fn unpainted(&self, id: NodeId) -> NodeId {
        match &self.walk.graph.nodes[id.0 as usize] {
            Node::Paint(_, child) if !self.walk.keeps_paint => self.unpainted(*child),
            _ => id,
        }
    }

    fn some<const N: usize>(&self, first: usize) -> [Scalar; N] {
        std::array::from_fn(|k| self.numbers[first + k].clone())
    }

    fn several(&self, first: usize, count: usize) -> Vec<Scalar> {
        self.numbers[first..first + count].to_vec()
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

/// A pattern's parameter, of which nothing is known.
pub(crate) fn parameter(place: u32) -> Scalar {
    Scalar::parameter(ParameterId(place), Interval::ALL)
}
