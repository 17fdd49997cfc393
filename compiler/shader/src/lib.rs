//! Emits a field graph as a naga module and splices it into the tracing templates.

pub mod bindings;
mod build;
mod emit;
mod link;
mod names;
mod splice;
mod tables;
mod template;
mod text;

pub use emit::MAX_NODES;
pub use splice::{Shader, splice};
pub use tables::Tables;
pub use template::Template;
pub use text::wgsl;
