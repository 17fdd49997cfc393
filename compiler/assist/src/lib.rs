//! What an editor, or a language server, asks about a scene's text.
//!
//! Every function here is total: it takes any text and any offset, broken programs included, and answers plain data
//! whose byte ranges lie on character boundaries of that text. Nothing is remembered from call to call. Texts are read
//! as OpenSCAD's dumps and programs alike ([`Dialect::Dump`]), as the compiler reads `.csg` files.
//!
//! | question | function |
//! |---|---|
//! | in which colours? | [`highlight`] |
//! | which bracket belongs to this one? | [`brackets`] |
//! | what could be written here? | [`complete`] |
//! | what does this call take? | [`call_hint`] |
//! | what is this? | [`hover`] |
//! | where is this defined, where used? | [`definition`], [`definition_in`], [`references`], [`rename`] |
//! | how is it written well? | [`format()`] |
//! | how is this mended? | [`quick_fixes`] |
//! | which numbers are here, and how do they move? | [`numbers`], [`scrub`], [`literals_of_call`] |
//! | which parameters has the scene? | [`parameters`], [`set_parameter`] |

pub mod manual;

mod brackets;
mod call_hint;
mod calls;
mod complete;
mod describe;
mod edit;
mod fixes;
mod format;
mod highlight;
mod hover;
mod index;
mod literals;
mod navigate;
mod nesting;
mod numbers;
mod parameters;
#[cfg(test)]
mod testing;
#[cfg(test)]
mod tests;
mod words;

pub use brackets::brackets;
pub use call_hint::{CallHint, call_hint};
pub use complete::{Completion, CompletionKind, Completions, complete, complete_in};
pub use edit::{Edit, apply};
pub use fixes::{Fix, quick_fixes};
pub use format::format;
pub use highlight::{Highlight, Kind, highlight};
pub use hover::{Hover, hover};
pub use literals::{CallArgument, Literal, literals_of_call};
pub use navigate::{Place, definition, definition_in, references, rename};
pub use numbers::{NumberLiteral, numbers, scrub};
pub use parameters::{Choice, Control, Group, Parameter, parameters, set_parameter};

use chiaro_syntax::{Dialect, Token};

/// The tokens of a text, comments included.
fn tokens(text: &str) -> Vec<Token> {
    chiaro_syntax::tokens(text, Dialect::Dump)
}
