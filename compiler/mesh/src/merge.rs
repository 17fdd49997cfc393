//! Merges triangles as far as the surface stays within a tolerance.
//!
//! An edge collapses into one of its ends, so that every vertex stays where contouring placed it, on the surface. How far
//! that moves the surface is told by quadrics (Garland, Heckbert 1997): of each vertex, the sum of the squared
//! distances to the planes of all triangles that came to it. It is at least the square of the greatest of them.
//! Borders between materials count as surfaces that stand upright on the triangles beside them.

mod fans;
mod quadric;

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::Error;
use crate::field::{Sampler, Stage};
use crate::mesh::Mesh;
use crate::vector::{Vector, cross, dot, length, mean, sub, unit};
use fans::Fans;
use quadric::Quadric;

/// What is known of a triangle while meshes are merged.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Trait {
    /// The unit normal of the surface that the triangle stands for.
    pub(crate) facing: Vector,
    /// The number of its material.
    pub(crate) paint: u32,
}

/// Merges triangles; `traits` go with them. The surface stays within `tolerance`, in millimetres, and no triangle is made
/// that is flatter than `thinnest`.
pub(crate) fn merge(
    mesh: &Mesh,
    traits: &[Trait],
    tolerance: f64,
    thinnest: f64,
    sampler: &mut Sampler,
) -> Result<(Mesh, Vec<Trait>), Error> {
    let mut merger = Merger::new(mesh, traits, tolerance, thinnest);
    merger.run(sampler)?;
    let left: Vec<u32> = merger.fans.left().collect();
    let triangles = left.iter().map(|triangle| merger.fans.corners(*triangle)).collect();
    let mut merged = Mesh { vertices: mesh.vertices.clone(), triangles };
    merged.compact();
    Ok((merged, left.iter().map(|triangle| traits[*triangle as usize]).collect()))
}

/// A collapse to be tried: its cost as ordered bits, the vertex that goes and the one that stays, and how often either had
/// changed when that was found.
type Candidate = Reverse<(u64, u32, u32, u32, u32)>;

struct Merger<'a> {
    /// The vertices as seen from amid them, where quadrics are most precise.
    vertices: Vec<Vector>,
    traits: &'a [Trait],
    fans: Fans,
    quadrics: Vec<Quadric>,
    /// How often the surroundings of each vertex have changed.
    changes: Vec<u32>,
    candidates: BinaryHeap<Candidate>,
    tolerance: f64,
    thinnest: f64,
}

impl<'a> Merger<'a> {
    fn new(mesh: &'a Mesh, traits: &'a [Trait], tolerance: f64, thinnest: f64) -> Self {
        let fans = Fans::new(mesh);
        let middle = mean(mesh.vertices.iter().copied());
        let mut merger = Self {
            vertices: mesh.vertices.iter().map(|vertex| sub(*vertex, middle)).collect(),
            traits,
            quadrics: vec![Quadric::default(); mesh.vertices.len()],
            changes: vec![0; mesh.vertices.len()],
            candidates: BinaryHeap::new(),
            fans,
            tolerance,
            thinnest,
        };
        for triangle in 0..mesh.triangles.len() {
            merger.add_planes(triangle as u32);
        }
        for vertex in 0..mesh.vertices.len() as u32 {
            merger.suggest_around(vertex, |other| vertex < other);
        }
        merger
    }

    /// Adds a triangle's plane, and those of its borders, to its corners' quadrics.
    fn add_planes(&mut self, triangle: u32) {
        let corners = self.fans.corners(triangle);
        let [a, b, c] = corners.map(|corner| self.vertices[corner as usize]);
        let Some(normal) = unit(cross(sub(b, a), sub(c, a))) else { return };
        corners.iter().for_each(|corner| self.quadrics[*corner as usize].add_plane(a, normal));
        for (from, to) in [(0, 1), (1, 2), (2, 0)].map(|(from, to)| (corners[from], corners[to])) {
            let paint = self.traits[triangle as usize].paint;
            let beyond = self.fans.triangle_at(to, from);
            if beyond.is_none_or(|beyond| self.traits[beyond as usize].paint == paint) {
                continue;
            }
            let (start, end) = (self.vertices[from as usize], self.vertices[to as usize]);
            if let Some(upright) = unit(cross(sub(end, start), normal)) {
                self.quadrics[from as usize].add_plane(start, upright);
                self.quadrics[to as usize].add_plane(start, upright);
            }
        }
    }

