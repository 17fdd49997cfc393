//! Parts: large scenes as several functions.
//!
//! Compilers take more than linear time for one large function, so the operands of large sharp Booleans are put into
//! functions of their own, some at a time, neighbours together; and a large node that several others refer to is one
//! function, so that what they share isn't copied into each.

use chiaro_field::paints::Painted;
use chiaro_field::{AllSeries, Bounds, Graph, Node, NodeId, Operation, Point, PointId};
use naga::{Function, Handle};
use rustc_hash::{FxHashMap, FxHashSet};

use super::{Emission, Scope};
use crate::build::Value;

/// The most nodes of one function, about.
const LARGE: u32 = 128;
/// The most nodes of a function for some operands of a large Boolean, which are divided in space.
const PART: u32 = 64;
/// So many operands of a series that look the same are a function, which `scene_distance` and `scene_surface` both call.
const MANY_IN_SERIES: usize = 4;
/// In large scenes, a shared node of this many is a function of its own.
const LARGE_SHARED: u32 = 32;

/// How a scene is divided.
pub(super) struct Parts {
    /// How many nodes each node stands for, shared ones counted every time.
    weights: Vec<u32>,
    /// The same with pieces of outlines and polytopes counted as nodes.
    costs: Vec<u32>,
    /// The boxes around the nodes.
    bounds: Vec<Bounds>,
    /// How many nodes refer to each node.
    uses: Vec<u32>,
    /// How many nodes and points refer to each point.
    point_uses: Vec<u32>,
    is_divided: bool,
    functions: FxHashMap<(Operation, Vec<NodeId>), Handle<Function>>,
}

impl Parts {
    pub(super) fn new(graph: &Graph, series: &AllSeries) -> Self {
        let mut weights: Vec<u32> = Vec::with_capacity(graph.nodes.len());
        let mut costs: Vec<u32> = Vec::with_capacity(graph.nodes.len());
        let mut uses = vec![0; graph.nodes.len()];
        for node in &graph.nodes {
            let (mut weight, mut cost) = (1_u32, own_cost(node));
            for child in node.children() {
                weight = weight.saturating_add(weights[child.0 as usize]);
                cost = cost.saturating_add(costs[child.0 as usize]);
                uses[child.0 as usize] += 1;
            }
            // A member is a call of its series' function.
            let is_member = series.of_member(NodeId(weights.len() as u32)).is_some();
            weights.push(if is_member { 1 } else { weight });
            costs.push(cost);
        }
        let mut point_uses = vec![0; graph.points.len()];
        let of_nodes = graph.nodes.iter().filter_map(Node::point);
        for point in of_nodes.chain(graph.points.iter().filter_map(Point::parent)) {
            point_uses[point.0 as usize] += 1;
        }
        let bounds = graph.facts.iter().map(|facts| facts.bounds).collect();
        let is_divided = weights[graph.root.0 as usize] > LARGE;
        Self { weights, costs, bounds, uses, point_uses, is_divided, functions: FxHashMap::default() }
    }

    /// Whether the nodes are too much for one function.
    fn are_large(&self, nodes: &[NodeId]) -> bool {
        self.weight_of(nodes) >= LARGE
    }

    /// How many nodes and points refer to a point.
    pub(super) fn uses_of_point(&self, id: PointId) -> u32 {
        self.point_uses[id.0 as usize]
    }

    /// Whether several nodes refer to this one.
    pub(super) fn is_shared(&self, id: NodeId) -> bool {
        self.uses[id.0 as usize] > 1
    }

    /// Whether the node is a function of its own.
    pub(super) fn is_apart(&self, id: NodeId) -> bool {
        self.is_divided && self.is_shared(id) && self.weight(id) >= LARGE_SHARED
    }

    /// Whether there is a function for these nodes.
    fn is_part(&self, operation: Operation, nodes: &[NodeId]) -> bool {
        self.is_divided && self.functions.contains_key(&(operation, nodes.to_vec()))
    }

    fn weight(&self, id: NodeId) -> u32 {
        self.weights[id.0 as usize]
    }

    fn weight_of(&self, nodes: &[NodeId]) -> u32 {
        nodes.iter().fold(0_u32, |sum, node| sum.saturating_add(self.weight(*node)))
    }

