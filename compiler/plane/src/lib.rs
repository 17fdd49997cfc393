//! Exact two-dimensional geometry on the CPU: regions bounded by lines and arcs.

pub mod region;

mod biarc;
mod boolean;
mod construct;
mod contour;
mod flatten;
mod hull;
mod intersect;
mod loft;
mod measure;
mod minkowski;
mod offset;
mod overlay;
mod recover;
mod tangle;
mod transform;

pub use flatten::{DEFAULT_TOLERANCE, default_tolerance};
pub use loft::{Loft, Matrix, Side};
pub use offset::Join;
pub use region::{Contour, Edge, Point, Region};
