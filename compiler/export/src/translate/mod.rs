//! From WGSL to other languages, for people to read.
//!
//! Theory: The vocabulary, the scene's functions and the templates are WGSL, and what is exported is that very text in
//! another language: every function, comment, loop and name stays. A syntax tree ([`wgsl_parse`]) says what is
//! written; [`Typing`] adds the types that WGSL infers and other languages want to read.
//! Changes: naga has writers for the same languages, but of its own form of a module: without comments, with loops undone,
//! expressions split, and names with numbers behind.
//! Practice: a subset suffices. What is outside of it is an error that names it, never a wrong text.

mod builtins;
mod comments;
mod dialect;
mod expression;
mod layout;
mod members;
mod reach;
mod statement;
mod types;
mod typing;

use wgsl_parse::parse_str;

pub use dialect::Dialect;
pub(crate) use reach::words;

/// Why a text can't be translated.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TranslationError {
    /// It isn't WGSL.
    #[error("the shader code is not WGSL: {0}")]
    Syntax(String),
    /// It is WGSL, and uses what other languages don't have or are not told.
    #[error("{0} can't be written in this language")]
    Unsupported(String),
}

impl TranslationError {
    fn unsupported(what: impl Into<String>) -> Self {
        Self::Unsupported(what.into())
    }
}

/// How live parameters are read. In WGSL they are the members of the uniform variable `parameters`.
#[derive(Clone, Copy)]
pub enum Parameters<'a> {
    /// Each is a variable of the text, whose name this tells.
    Variables(&'a dyn Fn(&str) -> String),
    /// Functions get them as a first argument, `parameters`, a constant reference to the struct `Parameters`.
    Passed,
}

/// The declarations of a WGSL text in another language. Variables that are bound to resources are left out: how those are
/// declared is the target's affair.
pub fn translate(wgsl: &str, dialect: Dialect, parameters: Parameters) -> Result<String, TranslationError> {
    let unit = parse_str(wgsl).map_err(|error| TranslationError::Syntax(error.to_string()))?;
    layout::Writer::new(wgsl, &unit, dialect, parameters)?.write(&unit)
}
