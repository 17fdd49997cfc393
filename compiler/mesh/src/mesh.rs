//! Triangle meshes.

use rustc_hash::FxHashMap;

use crate::vector::{Vector, add, cross, dot, length, scale, sub, unit};

/// A closed surface of triangles. Each edge is the side of two triangles, which pass it in opposite directions, and the
/// triangles around a vertex are one fan.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Points in millimetres; no two are nearer to each other than a millionth of the size.
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

    /// Moves vertices apart that are nearer to each other than this, each into the solid.
    pub(crate) fn separate(&mut self, apart: f64) {
        const MOST_STEPS: u32 = 64;
        let greatest = self.vertices.iter().flatten().fold(0.0, |greatest: f64, x| greatest.max(x.abs()));
        let apart = apart.max(4.0 * f64::from(f32::EPSILON) * greatest);
        let inwards = self.inwards();
        let site = |point: Vector| point.map(|coordinate| (coordinate / apart).floor() as i64);
        let mut taken: FxHashMap<[i64; 3], Vec<Vector>> = FxHashMap::default();
        for (vertex, inwards) in self.vertices.iter_mut().zip(inwards) {
            let is_free = |point: Vector| {
                let [x, y, z] = site(point);
                let around = (0..27).map(|n| [x + n % 3 - 1, y + n / 3 % 3 - 1, z + n / 9 - 1]);
                let near = around.filter_map(|site| taken.get(&site)).flatten();
                near.into_iter().all(|other| length(sub(*other, point)) >= apart)
            };
            let places = (0..MOST_STEPS).map(|step| add(*vertex, scale(inwards, 1.5 * apart * f64::from(step))));
            if let Some(place) = places.into_iter().find(|place| is_free(*place)) {
                *vertex = place;
            }
            taken.entry(site(*vertex)).or_default().push(*vertex);
        }
    }

    /// The directions that the surface at each vertex faces away from.
    fn inwards(&self) -> Vec<Vector> {
        let mut sums = vec![[0.0; 3]; self.vertices.len()];
        for (triangle, corners) in self.triangles.iter().enumerate() {
            let [a, b, c] = self.corners(triangle);
            let normal = unit(cross(sub(b, a), sub(c, a))).unwrap_or([0.0; 3]);
            corners.iter().for_each(|corner| sums[*corner as usize] = sub(sums[*corner as usize], normal));
        }
        sums.into_iter().map(|sum| unit(sum).unwrap_or([1.0, 0.0, 0.0])).collect()
    }

    /// Rounds coordinates to multiples of at most this.
    pub(crate) fn round(&mut self, grid: f64) {
        let grid = grid.log2().floor().exp2();
        // The sum has no negative zeros.
        self.vertices.iter_mut().flatten().for_each(|x| *x = (*x / grid).round() * grid + 0.0);
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
