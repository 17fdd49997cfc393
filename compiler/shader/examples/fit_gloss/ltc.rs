//! Linearly transformed cosines: the clamped cosine lobe about z, its directions multiplied by a matrix.

use crate::lobe::Lobe;
use crate::vector::{Vector, dot, normalized};

/// The distribution's inverse matrix, [[a, 0, b], [0, 1, 0], [c, 0, d]], in the frame of the mirror image's direction: that
/// is z, and y is across the plane of the view. Its scale means nothing.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ltc {
    pub(crate) a: f64,
    pub(crate) b: f64,
    pub(crate) c: f64,
    pub(crate) d: f64,
}

impl Ltc {
    fn determinant(&self) -> f64 {
        self.a * self.d - self.b * self.c
    }

    /// How dense it is about a unit direction above the horizon.
    pub(crate) fn density(&self, lobe: &Lobe, w: Vector) -> f64 {
        let [x, y, z] = lobe.mirror_frame(w);
        let back = [self.a * x + self.b * z, y, self.c * x + self.d * z];
        let length2 = dot(back, back);
        if w[2] <= 0.0 || back[2] <= 0.0 {
            return 0.0;
        }
        back[2] / (std::f64::consts::PI * length2 * length2) * self.determinant().abs() / self.above_horizon(lobe)
    }

    /// A direction for a point of the unit square, as dense as the distribution, horizon or not.
    pub(crate) fn drawn(&self, lobe: &Lobe, u: [f64; 2]) -> Vector {
        let (r, angle) = (u[0].sqrt(), std::f64::consts::TAU * u[1]);
        let [x, y, z] = [r * angle.cos(), r * angle.sin(), (1.0 - u[0]).sqrt()];
        let det = self.determinant();
        lobe.out_of_mirror_frame(normalized([(self.d * x - self.b * z) / det, y, (self.a * z - self.c * x) / det]))
    }

    /// How much of it is above the horizon. In the cosine's space the horizon is a plane at an angle γ to that of the
    /// cosine, and both leave (1 + cos γ) / 2 of it.
    fn above_horizon(&self, lobe: &Lobe) -> f64 {
        let [x, _, z] = lobe.mirror_frame([0.0, 0.0, 1.0]);
        let (across, along) = (x * self.d - z * self.c, z * self.a - x * self.b);
        let cosine = along / across.hypot(along) * self.determinant().signum();
        (0.5 * (1.0 + cosine)).max(1e-6)
    }
}
