//! The names that the language comes with, for tools that help to write it.

use crate::{functions, geometry, instance};

pub use crate::geometry::color_names as colors;
pub use chiaro_solid::SHADOW_METHODS as SHADOWS;

/// Every built-in module, those of control flow and those that are not supported yet included.
pub fn modules() -> impl Iterator<Item = &'static str> {
    geometry::names().chain(instance::CONTROL)
}

/// Every built-in function, those that are not supported yet included.
pub fn functions() -> impl Iterator<Item = &'static str> {
    functions::names().chain(functions::UNSUPPORTED)
}

/// The parameters of a built-in module that makes geometry.
pub fn parameters(module: &str) -> Option<Parameters> {
    let (positional, named) = geometry::parameters(module)?;
    Some(Parameters { positional, named })
}

/// What a module takes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameters {
    /// The parameters that arguments without a name go to, in order.
    pub positional: Vec<&'static str>,
    /// Those that have to be named.
    pub named: Vec<&'static str>,
}

/// The variables that are set from the beginning, or by every instance.
pub const VARIABLES: [&str; 12] =
    ["$fn", "$fa", "$fs", "$t", "$preview", "$vpr", "$vpt", "$vpd", "$vpf", "$children", "$parent_modules", "PI"];
