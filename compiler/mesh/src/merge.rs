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

/// How far merging may go, in millimetres.
pub(crate) struct Limits {
    /// The surface stays within this.
    pub(crate) tolerance: f64,
    /// No triangle is made that is lower than this.
    pub(crate) thinnest: f64,
    /// Edges that are shorter than this collapse, whatever becomes of the triangles around.
    pub(crate) shortest: f64,
}

/// Merges triangles; `traits` go with them.
pub(crate) fn merge(
    mesh: &Mesh,
    traits: &[Trait],
    limits: Limits,
    sampler: &mut Sampler,
) -> Result<(Mesh, Vec<Trait>), Error> {
    let mut merger = Merger::new(mesh, traits, limits);
    // What is gone may have been in the way of others.
    while merger.run(sampler)? | merger.weld() {}
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
    limits: Limits,
}

impl<'a> Merger<'a> {
    fn new(mesh: &'a Mesh, traits: &'a [Trait], limits: Limits) -> Self {
        let fans = Fans::new(mesh);
        let middle = mean(mesh.vertices.iter().copied());
        let mut merger = Self {
            vertices: mesh.vertices.iter().map(|vertex| sub(*vertex, middle)).collect(),
            traits,
            quadrics: vec![Quadric::default(); mesh.vertices.len()],
            changes: vec![0; mesh.vertices.len()],
            candidates: BinaryHeap::new(),
            fans,
            limits,
        };
        while merger.weld() {}
        let left: Vec<u32> = merger.fans.left().collect();
        left.into_iter().for_each(|triangle| merger.add_planes(triangle));
        merger
    }

    /// Collapses edges that are next to nothing, since vertices of several cells may be put on the same corner. Answers
    /// whether there were any.
    fn weld(&mut self) -> bool {
        let mut has_welded = false;
        for vertex in 0..self.vertices.len() as u32 {
            let is_near = |other: &u32| {
                let way = sub(self.vertices[*other as usize], self.vertices[vertex as usize]);
                length(way) < self.limits.shortest && self.fans.stays_a_surface(vertex, *other)
            };
            if let Some(kept) = self.fans.neighbours(vertex).into_iter().find(is_near) {
                self.join(vertex, kept);
                has_welded = true;
            }
        }
        has_welded
    }

    /// Notes all collapses that cost little enough.
    fn suggest_all(&mut self) {
        for vertex in 0..self.vertices.len() as u32 {
            self.suggest_around(vertex, |other| vertex < other);
        }
    }

