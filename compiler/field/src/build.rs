//! Builds a graph of which no two points, nodes or materials are equal.

use std::hash::{Hash, Hasher};

use chiaro_plane::Edge;
use chiaro_solid::{Affine, Material, Scalar, singular};
use chiaro_syntax::Span;
use chiaro_vocabulary::{Class, Interval};
use rustc_hash::{FxHashMap, FxHasher};

use crate::extent::{Extent, Measure, Placement, Ranges};
use crate::facts::Facts;
use crate::graph::{self, Graph, MaterialId, Node, NodeId, Point, PointId};
use crate::matrix::{constant_rows, linear};
use crate::walk;

/// A graph under construction: nodes only ever join it. What the root does not need is left out at the end.
pub(crate) struct Builder {
    points: Interner<Point>,
    nodes: Interner<Node>,
    materials: Interner<Material>,
    placements: Placements,
    facts: Vec<Facts>,
    extents: Vec<Extent>,
    spans: Vec<Span>,
    /// How many nodes are above one another at the most below each one, itself counted.
    heights: Vec<u32>,
}

impl Builder {
    pub(crate) fn new() -> Self {
        let mut builder = Self {
            points: Interner::default(),
            nodes: Interner::default(),
            materials: Interner::default(),
            placements: Placements { forward: Vec::new() },
            facts: Vec::new(),
            extents: Vec::new(),
            spans: Vec::new(),
            heights: Vec::new(),
        };
        builder.point(Point::World);
        builder
    }

    /// The point, which is no [`Point::Affine`].
    pub(crate) fn point(&mut self, point: Point) -> PointId {
        self.placed_point(point, None)
    }

    /// A point mapped by a matrix, which `forward` undoes.
    pub(crate) fn affine(&mut self, map: Affine, forward: Affine, from: PointId) -> PointId {
        self.placed_point(Point::Affine(map, from), Some(forward))
    }

    fn placed_point(&mut self, point: Point, forward: Option<Affine>) -> PointId {
        let hash = hash_of(|state| point.hash(state));
        let (id, new) = self.points.intern(hash, point);
        if new {
            self.placements.forward.push(forward);
        }
        PointId(id)
    }

    /// The node; its bounds follow from it, its class and Lipschitz constant are given.
    pub(crate) fn node(&mut self, node: Node, span: Span, class: Class, lipschitz: f64) -> NodeId {
        let hash = hash_of(|state| hash_node(&node, state));
        let (id, new) = self.nodes.intern(hash, node);
        if new {
            let extent = self.measure().in_world(&self.nodes.items[id as usize], &self.extents);
            self.extents.push(extent);
            self.facts.push(Facts { bounds: extent.bounds, growth: extent.endless_growth(), class, lipschitz });
            self.spans.push(span);
            let children = self.nodes.items[id as usize].children();
            let below = children.iter().map(|child| self.heights[child.0 as usize]).max();
            self.heights.push(1 + below.unwrap_or(0));
        } else {
            // What is lowered twice, from two places, is known to be no better than from either.
            let facts = &mut self.facts[id as usize];
            facts.class = facts.class.max(class);
            facts.lipschitz = facts.lipschitz.max(lipschitz);
        }
        NodeId(id)
    }

    pub(crate) fn material(&mut self, material: &Material) -> MaterialId {
        let hash = hash_of(|state| walk::material_scalars(material).for_each(|scalar| scalar.hash(state)));
        MaterialId(self.materials.intern(hash, material.clone()).0)
    }

    pub(crate) fn get(&self, id: NodeId) -> &Node {
        &self.nodes.items[id.0 as usize]
    }

    pub(crate) fn get_point(&self, id: PointId) -> &Point {
        &self.points.items[id.0 as usize]
    }

    /// The map that undoes a point's, if it is known as it was composed.
    pub(crate) fn forward(&self, id: PointId) -> Option<&Affine> {
        self.placements.forward[id.0 as usize].as_ref()
    }

    /// How many coordinates a point has.
    pub(crate) fn dimension(&self, id: PointId) -> usize {
        graph::dimension(&self.points.items, id)
    }

    /// How many nodes are above one another at the most in a node.
    pub(crate) fn height(&self, id: NodeId) -> u32 {
        self.heights[id.0 as usize]
    }

    pub(crate) fn facts(&self, id: NodeId) -> &Facts {
        &self.facts[id.0 as usize]
    }

    pub(crate) fn span(&self, id: NodeId) -> Span {
        self.spans[id.0 as usize]
    }

    pub(crate) fn extent(&self, id: NodeId) -> &Extent {
        &self.extents[id.0 as usize]
    }

    /// A node's extent in the coordinates of a point that everything in it is asked at or behind.
    pub(crate) fn extent_at(&self, id: NodeId, frame: PointId) -> Extent {
        self.measure().in_frame(id, frame, &self.extents)
    }

    /// How many nodes there are.
    pub(crate) fn len(&self) -> usize {
        self.nodes.items.len()
    }

