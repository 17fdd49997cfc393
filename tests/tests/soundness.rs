//! What the compiler claims of a field holds at sampled points, for every scene of ours, every one of the suite and every
//! example that OpenSCAD's package brings: the Lipschitz constant, the bounds, and that exact distances are no shorter
//! than the way to the surface. Each test counts what it looked at, since one that looks at nothing finds nothing.

use chiaro_compiler::field::{Class, Evaluator, Facts};
use chiaro_compiler::vocabulary::Bounds;
use chiaro_tests::corpus::{Subject, every_scene};
use chiaro_tests::sampling::{Random, distance, sample_box};

/// Rounding of f64 through some hundred operations, relative to the coordinates.
const ROUNDING: f64 = 1e-9;

/// A scene's field at the defaults of its live parameters.
struct Sampled {
    subject: &'static Subject,
    facts: Facts,
    evaluator: Evaluator,
    /// Where samples are drawn from.
    bounds: Bounds,
}

/// The fields of all scenes that aren't empty.
fn fields() -> impl Iterator<Item = Sampled> {
    let of = |subject: &'static Subject| {
        let graph = &subject.scene.graph;
        let facts = graph.facts[graph.root.0 as usize];
        let evaluator = Evaluator::new(graph, &subject.scene.defaults());
        Sampled { subject, facts, evaluator, bounds: sample_box(&facts.bounds) }
    };
    every_scene().iter().map(of).filter(|field| !field.facts.bounds.is_empty())
}

#[test]
fn values_change_no_faster_than_the_lipschitz_constant() {
    let (mut pairs, mut sloped) = (0, 0);
    for Sampled { subject, facts, evaluator, bounds } in fields() {
        let path = &subject.path;
        let mut random = Random::new(1);
        let slack = ROUNDING * (1.0 + bounds.diagonal());
        let mut steepest = 0.0_f64;
        for _ in 0..400 {
            let p = random.point(&bounds);
            // Neighbours show the slope, far points the claim that values are distances.
            for reach in [1e-3, 0.03, 1.0] {
                let other = random.point(&bounds);
                let q = std::array::from_fn(|axis| p[axis] + reach * (other[axis] - p[axis]));
                let [here, there] = [p, q].map(|point| evaluator.distance(point));
                let change = (here - there).abs();
                let most = facts.lipschitz * distance(p, q);
                // What is enormous has the rounding of its own size.
                let slack = slack + 4.0 * f64::EPSILON * here.abs();
                assert!(change <= most * (1.0 + ROUNDING) + slack, "{path:?}: from {p:?} to {q:?}: {change} > {most}");
                steepest = steepest.max(change / distance(p, q));
                pairs += 1;
            }
        }
        sloped += usize::from(steepest > 0.5 * facts.lipschitz);
    }
    assert!(pairs >= 230_000, "{pairs} pairs");
    assert!(sloped >= 190, "of only {sloped} fields pairs are half as steep as claimed");
}

#[test]
fn there_is_nothing_outside_the_bounds() {
    let (mut outside, mut inside) = (0, 0);
    for Sampled { subject, facts, evaluator, bounds } in fields() {
        let mut random = Random::new(2);
        let mut meets = false;
        for _ in 0..2_000 {
            let p = random.point(&bounds);
            let value = evaluator.distance(p);
            if facts.bounds.distance(p) > 0.0 {
                assert!(value > 0.0, "{:?}: {value} at {p:?}, outside {:?}", subject.path, facts.bounds);
                outside += 1;
            }
            meets |= value < 0.0;
        }
        inside += usize::from(meets);
    }
    assert!(outside >= 330_000, "{outside} points are outside");
    assert!(inside >= 180, "samples meet the inside of only {inside} scenes");
}

/// From a point with an exact distance there is a way of that length to the surface, straight down the gradient.
#[test]
fn exact_distances_lead_to_the_surface() {
    let (mut scenes, mut points) = (0, 0);
    for Sampled { subject, facts, evaluator, bounds } in fields() {
        if facts.class == Class::Bound {
            continue;
        }
        scenes += 1;
        let mut random = Random::new(3);
        let slack = 1e-6 * (1.0 + bounds.diagonal());
        for _ in 0..300 {
            let p = random.point(&bounds);
            let value = evaluator.distance(p);
            if facts.class == Class::ExactOutside && value < 0.0 {
                continue;
            }
            let down = evaluator.normal(p).map(|component| -component * value / facts.lipschitz);
            let foot = std::array::from_fn(|axis| p[axis] + down[axis]);
            let left = evaluator.distance(foot);
            assert!(left.abs() <= slack, "{:?}: {left} is left of {value} at {p:?}", subject.path);
            points += 1;
        }
    }
    assert!(scenes >= 120 && points >= 34_000, "{points} points of {scenes} scenes");
}
