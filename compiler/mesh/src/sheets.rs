//! The sheets of the surface in all cells, and the crossings that each of them connects.

use crate::crossings::Crossing;
use crate::cycles::{Cycles, doubled_faces};
use crate::lattice::Site;
use crate::search::{CellId, Cells};

/// Sheets by their numbers, which are the numbers of the mesh's vertices.
pub(crate) struct Sheets {
    cells: Vec<CellId>,
    /// Of each crossing, the sheets of the four cells around its edge: anticlockwise as seen from the edge's greater end.
    around: Vec<[u32; 4]>,
    /// Where each sheet's crossings start in `crossings`.
    starts: Vec<u32>,
    crossings: Vec<u32>,
}

impl Sheets {
    /// None if the surface goes on where there are no cells.
    pub(crate) fn new(cells: &Cells, crossings: &[Crossing]) -> Option<Self> {
        let cycles = cycles(cells);
        let mut firsts = Vec::with_capacity(cycles.len());
        let mut owners = Vec::with_capacity(cycles.len());
        for (cell, cycles) in cycles.iter().enumerate() {
            firsts.push(owners.len() as u32);
            owners.extend((0..cycles.count).map(|_| cell as CellId));
        }
        let sheet = |crossing: &Crossing, at_b: u32, at_c: u32| {
            let (b, c) = ((crossing.axis + 1) % 3, (crossing.axis + 2) % 3);
            let mut site = cells.cells[crossing.cell as usize].site;
            site[b] = site[b].checked_sub(at_b)?;
            site[c] = site[c].checked_sub(at_c)?;
            let cell = cells.at(site)? as usize;
            let edge = 4 * crossing.axis + at_b as usize + 2 * at_c as usize;
            Some(firsts[cell] + u32::from(cycles[cell].of_edge[edge]))
        };
        let around = crossings.iter().map(|crossing| {
            let sheet = |at_b, at_c| sheet(crossing, at_b, at_c);
            Some([sheet(0, 0)?, sheet(1, 0)?, sheet(1, 1)?, sheet(0, 1)?])
        });
        let around: Vec<[u32; 4]> = around.collect::<Option<_>>()?;
        let (starts, listed) = by_sheet(owners.len(), &around);
        Some(Self { cells: owners, around, starts, crossings: listed })
    }

    pub(crate) fn count(&self) -> usize {
        self.cells.len()
    }

    /// The cell that a sheet is in.
    pub(crate) fn cell(&self, sheet: usize) -> CellId {
        self.cells[sheet]
    }

    /// The crossings of a sheet, three or more.
    pub(crate) fn crossings(&self, sheet: usize) -> &[u32] {
        &self.crossings[self.starts[sheet] as usize..self.starts[sheet + 1] as usize]
    }

    /// The sheets around each crossing's edge.
    pub(crate) fn around(&self) -> &[[u32; 4]] {
        &self.around
    }
}

/// How the surface goes through each cell, so that neighbours agree.
fn cycles(cells: &Cells) -> Vec<Cycles> {
    let joined = |site: Site, inside: u8| {
        let doubled = doubled_faces(inside);
        let is_joined = |face: &u8| {
            let opposite = face ^ 1;
            let beyond = neighbour(site, *face).and_then(|site| cells.at(site));
            beyond.is_some_and(|cell| doubled_faces(cells.cells[cell as usize].inside) >> opposite & 1 == 1)
        };
        (0..6).filter(|face| doubled >> face & 1 == 1).filter(is_joined).fold(0, |faces, face| faces | 1 << face)
    };
    cells.cells.iter().map(|cell| Cycles::new(cell.inside, joined(cell.site, cell.inside))).collect()
}

/// The cell beyond a face.
fn neighbour(mut site: Site, face: u8) -> Option<Site> {
    let axis = usize::from(face / 2);
    site[axis] = if face % 2 == 1 { site[axis].checked_add(1)? } else { site[axis].checked_sub(1)? };
    Some(site)
}

/// The crossings sorted by sheet, and where those of each start.
fn by_sheet(sheets: usize, around: &[[u32; 4]]) -> (Vec<u32>, Vec<u32>) {
    let mut starts = vec![0u32; sheets + 1];
    around.iter().flatten().for_each(|sheet| starts[*sheet as usize + 1] += 1);
    for sheet in 0..sheets {
        starts[sheet + 1] += starts[sheet];
    }
    let mut next = starts.clone();
    let mut listed = vec![0u32; 4 * around.len()];
    for (crossing, sheets) in around.iter().enumerate() {
        for sheet in sheets {
            listed[next[*sheet as usize] as usize] = crossing as u32;
            next[*sheet as usize] += 1;
        }
    }
    (starts, listed)
}
