//! Evaluates a syntax tree to a solid tree: values, scopes, built-ins, live numbers.
//!
//! The evaluator is a partial evaluator: Customizer parameters and `$t` stay symbolic ([`Value::Number`] holds a
//! [`Scalar`](chiaro_solid::Scalar)), everything else folds to constants. It knows nothing of fields.

mod geometry;
mod settings;
mod value;

pub use geometry::Facets;
pub use settings::Settings;
pub use value::Value;
