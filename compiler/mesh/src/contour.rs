//! Manifold dual contouring: a quadrilateral for each edge of the lattice that the surface crosses, whose corners are the
//! vertices of the sheets around (Ju, Losasso, Schaefer, Warren 2002; sheets after Nielson 2004).

use crate::Error;
use crate::crossings::{Crossing, crossings};
use crate::field::{Sampler, Stage};
use crate::lattice::Lattice;
use crate::mesh::Mesh;
use crate::placement::place;
use crate::search::cells;
use crate::sheets::Sheets;
use crate::vector::{Vector, add, cross, dot, length, scale, sub};

/// The surface in a lattice, as triangles of the size of its cells.
pub(crate) struct Contour {
    pub(crate) mesh: Mesh,
    /// The unit normal of the surface that each triangle stands for.
    pub(crate) facing: Vec<Vector>,
    /// Whether there are parts of the solid that are too thin for the lattice.
    pub(crate) misses_parts: bool,
}

/// The surface in the lattice; none if it goes through too many cells.
pub(crate) fn contour(lattice: &Lattice, sampler: &mut Sampler) -> Result<Option<Contour>, Error> {
    let Some(cells) = cells(lattice, sampler)? else { return Ok(None) };
    let crossings = crossings(lattice, &cells, sampler)?;
    let sheets = Sheets::new(&cells, &crossings).ok_or(Error::BeyondBounds)?;
    let vertices = place(lattice, &cells, &crossings, &sheets, sampler)?;
    let quads: Vec<Quad> = sheets
        .around()
        .iter()
        .zip(&crossings)
        .map(|(corners, crossing)| Quad::new(*corners, crossing, &vertices))
        .collect();
    let triangles = triangles(lattice, &quads, &vertices, sampler)?;
    let facing = crossings.iter().flat_map(|crossing| [crossing.normal; 2]).collect();
    Ok(Some(Contour { mesh: Mesh { vertices, triangles }, facing, misses_parts: cells.misses_parts }))
}

struct Quad {
    /// Anticlockwise seen from outside.
    corners: [u32; 4],
    /// Which diagonal cuts it so that both halves face outwards; none if both do or neither does.
    better: Option<Diagonal>,
    /// The middles of the two diagonals.
    middles: [Vector; 2],
}

/// The diagonals of a quadrilateral.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Diagonal {
    /// Between the first and the third corner.
    First,
    Second,
}

impl Quad {
    fn new(mut corners: [u32; 4], crossing: &Crossing, vertices: &[Vector]) -> Self {
        if !crossing.leaves {
            corners.reverse();
        }
        let at = corners.map(|corner| vertices[corner as usize]);
        let faces = |diagonal: Diagonal| {
            let heights = halves(diagonal).map(|half| {
                let [a, b, c] = half.map(|corner| at[corner]);
                dot(cross(sub(b, a), sub(c, a)), crossing.normal)
            });
            heights.iter().all(|height| *height > 0.0)
        };
        let better = match (faces(Diagonal::First), faces(Diagonal::Second)) {
            (true, false) => Some(Diagonal::First),
            (false, true) => Some(Diagonal::Second),
            _ => None,
        };
        let middle = |a: usize, b: usize| scale(add(at[a], at[b]), 0.5);
        Self { corners, better, middles: [middle(0, 2), middle(1, 3)] }
    }

    fn cut(&self, diagonal: Diagonal) -> [[u32; 3]; 2] {
        halves(diagonal).map(|half| half.map(|corner| self.corners[corner]))
    }
}

fn halves(diagonal: Diagonal) -> [[usize; 3]; 2] {
    match diagonal {
        Diagonal::First => [[0, 1, 2], [0, 2, 3]],
        Diagonal::Second => [[0, 1, 3], [1, 2, 3]],
    }
}

/// Cuts each quadrilateral along the diagonal that is nearer to the surface, where the two differ.
fn triangles(
    lattice: &Lattice,
    quads: &[Quad],
    vertices: &[Vector],
    sampler: &mut Sampler,
) -> Result<Vec<[u32; 3]>, Error> {
    const DIFFERENT: f64 = 1e-4;
    let bent: Vec<usize> = (0..quads.len())
        .filter(|number| {
            let [first, second] = quads[*number].middles;
            quads[*number].better.is_none() && length(sub(first, second)) > DIFFERENT * lattice.step
        })
        .collect();
    let middles: Vec<Vector> = bent.iter().flat_map(|number| quads[*number].middles).collect();
    let values = sampler.distances(Stage::Placing, &middles, |middle| *middle)?;
    let mut diagonals: Vec<Diagonal> =
        (quads.iter()).map(|quad| quad.better.unwrap_or_else(|| shorter(quad, vertices))).collect();
    for (number, values) in bent.iter().zip(values.chunks_exact(2)) {
        let nearer = values[0].abs() <= values[1].abs();
        diagonals[*number] = if nearer { Diagonal::First } else { Diagonal::Second };
    }
    Ok(quads.iter().zip(diagonals).flat_map(|(quad, diagonal)| quad.cut(diagonal)).collect())
}

fn shorter(quad: &Quad, vertices: &[Vector]) -> Diagonal {
    let [a, b, c, d] = quad.corners.map(|corner| vertices[corner as usize]);
    if length(sub(c, a)) <= length(sub(d, b)) { Diagonal::First } else { Diagonal::Second }
}
