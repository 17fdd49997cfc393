//! The flat faces of a mesh and their outlines.

use rustc_hash::{FxHashMap, FxHashSet};

use crate::merge::Trait;
use crate::mesh::Mesh;
use crate::vector::{Vector, cross, dot, length, sub};

/// Stands for the face of a triangle that is in none.
pub(super) const CURVED: u32 = u32::MAX;

/// Unit normals whose components differ by less than this are those of one plane.
const PARALLEL: f64 = 1e-6;

/// The closed outlines of a face: around it anticlockwise, around its holes clockwise.
pub(super) type Outline = Vec<Vec<u32>>;

/// The flat faces of a mesh.
pub(super) struct Faces<'a> {
    mesh: &'a Mesh,
    flat: f64,
    /// The face of each triangle, or [`CURVED`].
    pub(super) of: Vec<u32>,
    /// What is known of the triangles of each face.
    pub(super) planes: Vec<Trait>,
    /// The triangle that passes each edge in this direction.
    passes: FxHashMap<(u32, u32), u32>,
}

impl<'a> Faces<'a> {
    pub(super) fn new(mesh: &'a Mesh, traits: &[Trait], flat: f64) -> Self {
        let mut passes = FxHashMap::default();
        for (triangle, corners) in mesh.triangles.iter().enumerate() {
            passes.extend(edges(*corners).map(|edge| (edge, triangle as u32)));
        }
        let of = vec![CURVED; mesh.triangles.len()];
        let mut faces = Self { mesh, flat, of, planes: Vec::new(), passes };
        for seed in 0..mesh.triangles.len() {
            faces.grow(seed, traits);
        }
        faces
    }

    /// Makes the face that a triangle is in, unless it has one or is not in the plane that it stands for.
    fn grow(&mut self, seed: usize, traits: &[Trait]) {
        let known = traits[seed];
        let height = dot(self.mesh.corners(seed)[0], known.facing);
        let is_in = |of: &[u32], triangle: usize| {
            let other = &traits[triangle];
            let is_parallel = (0..3).all(|axis| (other.facing[axis] - known.facing[axis]).abs() < PARALLEL);
            let is_level = |corner: Vector| (dot(corner, known.facing) - height).abs() < self.flat;
            of[triangle] == CURVED
                && other.paint == known.paint
                && is_parallel
                && self.mesh.corners(triangle).into_iter().all(is_level)
        };
        if !is_in(&self.of, seed) {
            return;
        }
        let face = self.planes.len() as u32;
        self.of[seed] = face;
        let mut open = vec![seed];
        while let Some(triangle) = open.pop() {
            for (from, to) in edges(self.mesh.triangles[triangle]) {
                let beyond = self.passes[&(to, from)] as usize;
                if is_in(&self.of, beyond) {
                    self.of[beyond] = face;
                    open.push(beyond);
                }
            }
        }
        self.planes.push(known);
    }

    /// Leaves the triangles of these faces as they are.
    pub(super) fn give_up(&mut self, faces: &[u32]) {
        let faces: FxHashSet<u32> = faces.iter().copied().collect();
        self.of.iter_mut().filter(|face| faces.contains(face)).for_each(|face| *face = CURVED);
    }

    /// The outlines of all faces, through the vertices that are needed. A face without any has been given up, or is
    /// nothing but an edge.
    pub(super) fn outlines(&self) -> Vec<Outline> {
        let mut all = self.whole_outlines();
        let needed = self.needed(&all);
        for outlines in &mut all {
            outlines.iter_mut().for_each(|outline| outline.retain(|vertex| needed[*vertex as usize]));
            outlines.retain(|outline| outline.len() > 2);
        }
        all
    }

