//! Series: operands of a Boolean that are the same but for where they stand and for some of their numbers, as `for` makes them.
//!
//! Theory: Two fields that differ by numbers alone follow one [`Pattern`]. If besides the maps to their shapes are
//! B₁M, B₂M, … with a map M of each member's own, then the field is one function, asked at M p. The point p is the deepest one
//! that all of several members are computed from: of the teeth of a twisted gear, that in the plane.
//! Practice: Of a series' members the first one gives the pattern. M is a move if that is all that tells members apart, and
//! else the first map itself. Members with several maps have to stand at constant places. By what the Bs move counts among the
//! numbers: in parts of different heights, not all is at the same place.

mod base;
mod frame;

use chiaro_solid::{Affine, Scalar};
use rustc_hash::FxHashMap;

use crate::graph::{Graph, Node, NodeId, PointId};
use crate::pattern::{Drawings, Pattern, Walk, parameter, weights};
use base::{Bases, Common};
use frame::Frame;

/// The fewest members of a series.
const FEWEST: usize = 3;
/// The most nodes of a member; and of one that differs from others by numbers, which all of its code needs.
const MOST_WEIGHT: u32 = 1024;
const MOST_WEIGHT_WITH_NUMBERS: u32 = 64;
/// By how many numbers members may differ, beside their places.
const MOST_NUMBERS: usize = 16;
/// With so many members of one pattern that have nothing else in common, no more are compared.
const MOST_FRAMES: usize = 16;
/// Parameters of patterns are counted from here: those of scenes are fewer.
const FIRST_PARAMETER: u32 = 1 << 31;

/// The series of a graph.
#[derive(Clone, Debug, Default)]
pub struct AllSeries {
    /// The series.
    pub series: Vec<Series>,
    of_operand: FxHashMap<NodeId, usize>,
    of_member: FxHashMap<NodeId, (usize, usize)>,
}

/// Operands that are the same but for their places and some numbers.
#[derive(Clone, Debug)]
pub struct Series {
    /// The members, in the order of the text.
    pub members: Vec<Instance>,
    /// The point that they are computed from, which is the pattern's world.
    pub base: PointId,
    /// Whether that has two coordinates.
    pub is_plane: bool,
    /// What they have in common; its slots are the parameters that each member has numbers for.
    pub pattern: Pattern,
    /// The series within the pattern.
    pub within: AllSeries,
}

/// A member of a series.
#[derive(Clone, Debug)]
pub struct Instance {
    /// The operand; of a difference, a complement.
    pub operand: NodeId,
    /// The operand without its sign and material.
    pub node: NodeId,
    /// From the base to where the pattern is asked; in a plane, it leaves z alone.
    pub map: Affine,
    /// The values of the pattern's parameters.
    pub numbers: Vec<Scalar>,
}

impl AllSeries {
    /// All series of a graph.
    pub fn of(graph: &Graph) -> Self {
        let weights = weights(graph);
        let common = Common::new(graph);
        let mut drawings = Drawings::default();
        let mut all = Self::default();
        let mut open = vec![graph.root];
        let mut seen = vec![false; graph.nodes.len()];
        while let Some(id) = open.pop() {
            if std::mem::replace(&mut seen[id.0 as usize], true) {
                continue;
            }
            let node = &graph.nodes[id.0 as usize];
            if let Node::Boolean(_, _, operands) = node {
                series_of(graph, operands, (&weights, &common), &mut drawings)
                    .into_iter()
                    .for_each(|own| all.push(own));
            }
            // What is within a series is found in its pattern.
            open.extend(node.children().iter().filter(|child| all.of_operand(**child).is_none()));
        }
        all
    }

    /// Takes up a series.
    fn push(&mut self, series: Series) {
        let place = self.series.len();
        for (member, instance) in series.members.iter().enumerate() {
            self.of_operand.insert(instance.operand, place);
            self.of_member.insert(instance.node, (place, member));
        }
        self.series.push(series);
    }

    /// The series that an operand is in.
    pub fn of_operand(&self, operand: NodeId) -> Option<usize> {
        self.of_operand.get(&operand).copied()
    }

    /// The series that a node is a member of, and that member.
    pub fn of_member(&self, node: NodeId) -> Option<(usize, &Instance)> {
        let (place, member) = *self.of_member.get(&node)?;
        Some((place, &self.series[place].members[member]))
    }
}

/// A member in the making.
struct Candidate<'g> {
    operand: NodeId,
    /// The operand without its sign and material.
    node: NodeId,
    base: PointId,
    walk: Walk<'g>,
}

