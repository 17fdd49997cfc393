//! Where a surface crosses the edges of cells, and which way it faces there.

use chiaro_vocabulary::cpu::Dual;

use crate::Error;
use crate::field::{Sampler, Stage};
use crate::lattice::Lattice;
use crate::search::{CellId, Cells};
use crate::vector::{add, dot, scale, sub, unit};

/// A point at which the surface crosses an edge of the lattice.
#[derive(Clone, Debug)]
pub(crate) struct Crossing {
    /// The cell whose least corner is the edge's lesser end.
    pub(crate) cell: CellId,
    /// The axis that the edge is parallel to.
    pub(crate) axis: usize,
    /// Whether the edge's lesser end is inside.
    pub(crate) leaves: bool,
    pub(crate) point: [f64; 3],
    /// The unit normal, outwards.
    pub(crate) normal: [f64; 3],
}

impl Crossing {
    /// The direction in which the edge leaves the solid.
    fn outwards(&self) -> [f64; 3] {
        let direction = if self.leaves { 1.0 } else { -1.0 };
        std::array::from_fn(|axis| if axis == self.axis { direction } else { 0.0 })
    }
}

/// All crossings, in the order of their cells.
pub(crate) fn crossings(lattice: &Lattice, cells: &Cells, sampler: &mut Sampler) -> Result<Vec<Crossing>, Error> {
    let mut brackets = brackets(cells);
    narrow(lattice, cells, &mut brackets, sampler)?;
    let mut crossings: Vec<Crossing> = (brackets.iter())
        .map(|bracket| {
            let point = bracket.point(lattice, cells, bracket.best);
            let leaves = bracket.values[0] < 0.0;
            Crossing { cell: bracket.cell, axis: bracket.axis, leaves, point, normal: [0.0; 3] }
        })
        .collect();
    touch(lattice, &mut crossings, sampler)?;
    Ok(crossings)
}

/// A part of an edge at whose ends the values have different signs.
struct Bracket {
    cell: CellId,
    axis: usize,
    /// The values at the edge's ends.
    values: [f64; 2],
    /// The ends of the part, from 0 to 1 along the edge, and the values there; one that stays while the other moves is
    /// halved each time (the Illinois method).
    ends: [(f64, f64); 2],
    moved: Option<usize>,
    /// The place with the least value so far, and that.
    best: f64,
    least: f64,
}

impl Bracket {
    fn point(&self, lattice: &Lattice, cells: &Cells, at: f64) -> [f64; 3] {
        let mut point = lattice.point(cells.cells[self.cell as usize].site);
        point[self.axis] += at * lattice.step;
        point
    }

    /// Where to ask next: where the chord between the ends is zero, or every third time the middle.
    fn guess(&self, round: usize) -> f64 {
        let [(a, at_a), (b, at_b)] = self.ends;
        let chord = a + (b - a) * at_a / (at_a - at_b);
        if round % 3 != 2 && chord > a && chord < b { chord } else { 0.5 * (a + b) }
    }

    fn learn(&mut self, at: f64, value: f64) {
        if value.abs() < self.least {
            (self.best, self.least) = (at, value.abs());
        }
        let end = usize::from((value < 0.0) != (self.values[0] < 0.0));
        self.ends[end] = (at, value);
        if self.moved == Some(end) {
            self.ends[1 - end].1 *= 0.5;
        }
        self.moved = Some(end);
    }
}

fn brackets(cells: &Cells) -> Vec<Bracket> {
    let mut brackets = Vec::with_capacity(2 * cells.cells.len());
    for (number, cell) in cells.cells.iter().enumerate() {
        for axis in 0..3 {
            let values = [cell.values[0], cell.values[axis + 1]];
            if (values[0] < 0.0) != (values[1] < 0.0) {
                let nearer = usize::from(values[1].abs() < values[0].abs());
                brackets.push(Bracket {
                    cell: number as CellId,
                    axis,
                    values,
                    ends: [(0.0, values[0]), (1.0, values[1])],
                    moved: None,
                    best: nearer as f64,
                    least: values[nearer].abs(),
                });
            }
        }
    }
    brackets
}

