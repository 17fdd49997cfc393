//! Finds the cells that a surface goes through.

use rustc_hash::FxHashMap;

use crate::Error;
use crate::field::{Sampler, Stage};
use crate::lattice::{Lattice, Site, corner, key, site};
use crate::vector::{add, length, scale, unit};

/// The most blocks of eight cells that may be left at the end: beyond, a mesh would fill some gigabytes.
const MOST_BLOCKS: usize = 4_000_000;

/// How many millions of cells the surface may go through: some four of each block.
pub(crate) const MOST_MILLIONS: usize = 16;

/// The number of a cell among those of a [`Cells`].
pub(crate) type CellId = u32;

/// The cells some of whose corners are inside and some outside.
pub(crate) struct Cells {
    pub(crate) cells: Vec<Cell>,
    /// Whether the surface was met where none of these is near: there are parts that are too thin for the lattice.
    pub(crate) misses_parts: bool,
    numbers: FxHashMap<u64, CellId>,
}

/// A cell that the surface goes through.
pub(crate) struct Cell {
    pub(crate) site: Site,
    /// Which corners are inside, as bits.
    pub(crate) inside: u8,
    /// The values at the least corner and at the ends of the three edges from there.
    pub(crate) values: [f64; 4],
}

impl Cells {
    /// The number of the cell at a site, if the surface goes through it.
    pub(crate) fn at(&self, site: Site) -> Option<CellId> {
        self.numbers.get(&key(site)).copied()
    }
}

/// All cells of the lattice whose corners are on different sides; none if they would be too many.
pub(crate) fn cells(lattice: &Lattice, sampler: &mut Sampler) -> Result<Option<Cells>, Error> {
    let Some(blocks) = blocks(lattice, sampler)? else { return Ok(None) };
    let mut numbers: FxHashMap<u64, u32> = FxHashMap::default();
    let mut points = Vec::new();
    for block in &blocks {
        for offset in 0..27 {
            let point = key([block[0] + offset % 3, block[1] + offset / 3 % 3, block[2] + offset / 9]);
            numbers.entry(point).or_insert_with(|| {
                points.push(point);
                points.len() as u32 - 1
            });
        }
    }
    let values = sampler.distances(Stage::Searching, &points, |point| lattice.point(site(*point)))?;
    let value = |site: Site| values[numbers[&key(site)] as usize];
    let mut cells = Vec::new();
    for site in blocks.iter().flat_map(|block| (0..8).map(|number| corner(*block, number))) {
        let inside = (0..8).fold(0u8, |inside, number| inside | u8::from(value(corner(site, number)) < 0.0) << number);
        if inside != 0 && inside != u8::MAX {
            let values = [0, 1, 2, 4].map(|number| value(corner(site, number)));
            cells.push(Cell { site, inside, values });
        }
    }
    let numbers = cells.iter().enumerate().map(|(number, cell)| (key(cell.site), number as CellId)).collect();
    let mut cells = Cells { cells, misses_parts: false, numbers };
    cells.misses_parts = misses_parts(lattice, &blocks, &cells, sampler)?;
    Ok(Some(cells))
}

/// Looks for the surface near some of the blocks' centres, and whether a cell is near where it is.
fn misses_parts(lattice: &Lattice, blocks: &[Site], cells: &Cells, sampler: &mut Sampler) -> Result<bool, Error> {
    const MOST_PROBES: usize = 1 << 14;
    const ROUNDS: usize = 4;
    let every = blocks.len().div_ceil(MOST_PROBES).max(1);
    let mut probes: Vec<[f64; 3]> =
        blocks.iter().step_by(every).map(|block| lattice.point(corner(*block, 7))).collect();
    let mut met = Vec::new();
    for _ in 0..ROUNDS {
        let values = sampler.gradients(Stage::Searching, &probes, |probe| *probe)?;
        let mut next = Vec::new();
        for (probe, dual) in probes.iter().zip(values) {
            let Some(normal) = unit(dual.gradient) else { continue };
            let way = -dual.value / length(dual.gradient);
            if way.abs() < 1e-3 * lattice.step {
                met.push(*probe);
            } else if way.abs() < 4.0 * lattice.step {
                next.push(add(*probe, scale(normal, way)));
            }
        }
        probes = next;
    }
    let is_missed = |point: &[f64; 3]| {
        let Some(cell) = lattice.cell(*point) else { return false };
        let around = (0..27).filter_map(|number| {
            let offset = [number % 3, number / 3 % 3, number / 9];
            let site: Option<Vec<u32>> = (0..3).map(|axis| (cell[axis] + offset[axis]).checked_sub(1)).collect();
            site.and_then(|site| cells.at([site[0], site[1], site[2]]))
        });
        around.count() == 0
    };
    met.retain(is_missed);
    has_surface(lattice, &met, sampler)
}

