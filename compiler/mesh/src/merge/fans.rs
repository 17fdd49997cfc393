//! The triangles around each vertex, while edges collapse.

use crate::mesh::Mesh;

/// A mesh whose edges can collapse.
pub(super) struct Fans {
    triangles: Vec<[u32; 3]>,
    gone: Vec<bool>,
    /// The triangles around each vertex.
    around: Vec<Vec<u32>>,
}

impl Fans {
    pub(super) fn new(mesh: &Mesh) -> Self {
        let mut around = vec![Vec::new(); mesh.vertices.len()];
        for (triangle, corners) in mesh.triangles.iter().enumerate() {
            corners.iter().for_each(|corner| around[*corner as usize].push(triangle as u32));
        }
        Self { triangles: mesh.triangles.clone(), gone: vec![false; mesh.triangles.len()], around }
    }

    pub(super) fn corners(&self, triangle: u32) -> [u32; 3] {
        self.triangles[triangle as usize]
    }

    /// The triangles around a vertex.
    pub(super) fn of(&self, vertex: u32) -> &[u32] {
        &self.around[vertex as usize]
    }

    /// Whether a triangle is left.
    pub(super) fn has(&self, triangle: u32) -> bool {
        !self.gone[triangle as usize]
    }

    /// The triangles that are left.
    pub(super) fn left(&self) -> impl Iterator<Item = u32> {
        (0..self.triangles.len() as u32).filter(|triangle| !self.gone[*triangle as usize])
    }

    /// The vertices that share an edge with this one.
    pub(super) fn neighbours(&self, vertex: u32) -> Vec<u32> {
        let following = |triangle: &u32| {
            let corners = self.corners(*triangle);
            let place = corners.iter().position(|corner| *corner == vertex).unwrap_or(0);
            corners[(place + 1) % 3]
        };
        self.of(vertex).iter().map(following).collect()
    }

    /// The triangle that passes an edge in this direction.
    pub(super) fn triangle_at(&self, from: u32, to: u32) -> Option<u32> {
        let passes = |triangle: &u32| {
            let [a, b, c] = self.corners(*triangle);
            [(a, b), (b, c), (c, a)].contains(&(from, to))
        };
        self.of(from).iter().copied().find(passes)
    }

    /// Whether the mesh is still a surface when the edge between two vertices collapses: they have no common neighbours
    /// but the two at the edge's triangles, and those have neighbours to spare.
    pub(super) fn stays_a_surface(&self, gone: u32, kept: u32) -> bool {
        const FEWEST: usize = 4;
        let others = self.neighbours(kept);
        let common: Vec<u32> = self.neighbours(gone).into_iter().filter(|vertex| others.contains(vertex)).collect();
        common.len() == 2 && common.iter().all(|vertex| self.of(*vertex).len() >= FEWEST)
    }

    /// Replaces one end of an edge by the other.
    pub(super) fn collapse(&mut self, gone: u32, kept: u32) {
        for triangle in std::mem::take(&mut self.around[gone as usize]) {
            let corners = &mut self.triangles[triangle as usize];
            if corners.contains(&kept) {
                self.gone[triangle as usize] = true;
                for corner in *corners {
                    self.around[corner as usize].retain(|other| *other != triangle);
                }
            } else {
                corners.iter_mut().filter(|corner| **corner == gone).for_each(|corner| *corner = kept);
                self.around[kept as usize].push(triangle);
            }
        }
    }
}