/// Narrows brackets until their values are a ten-millionth of a cell, or they are as narrow.
fn narrow(lattice: &Lattice, cells: &Cells, brackets: &mut [Bracket], sampler: &mut Sampler) -> Result<(), Error> {
    const CLOSE: f64 = 1e-7;
    const MOST_ROUNDS: usize = 60;
    let mut open: Vec<u32> = (0..brackets.len() as u32).collect();
    for round in 0..MOST_ROUNDS {
        open.retain(|number| {
            let bracket = &brackets[*number as usize];
            bracket.least > CLOSE * lattice.step && bracket.ends[1].0 - bracket.ends[0].0 > CLOSE
        });
        if open.is_empty() {
            break;
        }
        let values = sampler.distances(Stage::Crossing, &open, |number| {
            let bracket = &brackets[*number as usize];
            bracket.point(lattice, cells, bracket.guess(round))
        })?;
        for (number, value) in open.iter().zip(values) {
            let bracket = &mut brackets[*number as usize];
            bracket.learn(bracket.guess(round), value);
        }
    }
    Ok(())
}

/// Finds the planes that touch the surface at the crossings. Their points move into these, so that crossings of a flat face
/// are all in its plane, as far as double precision goes.
///
/// The gradients are those a little inside. At a crossing itself, the value of a flat face is often zero to the last digit or
/// nothing but the rounding of numbers; there a distance, which is a root, has no gradient or one of any direction.
fn touch(lattice: &Lattice, crossings: &mut [Crossing], sampler: &mut Sampler) -> Result<(), Error> {
    /// How far from the crossings gradients are asked for, in cells: no edge of a face should be between.
    const INSIDE: f64 = 1e-6;
    /// How far a point may move, in cells.
    const LITTLE: f64 = 1e-6;
    let inside = |crossing: &Crossing| add(crossing.point, scale(crossing.outwards(), -INSIDE * lattice.step));
    let gradients = sampler.gradients(Stage::Crossing, crossings, inside)?;
    let normals = normals(lattice, crossings, &gradients, sampler)?;
    for ((crossing, normal), dual) in crossings.iter_mut().zip(normals).zip(gradients) {
        let way = dot(normal, sub(inside(crossing), crossing.point)) - dual.value / dual.slope();
        if way.abs() < LITTLE * lattice.step {
            crossing.point = add(crossing.point, scale(normal, way));
        }
        crossing.normal = normal;
    }
    Ok(())
}

/// The directions of the gradients. Where one vanishes, that of differences over a thousandth of
/// a cell, or else the direction of the edge.
fn normals(
    lattice: &Lattice,
    crossings: &[Crossing],
    gradients: &[Dual],
    sampler: &mut Sampler,
) -> Result<Vec<[f64; 3]>, Error> {
    let mut normals: Vec<Option<[f64; 3]>> = gradients.iter().map(|dual| unit(dual.gradient)).collect();
    let vague: Vec<usize> = (0..normals.len()).filter(|number| normals[*number].is_none()).collect();
    let around: Vec<(usize, [f64; 3])> = (vague.iter())
        .flat_map(|number| {
            (0..6).map(move |side| (*number, std::array::from_fn(|axis| f64::from(axis == side / 2) * sign(side))))
        })
        .collect();
    let reach = 1e-3 * lattice.step;
    let values = sampler
        .distances(Stage::Crossing, &around, |(number, side)| add(crossings[*number].point, scale(*side, reach)))?;
    for (number, values) in vague.iter().zip(values.chunks_exact(6)) {
        normals[*number] = unit(sub([values[0], values[2], values[4]], [values[1], values[3], values[5]]));
    }
    Ok(normals.into_iter().zip(crossings).map(|(normal, crossing)| normal.unwrap_or(crossing.outwards())).collect())
}

fn sign(side: usize) -> f64 {
    if side.is_multiple_of(2) { 1.0 } else { -1.0 }
}
