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

/// How far, in cells along each axis, the corner of a solid may be from the middle of a cell that has its vertex there.
const REACH: f64 = 2.5;

/// The vertices' points, one for each sheet.
pub(crate) fn place(
    lattice: &Lattice,
    cells: &Cells,
    crossings: &[Crossing],
    sheets: &Sheets,
    sampler: &mut Sampler,
) -> Result<Vec<Vector>, Error> {
    let room = Room { lattice, cells };
    let mut vertices: Vec<Vertex> = (0..sheets.count())
        .map(|sheet| {
            let planes = sheets.crossings(sheet).iter().map(|crossing| {
                let crossing = &crossings[*crossing as usize];
                (crossing.point, crossing.normal)
            });
            let center = lattice.center(cells.cells[sheets.cell(sheet) as usize].site);
            Vertex::new(planes.collect(), center, &room)
        })
        .collect();
    settle(&room, &mut vertices, sampler)?;
    share_corners(&room, sheets, &mut vertices);
    refine(&room, &mut vertices, sampler)?;
    fall_back(lattice, &mut vertices, sampler)?;
    Ok(vertices.into_iter().map(|vertex| vertex.point).collect())
}

/// Where vertices may be: in their own cells and half a cell around, for ridges that pass close by; and where a tip or a
/// ridge sticks out into a cell without a vertex, in all of that.
struct Room<'a> {
    lattice: &'a Lattice,
    cells: &'a Cells,
}

impl Room<'_> {
    /// How far a vertex may be from its cell's centre along each axis, to be in that cell.
    fn own(&self) -> f64 {
        (0.5 - MARGIN) * self.lattice.step
    }

    /// The same for the cells around.
    fn around(&self) -> f64 {
        (1.5 - MARGIN) * self.lattice.step
    }

    /// Whether the vertex of the cell with this centre may be at the point.
    fn allows(&self, center: Vector, point: Vector) -> bool {
        let farthest = sub(point, center).into_iter().fold(0.0, |farthest: f64, way| farthest.max(way.abs()));
        let is_free = || self.lattice.cell(point).is_none_or(|site| self.cells.at(site).is_none());
        farthest <= 2.0 * self.own() || (farthest <= self.around() && is_free())
    }
}

struct Vertex {
    /// The crossings around: points and normals.
    planes: Vec<(Vector, Vector)>,
    /// Amid the crossings.
    middle: Vector,
    center: Vector,
    point: Vector,
    /// Whether the planes are those of an edge or a corner.
    sharp: bool,
    /// Whether the point is where flat faces meet, and stays.
    settled: bool,
}

impl Vertex {
    fn new(planes: Vec<(Vector, Vector)>, center: Vector, room: &Room) -> Self {
        let middle = mean(planes.iter().map(|(point, _)| *point));
        let sharp = is_sharp(&planes);
        let mut vertex = Self { planes, middle, center, point: middle, sharp, settled: false };
        vertex.middle = vertex.confined(middle, room.own());
        vertex.point = if sharp { vertex.fit(&vertex.planes, room) } else { vertex.middle };
        vertex
    }

    /// Where planes meet, as near to the middle as may be.
    fn fit(&self, planes: &[(Vector, Vector)], room: &Room) -> Vector {
        let quadric = Quadric::new(self.middle, planes.iter().copied());
        let within = |reach: f64| {
            let corner = |reach: f64| sub(self.center.map(|coordinate| coordinate + reach), self.middle);
            add(self.middle, quadric.least_within(corner(-reach), corner(reach)))
        };
        let best = within(room.around());
        if room.allows(self.center, best) { best } else { within(room.own()) }
    }

    /// Where all planes meet, if they do: flat faces, which may be as good as parallel. Away from the cell, an edge may end
    /// before its nearest point is reached; then the nearest within the cell comes second.
    fn meetings(&self, room: &Room) -> Vec<Vector> {
        let close = CLOSE * room.lattice.step;
        let distinct = distinct(&self.planes, close);
        if distinct.len() < 2 {
            return Vec::new();
        }
        let quadric = Quadric::new(self.middle, distinct.iter().copied());
        let mut points = Vec::new();
        for reach in [REACH * room.lattice.step, room.own()] {
            let corner = |reach: f64| sub(self.center.map(|coordinate| coordinate + reach), self.middle);
            let point = add(self.middle, quadric.exact_within(corner(-reach), corner(reach)));
            if self.is_met_by_all(point, close) {
                points.push(point);
            }
        }
        points
    }

    /// Whether all planes go through a point.
    fn is_met_by_all(&self, point: Vector, close: f64) -> bool {
        self.planes.iter().all(|(on, normal)| dot(*normal, sub(point, *on)).abs() < close)
    }

    fn confined(&self, point: Vector, reach: f64) -> Vector {
        std::array::from_fn(|axis| point[axis].clamp(self.center[axis] - reach, self.center[axis] + reach))
    }

    /// The points at which its neighbourhood is asked: its own, or a little towards each crossing, where the surfaces
    /// that meet here are each by themselves.
    fn probes(&self) -> Vec<Vector> {
        if self.sharp { self.towards_crossings(self.point).collect() } else { vec![self.point] }
    }

