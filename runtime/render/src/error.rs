//! What can go wrong while drawing.

use chiaro_syntax::Diagnostic;

/// Why there is no picture.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Error {
    /// The machine has no driver that could draw, not even in software.
    #[error("no graphics driver: on Debian install mesa-vulkan-drivers (tools/setup.sh does)")]
    NoDriver,
    /// No adapter is of the kind, or has the name, that was asked for.
    #[error("no graphics adapter is {wanted}; there are: {available}")]
    NoAdapter {
        /// What was asked for.
        wanted: String,
        /// What there is, separated by commas.
        available: String,
    },
    /// The adapter lacks what every picture needs.
    #[error("the graphics adapter {adapter} cannot be used: {reason}")]
    Unusable {
        /// The adapter's name.
        adapter: String,
        /// What the driver said.
        reason: String,
    },
    /// The scene cannot be put into a shader.
    #[error("{}", .0.message)]
    Scene(Box<Diagnostic>),
    /// The picture is larger than the adapter can draw, or has no pixels.
    #[error(
        "a picture of {width} × {height} pixels cannot be drawn: \
         this graphics adapter draws up to {most_pixels} pixels, at most {longest_edge} along an edge"
    )]
    PictureSize {
        /// The width asked for.
        width: u32,
        /// The height asked for.
        height: u32,
        /// The most pixels that a picture may have along one edge.
        longest_edge: u32,
        /// The most pixels that a picture may have in all.
        most_pixels: u64,
    },
    /// The scene needs a larger buffer than the adapter has.
    #[error("the scene's {what} take {needed} bytes; this graphics adapter has room for {limit}")]
    SceneSize {
        /// What is too large.
        what: &'static str,
        /// How large it is.
        needed: u64,
        /// How large it may be.
        limit: u64,
    },
    /// Live numbers moved too many parts of a union into each other for the model to follow; one made anew, with the same
    /// values, draws them.
    #[error("too many of a union's {members} parts lie in each other now: the scene has to be compiled anew for that")]
    Dense {
        /// How many parts there are.
        members: usize,
    },
    /// There are fewer values than live numbers refer to.
    #[error("the scene has {needed} live numbers, but {given} values were given")]
    Parameters {
        /// How many there have to be.
        needed: usize,
        /// How many were given.
        given: usize,
    },
    /// The driver took no part in it any longer; a new [`Gpu`](crate::Gpu) may help.
    #[error("the graphics device was lost: {0}")]
    Lost(String),
    /// The driver refused a command.
    #[error("the graphics driver refused: {0}")]
    Refused(String),
    /// The driver did not finish in time.
    #[error("the graphics driver did not answer within {0} seconds")]
    Stuck(u64),
}

/// The result of drawing.
pub type Result<T> = std::result::Result<T, Error>;
