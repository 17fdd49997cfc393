//! What the graph claims of itself holds, sampled over random trees.

use crate::trees::{self, Random, Trees};
use chiaro_field::{Class, Evaluator, Graph, Node, NodeId, lower};
use chiaro_solid::{ParameterId, Scalar};
use chiaro_vocabulary::Interval;

/// How much the tests looked at, since one that looks at nothing finds nothing.
#[derive(Debug, Default)]
struct Seen {
    /// Graphs at certain values of their parameters, with something in them.
    graphs: usize,
    /// Of these, the ones with points inside.
    entered: usize,
    /// Of these, the ones whose class is better than a bound.
    exact: usize,
    /// Of these, the ones with slopes of half of what is claimed or more.
    steep: usize,
}

/// The first claim of a graph that does not hold at some values of its parameters.
fn broken(graph: &Graph, parameters: &[f64], random: &mut Random, seen: &mut Seen) -> Option<String> {
    const SLACK: f64 = 1e-6;
    let evaluator = Evaluator::new(graph, parameters);
    let facts = &graph.facts[graph.root.0 as usize];
    let (now, lipschitz) = (evaluator.bounds(), facts.lipschitz);
    if now.is_empty() {
        return None;
    }
    let reach = (0..3).map(|axis| now.axis(axis).magnitude()).filter(|m| m.is_finite()).fold(5.0, f64::max);
    let points: Vec<[f64; 3]> =
        (0..120).map(|i| random.point(if i % 3 == 0 { reach.min(8.0) } else { 1.4 * reach })).collect();
    let values: Vec<f64> = points.iter().map(|point| evaluator.distance(*point)).collect();
    let mut steepest = 0.0_f64;
    for (p, f) in points.iter().zip(&values) {
        let dual = evaluator.gradient(*p);
        steepest = steepest.max(dual.slope());
        let claims = [
            ("is finite", f.is_finite()),
            ("lies within the bounds", *f > -SLACK || facts.bounds.distance(*p) <= SLACK),
            ("lies within the present bounds", *f > -SLACK || now.distance(*p) <= SLACK),
            (
                "is as far as the bounds",
                facts.class == Class::Bound
                    || *f >= now.distance(*p) * lipschitz.recip() - SLACK
                    || now.distance(*p) == 0.0,
            ),
            ("is the dual number's", (dual.value - f).abs() <= SLACK * (1.0 + f.abs())),
            ("has a slope within L", dual.slope() <= lipschitz * (1.0 + SLACK) + SLACK),
        ];
        if let Some((claim, _)) = claims.iter().find(|(_, holds)| !holds) {
            return Some(format!("{f} at {p:?} {claim}: L = {lipschitz}, slope {}, {facts:?}, {now:?}", dual.slope()));
        }
    }
    for (i, (p, f)) in points.iter().zip(&values).enumerate() {
        for (q, g) in points.iter().zip(&values).skip(i + 1) {
            let apart = (0..3).map(|axis| (p[axis] - q[axis]).powi(2)).sum::<f64>().sqrt();
            if (f - g).abs() > lipschitz * apart * (1.0 + SLACK) + SLACK {
                return Some(format!("{f} at {p:?} and {g} at {q:?} differ within L = {lipschitz}"));
            }
        }
    }
    seen.graphs += 1;
    seen.entered += usize::from(values.iter().any(|value| *value < 0.0));
    seen.exact += usize::from(facts.class != Class::Bound);
    seen.steep += usize::from(steepest >= 0.5 * lipschitz);
    None
}

/// The first claim of a graph about any of its nodes that does not hold.
fn broken_inside(graph: &Graph, parameters: &[f64], random: &mut Random) -> Option<String> {
    const SLACK: f64 = 1e-6;
    let evaluator = Evaluator::new(graph, parameters);
    let points: Vec<[f64; 3]> = (0..24).map(|_| random.point(12.0)).collect();
    let mut tapered = vec![false; graph.nodes.len()];
    for (index, node) in graph.nodes.iter().enumerate().rev() {
        let below = tapered[index] || matches!(node, Node::Taper(..));
        node.children().iter().for_each(|child| tapered[child.0 as usize] |= below);
    }
    for (index, facts) in graph.facts.iter().enumerate() {
        let values: Vec<f64> = points.iter().map(|p| evaluator.value(NodeId(index as u32), *p)).collect();
        let outside = points.iter().zip(&values).find(|(p, f)| **f < -SLACK && facts.bounds.distance(**p) > SLACK);
        if let Some((p, f)) = outside {
            return Some(format!("d{index} is {f} at {p:?}, outside of {:?}", facts.bounds));
        }
        let near = points.iter().zip(&values).find(|(p, f)| {
            let beyond = |axis: usize| (facts.bounds.min[axis] - p[axis]).max(p[axis] - facts.bounds.max[axis]);
            let gap = (0..3).map(beyond).fold(0.0, f64::max);
            facts.growth.is_finite() && gap > facts.growth * f.max(0.0) * (1.0 + SLACK) + SLACK
        });
        if let Some((p, f)) = near {
            return Some(format!("d{index} is {f} at {p:?}, too far from {facts:?}"));
        }
        for (pair, f) in points.windows(2).zip(values.windows(2)) {
            let apart = (0..3).map(|axis| (pair[0][axis] - pair[1][axis]).powi(2)).sum::<f64>().sqrt();
            let steep = (f[0] - f[1]).abs() > facts.lipschitz * apart * (1.0 + SLACK) + SLACK;
            if steep && !tapered[index] {
                return Some(format!("d{index} is {f:?} at {pair:?} with L = {}", facts.lipschitz));
            }
        }
    }
    None
}

