//! Points to ask fields at: deterministic, so that a failure can be repeated.

use chiaro_compiler::vocabulary::Bounds;

/// A generator of pseudo-random numbers (splitmix64).
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The generator with this seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The next number from 0 to 1.
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// The next point of a finite box.
    pub fn point(&mut self, bounds: &Bounds) -> [f64; 3] {
        std::array::from_fn(|axis| bounds.min[axis] + self.unit() * (bounds.max[axis] - bounds.min[axis]))
    }
}

/// The box that samples of a scene are drawn from: its bounds and half as much again around them. What is enormous
/// or empty is replaced by 100 mm around the origin.
pub fn sample_box(bounds: &Bounds) -> Bounds {
    let bounds = if bounds.is_empty() { Bounds::ALL } else { *bounds };
    let bounded = if bounds.diagonal() < 1e6 { bounds } else { bounds.intersection(&Bounds::centred([100.0; 3])) };
    bounded.inflate(0.25 * bounded.diagonal() + 1e-3)
}

/// The distance of two points.
pub fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|axis| (a[axis] - b[axis]).powi(2)).sum::<f64>().sqrt()
}
