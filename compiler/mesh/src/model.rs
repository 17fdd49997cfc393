//! From a field to a mesh with materials.

use chiaro_field::{Bounds, Look};

use crate::Error;
use crate::contour::{Contour, contour};
use crate::field::{Field, Sampler, Stage, Watch};
use crate::flakes::without_flakes;
use crate::flatten::flatten;
use crate::lattice::{Lattice, MOST_CELLS};
use crate::merge::{Limits, Trait, merge};
use crate::mesh::Mesh;
use crate::vector::{Vector, add, dot, mean, scale, sub, unit};

/// How fine a mesh is to be. Where both are open, the tolerance is a two-thousandth of the scene's diagonal.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Detail {
    /// How far, in millimetres, the mesh may be off the surface; positive.
    pub tolerance: Option<f64>,
    /// How many cells are along the longest side, which decides what is too thin to be found. If it is open, it is chosen by
    /// the tolerance.
    pub resolution: Option<u32>,
}

/// A mesh with its materials.
#[derive(Clone, Debug)]
pub struct Model {
    /// The surface.
    pub mesh: Mesh,
    /// The looks of materials.
    pub materials: Vec<Look>,
    /// The number of each triangle's material.
    pub painted: Vec<u32>,
    /// How the surface is at each triangle's corners, just within the triangle.
    pub corners: Vec<[Corner; 3]>,
    /// How the mesh came out.
    pub report: Report,
}

/// The surface at a corner of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// The unit normal, outwards.
    pub normal: [f64; 3],
    /// Linear red, green and blue, and opacity. It differs from the material's where materials blend.
    pub color: [f64; 4],
}

/// How a mesh came out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Report {
    /// The length of a cell's edges, in millimetres.
    pub cell: f64,
    /// How far off the surface, in millimetres, the mesh was to be at the most.
    pub tolerance: f64,
    /// How far off the surface it is, in millimetres, in the middles of 99 of 100 triangles.
    pub deviation: f64,
    /// Whether there are parts that are too thin for the cells, and so are missing.
    pub misses_parts: bool,
}

impl Model {
    /// Whether colours change within triangles.
    pub fn is_blended(&self) -> bool {
        let of_materials = self.painted.iter().map(|material| self.materials[*material as usize].color);
        of_materials.zip(&self.corners).any(|(color, corners)| corners.iter().any(|corner| corner.color != color))
    }
}

/// The tolerance of scenes for which none is given, as a part of their diagonal.
const TOLERANCE: f64 = 1.0 / 2000.0;
/// The resolution that a search for the right one starts from.
const FIRST_RESOLUTION: u32 = 96;
/// The highest resolution that is chosen for a given tolerance, and without one.
const HIGHEST_RESOLUTION: [u32; 2] = [1024, 256];

/// Makes a mesh of the field's surface.
pub fn model(field: &dyn Field, detail: &Detail, watch: &mut Watch) -> Result<Model, Error> {
    let bounds = bounded(field)?;
    let tolerance = detail.tolerance.unwrap_or(TOLERANCE * bounds.diagonal());
    let mut sampler = Sampler::new(field, watch);
    let (contour, cell) = match detail.resolution {
        Some(resolution) => at_resolution(&bounds, resolution, &mut sampler)?,
        None => {
            let highest = HIGHEST_RESOLUTION[usize::from(detail.tolerance.is_none())];
            within_tolerance(&bounds, 0.5 * tolerance, highest, &mut sampler)?
        }
    };
    let Contour { mesh, facing, misses_parts } = contour;
    let paints = paints(&mesh, &mut sampler)?;
    let traits: Vec<Trait> = facing.into_iter().zip(paints).map(|(facing, paint)| Trait { facing, paint }).collect();
    // Vertices that are nearer to each other than some programs can tell would be one.
    let apart = APART * bounds.diagonal();
    let limits = Limits { tolerance: 0.5 * tolerance, thinnest: THINNEST * cell, shortest: apart.max(SHORTEST * cell) };
    let (mesh, traits) = merge(&mesh, &traits, limits, &mut sampler)?;
    let (mesh, traits) = flatten(mesh, traits, FLAT * cell);
    let (mut mesh, traits) = without_flakes(mesh, traits, apart);
    mesh.separate(apart);
    mesh.round(ROUND * bounds.diagonal());
    let deviation = deviation(&mesh, &mut sampler)?;
    let corners = corners(&mesh, &traits, &mut sampler)?;
    let report = Report { cell, tolerance, deviation, misses_parts };
    let painted = traits.into_iter().map(|known| known.paint).collect();
    Ok(Model { mesh, materials: field.materials(), painted, corners, report })
}

