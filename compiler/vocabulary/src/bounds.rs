//! Axis-aligned boxes.

use crate::interval::Interval;

/// An axis-aligned box in millimetres, possibly empty or infinite. Plane shapes have a box that is all of z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The least corner.
    pub min: [f64; 3],
    /// The greatest corner; less than `min` on some axis if the box is empty.
    pub max: [f64; 3],
}

impl Bounds {
    /// No point at all.
    pub const EMPTY: Bounds = Bounds { min: [f64::INFINITY; 3], max: [f64::NEG_INFINITY; 3] };

    /// All of space.
    pub const ALL: Bounds = Bounds { min: [f64::NEG_INFINITY; 3], max: [f64::INFINITY; 3] };

    /// The box of these three ranges.
    pub fn new(x: Interval, y: Interval, z: Interval) -> Self {
        Self { min: [x.min, y.min, z.min], max: [x.max, y.max, z.max] }
    }

    /// The box centred at the origin that reaches `half` to each side.
    pub fn centred(half: [f64; 3]) -> Self {
        Self { min: half.map(|h| -h), max: half }
    }

    /// The range on one axis; meaningless if the box is empty.
    pub fn axis(&self, axis: usize) -> Interval {
        Interval { min: self.min[axis], max: self.max[axis] }
    }

    /// Whether no point lies in it.
    pub fn is_empty(&self) -> bool {
        (0..3).any(|axis| self.min[axis] > self.max[axis])
    }

    /// Whether it is bounded on every axis (an empty box is).
    pub fn is_finite(&self) -> bool {
        self.is_empty() || (0..3).all(|axis| self.min[axis].is_finite() && self.max[axis].is_finite())
    }

    /// The smallest box that holds both.
    pub fn union(&self, other: &Bounds) -> Bounds {
        if self.is_empty() {
            return *other;
        }
        if other.is_empty() {
            return *self;
        }
        Bounds {
            min: std::array::from_fn(|axis| self.min[axis].min(other.min[axis])),
            max: std::array::from_fn(|axis| self.max[axis].max(other.max[axis])),
        }
    }

    /// What lies in both.
    pub fn intersection(&self, other: &Bounds) -> Bounds {
        let both = Bounds {
            min: std::array::from_fn(|axis| self.min[axis].max(other.min[axis])),
            max: std::array::from_fn(|axis| self.max[axis].min(other.max[axis])),
        };
        if both.is_empty() { Bounds::EMPTY } else { both }
    }

    /// The box with every face moved outwards by `by` (inwards, if negative).
    pub fn inflate(&self, by: f64) -> Bounds {
        if self.is_empty() {
            return *self;
        }
        let moved = Bounds { min: self.min.map(|c| c - by), max: self.max.map(|c| c + by) };
        if moved.is_empty() { Bounds::EMPTY } else { moved }
    }

    /// The centre of a finite box that is not empty.
    pub fn center(&self) -> [f64; 3] {
        std::array::from_fn(|axis| 0.5 * (self.min[axis] + self.max[axis]))
    }

    /// The edge lengths; zero if it is empty.
    pub fn size(&self) -> [f64; 3] {
        if self.is_empty() { [0.0; 3] } else { std::array::from_fn(|axis| self.max[axis] - self.min[axis]) }
    }

    /// The length of the diagonal.
    pub fn diagonal(&self) -> f64 {
        self.size().iter().map(|s| s * s).sum::<f64>().sqrt()
    }

    /// The distance from a point to the box; zero inside, infinite if the box is empty.
    pub fn distance(&self, point: [f64; 3]) -> f64 {
        if self.is_empty() {
            return f64::INFINITY;
        }
        let beyond = |axis: usize| (self.min[axis] - point[axis]).max(point[axis] - self.max[axis]).max(0.0);
        (0..3).map(|axis| beyond(axis).powi(2)).sum::<f64>().sqrt()
    }
}
