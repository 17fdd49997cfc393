//! Every shape and operator, once: its WGSL, its row in the table, its value on the CPU.
//!
//! A primitive is one WGSL function in `wgsl/` and one [`Row`] in [`rows`](mod@rows). What the evaluator accepts, the
//! manual, the shader library and the CPU's distances all derive from that pair.
//!
//! # To add a primitive
//!
//! 1. Write its function in `wgsl/`, beside its like. It takes a point `p` (or a distance `d`) and then its parameters;
//!    [`Kind`] says what it answers. Keep to `let` and `select`: no branches, loops or variables. It must be finite at
//!    every point, and its slope at most 1: divide a looser bound by its constant. Say where the formula is from.
//! 2. Write its row in `src/rows/`, with the same parameters in the same order, and add it to the list in `rows.rs`.
//!    `class` is a promise that marching and joints rely on; the tests sample it.

pub mod bounds;
pub mod cpu;
pub mod form;
pub mod interval;
mod library;
pub mod rows;
pub mod table;

pub use bounds::Bounds;
pub use form::Form;
pub use interval::Interval;
pub use library::{module, source};
pub use rows::{row, rows};
pub use table::{Class, Kind, Parameter, Row, Type, Unit};