/// Merging makes no triangles that are lower than this part of a cell.
const THINNEST: f64 = 1e-2;
/// Edges that are shorter than this part of a cell have no length.
const SHORTEST: f64 = 1e-4;
/// What is nearer than this part of a cell to a plane is in it.
const FLAT: f64 = 2e-4;
/// So far apart, as a part of the diagonal of the scene's box, are any two vertices.
const APART: f64 = 2e-6;
/// Coordinates are multiples of about this part of the diagonal: what was to be 0 is 0.
const ROUND: f64 = 1e-10;

/// The box of a field, if that is finite, has something in it, and is near enough for the numbers of meshes.
fn bounded(field: &dyn Field) -> Result<Bounds, Error> {
    let bounds = field.bounds();
    if bounds.is_empty() || bounds.diagonal() == 0.0 {
        return Err(Error::Empty);
    }
    let endless = (0..3).filter(|axis| !(bounds.min[*axis].is_finite() && bounds.max[*axis].is_finite()));
    let names: Vec<&str> = endless.map(|axis| ["x", "y", "z"][axis]).collect();
    if !names.is_empty() {
        return Err(Error::Unbounded { axes: names.join(", ") });
    }
    let (size, far) = (bounds.diagonal(), (0..3).map(|axis| bounds.axis(axis).magnitude()).fold(0.0, f64::max));
    let rounding = far * f64::from(f32::EPSILON);
    if rounding > TOLERANCE * size { Err(Error::TooFar { size, far, rounding }) } else { Ok(bounds) }
}

fn at_resolution(bounds: &Bounds, resolution: u32, sampler: &mut Sampler) -> Result<(Contour, f64), Error> {
    let too_fine = Error::TooFine { resolution, most: crate::search::MOST_MILLIONS };
    if resolution > MOST_CELLS {
        return Err(too_fine);
    }
    let lattice = Lattice::around(bounds, resolution);
    let Some(contour) = contour(&lattice, sampler)? else { return Err(too_fine) };
    if contour.mesh.triangles.is_empty() {
        return Err(Error::NothingFound { cell: lattice.step, resolution });
    }
    Ok((contour, lattice.step))
}

/// Chooses the resolution so that the mesh is within the tolerance and nothing is missing, if the highest one will do for
/// that.
fn within_tolerance(
    bounds: &Bounds,
    tolerance: f64,
    highest: u32,
    sampler: &mut Sampler,
) -> Result<(Contour, f64), Error> {
    let mut resolution = FIRST_RESOLUTION;
    loop {
        let attempt = at_resolution(bounds, resolution, sampler);
        let finer = match &attempt {
            Err(Error::NothingFound { .. }) => 2.0,
            Err(_) => return attempt,
            Ok((contour, _)) => {
                // The distance of a chord from its arc goes with the square of its length.
                let off = (deviation(&contour.mesh, sampler)? / tolerance).sqrt();
                if off > 1.0 || contour.misses_parts { (1.1 * off).clamp(1.3, 4.0) } else { 1.0 }
            }
        };
        if finer == 1.0 || resolution == highest {
            return attempt;
        }
        resolution = ((f64::from(resolution) * finer).ceil() as u32).min(highest);
    }
}

