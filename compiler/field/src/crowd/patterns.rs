//! Collects the patterns of members.

use rustc_hash::FxHashMap;

use super::Member;
use crate::graph::{Graph, Node, NodeId};
use crate::pattern::{Drawings, Pattern, Walk, weights};

/// Collects patterns.
#[derive(Default)]
pub(super) struct Patterns {
    patterns: Vec<Pattern>,
    places: FxHashMap<Vec<u64>, usize>,
    drawings: Drawings,
}

impl Patterns {
    /// An operand as a member; its pattern is the place here.
    pub(super) fn member(&mut self, graph: &Graph, node: NodeId) -> Member {
        let (material, painted) = match &graph.nodes[node.0 as usize] {
            Node::Paint(material, child) => (Some(*material), *child),
            _ => (None, node),
        };
        let walk = Walk::through(graph, material.is_none(), painted, &mut self.drawings);
        let next = self.patterns.len();
        let pattern = match self.places.get(&walk.key) {
            Some(&known) => known,
            None => {
                self.patterns.push(walk.pattern_of_all());
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