    /// The outlines through all vertices.
    fn whole_outlines(&self) -> Vec<Outline> {
        let mut all = vec![Outline::new(); self.planes.len()];
        let mut seen: FxHashSet<(u32, u32)> = FxHashSet::default();
        for (triangle, corners) in self.mesh.triangles.iter().enumerate() {
            for start in edges(*corners) {
                if self.of[triangle] == CURVED || !self.is_border(start) || seen.contains(&start) {
                    continue;
                }
                let mut outline = Vec::new();
                let mut edge = start;
                while seen.insert(edge) {
                    outline.push(edge.0);
                    edge = self.following(edge);
                }
                all[self.of[triangle] as usize].push(outline);
            }
        }
        all
    }

    /// Whether an edge has another face on its other side, or none.
    fn is_border(&self, (from, to): (u32, u32)) -> bool {
        let [own, other] = [(from, to), (to, from)].map(|edge| self.of[self.passes[&edge] as usize]);
        own == CURVED || own != other
    }

    /// The edge that follows on the border of a face.
    fn following(&self, (from, to): (u32, u32)) -> (u32, u32) {
        let mut next = self.next((from, to));
        while !self.is_border(next) {
            next = self.next((next.1, next.0));
        }
        next
    }

    /// The edge that follows around a triangle.
    fn next(&self, edge: (u32, u32)) -> (u32, u32) {
        let around = edges(self.mesh.triangles[self.passes[&edge] as usize]);
        let place = around.iter().position(|other| *other == edge).unwrap_or(0);
        around[(place + 1) % 3]
    }

    /// Which vertices are needed: those that are not between two faces alone, or not on a straight edge.
    fn needed(&self, all: &[Outline]) -> Vec<bool> {
        let mut needed = vec![false; self.mesh.vertices.len()];
        let mut borders = vec![0u32; self.mesh.vertices.len()];
        for corners in &self.mesh.triangles {
            for edge in edges(*corners) {
                let is_border = self.is_border(edge);
                borders[edge.0 as usize] += u32::from(is_border);
                let is_curved = is_border && self.of[self.passes[&edge] as usize] == CURVED;
                [edge.0, edge.1].iter().filter(|_| is_curved).for_each(|vertex| needed[*vertex as usize] = true);
            }
        }
        (needed.iter_mut().zip(borders)).for_each(|(needed, borders)| *needed |= borders > 2);
        for outline in all.iter().flatten() {
            let bent: Vec<u32> = sides(outline, &needed).flat_map(|side| self.bent(&side)).collect();
            bent.into_iter().for_each(|vertex| needed[vertex as usize] = true);
        }
        needed
    }

    /// The vertices between the ends of a side, if it is not straight.
    fn bent(&self, side: &[u32]) -> Vec<u32> {
        /// How much farther than from its plane a vertex may be from an edge.
        const OFF: f64 = 10.0;
        let at = |vertex: &u32| self.mesh.vertices[*vertex as usize];
        let [first, inner @ .., last] = side else { return Vec::new() };
        let way = sub(at(last), at(first));
        let size = length(way);
        let is_off = |vertex: &u32| {
            let off = length(cross(sub(at(vertex), at(first)), way)) / size;
            off.is_nan() || off > OFF * self.flat
        };
        if inner.iter().any(is_off) { inner.to_vec() } else { Vec::new() }
    }
}

/// The sides of an outline, each from one needed vertex to the next; all of it, if there is none.
fn sides<'a>(outline: &'a [u32], needed: &'a [bool]) -> impl Iterator<Item = Vec<u32>> + 'a {
    let ends: Vec<usize> = (0..outline.len()).filter(|place| needed[outline[*place] as usize]).collect();
    let closed = ends.is_empty().then_some((0, outline.len()));
    let between = (0..ends.len()).map(move |number| {
        let (from, to) = (ends[number], ends[(number + 1) % ends.len()]);
        (from, if to > from { to } else { to + outline.len() })
    });
    let side = |(from, to): (usize, usize)| (from..=to).map(|place| outline[place % outline.len()]).collect();
    closed.into_iter().chain(between).map(side)
}

fn edges([a, b, c]: [u32; 3]) -> [(u32, u32); 3] {
    [(a, b), (b, c), (c, a)]
}
