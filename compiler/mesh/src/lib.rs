//! Field graph to closed triangle meshes with materials, and the files they are written as.
//!
//! * [`model()`] finds the surface of a [`Field`], a [`GraphField`] for instance, and makes a [`Model`] of it: a [`Mesh`]
//!   that is closed and manifold, with sharp edges where the solid has them, materials and normals.
//! * [`write`](mod@write) makes the bytes of STL, OBJ, PLY, 3MF and glTF files of it.
//!
//! Inside, `lattice` is where the surface is looked for, `search` finds the cells it goes through, `crossings` where it
//! crosses their edges, `cycles` and `sheets` how it goes through each cell, `placement` puts a vertex on each sheet,
//! `contour` joins the vertices, and `merge` takes out those that flat and slightly curved faces don't need.
//!
//! There are no files, clock or threads here: who implements [`Field`] may spread a batch of questions as they like.

mod contour;
mod crossings;
mod cycles;
mod error;
mod field;
mod flakes;
mod flatten;
mod lattice;
mod merge;
mod mesh;
mod model;
mod placement;
mod quadric;
mod search;
mod sheets;
mod vector;
pub mod write;

pub use error::Error;
pub use field::{Field, GraphField, Progress, Stage, Watch};
pub use mesh::Mesh;
pub use model::{Corner, Detail, Model, Report, model};
