//! Sums of squared distances to planes.

use crate::vector::{Vector, dot};

/// A sum of squared distances to planes, as a function of a point.
#[derive(Clone, Debug, Default)]
pub(super) struct Quadric {
    /// Of n nᵀ: xx, yy, zz, xy, yz, zx.
    squares: [f64; 6],
    /// Of −d n, where d is the plane's height.
    linear: Vector,
    /// Of d².
    constant: f64,
}

impl Quadric {
    /// Adds the plane through a point with that unit normal.
    pub(super) fn add_plane(&mut self, point: Vector, normal: Vector) {
        let [x, y, z] = normal;
        let height = dot(normal, point);
        let squares = [x * x, y * y, z * z, x * y, y * z, z * x];
        self.add(&Quadric { squares, linear: normal.map(|n| -height * n), constant: height * height });
    }

    pub(super) fn add(&mut self, other: &Quadric) {
        (0..6).for_each(|index| self.squares[index] += other.squares[index]);
        (0..3).for_each(|axis| self.linear[axis] += other.linear[axis]);
        self.constant += other.constant;
    }

    pub(super) fn at(&self, [x, y, z]: Vector) -> f64 {
        let [xx, yy, zz, xy, yz, zx] = self.squares;
        let square = xx * x * x + yy * y * y + zz * z * z + 2.0 * (xy * x * y + yz * y * z + zx * z * x);
        square + 2.0 * dot(self.linear, [x, y, z]) + self.constant
    }
}
