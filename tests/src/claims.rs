//! What a field claims of itself, asked at random points.

use chiaro_compiler::field::{Evaluator, Graph};

use crate::sampling::{Random, distance, sample_box};

/// Rounding of f64 through some hundred operations, relative to the numbers involved.
const ROUNDING: f64 = 1e-9;

/// How much slopes may be above what is claimed: where a function bends, a dual number rounds more than a value.
const SLOPE: f64 = 1e-6;

/// The first claim of a field that is broken at `count` random points, while its live parameters have these values: its
/// values are finite, those inside the solid lie within the bounds, and they change no faster than L, from point to
/// point and by their gradients.
pub fn broken(graph: &Graph, parameters: &[f64], random: &mut Random, count: usize) -> Option<String> {
    let facts = graph.facts[graph.root.0 as usize];
    if facts.bounds.is_empty() {
        return None;
    }
    let evaluator = Evaluator::new(graph, parameters);
    let bounds = sample_box(&facts.bounds);
    let slack = ROUNDING * (1.0 + bounds.diagonal());
    let mut last = None;
    for _ in 0..count {
        let p = random.point(&bounds);
        let (value, dual) = (evaluator.distance(p), evaluator.gradient(p));
        if !value.is_finite() || !dual.gradient.iter().all(|slope| slope.is_finite()) {
            return Some(format!("the value at {p:?} is {value}, the gradient {:?}", dual.gradient));
        }
        if value < -slack && facts.bounds.distance(p) > slack {
            return Some(format!("{value} at {p:?} is outside {:?}", facts.bounds));
        }
        if dual.slope() > facts.lipschitz * (1.0 + SLOPE) + SLOPE {
            return Some(format!("the slope at {p:?} is {}, above {}", dual.slope(), facts.lipschitz));
        }
        if let Some((q, other)) = last.replace((p, value)) {
            let most = facts.lipschitz * distance(p, q) * (1.0 + ROUNDING) + slack;
            if (value - other).abs() > most {
                return Some(format!("{value} at {p:?} and {other} at {q:?} differ by more than {most}"));
            }
        }
    }
    None
}