    /// Notes the collapses between a vertex and those of its neighbours that are wanted, if they cost little enough.
    fn suggest_around(&mut self, vertex: u32, wanted: impl Fn(u32) -> bool) {
        for neighbour in self.fans.neighbours(vertex) {
            if wanted(neighbour) {
                self.suggest(vertex, neighbour);
                self.suggest(neighbour, vertex);
            }
        }
    }

    fn suggest(&mut self, gone: u32, kept: u32) {
        /// Short edges go first where nothing else tells edges apart: triangles stay rounder.
        const SHORT_FIRST: f64 = 1e-8;
        let (from, to) = (self.vertices[gone as usize], self.vertices[kept as usize]);
        let error = self.quadrics[gone as usize].at(to) + self.quadrics[kept as usize].at(to);
        if error <= self.tolerance * self.tolerance {
            let way = sub(to, from);
            let cost = error.max(0.0) + SHORT_FIRST * dot(way, way);
            let changes = [gone, kept].map(|vertex| self.changes[vertex as usize]);
            self.candidates.push(Reverse((cost.to_bits(), gone, kept, changes[0], changes[1])));
        }
    }

    fn run(&mut self, sampler: &mut Sampler) -> Result<(), Error> {
        const TOLD_EVERY: usize = 1 << 13;
        let all = self.vertices.len();
        let mut merged = 0;
        while let Some(Reverse((_, gone, kept, gone_changes, kept_changes))) = self.candidates.pop() {
            let is_new = self.changes[gone as usize] == gone_changes && self.changes[kept as usize] == kept_changes;
            if !is_new || !self.may_collapse(gone, kept) {
                continue;
            }
            self.collapse(gone, kept);
            merged += 1;
            if merged % TOLD_EVERY == 0 {
                sampler.tell(Stage::Merging, merged, all)?;
            }
        }
        Ok(())
    }

    /// Whether the mesh stays a surface, and every triangle faces where it did.
    fn may_collapse(&self, gone: u32, kept: u32) -> bool {
        self.fans.stays_a_surface(gone, kept)
            && self.fans.of(gone).iter().all(|triangle| {
                let corners = self.fans.corners(*triangle);
                corners.contains(&kept) || self.may_become(*triangle, corners, gone, kept)
            })
    }

    fn may_become(&self, triangle: u32, corners: [u32; 3], gone: u32, kept: u32) -> bool {
        /// The cosine that a triangle's normal may turn by.
        const TURN: f64 = 0.5;
        let before = corners.map(|corner| self.vertices[corner as usize]);
        let after = corners.map(|corner| self.vertices[if corner == gone { kept } else { corner } as usize]);
        let (old, new) = (Form::of(before), Form::of(after));
        let faces = |direction: Vector| dot(new.normal, direction) > TURN * length(new.normal) * length(direction);
        // The normal of a sliver says nothing.
        let turned = old.height > self.thinnest && !faces(old.normal);
        faces(self.traits[triangle as usize].facing)
            && !turned
            && new.height > self.thinnest.min(0.5 * old.height).max(f64::MIN_POSITIVE)
    }

    fn collapse(&mut self, gone: u32, kept: u32) {
        let quadric = self.quadrics[gone as usize].clone();
        self.quadrics[kept as usize].add(&quadric);
        self.fans.collapse(gone, kept);
        self.changes[gone as usize] += 1;
        self.changes[kept as usize] += 1;
        self.suggest_around(kept, |_| true);
    }
}

/// A triangle's normal, as long as twice its area, and its least height.
struct Form {
    normal: Vector,
    height: f64,
}

impl Form {
    fn of([a, b, c]: [Vector; 3]) -> Self {
        let normal = cross(sub(b, a), sub(c, a));
        let longest = [sub(b, a), sub(c, b), sub(a, c)].map(length).into_iter().fold(0.0, f64::max);
        Self { normal, height: if longest > 0.0 { length(normal) / longest } else { 0.0 } }
    }
}
