//! Evaluates a syntax tree to a solid tree: values, scopes, built-ins, live numbers.
//!
//! [`evaluate`] runs a scene's program. It is a partial evaluator: Customizer parameters and `$t` stay symbolic, as
//! [`Scalar`](chiaro_solid::Scalar)s, and everything else folds to constants. Where a live number decides the structure
//! of the scene, it becomes a constant and the evaluation starts again. The crate knows nothing of fields.

// The way of a scene: files are read, blocks sorted out, expressions and instances evaluated, solids built.
mod load;
mod misspelt;
mod plan;
mod scene;

mod call;
mod evaluator;
mod expression;
mod foreign;
mod functions;
mod instance;
mod list;
mod live;
mod scope;
mod suggest;
mod value;

pub mod names;

mod geometry;
mod options;
mod settings;

pub use geometry::Facets;
pub use options::{Limits, LiveLiteral, Options, STACK_BYTES, World};
pub use scene::{Evaluation, evaluate};

#[cfg(test)]
mod tests;
