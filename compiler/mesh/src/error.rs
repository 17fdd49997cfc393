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
    /// Files of meshes have numbers in single precision, in which the scene would be a heap of crumbs.
    #[error(
        "the scene is {size:.3e} mm large, but {far:.3e} mm from the origin, where the numbers of mesh files are rounded to {rounding:.1e} mm: move it nearer to the origin"
    )]
    TooFar {
        /// The diagonal of the scene's box, in millimetres.
        size: f64,
        /// How far from the origin it reaches.
        far: f64,
        /// The distance of neighbouring numbers there.
        rounding: f64,
    },
    /// The field has no value at a point, and so no surface around it.
    #[error("the distance to the scene is not a number at {point:?}, so that there is no surface to make a mesh of")]
    NotANumber {
        /// The point, in millimetres.
        point: [f64; 3],
    },
    /// The surface goes on where the field says there is nothing.
    #[error("the surface leaves the box that the scene should be in, so that its mesh would have holes")]
    BeyondBounds,
    /// Whoever watched said so.
    #[error("cancelled")]
    Cancelled,
}
