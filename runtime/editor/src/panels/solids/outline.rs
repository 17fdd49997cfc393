//! A tree as a list of rows that can be opened.

use std::collections::HashSet;
use std::hash::{DefaultHasher, Hash, Hasher};

use chiaro_compiler::syntax::Span;
use chiaro_compiler::vocabulary::{Bounds, Class};
use chiaro_compiler::{SolidId, Tree};

/// Nodes down to here are open at first.
const OPEN_DEPTH: u32 = 2;
/// But not those with more children than this.
const OPEN_CHILDREN: usize = 50;

/// A node of the tree.
#[derive(Clone, Debug)]
pub(super) struct Node {
    pub(super) what: String,
    pub(super) span: Span,
    pub(super) solid: SolidId,
    pub(super) bounds: Bounds,
    pub(super) class: Option<Class>,
    pub(super) lipschitz: f64,
    pub(super) depth: u32,
    pub(super) has_children: bool,
    parent: Option<u32>,
    /// How many nodes it and all below it are.
    size: u32,
    /// The same for the same place of the next revision's tree.
    place: u64,
}

/// The nodes, parents before their children, and which of them are in the list.
#[derive(Default)]
pub(super) struct Outline {
    nodes: Vec<Node>,
    open: HashSet<u64>,
    visible: Vec<u32>,
}

impl Outline {
    pub(super) fn new(tree: Tree) -> Self {
        let mut outline = Self::default();
        outline.fill(tree);
        outline.list();
        outline
    }

    /// Takes the tree apart. (It may be as deep as the evaluator allows: so there is no recursion here.)
    fn fill(&mut self, tree: Tree) {
        let mut waiting = vec![(tree, None, 0_u32, 0_u64)];
        while let Some((tree, parent, depth, place)) = waiting.pop() {
            let index = self.nodes.len() as u32;
            if depth < OPEN_DEPTH && tree.children.len() <= OPEN_CHILDREN {
                self.open.insert(place);
            }
            self.nodes.push(Node {
                has_children: !tree.children.is_empty(),
                what: tree.what,
                span: tree.span,
                solid: tree.solid,
                bounds: tree.bounds,
                class: tree.class,
                lipschitz: tree.lipschitz,
                depth,
                parent,
                size: 1,
                place,
            });
            for (number, child) in tree.children.into_iter().enumerate().rev() {
                let mut hasher = DefaultHasher::new();
                (place, number, &child.what).hash(&mut hasher);
                waiting.push((child, Some(index), depth + 1, hasher.finish()));
            }
        }
        for index in (0..self.nodes.len()).rev() {
            if let Some(parent) = self.nodes[index].parent {
                self.nodes[parent as usize].size += self.nodes[index].size;
            }
        }
    }

    /// Opens what is open in the tree of another revision.
    pub(super) fn open_like(&mut self, other: &Outline) {
        if !other.nodes.is_empty() {
            self.open.clone_from(&other.open);
            self.list();
        }
    }

    /// How many nodes there are.
    pub(super) fn len(&self) -> usize {
        self.nodes.len()
    }

    /// The nodes in the list.
    pub(super) fn visible(&self) -> &[u32] {
        &self.visible
    }

    pub(super) fn node(&self, index: u32) -> &Node {
        &self.nodes[index as usize]
    }

    pub(super) fn is_open(&self, index: u32) -> bool {
        self.open.contains(&self.node(index).place)
    }

    /// Opens or closes a node.
    pub(super) fn toggle(&mut self, index: u32) {
        let place = self.node(index).place;
        if !self.open.remove(&place) {
            self.open.insert(place);
        }
        self.list();
    }

    /// Opens what is around a solid. Its row.
    pub(super) fn reveal(&mut self, solid: SolidId) -> Option<usize> {
        let found = self.nodes.iter().position(|node| node.solid == solid)? as u32;
        let parent = |index: &u32| self.nodes[*index as usize].parent;
        let around: Vec<u32> = std::iter::successors(parent(&found), parent).collect();
        let places = around.iter().map(|index| self.nodes[*index as usize].place);
        self.open.extend(places);
        self.list();
        self.visible.binary_search(&found).ok()
    }

    /// Lists the nodes whose parents are all open.
    fn list(&mut self) {
        self.visible.clear();
        let mut index = 0;
        while let Some(node) = self.nodes.get(index) {
            self.visible.push(index as u32);
            index += if self.open.contains(&node.place) { 1 } else { node.size as usize };
        }
    }
}
