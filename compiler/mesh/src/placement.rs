//! Places a vertex for each sheet of the surface in each cell: on edges and corners where there are any, otherwise on
//! the surface amid its crossings.

use crate::Error;
use crate::crossings::Crossing;
use crate::field::{Sampler, Stage};
use crate::lattice::Lattice;
use crate::quadric::Quadric;
use crate::search::Cells;
use crate::sheets::Sheets;
use crate::vector::{Vector, add, dot, length, mean, scale, sub, unit};

/// A vertex keeps this part of a cell away from the cell's faces, so that no two are in one place even in single
/// precision.
const MARGIN: f64 = 1e-4;

/// Planes whose normals' cosine is less than this make an edge: 11.5°.
const SHARP: f64 = 0.98;

/// A vertex within this part of a cell of the surface is on it.
const CLOSE: f64 = 1e-5;

/// The vertices' points, one for each sheet.
pub(crate) fn place(
    lattice: &Lattice,
    cells: &Cells,
    crossings: &[Crossing],
    sheets: &Sheets,
    sampler: &mut Sampler,
) -> Result<Vec<Vector>, Error> {
    let mut vertices: Vec<Vertex> = (0..sheets.count())
        .map(|sheet| {
            let planes = sheets.crossings(sheet).iter().map(|crossing| {
                let crossing = &crossings[*crossing as usize];
                (crossing.point, crossing.normal)
            });
            let center = lattice.center(cells.cells[sheets.cell(sheet) as usize].site);
            Vertex::new(planes.collect(), center, (0.5 - MARGIN) * lattice.step)
        })
        .collect();
    refine(lattice, &mut vertices, sampler)?;
    fall_back(lattice, &mut vertices, sampler)?;
    Ok(vertices.into_iter().map(|vertex| vertex.point).collect())
}

struct Vertex {
    /// The crossings around: points and normals.
    planes: Vec<(Vector, Vector)>,
    /// Amid the crossings.
    middle: Vector,
    center: Vector,
    /// How far from the centre it may be along each axis.
    reach: f64,
    point: Vector,
    /// Whether the planes are those of an edge or a corner.
    sharp: bool,
}

impl Vertex {
    fn new(planes: Vec<(Vector, Vector)>, center: Vector, reach: f64) -> Self {
        let middle = mean(planes.iter().map(|(point, _)| *point));
        let mut vertex = Self { planes, middle, center, reach, point: middle, sharp: false };
        vertex.middle = vertex.confined(middle);
        vertex.sharp = is_sharp(&vertex.planes);
        vertex.point = if vertex.sharp { vertex.fit(&vertex.planes) } else { vertex.middle };
        vertex
    }

    /// Where planes meet, as near to the middle as may be.
    fn fit(&self, planes: &[(Vector, Vector)]) -> Vector {
        let corner = |reach: f64| sub(self.center.map(|coordinate| coordinate + reach), self.middle);
        let way =
            Quadric::new(self.middle, planes.iter().copied()).least_within(corner(-self.reach), corner(self.reach));
        add(self.middle, way)
    }

    fn confined(&self, point: Vector) -> Vector {
        std::array::from_fn(|axis| point[axis].clamp(self.center[axis] - self.reach, self.center[axis] + self.reach))
    }

    /// The points at which its neighbourhood is asked: its own, or a little towards each crossing, where the surfaces
    /// that meet here are each by themselves.
    fn probes(&self) -> Vec<Vector> {
        const PART: f64 = 0.1;
        match self.sharp {
            true => {
                self.planes.iter().map(|(point, _)| add(self.point, scale(sub(*point, self.point), PART))).collect()
            }
            false => vec![self.point],
        }
    }

    /// Moves to where the planes that touch the surface near it meet.
    fn learn(&mut self, tangents: &[(Vector, Vector)]) {
        let [(point, _), ..] = tangents else { return };
        match self.sharp {
            true => {
                self.point = self.fit(tangents);
                self.sharp = is_sharp(tangents);
            }
            false => self.point = self.confined(*point),
        }
    }

    /// Whether its planes meet in its point: then it need not be moved.
    fn is_exact(&self, tolerance: f64) -> bool {
        self.planes.iter().all(|(point, normal)| dot(*normal, sub(self.point, *point)).abs() < tolerance)
    }
}

fn is_sharp(planes: &[(Vector, Vector)]) -> bool {
    planes.iter().enumerate().any(|(index, (_, a))| planes[..index].iter().any(|(_, b)| dot(*a, *b) < SHARP))
}

/// Moves vertices onto the surface, or to where several surfaces meet, by Newton's method.
fn refine(lattice: &Lattice, vertices: &mut [Vertex], sampler: &mut Sampler) -> Result<(), Error> {
    const ROUNDS: usize = 3;
    let close = CLOSE * lattice.step;
    let mut open: Vec<u32> = (0..vertices.len() as u32).collect();
    open.retain(|number| {
        let vertex = &vertices[*number as usize];
        !vertex.is_exact(close)
    });
    for _ in 0..ROUNDS {
        let probes: Vec<(u32, Vector)> = (open.iter())
            .flat_map(|number| vertices[*number as usize].probes().into_iter().map(move |probe| (*number, probe)))
            .collect();
        let values = sampler.gradients(Stage::Placing, &probes, |(_, probe)| *probe)?;
        let mut tangents: Vec<(Vector, Vector)> = Vec::new();
        let mut next = Vec::new();
        for (index, ((number, probe), dual)) in probes.iter().zip(values).enumerate() {
            // The plane that touches the surface, as far as value and slope tell.
            if let Some(normal) = unit(dual.gradient) {
                let way = -dual.value / length(dual.gradient);
                if way.abs() < lattice.step {
                    tangents.push((add(*probe, scale(normal, way)), normal));
                }
            }
            if probes.get(index + 1).is_none_or(|(other, _)| other != number) {
                let vertex = &mut vertices[*number as usize];
                let before = vertex.point;
                vertex.learn(&tangents);
                tangents.clear();
                if length(sub(vertex.point, before)) > close {
                    next.push(*number);
                }
            }
        }
        open = next;
    }
    Ok(())
}

/// Where no corner was found on the surface after all, the middle of the crossings will do if it is nearer.
fn fall_back(lattice: &Lattice, vertices: &mut [Vertex], sampler: &mut Sampler) -> Result<(), Error> {
    const FAR: f64 = 0.05;
    let moved: Vec<u32> = (0..vertices.len() as u32)
        .filter(|number| vertices[*number as usize].point != vertices[*number as usize].middle)
        .collect();
    let values = sampler.distances(Stage::Placing, &moved, |number| vertices[*number as usize].point)?;
    let far: Vec<(u32, f64)> =
        moved.into_iter().zip(values).filter(|(_, value)| value.abs() > FAR * lattice.step).collect();
    let middles = sampler.distances(Stage::Placing, &far, |(number, _)| vertices[*number as usize].middle)?;
    for ((number, value), middle) in far.iter().zip(middles) {
        let vertex = &mut vertices[*number as usize];
        if middle.abs() < value.abs() {
            vertex.point = vertex.middle;
        }
    }
    Ok(())
}
