//! Exact two-dimensional geometry on the CPU: regions bounded by lines and arcs.

pub mod region;

mod construct;
mod flatten;
mod measure;
mod transform;

pub use flatten::{DEFAULT_TOLERANCE, default_tolerance};
pub use region::{Contour, Edge, Point, Region};