fn is_error(diagnostic: &chiaro_syntax::Diagnostic) -> bool {
    diagnostic.severity == chiaro_syntax::Severity::Error
}

/// Every node of an unpruned evaluation is what the pruned one says.
fn unpruned(graph: &Graph, evaluator: &Evaluator, point: [f64; 3]) -> f64 {
    let chiaro_field::Node::Boolean(chiaro_field::Operation::Union, None, children) =
        &graph.nodes[graph.root.0 as usize]
    else {
        return evaluator.distance(point);
    };
    children.iter().map(|child: &NodeId| evaluator.value(*child, point)).fold(f64::INFINITY, f64::min)
}

#[test]
fn constant_trees() {
    let (mut failures, mut seen) = (Vec::new(), Seen::default());
    for seed in 0..1500 {
        let mut random = Random(seed);
        let mut number = |random: &mut Random, least, most| Scalar::from(random.within(least, most));
        let depth = 1 + (seed % 4) as u32;
        let root = Trees { random: &mut random, number: &mut number }.space(depth);
        let (graph, diagnostics) = lower(&root);
        if diagnostics.iter().any(is_error) {
            continue;
        }
        let what = broken(&graph, &[], &mut random, &mut seen).or_else(|| broken_inside(&graph, &[], &mut random));
        failures.extend(what.map(|what| format!("seed {seed}: {what}")));
    }
    assert!(failures.is_empty(), "{} failures:\n{}", failures.len(), failures.join("\n"));
    assert!(seen.graphs >= 1_450 && seen.entered >= 1_100, "{seen:?}");
    assert!(seen.exact >= 450 && seen.steep >= 1_400, "{seen:?}");
}

#[test]
fn live_trees() {
    let (mut failures, mut seen) = (Vec::new(), Seen::default());
    for seed in 0..700 {
        let mut random = Random(seed ^ 0xabcd_ef00);
        let mut ranges: Vec<Interval> = Vec::new();
        let mut number = |random: &mut Random, least: f64, most: f64| {
            let (a, b) = (random.within(least, most), random.within(least, most));
            if random.below(3) > 0 {
                return Scalar::from(a);
            }
            let range = Interval::new(a, b);
            ranges.push(range);
            Scalar::parameter(ParameterId(ranges.len() as u32 - 1), range)
        };
        let depth = 1 + (seed % 3) as u32;
        let root = Trees { random: &mut random, number: &mut number }.space(depth);
        let (graph, diagnostics) = lower(&root);
        if diagnostics.iter().any(is_error) {
            continue;
        }
        for _ in 0..3 {
            let parameters: Vec<f64> = ranges.iter().map(|range| random.within(range.min, range.max)).collect();
            let what = broken(&graph, &parameters, &mut random, &mut seen);
            failures.extend(what.map(|what| format!("seed {seed}: {what}")));
        }
    }
    assert!(failures.is_empty(), "{} failures:\n{}", failures.len(), failures.join("\n"));
    assert!(seen.graphs >= 2_000 && seen.entered >= 1_600, "{seen:?}");
    assert!(seen.exact >= 680 && seen.steep >= 2_000, "{seen:?}");
}

#[test]
fn pruned_unions_have_the_values_of_all_their_operands() {
    use chiaro_solid::Boolean;
    use chiaro_vocabulary::rows;
    for seed in 0..20 {
        let mut random = Random(seed);
        let balls = (0..200).map(|index| {
            let size = random.within(0.2, 3.0);
            let row = if index % 2 == 0 {
                trees::shape(&rows::SPHERE, &[size])
            } else {
                trees::shape(&rows::BOX, &[size; 3])
            };
            trees::moved(random.point(20.0), row)
        });
        let root = trees::boolean(Boolean::Union, None, balls.collect());
        let (graph, _) = lower(&root);
        let evaluator = Evaluator::new(&graph, &[]);
        for _ in 0..200 {
            let point = random.point(25.0);
            assert_eq!(evaluator.distance(point), unpruned(&graph, &evaluator, point));
        }
    }
}