    /// What asking all these nodes costs, in nodes.
    pub(super) fn cost_of(&self, nodes: &[NodeId]) -> u32 {
        nodes.iter().fold(0_u32, |sum, node| sum.saturating_add(self.costs[node.0 as usize]))
    }

    /// The lists of nodes joined to lists for one function each or, of a single node, for that by itself.
    fn packed(&self, lists: Vec<Vec<NodeId>>) -> Vec<Vec<NodeId>> {
        let placed = lists.into_iter().map(|list| (self.center(&list), list)).collect();
        let mut packed = Vec::new();
        self.pack(placed, &mut packed);
        packed
    }

    /// Packs lists, each with its middle: divided across their longest extent until they are small enough.
    fn pack(&self, mut placed: Vec<([f64; 3], Vec<NodeId>)>, packed: &mut Vec<Vec<NodeId>>) {
        let weight = placed.iter().fold(0_u32, |sum, (_, list)| sum.saturating_add(self.weight_of(list)));
        if placed.len() < 2 || weight <= PART {
            let together: Vec<NodeId> = placed.into_iter().flat_map(|(_, list)| list).collect();
            packed.extend((!together.is_empty()).then_some(together));
            return;
        }
        let extent = |axis: usize| {
            let along = || placed.iter().map(|(center, _)| center[axis]);
            along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
        };
        let extents = [0, 1, 2].map(extent);
        let axis = (1..3).fold(0, |longest, axis| if extents[axis] > extents[longest] { axis } else { longest });
        placed.sort_by(|(a, _), (b, _)| a[axis].total_cmp(&b[axis]));
        let beyond = placed.split_off(placed.len() / 2);
        self.pack(placed, packed);
        self.pack(beyond, packed);
    }

    /// The middle of what is around the nodes; zero where that is without end.
    fn center(&self, nodes: &[NodeId]) -> [f64; 3] {
        let around = nodes.iter().fold(Bounds::EMPTY, |all, node| all.union(&self.bounds[node.0 as usize]));
        around.center().map(|middle| if middle.is_finite() { middle } else { 0.0 })
    }

    /// The nodes, which look the same, in lists for one function each.
    fn lists(&self, nodes: &[NodeId]) -> Vec<Vec<NodeId>> {
        match self.is_divided {
            true => self.packed(nodes.iter().map(|node| vec![*node]).collect()),
            false => vec![nodes.to_vec()],
        }
    }
}

/// A node's own cost.
fn own_cost(node: &Node) -> u32 {
    let pieces = match node {
        Node::Outline(region, _) => region.edges().count(),
        Node::Loft(loft, _) => loft.sides(),
        Node::Polytope(triangles, _) => triangles.len(),
        _ => 1,
    };
    u32::try_from(pieces).unwrap_or(u32::MAX)
}

impl Emission<'_> {
    /// The operands of a sharp Boolean in lists for one function each, of single ones for none: where they can be, those that
    /// `scene_surface` asks for too, by series and material.
    fn lists(&self, nodes: &[NodeId]) -> Vec<Vec<NodeId>> {
        let of_group = |group: &Vec<NodeId>| self.parts.lists(group);
        if self.parts.are_large(nodes) {
            return self.parts.packed(self.groups(nodes).iter().flat_map(of_group).collect());
        }
        if nodes.iter().all(|node| self.series.of_operand(*node).is_none()) {
            return nodes.iter().map(|node| vec![*node]).collect();
        }
        let series: Vec<Vec<NodeId>> = self.groups(nodes).into_iter().filter(|group| self.is_series(group)).collect();
        let in_series: FxHashSet<NodeId> = series.iter().flatten().copied().collect();
        let others = nodes.iter().filter(|node| !in_series.contains(node)).map(|node| vec![*node]);
        series.iter().flat_map(of_group).chain(others).collect()
    }

    /// The nodes, which look the same, in lists for functions that there are already or that are worthwhile.
    fn lists_alike(&self, nodes: &[NodeId]) -> Vec<Vec<NodeId>> {
        let lists: Vec<Vec<NodeId>> = self.groups(nodes).iter().flat_map(|group| self.parts.lists(group)).collect();
        match &lists[..] {
            [_] => lists,
            _ if lists.iter().any(|list| self.is_series(list)) || self.parts.is_divided => lists,
            _ => vec![nodes.to_vec()],
        }
    }

    /// The nodes by their series and materials.
    fn groups(&self, nodes: &[NodeId]) -> Vec<Vec<NodeId>> {
        let mut groups: Vec<Vec<NodeId>> = Vec::new();
        let mut group_of: FxHashMap<(Painted, Option<usize>), usize> = FxHashMap::default();
        for &node in nodes {
            let key = (self.paints.painted(node), self.series.of_operand(node));
            let group = *group_of.entry(key).or_insert_with(|| {
                groups.push(Vec::new());
                groups.len() - 1
            });
            groups[group].push(node);
        }
        groups
    }

    /// What the function of these nodes is called, but for letters behind it, and what is said of it.
    fn told_part(&self, nodes: &[NodeId]) -> (String, String) {
        match self.series.of_operand(nodes[0]).filter(|_| self.is_series(nodes)) {
            Some(series) => {
                (format!("{}_series", self.name_of_series(series)), format!("// All {} of them.\n", nodes.len()))
            }
            None => ("part".to_owned(), "// The distance to some of the scene's shapes.\n".to_owned()),
        }
    }

    /// Whether these are many of one series.
    fn is_series(&self, group: &[NodeId]) -> bool {
        let mut series = group.iter().map(|node| self.series.of_operand(*node));
        let first = series.next().flatten();
        group.len() >= MANY_IN_SERIES && first.is_some() && series.all(|own| own == first)
    }
}

