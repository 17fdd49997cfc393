//! Lowers a solid tree to a field graph with sound facts, and evaluates it on the CPU.
//!
//! * [`graph`] says what a field graph is, and [`facts`] what is known of its nodes.
//! * [`lower()`] makes one of a solid tree. It fuses transforms, shares what is equal and leaves out what is not seen.
//! * [`lower_with_lineage()`] keeps, beside the graph, what each solid came to: for editors, which go from a surface back
//!   to the text.
//! * [`crowd`] finds the large unions of which little matters at any one place, and what matters where.
//! * [`series`] finds operands that differ by their places and some numbers alone: loops, to who reads the code.
//! * [`Evaluator`] answers distances and gradients; [`Graph::bounds_at`] boxes at certain values of live numbers.
//! * [`Painter`] answers how the surface looks; [`paints`] tells who painted what.
//! * [`print()`] shows a graph as text.
//!
//! Inside, `build` keeps graphs free of duplicates, `checks` refuses numbers that none can use, `extent` measures where nodes are, `walk` visits what they refer
//! to, `pattern` tells what fields have in common, and `matrix` and `hull` do the arithmetic.

mod at;
mod build;
mod checks;
pub mod crowd;
pub mod evaluate;
mod extent;
pub mod facts;
pub mod graph;
mod hull;
pub mod lineage;
mod lower;
mod matrix;
mod painter;
pub mod paints;
mod pattern;
mod print;
pub mod series;
mod walk;

pub use chiaro_vocabulary::{Bounds, Class};
pub use crowd::Crowds;
pub use evaluate::Evaluator;
pub use facts::Facts;
pub use graph::{Graph, MaterialId, Node, NodeId, Operation, Point, PointId};
pub use lineage::{Lineage, Step, StepId};
pub use lower::{lower, lower_with_lineage};
pub use painter::{Look, Painter, linear_from_srgb};
pub use print::print;
pub use series::AllSeries;
