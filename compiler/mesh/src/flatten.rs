//! Gives flat faces as few triangles as they need.
//!
//! A *face* is a connected set of triangles in one plane and of one material. A vertex amid a face, or on the straight
//! edge between two faces, is not needed. So each face is triangulated anew from its outlines, without these: n corners and
//! h holes come to n + 2 h − 2 triangles. What is curved stays as it is.

mod faces;
mod triangulate;

use rustc_hash::FxHashMap;

use crate::merge::Trait;
use crate::mesh::Mesh;
use faces::{CURVED, Faces};
use triangulate::triangulate;

/// The mesh with as few triangles as its flat faces need, where what is within `flat`, in millimetres, of a plane is in it.
pub(crate) fn flatten(mesh: Mesh, traits: Vec<Trait>, flat: f64) -> (Mesh, Vec<Trait>) {
    let mut faces = Faces::new(&mesh, &traits, flat);
    loop {
        let outlines = faces.outlines();
        let mut triangles = Triangles::default();
        let mut failed = Vec::new();
        for (triangle, corners) in mesh.triangles.iter().enumerate() {
            if faces.of[triangle] == CURVED {
                triangles.add(*corners, traits[triangle], CURVED, &mut failed);
            }
        }
        for (number, outline) in outlines.iter().enumerate() {
            let plane = &faces.planes[number];
            match triangulate(outline, &mesh.vertices, plane.facing) {
                Some(corners) => {
                    corners.into_iter().for_each(|corners| triangles.add(corners, *plane, number as u32, &mut failed));
                }
                None => failed.push(number as u32),
            }
        }
        failed.retain(|face| *face != CURVED);
        if !failed.is_empty() {
            // Their outlines cross themselves or each other: they stay as they are.
            faces.give_up(&failed);
            continue;
        }
        let mut flattened = Mesh { vertices: mesh.vertices.clone(), triangles: triangles.corners };
        flattened.compact();
        return if flattened.is_manifold() { (flattened, triangles.traits) } else { (mesh, traits) };
    }
}

/// Triangles of a new mesh.
#[derive(Default)]
struct Triangles {
    corners: Vec<[u32; 3]>,
    traits: Vec<Trait>,
    /// The face that passes each edge.
    passes: FxHashMap<(u32, u32), u32>,
}

impl Triangles {
    /// Adds a triangle of a face. If another one passes an edge in the same direction, both faces are noted.
    fn add(&mut self, [a, b, c]: [u32; 3], known: Trait, face: u32, failed: &mut Vec<u32>) {
        for edge in [(a, b), (b, c), (c, a)] {
            if let Some(other) = self.passes.insert(edge, face) {
                failed.extend([face, other]);
            }
        }
        self.corners.push([a, b, c]);
        self.traits.push(known);
    }
}
