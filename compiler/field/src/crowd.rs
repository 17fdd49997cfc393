//! Crowds: sharp unions of many operands, of which few matter at any one place.
//!
//! What operands have in common is their [`Pattern`]; what tells them apart are numbers. [`Cells`] say which of them can
//! be the nearest where. Together they let a scene be asked by a few functions and a table, in the place of code for
//! each operand.
//!
//! Crowds are looked for only where nothing but the sign of a value and its least counts from there to the root: below
//! materials, complements and sharp Booleans. There a bound serves as well as the value, far from the crowd.

mod cells;
mod patterns;

use chiaro_solid::Scalar;
use rustc_hash::FxHashMap;

use crate::facts::Facts;
use crate::graph::{Graph, MaterialId, Node, NodeId, Operation};
use crate::pattern::weights;
use crate::walk::material_scalars;
use patterns::Patterns;

pub use crate::pattern::Pattern;
pub use cells::{BLOCK_EDGE, Cell, Cells, MOST_DIVISIONS};

/// The most crowds of a graph: the largest ones.
pub const MOST_CROWDS: usize = 8;

/// With fewer operands that cells can tell apart, a union is no crowd.
const MANY: usize = 64;
/// The most patterns of a crowd: what five bits can tell apart, and none.
const MOST_PATTERNS: usize = 31;
/// The most nodes of a member.
const MOST_WEIGHT: u32 = 64;
/// The most nodes of all patterns of a crowd.
const MOST_PATTERN_WEIGHT: u32 = 768;

/// The crowds of a graph.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Crowds {
    /// The crowds, the largest first.
    pub crowds: Vec<Crowd>,
    /// The patterns that their members follow.
    pub patterns: Vec<Pattern>,
}

/// A sharp union of many operands.
#[derive(Clone, Debug, PartialEq)]
pub struct Crowd {
    /// The union.
    pub union: NodeId,
    /// Those of its operands that cells tell apart, in the order of the text.
    pub members: Vec<Member>,
    /// The other ones.
    pub others: Vec<NodeId>,
    /// The members' patterns, by their places among [`Crowds::patterns`].
    pub patterns: Vec<usize>,
}

/// An operand of a crowd.
#[derive(Clone, Debug, PartialEq)]
pub struct Member {
    /// The operand.
    pub node: NodeId,
    /// Its pattern, by the place among [`Crowd::patterns`].
    pub pattern: usize,
    /// The values of the pattern's parameters.
    pub numbers: Vec<Scalar>,
    /// Its material, if it has one throughout. Else its pattern knows more.
    pub material: Option<MaterialId>,
}

impl Crowds {
    /// The crowds of a graph.
    pub fn of(graph: &Graph) -> Self {
        let weights = weights(graph);
        let uses = uses(graph);
        let mut patterns = Patterns::default();
        let mut crowds = Vec::new();
        let mut open = vec![graph.root];
        while let Some(id) = open.pop() {
            if uses[id.0 as usize] > 1 {
                continue;
            }
            match &graph.nodes[id.0 as usize] {
                Node::Boolean(Operation::Union, None, operands) => {
                    let crowd = crowd(graph, id, operands, &weights, &mut patterns);
                    open.extend(crowd.as_ref().map_or(operands, |crowd| &crowd.others));
                    crowds.extend(crowd);
                }
                Node::Boolean(Operation::Intersection, None, operands) => open.extend(operands),
                Node::Negate(child) | Node::Paint(_, child) => open.push(*child),
                _ => {}
            }
        }
        crowds.sort_by_key(|crowd| std::cmp::Reverse(crowd.members.len()));
        crowds.truncate(MOST_CROWDS);
        let (patterns, places) = patterns.used(crowds.iter().flat_map(|crowd| crowd.patterns.iter().copied()));
        for pattern in crowds.iter_mut().flat_map(|crowd| &mut crowd.patterns) {
            *pattern = places[pattern];
        }
        Self { crowds, patterns }
    }

