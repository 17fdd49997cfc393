//! The field on the CPU: the vocabulary's own functions, over numbers or over dual numbers for gradients.

mod compiled;
mod memory;
mod query;
mod tree;

use chiaro_vocabulary::Bounds;
use chiaro_vocabulary::cpu::Dual;

use crate::graph::{Graph, NodeId};
use compiled::Compiled;
use memory::Remembered;
use query::Query;

/// Answers distances to a scene while its live parameters have certain values.
///
/// It may be asked from many threads at once; each keeps its own memory from question to question.
#[derive(Debug)]
pub struct Evaluator {
    compiled: Compiled,
    bounds: Vec<Bounds>,
    root: NodeId,
    lipschitz: f64,
}

impl Evaluator {
    /// An evaluator of a graph, for these values of the live parameters in the order of their ids.
    pub fn new(graph: &Graph, parameters: &[f64]) -> Self {
        let bounds = graph.bounds_at(parameters);
        let compiled = Compiled::new(graph, parameters, &bounds);
        let lipschitz = graph.facts[graph.root.0 as usize].lipschitz;
        Self { compiled, bounds, root: graph.root, lipschitz }
    }

    /// The scene's value at a point, in millimetres: a signed distance times at most [`lipschitz`](Self::lipschitz).
    pub fn distance(&self, point: [f64; 3]) -> f64 {
        self.value(self.root, point)
    }

    /// The value of one node at a point.
    pub fn value(&self, node: NodeId, point: [f64; 3]) -> f64 {
        self.query(node, point, point)
    }

    /// The scene's value at a point, with its gradient.
    pub fn gradient(&self, point: [f64; 3]) -> Dual {
        self.query(self.root, Dual::point(point), point)
    }

    /// The unit vector in which the scene's value grows fastest at a point; z where it does not grow at all.
    pub fn normal(&self, point: [f64; 3]) -> [f64; 3] {
        let dual = self.gradient(point);
        let slope = dual.slope();
        if slope > 0.0 && slope.is_finite() {
            dual.gradient.map(|component| component / slope)
        } else {
            [0.0, 0.0, 1.0]
        }
    }

    /// The scene's box while the parameters have these values.
    pub fn bounds(&self) -> Bounds {
        self.bounds[self.root.0 as usize]
    }

    /// The greatest slope of the scene's value: divided by it, the value is a bound of the distance.
    pub fn lipschitz(&self) -> f64 {
        self.lipschitz
    }

    fn query<N: Remembered>(&self, node: NodeId, point: [N; 3], position: [f64; 3]) -> N {
        N::with_memory(|memory| {
            memory.begin(self.compiled.shared_points, self.compiled.shared_nodes);
            Query { compiled: &self.compiled, memory, point, position }.node(node)
        })
    }
}
