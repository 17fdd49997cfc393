//! The files that the command and the editor touch.
//!
//! * [`FileWorld`] reads scenes and what they include; [`confine()`] says where from.
//! * [`write()`] writes a file whole or not at all, [`write_all()`] several of them, [`write_folder()`] a folder, and a [`Batch`]
//!   those that are made one after the other.
//! * A [`Temporary`] disappears in the end; a process that is told to end first calls [`abandon()`].
//! * [`images`] are pictures as files.

pub mod images;

mod place;
mod temporaries;
mod whole;
mod world;

pub use place::is_stream_at;
pub use temporaries::{Folders, Temporary, abandon};
pub use whole::{Batch, write, write_all, write_folder};
pub use world::{FileWorld, admit, confine};