/// Whether the value changes its sign at any of these points, where it is zero: coincident faces of solids leave
/// zeros that are no surface.
fn has_surface(lattice: &Lattice, zeros: &[[f64; 3]], sampler: &mut Sampler) -> Result<bool, Error> {
    /// How far to both sides is looked, in cells.
    const REACHES: [f64; 5] = [0.002, 0.01, 0.05, 0.2, 0.5];
    const MOST_LOOKED_AT: usize = 512;
    let every = zeros.len().div_ceil(MOST_LOOKED_AT).max(1);
    let zeros: Vec<[f64; 3]> = zeros.iter().step_by(every).copied().collect();
    let gradients = sampler.gradients(Stage::Searching, &zeros, |zero| *zero)?;
    let beside: Vec<[f64; 3]> = (zeros.iter().zip(gradients))
        .flat_map(|(zero, dual)| {
            let normal = unit(dual.gradient).unwrap_or([0.0, 0.0, 1.0]);
            REACHES
                .iter()
                .flat_map(move |reach| [*reach, -reach].map(|by| add(*zero, scale(normal, by * lattice.step))))
        })
        .collect();
    let values = sampler.distances(Stage::Searching, &beside, |point| *point)?;
    let changes = |values: &[f64]| values.iter().any(|value| *value < 0.0) && values.iter().any(|value| *value > 0.0);
    Ok(values.chunks(2 * REACHES.len()).any(changes))
}

/// Blocks of eight cells, by the least corner, that the surface may go through; none if they would be too many.
///
/// Theory: a value is at most the Lipschitz constant times the distance to the surface; so a cube whose centre's value is
/// more than that for half its diagonal is on one side.
fn blocks(lattice: &Lattice, sampler: &mut Sampler) -> Result<Option<Vec<Site>>, Error> {
    let longest = lattice.cells.iter().fold(2, |longest: u32, cells| longest.max(*cells));
    let mut side = longest.next_power_of_two();
    let mut blocks: Vec<Site> = vec![[0; 3]];
    loop {
        let values = sampler.distances(Stage::Searching, &blocks, |block| {
            lattice.point(block.map(|coordinate| coordinate + side / 2))
        })?;
        let reach = 0.5 * 3.0f64.sqrt() * lattice.step * f64::from(side) * sampler.field().lipschitz() * (1.0 + 1e-9);
        let mut values = values.into_iter();
        // What has no value is looked at more closely.
        blocks.retain(|_| !values.next().is_some_and(|value| value.abs() > reach));
        if are_too_many(blocks.len(), side) {
            return Ok(None);
        }
        if side == 2 {
            return Ok(Some(blocks));
        }
        side /= 2;
        let parts = |block: &Site| {
            let block = *block;
            (0..8).map(move |number| std::array::from_fn(|axis| block[axis] + side * (number >> axis & 1)))
        };
        blocks = blocks.iter().flat_map(parts).filter(|part| lattice.has(*part)).collect();
    }
}

/// A surface fills four times the blocks at half their side: what will be too much is seen early.
fn are_too_many(blocks: usize, side: u32) -> bool {
    const MANY: usize = 4096;
    let expected = blocks as f64 * 4f64.powi((side / 2).ilog2() as i32);
    blocks > MOST_BLOCKS || (blocks > MANY && 0.7 * expected > MOST_BLOCKS as f64)
}