    /// From a point, a little towards each crossing.
    fn towards_crossings(&self, point: Vector) -> impl Iterator<Item = Vector> {
        const PART: f64 = 0.1;
        self.planes.iter().map(move |(crossing, _)| add(point, scale(sub(*crossing, point), PART)))
    }

    /// Moves to where the planes that touch the surface near it meet.
    fn learn(&mut self, tangents: &[(Vector, Vector)], room: &Room) {
        let [(point, _), ..] = tangents else { return };
        match self.sharp {
            true => {
                self.point = self.fit(tangents, room);
                self.sharp = is_sharp(tangents);
            }
            false => self.point = self.confined(*point, room.own()),
        }
    }
}

fn is_sharp(planes: &[(Vector, Vector)]) -> bool {
    planes.iter().enumerate().any(|(index, (_, a))| planes[..index].iter().any(|(_, b)| dot(*a, *b) < SHARP))
}

/// The planes that are not the same.
fn distinct(planes: &[(Vector, Vector)], close: f64) -> Vec<(Vector, Vector)> {
    /// Unit normals whose components differ by less than this are the same.
    const PARALLEL: f64 = 1e-7;
    let mut distinct: Vec<(Vector, Vector)> = Vec::new();
    for (point, normal) in planes {
        let is_same = |(on, other): &(Vector, Vector)| {
            (0..3).all(|axis| (other[axis] - normal[axis]).abs() < PARALLEL)
                && dot(*other, sub(*point, *on)).abs() < close
        };
        if !distinct.iter().any(is_same) {
            distinct.push((*point, *normal));
        }
    }
    distinct
}

/// Puts vertices where flat faces meet, if that is on the surface, and the faces are there.
fn settle(room: &Room, vertices: &mut [Vertex], sampler: &mut Sampler) -> Result<(), Error> {
    let close = CLOSE * room.lattice.step;
    let candidates: Vec<(u32, Vector)> = (0..)
        .zip(vertices.iter())
        .flat_map(|(number, vertex)| vertex.meetings(room).into_iter().map(move |point| (number, point)))
        .collect();
    let probes: Vec<(usize, Vector)> = (candidates.iter().enumerate())
        .flat_map(|(index, (number, point))| {
            let around = vertices[*number as usize].towards_crossings(*point);
            std::iter::once(*point).chain(around).map(move |probe| (index, probe))
        })
        .collect();
    let values = sampler.distances(Stage::Placing, &probes, |(_, probe)| *probe)?;
    let mut is_there = vec![true; candidates.len()];
    for ((index, _), value) in probes.iter().zip(values) {
        is_there[*index] &= value.abs() < close;
    }
    for ((number, point), is_there) in candidates.into_iter().zip(is_there) {
        let vertex = &mut vertices[number as usize];
        if is_there && !vertex.settled {
            (vertex.point, vertex.settled) = (point, true);
        }
    }
    Ok(())
}

/// Gives a vertex the corner that one beside it has found, if its planes meet there, too: those of faces that share a corner
/// and no edge meet along a line that is elsewhere in the air.
fn share_corners(room: &Room, sheets: &Sheets, vertices: &mut [Vertex]) {
    const ROUNDS: usize = 3;
    let close = CLOSE * room.lattice.step;
    for _ in 0..ROUNDS {
        let shared: Vec<(usize, Vector)> = (0..vertices.len())
            .filter(|sheet| vertices[*sheet].sharp && !vertices[*sheet].settled)
            .filter_map(|sheet| {
                let vertex = &vertices[sheet];
                let around = sheets.crossings(sheet).iter().flat_map(|crossing| sheets.around()[*crossing as usize]);
                let corners = around.map(|other| &vertices[other as usize]).filter(|other| other.settled);
                let fits = |corner: &Vector| {
                    let farthest =
                        sub(*corner, vertex.center).into_iter().fold(0.0, |most: f64, way| most.max(way.abs()));
                    farthest < REACH * room.lattice.step && vertex.is_met_by_all(*corner, close)
                };
                corners.map(|other| other.point).find(fits).map(|corner| (sheet, corner))
            })
            .collect();
        for (sheet, corner) in shared {
            (vertices[sheet].point, vertices[sheet].settled) = (corner, true);
        }
    }
}

/// Moves vertices onto the surface, or to where several surfaces meet, by Newton's method.
fn refine(room: &Room, vertices: &mut [Vertex], sampler: &mut Sampler) -> Result<(), Error> {
    const ROUNDS: usize = 3;
    let step = room.lattice.step;
    let close = CLOSE * step;
    let mut open: Vec<u32> = (0..vertices.len() as u32).collect();
    open.retain(|number| {
        let vertex = &vertices[*number as usize];
        !vertex.settled && !vertex.is_met_by_all(vertex.point, close)
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
                if way.abs() < step {
                    tangents.push((add(*probe, scale(normal, way)), normal));
                }
            }
            if probes.get(index + 1).is_none_or(|(other, _)| other != number) {
                let vertex = &mut vertices[*number as usize];
                let before = vertex.point;
                vertex.learn(&tangents, room);
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
        .filter(|number| {
            let vertex = &vertices[*number as usize];
            !vertex.settled && vertex.point != vertex.middle
        })
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
