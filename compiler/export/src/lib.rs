//! Writes scenes as shader code for other programs: as libraries and programs in shading languages, and as the files that
//! engines and pages take.
//!
//! * [`Source`] is a scene's functions as one WGSL text, with live parameters under their own names.
//! * [`translate`] says the same in GLSL, HLSL or Metal: comments, loops and names stay as they are.
//! * [`listing()`] is what people look at: with the expression that each line stands for.
//! * [`export`] puts that into a [`Target`]'s templates (the folder `packages`).

mod context;
mod lamps;
mod languages;
mod listing;
mod packages;
mod parameters;
mod prose;
mod source;
mod subject;
mod target;
mod translate;
mod words;

pub use listing::listing;
pub use parameters::{Parameter, snake_case};
pub use prose::Prose;
pub use source::Source;
pub use subject::{Camera, Scene};
pub use target::{File, Language, Package, Target, export};
pub use translate::{Dialect, Parameters, TranslationError, translate};
