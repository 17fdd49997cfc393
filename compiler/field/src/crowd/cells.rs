//! Cells: which members of a crowd can be the nearest where.
//!
//! Theory: Within R of a point c, a value that changes by at most L a millimetre stays within L R of what it is at c. So a
//! member whose value at c is more than (L + L') R above another's is nowhere the least within R of c. (Barbier et al.,
//! "Lipschitz Pruning", 2025, for cells of a hierarchical grid: each looks only at what its parent kept.)
//! Changes: Values at c are asked only of members whose boxes are near enough to matter. Cells are divided where that
//! shortens their lists, and sooner where there is a surface: most questions are about points beside one.
//! Practice: Lists are exact everywhere in the grid: asking a cell's members gives the very least of all. Members that lie in
//! each other have no short lists: there the work would have no end, so it is counted, and given up beyond a bound.

use chiaro_vocabulary::{Bounds, Class};
use rustc_hash::FxHashMap;

use super::Crowd;
use crate::evaluate::Evaluator;
use crate::graph::Graph;
use crate::pattern::weights;

/// How many cells a block has along each edge.
pub const BLOCK_EDGE: u32 = 4;
/// How often cells of the grid may be divided into blocks.
pub const MOST_DIVISIONS: u32 = 3;

/// By how much of its diagonal, at the most, the grid reaches beyond the crowd's box.
const MARGIN: f64 = 0.1;
/// The most members of a cell that is left undivided, if a surface passes through it, and if none does.
const FEW: usize = 4;
const FEW_AWAY: usize = 16;
/// Dividing has to shorten lists to this part.
const SHORTENED: f64 = 0.8;
/// Cells whose eighths have lists so nearly as long are not divided.
const HOPELESS: f64 = 0.95;
/// For several cells together, so many members are not asked for their values if boxes tell them apart.
const TOO_MANY: usize = 48;
/// How many cells a grid has for each member; at the least, and at the most.
const CELLS_EACH: usize = 16;
const LEAST_CELLS: usize = 1 << 12;
const MOST_CELLS: usize = 1 << 20;
/// The work of making cells is counted in boxes that are looked at; asking a node for its value is as much as so many.
const BOXES_PER_NODE: usize = 40;
/// The most work: so much, and for each member what so many questions for its value are.
const LEAST_WORK: usize = 1 << 23;
const QUESTIONS_EACH: usize = 800;
/// Where lists are of more members on average over the grid's volume, members lie in each other, and loops are not worth it.
const MOST_LISTED: f64 = 32.0;
/// The same before any cube of the grid is divided, in a sample of so many cubes: then dividing will not do.
const MOST_LISTED_AT_FIRST: usize = 128;
const SAMPLED: usize = 64;
/// How far off a point may be that a shader takes for another, as a part of its coordinates.
const ROUNDING: f64 = 4.0 * f32::EPSILON as f64;

/// A grid of cubes, some of which are divided into blocks of 4 × 4 × 4, and so on.
#[derive(Clone, Debug, PartialEq)]
pub struct Cells {
    /// The grid's least corner.
    pub origin: [f64; 3],
    /// The edge of a cube, in millimetres.
    pub edge: f64,
    /// How many cubes there are along each axis.
    pub counts: [u32; 3],
    /// The cubes of the grid, x fastest and z slowest, then those of the blocks.
    pub cells: Vec<Cell>,
    /// The lists one behind the other, each of members by their places in the crowd in rising order.
    pub members: Vec<u32>,
}

/// What is known of a cube.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cell {
    /// The members that can be the nearest: from one place of [`Cells::members`] up to another.
    List(u32, u32),
    /// The cubes it is divided into start at this place of [`Cells::cells`].
    Block(u32),
}