    fn measure(&self) -> Measure<'_> {
        Measure { points: &self.points.items, nodes: &self.nodes.items, ranges: &self.placements }
    }

    /// The graph of what the root needs.
    pub(crate) fn finish(self, root: NodeId) -> Graph {
        completed(walk::compacted(self.graph(root)))
    }

    /// The graph of all there is, numbered as it is here.
    pub(crate) fn finish_whole(self, root: NodeId) -> Graph {
        completed(self.graph(root))
    }

    fn graph(self, root: NodeId) -> Graph {
        Graph {
            points: self.points.items,
            nodes: self.nodes.items,
            facts: self.facts,
            spans: self.spans,
            root,
            materials: self.materials.items,
            slots: Vec::new(),
        }
    }
}

fn completed(mut graph: Graph) -> Graph {
    walk::forget_growth_below_tapers(&mut graph);
    graph.slots = walk::slots(&graph);
    graph
}

/// The maps that undo those of the points, as they were composed: their ranges are tighter than those of an inverse.
struct Placements {
    forward: Vec<Option<Affine>>,
}

impl Ranges for Placements {
    fn range(&self, number: &Scalar) -> Interval {
        number.range()
    }

    fn placement(&self, map: &Affine, point: PointId) -> Placement {
        use chiaro_solid::affine::Similarity;
        let inverse;
        let forward = match &self.forward[point.0 as usize] {
            Some(forward) => forward,
            None => {
                inverse = map.inverse();
                &inverse
            }
        };
        if let Some(rows) = constant_rows(forward) {
            let similar = matches!(forward.similarity(), Similarity::Uniform(_));
            let stretch = if similar { 1.0 } else { singular::greatest(&linear(&rows)).max(1.0) };
            return Placement { rows: rows.map(|row| row.map(Interval::point)), stretch };
        }
        let mut rows = forward.rows().each_ref().map(|row| row.each_ref().map(Scalar::range));
        let factor = match forward.similarity() {
            Similarity::Uniform(factor) => Some(factor.range().max),
            Similarity::AtLeast(_) => None,
        };
        if let Some(factor) = factor {
            // No entry of a similarity exceeds its factor.
            for entry in rows.iter_mut().flat_map(|row| &mut row[..3]) {
                *entry = Interval { min: entry.min.max(-factor), max: entry.max.min(factor) };
            }
        }
        let squares = || rows.iter().flat_map(|row| &row[..3]).map(|entry| entry.magnitude().powi(2));
        let stretch = factor.unwrap_or_else(|| squares().sum::<f64>().sqrt());
        Placement { rows, stretch }
    }
}

/// A list of distinct items, found again by their hash.
struct Interner<T> {
    items: Vec<T>,
    by_hash: FxHashMap<u64, u32>,
}

impl<T> Default for Interner<T> {
    fn default() -> Self {
        Self { items: Vec::new(), by_hash: FxHashMap::default() }
    }
}

impl<T: PartialEq> Interner<T> {
    /// The item's number, and whether it is new. Different items of one hash take the hashes behind it.
    fn intern(&mut self, mut hash: u64, item: T) -> (u32, bool) {
        while let Some(id) = self.by_hash.get(&hash) {
            if self.items[*id as usize] == item {
                return (*id, false);
            }
            hash = hash.wrapping_add(1);
        }
        let id = self.items.len() as u32;
        self.by_hash.insert(hash, id);
        self.items.push(item);
        (id, true)
    }
}

fn hash_of(feed: impl FnOnce(&mut FxHasher)) -> u64 {
    let mut state = FxHasher::default();
    feed(&mut state);
    state.finish()
}

fn hash_node(node: &Node, state: &mut impl Hasher) {
    std::mem::discriminant(node).hash(state);
    match node {
        Node::Nothing => {}
        Node::Shape(row, arguments, point) => (row, arguments, point).hash(state),
        Node::Outline(region, point) => {
            point.hash(state);
            region.edges().for_each(|edge| hash_edge(edge, state));
        }
        Node::Loft(loft, point) => {
            point.hash(state);
            loft.numbers().for_each(|number| number.to_bits().hash(state));
        }
        Node::Polytope(triangles, point) => {
            point.hash(state);
            triangles.iter().flatten().flatten().for_each(|number| number.to_bits().hash(state));
        }
        Node::Boolean(operation, joint, children) => {
            (operation, children).hash(state);
            if let Some(joint) = joint {
                (joint.profile, &joint.radius).hash(state);
            }
        }
        Node::Negate(child) => child.hash(state),
        Node::Adjust(row, arguments, child) => (row, arguments, child).hash(state),
        Node::Extrude(height, child, point) => (height, child, point).hash(state),
        Node::Taper(height, scale, child, point) => (height, scale, child, point).hash(state),
        Node::Confine(radius, lipschitz, child, point) => (radius, lipschitz.to_bits(), child, point).hash(state),
        Node::Paint(material, child) => (material, child).hash(state),
    }
}

fn hash_edge(edge: &Edge, state: &mut impl Hasher) {
    let numbers = match *edge {
        Edge::Line { from, to } => [from[0], from[1], to[0], to[1], 0.0],
        Edge::Arc { center, radius, start, sweep } => [center[0], center[1], radius, start, sweep],
    };
    numbers.map(f64::to_bits).hash(state);
}