    /// Adds a triangle's plane, and those of its borders, to its corners' quadrics.
    fn add_planes(&mut self, triangle: u32) {
        let corners = self.fans.corners(triangle);
        let Some((a, normal)) = self.plane_of(triangle) else { return };
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

    fn plane_of(&self, triangle: u32) -> Option<(Vector, Vector)> {
        self.plane(triangle, self.fans.corners(triangle).map(|corner| self.vertices[corner as usize]))
    }

    /// The plane that a triangle stands for. The normal of a sliver says nothing; one that is folded, or no more than an
    /// edge, stands for none.
    fn plane(&self, triangle: u32, at: [Vector; 3]) -> Option<(Vector, Vector)> {
        let form = Form::of(at);
        if form.height > self.limits.thinnest {
            return Some((at[0], unit(form.normal)?));
        }
        let facing = self.traits[triangle as usize].facing;
        let is_level = |corner: &Vector| dot(sub(*corner, at[0]), facing).abs() < self.limits.thinnest;
        let stands = form.height > self.limits.shortest && at.iter().all(is_level);
        stands.then_some((at[0], facing))
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
        if error <= self.limits.tolerance * self.limits.tolerance {
            let way = sub(to, from);
            let cost = error.max(0.0) + SHORT_FIRST * dot(way, way);
            let changes = [gone, kept].map(|vertex| self.changes[vertex as usize]);
            self.candidates.push(Reverse((cost.to_bits(), gone, kept, changes[0], changes[1])));
        }
    }

    /// Collapses edges, the cheapest first. Answers whether there were any.
    fn run(&mut self, sampler: &mut Sampler) -> Result<bool, Error> {
        const TOLD_EVERY: usize = 1 << 13;
        let all = self.vertices.len();
        let mut merged = 0;
        self.suggest_all();
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
        Ok(merged > 0)
    }

    /// Whether the mesh stays a surface, and every triangle faces where it did.
    fn may_collapse(&self, gone: u32, kept: u32) -> bool {
        self.fans.stays_a_surface(gone, kept)
            && self.fans.of(gone).iter().all(|triangle| {
                let corners = self.fans.corners(*triangle);
                corners.contains(&kept)
                    || self.is_folded(corners, gone, kept)
                    || self.may_become(*triangle, corners, gone, kept)
            })
    }

    /// Whether a triangle vanishes when an edge collapses. Vertices of several cells may be put on the same corner, and where
    /// the surface about a vertex folds back onto itself, two of these are around it. Once they are neighbours, they are
    /// welded, and both triangles between them vanish.
    fn is_folded(&self, corners: [u32; 3], gone: u32, kept: u32) -> bool {
        let is_twin = |corner: &u32| {
            let way = sub(self.vertices[*corner as usize], self.vertices[kept as usize]);
            *corner != gone && length(way) < self.limits.shortest
        };
        let Some(twin) = corners.into_iter().find(is_twin) else { return false };
        let (around_gone, around_kept) = (self.fans.neighbours(gone), self.fans.neighbours(kept));
        let is_common = |other: &u32| {
            *other != gone && *other != kept && (around_gone.contains(other) || around_kept.contains(other))
        };
        let around_twin = self.fans.neighbours(twin);
        !around_twin.contains(&kept) && around_twin.iter().filter(|other| is_common(other)).count() == 2
    }

    fn may_become(&self, triangle: u32, corners: [u32; 3], gone: u32, kept: u32) -> bool {
        /// The cosine that a triangle's normal may turn by.
        const TURN: f64 = 0.5;
        let before = corners.map(|corner| self.vertices[corner as usize]);
        let after = corners.map(|corner| self.vertices[if corner == gone { kept } else { corner } as usize]);
        let (old, new) = (Form::of(before), Form::of(after));
        // What was no more than an edge may stay one.
        if old.height.max(new.height) < self.limits.shortest {
            return true;
        }
        let facing = self.traits[triangle as usize].facing;
        // No quadric tells of what had no plane: it may only become a part of the one that it faces from.
        let height = dot(sub(self.vertices[kept as usize], before[0]), facing);
        if self.plane(triangle, before).is_none() && height.abs() > self.limits.tolerance {
            return false;
        }
        let faces = |direction: Vector| dot(new.normal, direction) > TURN * length(new.normal) * length(direction);
        // The normal of a sliver says nothing.
        let turned = old.height > self.limits.thinnest && !faces(old.normal);
        faces(facing) && !turned && new.height > self.limits.thinnest.min(0.5 * old.height).max(f64::MIN_POSITIVE)
    }

    fn collapse(&mut self, gone: u32, kept: u32) {
        self.join(gone, kept);
        self.suggest_around(kept, |_| true);
    }

    fn join(&mut self, gone: u32, kept: u32) {
        let quadric = self.quadrics[gone as usize].clone();
        self.quadrics[kept as usize].add(&quadric);
        let has_none = |triangle: &u32| self.plane_of(*triangle).is_none();
        let without: Vec<u32> = self.fans.of(gone).iter().copied().filter(has_none).collect();
        self.fans.collapse(gone, kept);
        self.changes[gone as usize] += 1;
        self.changes[kept as usize] += 1;
        // What stands for a plane now, the quadrics have to know.
        for triangle in without {
            if self.fans.has(triangle) {
                self.add_planes(triangle);
            }
        }
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