impl Cells {
    /// The cells of a crowd while the live parameters have certain values: about as many cells and members of lists as
    /// given, or fewer. None if too many members lie in each other: if lists would be long almost everywhere, or making
    /// them take much more work than for members beside each other.
    pub fn of(graph: &Graph, crowd: &Crowd, parameters: &[f64], room: usize) -> Option<Self> {
        let weights = weights(graph);
        let evaluator = Evaluator::new(graph, parameters);
        let bounds = graph.bounds_at(parameters);
        let reaches: Vec<Reach> = (crowd.members.iter())
            .map(|member| {
                let facts = &graph.facts[member.node.0 as usize];
                let is_distance = facts.class != Class::Bound && facts.lipschitz <= 1.0;
                Reach {
                    bounds: bounds[member.node.0 as usize],
                    is_distance,
                    all_bounds: facts.bounds,
                    growth: facts.growth,
                    lipschitz: facts.lipschitz,
                    work: BOXES_PER_NODE * weights[member.node.0 as usize] as usize,
                }
            })
            .collect();
        let value = |member: u32, point| evaluator.value(crowd.members[member as usize].node, point);
        Growing::new(&reaches, &value, room).grown()
    }

    /// The members that can be the nearest at a point of the grid; the nearest point of the grid, if it is outside.
    pub fn at(&self, point: [f64; 3]) -> &[u32] {
        let mut local = [0, 1, 2].map(|axis| (point[axis] - self.origin[axis]) / self.edge);
        let place = [0, 1, 2].map(|axis| (local[axis].max(0.0) as u32).min(self.counts[axis] - 1));
        local = [0, 1, 2].map(|axis| local[axis] - f64::from(place[axis]));
        let mut cell = self.cells[index(place, self.counts)];
        loop {
            match cell {
                Cell::List(first, last) => return &self.members[first as usize..last as usize],
                Cell::Block(first) => {
                    local = local.map(|x| x * f64::from(BLOCK_EDGE));
                    let place = local.map(|x| (x.max(0.0) as u32).min(BLOCK_EDGE - 1));
                    local = [0, 1, 2].map(|axis| local[axis] - f64::from(place[axis]));
                    cell = self.cells[first as usize + index(place, [BLOCK_EDGE; 3])];
                }
            }
        }
    }

    /// How many members a list has on average over the grid's volume.
    pub fn mean_listed(&self) -> f64 {
        let [x, y, z] = self.counts.map(|count| count as usize);
        self.mean_of(0, x * y * z)
    }

    /// The same over so many cells from a place on.
    fn mean_of(&self, first: usize, count: usize) -> f64 {
        let listed = |cell: &Cell| match *cell {
            Cell::List(from, to) => f64::from(to - from),
            Cell::Block(first) => self.mean_of(first as usize, BLOCK_EDGE.pow(3) as usize),
        };
        self.cells[first..first + count].iter().map(listed).sum::<f64>() / count as f64
    }

    /// A cube around so many cubes of the grid from a place on.
    fn cube(&self, place: [u32; 3], counts: [u32; 3]) -> Cube {
        let [x, y, z] = counts;
        let half = 0.5 * self.edge * f64::from(x.max(y).max(z));
        let center =
            [0, 1, 2].map(|axis| self.origin[axis] + 0.5 * self.edge * f64::from(2 * place[axis] + counts[axis]));
        Cube { center, half }
    }

    /// The box that the grid fills.
    pub fn bounds(&self) -> Bounds {
        let max = [0, 1, 2].map(|axis| self.origin[axis] + self.edge * f64::from(self.counts[axis]));
        Bounds { min: self.origin, max }
    }
}

fn index(place: [u32; 3], counts: [u32; 3]) -> usize {
    ((place[2] * counts[1] + place[1]) * counts[0] + place[0]) as usize
}

/// How far a member's values reach.
struct Reach {
    /// The box around the member now, and whether its values outside are at least the distance to that.
    bounds: Bounds,
    is_distance: bool,
    /// The box for all values of live numbers, and the growth that goes with it.
    all_bounds: Bounds,
    growth: f64,
    lipschitz: f64,
    /// What asking for its value takes.
    work: usize,
}

