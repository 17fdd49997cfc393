//! What kernels read of crowds: a member's numbers, and the cells that list the members.

use chiaro_field::crowd::{Cell, Cells, Crowd, MOST_CROWDS, Member};
use chiaro_field::{Bounds, Crowds, Graph};
use chiaro_solid::Material;
use rustc_hash::FxHashMap;

use crate::tables::single;
use chiaro_field::linear_from_srgb;

/// The quadruples of a crowd's grid.
pub(crate) const GRID_ROWS: usize = 3;
/// How many of an entry's bits say which of the crowd's patterns the member follows; the others say where its numbers are.
pub(crate) const PATTERN_BITS: u32 = 5;
/// What stands behind the last entry of a list: no pattern.
const END: u32 = (1 << PATTERN_BITS) - 1;
/// `CROWD_BLOCK` of `crowd.wgsl`.
const BLOCK: u32 = 1 << 31;
/// How many words stand before a member's numbers to say what it looks like.
const LOOK_WORDS: usize = 8;
/// The least room for a crowd's cells in words, and how much there is for each member.
const LEAST_ROOM: usize = 1 << 18;
const ROOM_EACH: usize = 512;
/// The most room for all cells together: 80 MiB, of 128 that every device allows of a storage buffer.
const MOST_ROOM: usize = 20 << 20;

/// What kernels read of crowds.
#[derive(Clone, Debug, PartialEq)]
pub struct CrowdData {
    /// To upload to [`CROWD_GRIDS`](crate::bindings::CROWD_GRIDS), which has room for [`MOST_CROWDS`] of them.
    pub grids: [[u32; 4]; GRID_ROWS * MOST_CROWDS],
    /// To upload to [`CROWDS`](crate::bindings::CROWDS); some quadruples.
    pub words: Vec<u32>,
}

impl CrowdData {
    /// The data of a scene's crowds while the live parameters have certain values. Crowds whose members lie in each other,
    /// so that cells are of no use, leave the others and are answered.
    pub fn of(graph: &Graph, crowds: &mut Crowds, parameters: &[f64]) -> (Self, Vec<Crowd>) {
        let cells: Vec<Option<Cells>> =
            crowds.crowds.iter().map(|crowd| Cells::of(graph, crowd, parameters, room(crowds, crowd))).collect();
        let dense: Vec<usize> = (0..cells.len()).filter(|crowd| cells[*crowd].is_none()).collect();
        let dense = crowds.take(&dense);
        let cells: Vec<Cells> = cells.into_iter().flatten().collect();
        (Self::with_cells(graph, crowds, &cells, parameters), dense)
    }

    fn with_cells(graph: &Graph, crowds: &Crowds, cells: &[Cells], parameters: &[f64]) -> Self {
        let mut data = Self { grids: Default::default(), words: Vec::new() };
        let crowds_and_cells = crowds.crowds.iter().zip(cells);
        for ((crowd, cells), grid) in crowds_and_cells.zip(data.grids.chunks_exact_mut(GRID_ROWS)) {
            let entries = add_rows(&mut data.words, graph, crowds, crowd, parameters);
            let first = add_cells(&mut data.words, cells, &entries) as u32;
            let Bounds { min, max } = cells.bounds();
            let ([min_x, min_y, min_z], [max_x, max_y, max_z]) = (min.map(bits), max.map(bits));
            let [count_x, count_y, count_z] = cells.counts;
            grid[0] = [min_x, min_y, min_z, bits(1.0 / cells.edge)];
            grid[1] = [max_x, max_y, max_z, first];
            grid[2] = [count_x, count_y, count_z, 0];
        }
        data
    }

    /// The most words that there may be, whatever values the live parameters have.
    pub fn most_words(crowds: &Crowds) -> usize {
        let of_crowd = |crowd: &Crowd| {
            let row = |member: &Member| member.numbers.len().next_multiple_of(4) + LOOK_WORDS;
            // Cells are divided while there is room: the last divisions may go beyond it, with lists of all members.
            crowd.members.iter().map(row).sum::<usize>() + 2 * room(crowds, crowd) + 96 * (crowd.members.len() + 4)
        };
        crowds.crowds.iter().map(of_crowd).sum()
    }
}

/// The room for a crowd's cells and lists.
fn room(crowds: &Crowds, crowd: &Crowd) -> usize {
    let all: usize = crowds.crowds.iter().map(|crowd| crowd.members.len()).sum();
    let share = MOST_ROOM as f64 * crowd.members.len() as f64 / all as f64;
    (LEAST_ROOM + ROOM_EACH * crowd.members.len()).min(share as usize)
}

/// Adds the numbers of a crowd's members; answers what lists say of each.
fn add_rows(words: &mut Vec<u32>, graph: &Graph, crowds: &Crowds, crowd: &Crowd, parameters: &[f64]) -> Vec<u32> {
    let has_looks = crowds.has_looks(crowd);
    let mut entry = |member: &Member| {
        if has_looks {
            words.extend(look(graph, member, parameters));
        }
        let row = words.len() as u32 / 4;
        words.extend(member.numbers.iter().map(|number| bits(number.value(parameters))));
        words.resize(words.len().next_multiple_of(4), 0);
        row << PATTERN_BITS | member.pattern as u32
    };
    crowd.members.iter().map(&mut entry).collect()
}

/// What a member looks like throughout: linear colour and opacity; roughness, metallic, emission; 1 if nobody painted it.
fn look(graph: &Graph, member: &Member, parameters: &[f64]) -> [u32; LOOK_WORDS] {
    let Some(material) = member.material else {
        return [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0].map(bits);
    };
    let Material { color: [red, green, blue, opacity], roughness, metallic, emission } =
        &graph.materials[material.0 as usize];
    let [red, green, blue] = [red, green, blue].map(|channel| linear_from_srgb(channel.value(parameters)));
    let [opacity, roughness, metallic, emission] =
        [opacity, roughness, metallic, emission].map(|number| number.value(parameters));
    [red, green, blue, opacity, roughness, metallic, emission, 0.0].map(bits)
}

/// Adds cells and their lists; answers where the cells are.
fn add_cells(words: &mut Vec<u32>, cells: &Cells, entries: &[u32]) -> usize {
    let first = words.len();
    let mut lists = Vec::new();
    let mut known = FxHashMap::default();
    let first_list = first + cells.cells.len();
    let mut list_of = |from: u32, to: u32| {
        *known.entry(from).or_insert_with(|| {
            let place = first_list + lists.len();
            lists.extend(cells.members[from as usize..to as usize].iter().map(|member| entries[*member as usize]));
            // Patterns are asked one after the other.
            lists[place - first_list..].sort_by_key(|entry| (entry & END, *entry));
            lists.push(END);
            place as u32
        })
    };
    words.extend(cells.cells.iter().map(|cell| match *cell {
        Cell::List(from, to) => list_of(from, to),
        Cell::Block(cell) => BLOCK | (first as u32 + cell),
    }));
    words.extend(lists);
    words.resize(words.len().next_multiple_of(4), 0);
    first
}

/// The bits of a number in single precision.
fn bits(value: f64) -> u32 {
    single(value).to_bits()
}
