//! The modules that make geometry: from arguments and children to solids.
//!
//! This is all of the language that knows shapes; scopes, control flow and functions are elsewhere. Each module is a
//! function from an [`Instance`] to a solid, and one row in the table of its file.

mod arguments;
mod aside;
mod balls;
mod booleans;
mod camera;
mod colors;
mod convexity;
mod decide;
mod exactness;
mod extent;
mod extrusions;
mod facets;
mod hull;
mod instance;
mod lights;
mod make;
mod minkowski;
mod natives;
mod offsets;
mod outline;
mod pieces;
mod planes;
mod polyhedra;
mod resize;
mod solids;
mod stages;
#[cfg(test)]
mod testing;
#[cfg(test)]
mod tests;
mod transforms;
mod unsupported;
mod vectors;
mod witnesses;

use std::sync::Arc;

use chiaro_solid::{Scalar, Solid};
use chiaro_syntax::tree::Name;
use chiaro_syntax::{Diagnostic, Span, Spanned};

use crate::settings::Settings;
use crate::value::Value;

pub(crate) use aside::{Aside, PlacedCamera};
pub(crate) use booleans::{EVERY, takes_every, union_of};
pub use colors::color_names;
pub use facets::Facets;
pub(crate) use hull::only_hull_counts;

use instance::{Instance, Module};

/// A built-in module's instance, its arguments evaluated and its children built.
pub(crate) struct Call<'a> {
    /// The module's name.
    pub(crate) name: &'a str,
    /// Name and arguments in the text.
    pub(crate) head: Span,
    /// The arguments in order, each with its parameter's name if it was given, and their places.
    pub(crate) arguments: Vec<Argument>,
    /// `$fn` as it is for this instance: the number of sides of curves. (`$fa` and `$fs` never make facets.)
    pub(crate) sides: Value,
    /// Whether all that counts of the solid is its convex hull.
    pub(crate) only_hull: bool,
    /// What the children came to, in order, the empty ones included (they count as operands).
    pub(crate) children: Vec<Arc<Solid>>,
    /// The only child that is written, if there is one only.
    pub(crate) only_child: Option<OnlyChild>,
    /// What the children have put aside; the instance moves it, and adds its own.
    pub(crate) aside: &'a mut Aside,
}

/// A child without others beside it in the text.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum OnlyChild {
    /// One solid.
    Operand,
    /// A loop, a condition or the like, which may make several.
    Several,
}

/// An argument of a [`Call`].
pub(crate) struct Argument {
    /// The parameter's name, if it was given, and its place.
    pub(crate) name: Option<Spanned<Name>>,
    /// Its value.
    pub(crate) value: Value,
    /// Its value's place in the text.
    pub(crate) span: Span,
}

/// Why there is no solid.
#[derive(Debug)]
pub(crate) enum Stop {
    /// An error to report. The scene has no picture, but evaluation goes on to find more.
    Error(Box<Diagnostic>),
    /// A live number would have to be known here: its parameters become structural, and evaluation starts again.
    Demote(Box<Demotion>),
}

/// A live number that decides the structure of the scene.
#[derive(Debug)]
pub(crate) struct Demotion {
    /// The number.
    pub(crate) number: Scalar,
    /// Where it would have to be known.
    pub(crate) span: Span,
    /// What for, as in "a list index".
    pub(crate) reason: &'static str,
}

/// What a module's function answers.
type Built = Result<Arc<Solid>, Stop>;

/// The tables of all files, in the order in which names are looked up.
const TABLES: [&[Module]; 14] = [
    solids::MODULES,
    planes::MODULES,
    polyhedra::MODULES,
    transforms::MODULES,
    booleans::MODULES,
    extrusions::MODULES,
    offsets::MODULES,
    minkowski::MODULES,
    hull::MODULES,
    resize::MODULES,
    colors::MODULES,
    lights::MODULES,
    camera::MODULES,
    unsupported::MODULES,
];

/// The solid of a built-in module's instance; none, if there is no such module.
pub(crate) fn build(call: Call, settings: &Settings, diagnostics: &mut Vec<Diagnostic>) -> Option<Built> {
    if let Some(module) = TABLES.iter().copied().flatten().find(|module| module.name == call.name) {
        let instance = Instance::bind(call, module.positional, module.named, settings.facets, diagnostics);
        return Some(instance.and_then(|mut instance| (module.build)(&mut instance)));
    }
    natives::build(call, settings.facets, diagnostics)
}

/// The parameters of a built-in module that makes geometry: those that arguments without a name go to, in order, and those
/// that have to be named.
pub(crate) fn parameters(name: &str) -> Option<(Vec<&'static str>, Vec<&'static str>)> {
    let module = TABLES.iter().copied().flatten().find(|module| module.name == name);
    let own = module.map(|module| (module.positional.to_vec(), module.named.to_vec()));
    own.or_else(|| Some((natives::parameters(name)?, Vec::new())))
}

/// The names of all built-in modules that make geometry.
pub(crate) fn names() -> impl Iterator<Item = &'static str> {
    TABLES.iter().copied().flatten().map(|module| module.name).chain(natives::names())
}