impl Reach {
    /// Whether boxes tell where its values are large.
    fn is_boxed(&self) -> bool {
        self.is_distance || self.growth.is_finite()
    }

    /// What the values in a cube are not below, as far as boxes tell.
    fn least_in(&self, cube: &Cube) -> f64 {
        let gaps = |bounds: &Bounds| {
            [0, 1, 2].map(|axis| {
                let (low, high) = (cube.center[axis] - cube.half, cube.center[axis] + cube.half);
                (bounds.min[axis] - high).max(low - bounds.max[axis]).max(0.0)
            })
        };
        let (gap, growth) = match self.is_distance {
            true => (gaps(&self.bounds).iter().map(|gap| gap * gap).sum::<f64>().sqrt(), 1.0),
            false => (gaps(&self.all_bounds).into_iter().fold(0.0, f64::max), self.growth),
        };
        // A value of zero or less is found in the box alone, of any depth; outside, one of δ not beyond growth · δ.
        if gap > 0.0 && growth.is_finite() { gap / growth.max(f64::MIN_POSITIVE) } else { f64::NEG_INFINITY }
    }
}

/// A cube by its centre and half its edge.
#[derive(Clone, Copy)]
struct Cube {
    center: [f64; 3],
    half: f64,
}

impl Cube {
    /// One of the cubes that it is divided into, so many along each edge.
    fn part(&self, place: [u32; 3], count: u32) -> Cube {
        let half = self.half / f64::from(count);
        let center = [0, 1, 2].map(|axis| {
            let across = 2.0 * f64::from(place[axis]) + 1.0 - f64::from(count);
            self.center[axis] + half * across
        });
        Cube { center, half }
    }
}

/// A cell that may still be divided.
struct Open {
    cell: usize,
    cube: Cube,
    list: Vec<u32>,
}

/// The members of a cube's list, and whether a surface may pass through the cube.
struct Pruned {
    list: Vec<u32>,
    has_surface: bool,
}

/// Cells in the making.
struct Growing<'a> {
    reaches: &'a [Reach],
    value: &'a dyn Fn(u32, [f64; 3]) -> f64,
    room: usize,
    /// The work that is left.
    work: usize,
    /// How far shaders' points may be off.
    slack: f64,
    cells: Cells,
    known: FxHashMap<Vec<u32>, Cell>,
}

impl<'a> Growing<'a> {
    fn new(reaches: &'a [Reach], value: &'a dyn Fn(u32, [f64; 3]) -> f64, room: usize) -> Self {
        let around = reaches.iter().fold(Bounds::EMPTY, |all, reach| all.union(&reach.bounds));
        let count = (CELLS_EACH * reaches.len()).clamp(LEAST_CELLS, MOST_CELLS);
        // One cube beyond the members: the farther away, the longer lists are.
        let margin = edge_for(around.size(), count).min(MARGIN * around.diagonal());
        let around = around.inflate(margin + f64::MIN_POSITIVE);
        let size = around.size();
        let edge = edge_for(size, count);
        let counts = size.map(|size| ((size / edge).ceil() as u32).max(1));
        let farthest = around.min.iter().chain(&around.max).fold(0.0, |most: f64, x| most.max(x.abs()));
        let all = counts.iter().map(|count| *count as usize).product();
        let cells = Cells { origin: around.min, edge, counts, cells: vec![Cell::List(0, 0); all], members: Vec::new() };
        let slack = ROUNDING * (farthest + around.diagonal());
        let work = LEAST_WORK + QUESTIONS_EACH * reaches.iter().map(|reach| reach.work).sum::<usize>();
        Self { reaches, value, room, work, slack, cells, known: FxHashMap::default() }
    }

