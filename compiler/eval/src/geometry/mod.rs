//! The modules that make geometry: from arguments and children to solids.
//!
//! This is all of the language that knows shapes; scopes, control flow and functions are elsewhere. Each module is a
//! function from a [`Call`] to a solid.

use std::sync::Arc;

use chiaro_solid::{Scalar, Solid};
use chiaro_syntax::{Diagnostic, Span};

use crate::settings::Settings;
use crate::value::Value;

mod facets;

pub use facets::Facets;

/// The solid of a built-in module's instance; none, if there is no such module.
pub(crate) fn build(
    call: Call,
    settings: &Settings,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<Result<Arc<Solid>, Stop>> {
    let _ = settings;
    match call.name {
        "group" => Some(Ok(union_of(call.children, call.head, diagnostics))),
        _ => None,
    }
}

/// The names of all built-in modules that make geometry.
pub(crate) fn names() -> impl Iterator<Item = &'static str> {
    ["group"].into_iter()
}

/// What some children are together. Empty ones are dropped, and so are those of another dimension than the first.
pub(crate) fn union_of(children: Vec<Arc<Solid>>, span: Span, _diagnostics: &mut Vec<Diagnostic>) -> Arc<Solid> {
    children.into_iter().next().unwrap_or_else(|| Solid::new(chiaro_solid::SolidKind::Empty, span))
}

/// A built-in module's instance, its arguments evaluated and its children built.
pub(crate) struct Call<'a> {
    /// The module's name.
    pub(crate) name: &'a str,
    /// Name and arguments in the text.
    pub(crate) head: Span,
    /// The arguments in order, each with its parameter's name if it was given, and its place.
    pub(crate) arguments: Vec<Argument>,
    /// `$fn`, `$fa` and `$fs` as they are for this instance.
    pub(crate) facets: FacetVariables,
    /// What the children came to, in order, the empty ones included (they count as operands).
    pub(crate) children: Vec<Arc<Solid>>,
}

/// An argument of a [`Call`].
pub(crate) struct Argument {
    /// The parameter's name, if it was given.
    pub(crate) name: Option<Arc<str>>,
    /// Its value.
    pub(crate) value: Value,
    /// Its value's place in the text.
    pub(crate) span: Span,
}

/// OpenSCAD's special variables for the resolution of curves.
#[derive(Clone, Debug)]
pub(crate) struct FacetVariables {
    pub(crate) number: Value,
    pub(crate) angle: Value,
    pub(crate) size: Value,
}

/// Why there is no solid.
pub(crate) enum Stop {
    /// An error to report. The scene has no picture, but evaluation goes on to find more.
    Error(Box<Diagnostic>),
    /// A live number would have to be known here: its parameters become structural, and evaluation starts again.
    Demote(Box<Demotion>),
}

/// A live number that decides the structure of the scene.
pub(crate) struct Demotion {
    /// The number.
    pub(crate) number: Scalar,
    /// Where it would have to be known.
    pub(crate) span: Span,
    /// What for, as in "a list index".
    pub(crate) reason: &'static str,
}
