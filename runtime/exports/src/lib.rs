//! Scenes as files of other programs: what `chiaro export` and the editor's dialog write.
//!
//! * A [`Format`] is what can be written; [`Format::ALL`] lists them.
//! * [`mesh_files`] and [`shader_files`] make the bytes of [`File`]s in memory.
//! * [`write()`] then puts all of them into place, or none.

mod files;
mod format;
mod mesh;
mod parallel;
mod shader;

pub use files::{File, occupied, write};
pub use format::{Format, MeshFormat};
pub use mesh::{mesh, mesh_files};
pub use shader::{Shaded, mesh_beside, shader_files};