    /// Takes out the crowds of these places, in rising order: their unions are to be asked as any other.
    pub fn take(&mut self, places: &[usize]) -> Vec<Crowd> {
        places.iter().rev().map(|place| self.crowds.remove(*place)).collect()
    }

    /// The crowd that this node is.
    pub fn of_node(&self, id: NodeId) -> Option<usize> {
        self.crowds.iter().position(|crowd| crowd.union == id)
    }

    /// Whether anything tells members of a crowd apart by what they look like.
    pub fn has_looks(&self, crowd: &Crowd) -> bool {
        let is_painted = |pattern: &usize| self.patterns[*pattern].is_painted;
        crowd.members.iter().any(|member| member.material.is_some()) || crowd.patterns.iter().any(is_painted)
    }

    /// The live numbers that tell members apart.
    pub fn live_numbers<'a>(&'a self, graph: &'a Graph) -> impl Iterator<Item = &'a Scalar> {
        let of_member = |member: &'a Member| {
            let material = member.material.map(|id| &graph.materials[id.0 as usize]);
            member.numbers.iter().chain(material.into_iter().flat_map(material_scalars))
        };
        let members = self.crowds.iter().flat_map(|crowd| &crowd.members);
        members.flat_map(of_member).filter(|number| number.constant().is_none())
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.crowds.is_empty()
    }
}

/// The crowd that these operands of a union make, if they are many.
fn crowd(graph: &Graph, union: NodeId, operands: &[NodeId], weights: &[u32], patterns: &mut Patterns) -> Option<Crowd> {
    if operands.len() < MANY {
        return None;
    }
    let mut members = Vec::new();
    let mut others = Vec::new();
    for &node in operands {
        let Facts { bounds, lipschitz, .. } = graph.facts[node.0 as usize];
        let is_told_apart = bounds.is_finite() && !bounds.is_empty() && lipschitz.is_finite();
        if is_told_apart && weights[node.0 as usize] <= MOST_WEIGHT {
            members.push(patterns.member(graph, node));
        } else {
            others.push(node);
        }
    }
    let chosen = chosen_patterns(&members, patterns);
    let (mut members, rest): (Vec<Member>, Vec<Member>) =
        members.into_iter().partition(|member| chosen.contains(&member.pattern));
    others.extend(rest.iter().map(|member| member.node));
    let place: FxHashMap<usize, usize> = chosen.iter().enumerate().map(|(place, pattern)| (*pattern, place)).collect();
    members.iter_mut().for_each(|member| member.pattern = place[&member.pattern]);
    (members.len() >= MANY).then_some(Crowd { union, members, others, patterns: chosen })
}

/// The patterns of most members, as many as may be, in the order in which members follow them.
fn chosen_patterns(members: &[Member], patterns: &Patterns) -> Vec<usize> {
    let mut order: Vec<usize> = Vec::new();
    let mut counts: FxHashMap<usize, usize> = FxHashMap::default();
    for member in members {
        let count = counts.entry(member.pattern).or_default();
        if *count == 0 {
            order.push(member.pattern);
        }
        *count += 1;
    }
    let mut by_count = order.clone();
    by_count.sort_by_key(|pattern| std::cmp::Reverse(counts[pattern]));
    let mut weight = 0_u32;
    by_count.retain(|pattern| {
        weight = weight.saturating_add(patterns.weight(*pattern));
        weight <= MOST_PATTERN_WEIGHT
    });
    by_count.truncate(MOST_PATTERNS);
    order.retain(|pattern| by_count.contains(pattern));
    order
}

/// How many nodes refer to each node.
fn uses(graph: &Graph) -> Vec<u32> {
    let mut uses = vec![0; graph.nodes.len()];
    for child in graph.nodes.iter().flat_map(Node::children) {
        uses[child.0 as usize] += 1;
    }
    uses
}