    fn grown(mut self) -> Option<Cells> {
        let mut open = Vec::new();
        let all: Vec<u32> = (0..self.reaches.len() as u32).collect();
        if self.is_dense(&all) {
            return None;
        }
        self.fill([0; 3], self.cells.counts, all, &mut open)?;
        for _ in 0..MOST_DIVISIONS {
            // Where the room or the work ends, the longest lists are shortened.
            open.sort_by_key(|open| std::cmp::Reverse(open.list.len()));
            for cell in std::mem::take(&mut open) {
                if self.may_go_on() {
                    self.divide(cell, &mut open);
                }
            }
        }
        Some(self.cells).filter(|cells| cells.mean_listed() <= MOST_LISTED)
    }

    /// Whether too many members lie in each other, as far as a few cubes tell.
    fn is_dense(&mut self, all: &[u32]) -> bool {
        let [x, y, z] = self.cells.counts;
        let count = (x * y * z) as usize;
        let step = count.div_ceil(SAMPLED);
        let cubes = (0..count).step_by(step).map(|cell| {
            let cell = cell as u32;
            self.cells.cube([cell % x, cell / x % y, cell / (x * y)], [1; 3])
        });
        let cubes: Vec<Cube> = cubes.collect();
        let listed: usize = cubes.iter().map(|cube| self.pruned(all, cube, true).list.len()).sum();
        listed > MOST_LISTED_AT_FIRST * cubes.len()
    }

    /// Whether there is room, and work, for more.
    fn may_go_on(&self) -> bool {
        self.work > 0 && self.cells.cells.len() + self.cells.members.len() + self.known.len() < self.room
    }

    /// Fills the cubes of the grid from one place up to another, where these members matter: halves them first. None if that
    /// is too much.
    fn fill(&mut self, low: [u32; 3], high: [u32; 3], candidates: Vec<u32>, open: &mut Vec<Open>) -> Option<()> {
        let counts = [0, 1, 2].map(|axis| high[axis] - low[axis]);
        let longest = (0..3).fold(0, |longest, axis| if counts[axis] > counts[longest] { axis } else { longest });
        let cube = self.cells.cube(low, counts);
        if !self.may_go_on() {
            return None;
        }
        let is_cell = counts[longest] == 1;
        let pruned = self.pruned(&candidates, &cube, is_cell);
        if is_cell {
            self.place(index(low, self.cells.counts), cube, pruned, open);
            return Some(());
        }
        let middle = low[longest] + counts[longest] / 2;
        let (mut first_high, mut second_low) = (high, low);
        first_high[longest] = middle;
        second_low[longest] = middle;
        self.fill(low, first_high, pruned.list.clone(), open)?;
        self.fill(second_low, high, pruned.list, open)
    }

    /// Divides a cell into a block, if that shortens lists.
    fn divide(&mut self, Open { cell, cube, list }: Open, open: &mut Vec<Open>) {
        let places = (0..BLOCK_EDGE.pow(3))
            .map(|k| [k % BLOCK_EDGE, k / BLOCK_EDGE % BLOCK_EDGE, k / (BLOCK_EDGE * BLOCK_EDGE)]);
        let eighths: Vec<Vec<u32>> =
            (0..8).map(|k| self.pruned(&list, &cube.part([k & 1, k >> 1 & 1, k >> 2], 2), false).list).collect();
        if eighths.iter().map(Vec::len).sum::<usize>() as f64 > HOPELESS * (eighths.len() * list.len()) as f64 {
            return;
        }
        let parts: Vec<(Cube, Pruned)> = places
            .map(|place| {
                let [x, y, z] = place.map(|k| (2 * k / BLOCK_EDGE) as usize);
                let part = cube.part(place, BLOCK_EDGE);
                let pruned = self.pruned(&eighths[x + 2 * y + 4 * z], &part, true);
                (part, pruned)
            })
            .collect();
        let total: usize = parts.iter().map(|(_, part)| part.list.len()).sum();
        if total as f64 > SHORTENED * (parts.len() * list.len()) as f64 {
            return;
        }
        let first = self.cells.cells.len();
        self.cells.cells[cell] = Cell::Block(first as u32);
        self.cells.cells.resize(first + parts.len(), Cell::List(0, 0));
        for (k, (cube, pruned)) in parts.into_iter().enumerate() {
            self.place(first + k, cube, pruned, open);
        }
    }

