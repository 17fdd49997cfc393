//! Writes scenes as shader code for other programs.

mod parameters;
mod source;
mod translate;

pub use parameters::{Parameter, snake_case};
pub use source::Source;
pub use translate::{Dialect, Parameters, TranslationError, translate};