/// The series among the operands of a Boolean.
fn series_of(
    graph: &Graph,
    operands: &[NodeId],
    (weights, common): (&[u32], &Common),
    drawings: &mut Drawings,
) -> Vec<Series> {
    let bases = Bases::new(graph, common, operands, FEWEST);
    let mut groups: Vec<Vec<Candidate>> = Vec::new();
    // Of a base and a key.
    let mut known: FxHashMap<(PointId, Vec<u64>), Vec<usize>> = FxHashMap::default();
    for &operand in operands.iter().filter(|operand| weights[operand.0 as usize] <= MOST_WEIGHT) {
        let Some(candidate) = bases.of(operand).and_then(|base| candidate(graph, base, operand, drawings)) else {
            continue;
        };
        let of_kind = known.entry((candidate.base, candidate.walk.key.clone())).or_default();
        match of_kind.iter().find(|group| groups[**group][0].is_like(&candidate)) {
            Some(group) => groups[*group].push(candidate),
            None if of_kind.len() < MOST_FRAMES => {
                of_kind.push(groups.len());
                groups.push(vec![candidate]);
            }
            None => {}
        }
    }
    let is_light = |group: &[Candidate]| weights[group[0].operand.0 as usize] <= MOST_WEIGHT_WITH_NUMBERS;
    let series =
        groups.iter().filter(|group| group.len() >= FEWEST).map(|group| (series(graph, group), is_light(group)));
    series
        .filter(|(series, is_light)| series.pattern.graph.slots.is_empty() || *is_light)
        .map(|(series, _)| series)
        .collect()
}

/// An operand as a candidate, if it has a place of its own.
fn candidate<'g>(graph: &'g Graph, base: PointId, operand: NodeId, drawings: &mut Drawings) -> Option<Candidate<'g>> {
    let node = match graph.nodes[operand.0 as usize] {
        Node::Negate(child) => child,
        _ => operand,
    };
    let (is_painted, node) = match graph.nodes[node.0 as usize] {
        Node::Paint(_, child) => (true, child),
        _ => (false, node),
    };
    let walk = Walk::from(base, graph, !is_painted, node, drawings);
    (!walk.maps.is_empty()).then_some(Candidate { operand, node, base, walk })
}

impl Candidate<'_> {
    /// Whether another one differs by its place and by some numbers alone.
    fn is_like(&self, other: &Candidate) -> bool {
        let Some(shifts) = Frame::of(&self.walk.maps).and_then(|frame| frame.shifts(&other.walk.maps)) else {
            return false;
        };
        let pairs = self.walk.numbers.iter().zip(&other.walk.numbers);
        let differing = pairs.filter(|(a, b)| a != b).count() + shifts.iter().filter(|by| **by != 0.0).count();
        differing <= MOST_NUMBERS
    }

    /// The numbers of the field, and then where its shapes are in a frame, which is the first candidate's.
    fn numbers(&self, frame: &Frame) -> Vec<Scalar> {
        let first = frame.maps.iter().flat_map(|map| map.rows().iter().map(|row| row[3].clone()));
        let shifts = frame.shifts(&self.walk.maps).unwrap_or_default();
        let places = first.zip(shifts).map(|(own, by)| if by == 0.0 { own } else { own + Scalar::from(by) });
        self.walk.numbers.iter().cloned().chain(places).collect()
    }
}

/// The series of some candidates that are like the first one.
fn series(graph: &Graph, group: &[Candidate]) -> Series {
    let first = &group[0];
    let others = group.iter().map(|member| member.walk.maps.as_slice());
    let Some(frame) = Frame::of_all(&first.walk.maps, others) else { unreachable!("others are like the first") };
    let all: Vec<Vec<Scalar>> = group.iter().map(|member| member.numbers(&frame)).collect();
    let columns: Vec<usize> =
        (0..all[0].len()).filter(|column| all.iter().any(|other| other[*column] != all[0][*column])).collect();
    let slots: Vec<Scalar> = (FIRST_PARAMETER..).take(columns.len()).map(parameter).collect();
    let mut numbers = all[0].clone();
    for (column, slot) in columns.iter().zip(&slots) {
        numbers[*column] = slot.clone();
    }
    let places = numbers.split_off(first.walk.numbers.len());
    let maps: Vec<Affine> = frame.maps.iter().zip(places.chunks_exact(3)).map(|(map, by)| map_to(map, by)).collect();
    let members = group.iter().zip(&all).map(|(member, own)| Instance {
        operand: member.operand,
        node: member.node,
        map: frame.of_member(&member.walk.maps),
        numbers: columns.iter().map(|column| own[*column].clone()).collect(),
    });
    let pattern = first.walk.pattern(&numbers, &maps, slots);
    Series {
        members: members.collect(),
        base: first.base,
        is_plane: graph.dimension(first.base) == 2,
        within: if pattern.graph.slots.is_empty() { AllSeries::of(&pattern.graph) } else { AllSeries::default() },
        pattern,
    }
}

/// The map with these numbers as what it moves by.
fn map_to(map: &Affine, by: &[Scalar]) -> Affine {
    let rows = map.rows();
    Affine::new([0, 1, 2].map(|axis| {
        let [x, y, z, _] = rows[axis].clone();
        [x, y, z, by[axis].clone()]
    }))
}
