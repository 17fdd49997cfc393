//! Bases: the points that series are functions of.

use rustc_hash::FxHashMap;

use crate::graph::{Graph, NodeId, Point, PointId};

/// For each node, the deepest point that all of its points are computed from; none, if it has no points.
pub(super) struct Common(Vec<Option<PointId>>);

impl Common {
    pub(super) fn new(graph: &Graph) -> Self {
        let mut common: Vec<Option<PointId>> = Vec::with_capacity(graph.nodes.len());
        for node in &graph.nodes {
            let of_children = node.children().iter().filter_map(|child| common[child.0 as usize]);
            common.push(of_children.chain(node.point()).reduce(|one, other| common_point(graph, one, other)));
        }
        Self(common)
    }
}

/// The deepest point that both are computed from: what is computed from another point stands behind that.
fn common_point(graph: &Graph, mut one: PointId, mut other: PointId) -> PointId {
    while one != other {
        let (from, deeper) = if one > other { (other, one) } else { (one, other) };
        let Some(parent) = graph.points[deeper.0 as usize].parent() else { return deeper };
        (one, other) = (from, parent);
    }
    one
}

/// For the operands of a Boolean, the deepest points that several of them are computed from.
pub(super) struct Bases<'a> {
    graph: &'a Graph,
    common: &'a Common,
    counts: FxHashMap<PointId, usize>,
    /// How many operands several are.
    several: usize,
}

impl<'a> Bases<'a> {
    pub(super) fn new(graph: &'a Graph, common: &'a Common, operands: &[NodeId], several: usize) -> Self {
        let mut bases = Self { graph, common, counts: FxHashMap::default(), several };
        for operand in operands {
            for point in bases.points(*operand) {
                *bases.counts.entry(point).or_default() += 1;
            }
        }
        bases
    }

    /// The base of an operand.
    pub(super) fn of(&self, operand: NodeId) -> Option<PointId> {
        self.points(operand).into_iter().find(|point| self.counts[point] >= self.several)
    }

    /// The points that all of an operand is computed from, the deepest first; without constant maps, which tell operands apart.
    fn points(&self, operand: NodeId) -> Vec<PointId> {
        let first = self.common.0[operand.0 as usize];
        let point = |id: &PointId| &self.graph.points[id.0 as usize];
        let is_constant_map = |id: &PointId| match point(id) {
            Point::Affine(map, _) => map.rows().iter().flatten().all(|number| number.constant().is_some()),
            _ => false,
        };
        let all = std::iter::successors(first, |id| point(id).parent());
        all.filter(|id| !is_constant_map(id)).collect()
    }
}