impl Scope<'_, '_> {
    /// The least or greatest of the nodes, which look the same: evaluated here if they are few, else by functions.
    pub(super) fn reduced(&mut self, operation: Operation, nodes: &[NodeId]) -> Value {
        let lists = self.emission.lists_alike(nodes);
        match &lists[..] {
            [list] if !self.emission.is_series(list) && !self.emission.parts.is_part(operation, list) => {
                self.reduced_here(operation, list)
            }
            _ => self.reduced_by_lists(operation, Vec::new(), lists),
        }
    }

    /// The least or greatest of some values and of the nodes, by functions where they are many.
    pub(super) fn reduced_with(&mut self, operation: Operation, values: Vec<Value>, nodes: &[NodeId]) -> Value {
        let lists = self.emission.lists(nodes);
        self.reduced_by_lists(operation, values, lists)
    }

    /// The least or greatest of the nodes, evaluated here.
    pub(super) fn reduced_here(&mut self, operation: Operation, nodes: &[NodeId]) -> Value {
        self.reduced_by_lists(operation, Vec::new(), nodes.iter().map(|node| vec![*node]).collect())
    }

    fn reduced_by_lists(&mut self, operation: Operation, mut values: Vec<Value>, lists: Vec<Vec<NodeId>>) -> Value {
        match operation {
            Operation::Union => self.least(values, lists),
            Operation::Intersection => {
                values.extend(lists.into_iter().map(|list| self.list(operation, list)));
                self.chain(operation, &values)
            }
        }
    }

    /// The least or greatest of the nodes: of a single one here, else by a function.
    pub(super) fn list(&mut self, operation: Operation, list: Vec<NodeId>) -> Value {
        match list[..] {
            [node] => self.distance(node),
            _ => self.by_part(operation, list),
        }
    }

    /// The node's distance, by a function of its own.
    pub(super) fn distance_by_part(&mut self, id: NodeId) -> Value {
        self.by_part(Operation::Union, vec![id])
    }

    /// The least or greatest of the nodes, by a function, which is emitted when it is first called.
    pub(super) fn by_part(&mut self, operation: Operation, nodes: Vec<NodeId>) -> Value {
        let key = (operation, nodes);
        let function = match self.emission.parts.functions.get(&key) {
            Some(&function) => function,
            None => {
                let (name, comment) = self.emission.told_part(&key.1);
                let name = self.emission.names.next(&name);
                let float = self.emission.types.float;
                let mut scope = Scope::new(self.emission, &name, float);
                let value = match key.1[..] {
                    [node] => scope.distance_here(node),
                    _ => scope.reduced_here(operation, &key.1),
                };
                let function = scope.finish(value);
                let function = self.emission.define(function, comment);
                self.emission.parts.functions.insert(key, function);
                function
            }
        };
        let point = self.builder.argument();
        let value = self.builder.call(function, &[point]);
        self.name(value, "group")
    }
}
