//! The files that the command and the editor touch.
//!
//! [`FileWorld`] reads scenes and what they include; [`write()`] writes a file whole or not at all; [`images`] are
//! pictures as files.

pub mod images;

mod whole;
mod world;

pub use whole::write;
pub use world::FileWorld;
