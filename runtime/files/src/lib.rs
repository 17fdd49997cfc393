//! The files that the command and the editor touch.
//!
//! [`FileWorld`] reads scenes and what they include; [`write()`] writes a file whole or not at all, [`write_all()`] several of
//! them, and a [`Batch`] those that are made one after the other; [`images`] are pictures as files.

pub mod images;

mod whole;
mod world;

pub use whole::{Batch, write, write_all, write_folder};
pub use world::FileWorld;
