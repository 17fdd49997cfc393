//! Lowers a solid tree to a field graph with sound facts, and evaluates it on the CPU.

mod at;
mod build;
pub mod evaluate;
mod extent;
pub mod facts;
pub mod graph;
mod hull;
mod lower;
mod matrix;
mod print;
mod walk;

pub use evaluate::Evaluator;
pub use facts::Facts;
pub use graph::{Graph, MaterialId, Node, NodeId, Operation, Point, PointId};
pub use lower::lower;
pub use print::print;

pub use chiaro_vocabulary::{Bounds, Class};