    /// Gives a cell its list, and opens it if that is long.
    fn place(&mut self, cell: usize, cube: Cube, pruned: Pruned, open: &mut Vec<Open>) {
        self.cells.cells[cell] = self.list(&pruned.list);
        if pruned.list.len() > if pruned.has_surface { FEW } else { FEW_AWAY } {
            open.push(Open { cell, cube, list: pruned.list });
        }
    }

    /// Where a list is, which is there once.
    fn list(&mut self, list: &[u32]) -> Cell {
        if let Some(&known) = self.known.get(list) {
            return known;
        }
        let first = self.cells.members.len() as u32;
        self.cells.members.extend(list);
        let cell = Cell::List(first, self.cells.members.len() as u32);
        self.known.insert(list.to_vec(), cell);
        cell
    }

    /// The candidates that can be the nearest somewhere in a cube, which is a cell or several.
    fn pruned(&mut self, candidates: &[u32], cube: &Cube, is_cell: bool) -> Pruned {
        if candidates.len() < 2 {
            return Pruned { list: candidates.to_vec(), has_surface: true };
        }
        let within = Cube { half: cube.half + self.slack, ..*cube };
        let radius = 3f64.sqrt() * within.half;
        let boxed: Vec<(u32, f64)> =
            candidates.iter().map(|&member| (member, self.reaches[member as usize].least_in(&within))).collect();
        let mut work = candidates.len();
        let mut range = |member: u32| {
            let reach = &self.reaches[member as usize];
            work += reach.work;
            let (value, spread) = ((self.value)(member, cube.center), reach.lipschitz * radius);
            (value - spread, value + spread)
        };

        // What one with the nearest box says of the least is enough for most others.
        let nearest = boxed.iter().fold(boxed[0], |nearest, other| if other.1 < nearest.1 { *other } else { nearest });
        let mut most = range(nearest.0).1;
        let near: Vec<(u32, f64)> = boxed.into_iter().filter(|(_, least)| *least <= most).collect();
        let is_boxed = |(member, _): &(u32, f64)| self.reaches[*member as usize].is_boxed();
        if !is_cell && near.len() > TOO_MANY && near.iter().all(is_boxed) {
            self.work = self.work.saturating_sub(work);
            return Pruned { list: near.into_iter().map(|(member, _)| member).collect(), has_surface: true };
        }
        let mut asked: Vec<(u32, f64)> = Vec::with_capacity(near.len());
        for (member, least) in near {
            if least <= most {
                let (low, high) = range(member);
                most = most.min(high);
                asked.push((member, low.max(least)));
            }
        }
        self.work = self.work.saturating_sub(work);
        asked.retain(|(_, least)| *least <= most);
        let least = asked.iter().fold(f64::INFINITY, |all, (_, least)| all.min(*least));
        let has_surface = least <= 0.0 && most >= 0.0;
        Pruned { list: asked.into_iter().map(|(member, _)| member).collect(), has_surface }
    }
}

/// The edge of cubes of which about so many fill a box.
fn edge_for(size: [f64; 3], count: usize) -> f64 {
    let longest = size.into_iter().fold(0.0, f64::max);
    // Flat boxes have one layer of cubes, which must not become too many across.
    let count_with = |edge: f64| size.map(|size| (size / edge).ceil().max(1.0)).into_iter().product::<f64>();
    if longest <= 0.0 {
        return 1.0;
    }
    let mut edge = longest;
    while count_with(0.8 * edge) <= count as f64 {
        edge *= 0.8;
    }
    edge
}
