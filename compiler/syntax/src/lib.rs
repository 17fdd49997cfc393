//! The scene language's text: source files, tokens, parser, syntax tree, printer and diagnostics.
//!
//! This crate knows no geometry and never fails: [`parse`] answers a tree for any text at all, together with
//! the diagnostics of whatever was wrong with it.

pub mod diagnostic;
pub mod source;
pub mod tree;

mod customizer;
mod lexer;
mod name;
mod operator;
mod parser;
mod printer;
mod string;
#[cfg(test)]
mod testing;
mod token;

pub use diagnostic::{Diagnostic, Label, Severity, Suggestion};
pub use lexer::tokens;
pub use parser::{Dialect, MAX_FILE_BYTES, MAX_NODES, parse};
pub use printer::print;
pub use source::{FileId, SourceFile, Sources, Span, Spanned, decode};
pub use token::{Token, TokenKind};
