//! The lobe that is fitted: the interface of `trace_surface.wgsl` without Fresnel's term, times the cosine.

use crate::vector::{Vector, dot, normalized, reflected};

/// Directions along one axis of the grids that integrals are sums over.
pub(crate) const GRID: usize = 40;

/// GGX with Smith's height-correlated masking, seen from one direction in the plane y = 0; the normal is z.
pub(crate) struct Lobe {
    alpha: f64,
    v: Vector,
}

/// What a lobe sends back of a radiance of 1 from everywhere.
pub(crate) struct Albedo {
    /// If Fresnel's term were 1.
    pub(crate) whole: f64,
    /// If it were (1 − h·l)⁵, the part of Schlick's that F₀ doesn't scale.
    pub(crate) grazing: f64,
}

impl Lobe {
    pub(crate) fn new(alpha: f64, cosine: f64) -> Self {
        Self { alpha, v: [(1.0 - cosine * cosine).sqrt(), 0.0, cosine] }
    }

    pub(crate) fn alpha(&self) -> f64 {
        self.alpha
    }

    /// A direction in the frame whose z is the mirror image's.
    pub(crate) fn mirror_frame(&self, [x, y, z]: Vector) -> Vector {
        let [sine, _, cosine] = self.v;
        [cosine * x + sine * z, y, cosine * z - sine * x]
    }

    /// The way back.
    pub(crate) fn out_of_mirror_frame(&self, [x, y, z]: Vector) -> Vector {
        let [sine, _, cosine] = self.v;
        [cosine * x - sine * z, y, cosine * z + sine * x]
    }

    /// D V cos.
    pub(crate) fn value(&self, l: Vector) -> f64 {
        if l[2] <= 0.0 {
            return 0.0;
        }
        let h = normalized([0, 1, 2].map(|i| l[i] + self.v[i]));
        let a2 = self.alpha * self.alpha;
        let spread = a2 * h[2] * h[2] + h[0] * h[0] + h[1] * h[1];
        let distribution = a2 / (std::f64::consts::PI * spread * spread);
        0.5 * distribution / (self.v[2] * (self.smith(self.v[2]) + self.smith(l[2])))
    }

    /// A direction for a point of the unit square, as dense as D G₁(v) / (4 cos v) (Heitz, "Sampling the GGX
    /// Distribution of Visible Normals", 2018), and the cosine between it and the half vector.
    pub(crate) fn drawn(&self, u: [f64; 2]) -> (Vector, f64) {
        let stretched = normalized([self.alpha * self.v[0], 0.0, self.v[2]]);
        // Across it: y, and what y and it span.
        let rising = [-stretched[2], 0.0, stretched[0]];
        let (r, angle) = (u[0].sqrt(), std::f64::consts::TAU * u[1]);
        let x = r * angle.cos();
        let s = 0.5 * (1.0 + stretched[2]);
        let y = (1.0 - s) * (1.0 - x * x).sqrt() + s * r * angle.sin();
        let z = (1.0 - x * x - y * y).max(0.0).sqrt();
        let seen = [0, 1, 2].map(|i| [0.0, x, 0.0][i] + y * rising[i] + z * stretched[i]);
        let h = normalized([self.alpha * seen[0], self.alpha * seen[1], seen[2].max(0.0)]);
        (reflected(self.v, h), dot(self.v, h))
    }

    pub(crate) fn albedo(&self) -> Albedo {
        let (mut whole, mut grazing) = (0.0, 0.0);
        // Finer than for the fit: this is what the energy comes to.
        let count = 4 * GRID;
        for u in squares(count) {
            let (l, cosine) = self.drawn(u);
            if l[2] > 0.0 {
                let smith = self.smith(self.v[2]);
                let weight = (1.0 + smith) / (smith + self.smith(l[2])) / (count * count) as f64;
                whole += weight;
                grazing += weight * (1.0 - cosine).powi(5);
            }
        }
        Albedo { whole, grazing }
    }

    /// Smith's √(1 + α² tan²).
    fn smith(&self, cosine: f64) -> f64 {
        let c2 = cosine * cosine;
        (1.0 + self.alpha * self.alpha * (1.0 - c2) / c2).sqrt()
    }
}

/// The middles of the cells of a grid over the unit square.
pub(crate) fn squares(count: usize) -> impl Iterator<Item = [f64; 2]> {
    (0..count * count).map(move |i| [i % count, i / count].map(|k| (k as f64 + 0.5) / count as f64))
}