/// How far the mesh is off the surface in the middles of 99 of 100 of its triangles, as far as some thousands of them tell.
fn deviation(mesh: &Mesh, sampler: &mut Sampler) -> Result<f64, Error> {
    const MOST_PROBES: usize = 1 << 13;
    let every = mesh.triangles.len().div_ceil(MOST_PROBES).max(1);
    let middles: Vec<Vector> =
        (0..mesh.triangles.len()).step_by(every).map(|triangle| mean(mesh.corners(triangle).into_iter())).collect();
    let values = sampler.gradients(Stage::Placing, &middles, |middle| *middle)?;
    let mut distances: Vec<f64> = (values.into_iter())
        .map(|dual| dual.value.abs() / dual.slope())
        .filter(|distance| distance.is_finite())
        .collect();
    distances.sort_unstable_by(f64::total_cmp);
    Ok(distances.get(distances.len() * 99 / 100).copied().unwrap_or(0.0))
}

/// The number of each triangle's material.
fn paints(mesh: &Mesh, sampler: &mut Sampler) -> Result<Vec<u32>, Error> {
    if let Some(look) = sampler.field().only_look() {
        return Ok(vec![look.paint.0 as u32; mesh.triangles.len()]);
    }
    let triangles: Vec<usize> = (0..mesh.triangles.len()).collect();
    let looks = sampler.looks(Stage::Painting, &triangles, |triangle| mean(mesh.corners(*triangle).into_iter()))?;
    Ok(looks.into_iter().map(|look| look.paint.0 as u32).collect())
}

/// The surface at the triangles' corners.
fn corners(mesh: &Mesh, traits: &[Trait], sampler: &mut Sampler) -> Result<Vec<[Corner; 3]>, Error> {
    /// A gradient that is turned further from the triangle's face is that of another surface.
    const SAME_SIDE: f64 = 0.5;
    let points: Vec<Vector> =
        (0..mesh.triangles.len()).flat_map(|triangle| just_within(mesh.corners(triangle))).collect();
    let gradients = sampler.gradients(Stage::Painting, &points, |point| *point)?;
    let materials = sampler.field().materials();
    let looks = match sampler.field().only_look() {
        Some(look) => vec![look; points.len()],
        None => sampler.looks(Stage::Painting, &points, |point| *point)?,
    };
    let corner = |index: usize| {
        let known = &traits[index / 3];
        let own = materials[known.paint as usize].color;
        // Beside a border, a point may be beyond it; what blends is like no material.
        let is_pure = looks[index].color == materials[looks[index].paint.0].color;
        let normal = unit(gradients[index].gradient).filter(|normal| dot(*normal, known.facing) > SAME_SIDE);
        Corner { normal: normal.unwrap_or(known.facing), color: if is_pure { own } else { looks[index].color } }
    };
    let mut corners: Vec<Corner> = (0..points.len()).map(corner).collect();
    smooth(mesh, &mut corners);
    Ok(corners.chunks_exact(3).map(|corners| [corners[0], corners[1], corners[2]]).collect())
}

/// Gives the corners at a vertex one normal where they are less than 25° apart: there the surface is smooth.
fn smooth(mesh: &Mesh, corners: &mut [Corner]) {
    const ALIKE: f64 = 0.9;
    let mut at_vertex: Vec<Vec<usize>> = vec![Vec::new(); mesh.vertices.len()];
    for (index, vertex) in mesh.triangles.iter().flatten().enumerate() {
        at_vertex[*vertex as usize].push(index);
    }
    for mut open in at_vertex {
        while let Some(first) = open.last().map(|index| corners[*index].normal) {
            let (alike, others): (Vec<usize>, Vec<usize>) =
                open.into_iter().partition(|index| dot(corners[*index].normal, first) > ALIKE);
            let normal = unit(mean(alike.iter().map(|index| corners[*index].normal))).unwrap_or(first);
            alike.iter().for_each(|index| corners[*index].normal = normal);
            open = others;
        }
    }
}

/// Points near the corners of a triangle, where no other surface is as near as its own.
fn just_within(corners: [Vector; 3]) -> [Vector; 3] {
    const PART: f64 = 0.05;
    let middle = mean(corners.into_iter());
    corners.map(|corner| add(corner, scale(sub(middle, corner), PART)))
}
