//! Why there is no mesh.

/// Why there is no mesh.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Error {
    /// There is nothing in the scene.
    #[error("the scene is empty: there is nothing to make a mesh of")]
    Empty,
    /// The solid may reach to infinity.
    #[error(
        "the scene has no end along {axes}, and a mesh has to; intersect it with something that has, such as a large cube"
    )]
    Unbounded {
        /// The axes, in words.
        axes: String,
    },
    /// No cell has corners on both sides.
    #[error(
        "the scene is empty, or no part of it is as thick as a cell of {cell:.3} mm: then take a smaller tolerance, or a higher resolution than {resolution}"
    )]
    NothingFound {
        /// The length of a cell's edges, in millimetres.
        cell: f64,
        /// How many of them there are along the longest side.
        resolution: u32,
    },
    /// The cells would not fit into memory.
    #[error(
        "{resolution} cells along the longest side are too many: the surface would go through more than {most} million cells; take a larger tolerance or a lower resolution"
    )]
    TooFine {
        /// How many cells there would be along the longest side.
        resolution: u32,
        /// How many millions of cells fit.
        most: usize,
    },
    /// Whoever watched said so.
    #[error("cancelled")]
    Cancelled,
}
