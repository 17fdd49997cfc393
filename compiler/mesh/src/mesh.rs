//! Triangle meshes.

use rustc_hash::{FxHashMap, FxHashSet};

use crate::vector::{Vector, cross, dot};

/// A closed surface of triangles. Each edge is the side of two triangles, which pass it in opposite directions, and the
/// triangles around a vertex are one fan.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Points in millimetres; no two are the same in single precision.
    pub vertices: Vec<[f64; 3]>,
    /// The numbers of the corners, anticlockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// The points of a triangle's corners.
    pub fn corners(&self, triangle: usize) -> [[f64; 3]; 3] {
        self.triangles[triangle].map(|corner| self.vertices[corner as usize])
    }

    /// The volume within, in cubic millimetres.
    pub fn volume(&self) -> f64 {
        let sixths = (0..self.triangles.len()).map(|triangle| {
            let [a, b, c] = self.corners(triangle);
            dot(a, cross(b, c))
        });
        sixths.sum::<f64>() / 6.0
    }

    /// Whether it is what its description promises: closed, of one orientation, and a surface about each vertex.
    pub fn is_manifold(&self) -> bool {
        let mut next: FxHashMap<(u32, u32), u32> = FxHashMap::default();
        for &[a, b, c] in &self.triangles {
            for (from, to, beyond) in [(a, b, c), (b, c, a), (c, a, b)] {
                if from == to || next.insert((from, to), beyond).is_some() {
                    return false;
                }
            }
        }
        // Around a vertex, the triangle (v, a, b) is followed by the one that has the side (v, b).
        let mut degree = vec![0u32; self.vertices.len()];
        self.triangles.iter().flatten().for_each(|corner| degree[*corner as usize] += 1);
        let mut seen = vec![false; self.vertices.len()];
        let turns = self.triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
        for (vertex, first) in turns {
            if std::mem::replace(&mut seen[vertex as usize], true) {
                continue;
            }
            let (mut at, mut count) = (first, 0);
            loop {
                let Some(&beyond) = next.get(&(vertex, at)) else { return false };
                (at, count) = (beyond, count + 1);
                if at == first {
                    break;
                }
            }
            if count != degree[vertex as usize] {
                return false;
            }
        }
        true
    }

    /// Moves vertices that are the same in single precision apart, by the least that can be told.
    pub(crate) fn separate(&mut self, least: f64) {
        let mut taken: FxHashSet<[u32; 3]> = FxHashSet::default();
        for vertex in &mut self.vertices {
            while !taken.insert(vertex.map(|coordinate| (coordinate as f32).to_bits())) {
                let step = (vertex[0].abs() * f64::from(f32::EPSILON)).max(least);
                vertex[0] += step;
            }
        }
    }

    /// Leaves out vertices that no triangle has.
    pub(crate) fn compact(&mut self) {
        let mut numbers = vec![u32::MAX; self.vertices.len()];
        let mut kept: Vec<Vector> = Vec::new();
        for corner in self.triangles.iter_mut().flatten() {
            let number = &mut numbers[*corner as usize];
            if *number == u32::MAX {
                *number = kept.len() as u32;
                kept.push(self.vertices[*corner as usize]);
            }
            *corner = *number;
        }
        self.vertices = kept;
    }
}
