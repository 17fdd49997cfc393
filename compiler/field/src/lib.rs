//! Lowers a solid tree to a field graph with sound facts, and evaluates it on the CPU.

pub mod facts;
pub mod graph;

pub use facts::Facts;
pub use graph::{Graph, MaterialId, Node, NodeId, Operation, Point, PointId};
