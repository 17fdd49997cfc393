//! Numbers that a field has to be safe from: none at all, too large ones, and those that steep shears make.

use std::sync::Arc;

use crate::trees::{Random, moved, shape, solid, transform};
use chiaro_field::{Evaluator, Graph, lower};
use chiaro_solid::scalar::Function;
use chiaro_solid::{Affine, Material, ParameterId, Scalar, Solid, SolidKind};
use chiaro_syntax::Severity;
use chiaro_vocabulary::{Interval, rows};

/// x grows with y.
fn shear(k: Scalar) -> Affine {
    let (zero, one) = (|| Scalar::ZERO, || Scalar::ONE);
    Affine::new([[one(), k, zero(), zero()], [zero(), one(), zero(), zero()], [zero(), zero(), one(), zero()]])
}

fn graph(root: &Arc<Solid>) -> Graph {
    let (graph, diagnostics) = lower(root);
    let errors: Vec<_> = diagnostics.iter().filter(|said| said.severity == Severity::Error).collect();
    assert!(errors.is_empty(), "{errors:?}");
    graph
}

/// The error of a tree.
fn error(root: &Arc<Solid>) -> String {
    let (_, diagnostics) = lower(root);
    let error = diagnostics.into_iter().find(|said| said.severity == Severity::Error);
    error.map_or(String::new(), |error| error.message)
}

/// Asks for gradients around the shear of a cube of edge length 2 by k, along it and beside it.
fn assert_sound(graph: &Graph, parameters: &[f64], k: f64) {
    let evaluator = Evaluator::new(graph, parameters);
    let facts = &graph.facts[graph.root.0 as usize];
    let mut random = Random(7);
    for round in 0..600 {
        let [x, y, z] = random.point(1.5);
        // Far ends, the middle, and all directions around it.
        let sheared = [[x + k * y, y, z], [x, y, z], [k * x, k * y, k * z], [k * y, x, z]][round % 4];
        let (value, dual) = (evaluator.distance(sheared), evaluator.gradient(sheared));
        assert!(value.is_finite() && dual.slope().is_finite(), "{k}: {value} at {sheared:?}");
        assert!(dual.slope() <= facts.lipschitz * (1.0 + 1e-6), "{k}: {} at {sheared:?}, {facts:?}", dual.slope());
        assert!(value > -1e-6 || facts.bounds.distance(sheared) <= 1e-6 * k, "{k}: {value} at {sheared:?}");
    }
    // Its middle and what is on the line through it are inside, as its faces at z = ±1 are at the surface.
    for y in [-0.9, 0.0, 0.9] {
        assert!(evaluator.distance([k * y, y, 0.0]) < 0.0, "{k}: {y}");
        assert!(evaluator.distance([k * y, y, 0.999]) < 0.0, "{k}: {y}");
        assert!(evaluator.distance([k * y, y, 1.001]) > 0.0, "{k}: {y}");
    }
}

#[test]
fn shears_of_any_steepness_are_sound() {
    let cube = || shape(&rows::BOX, &[1.0; 3]);
    for k in [0.5, 3.0, 300.0, 1e3, 1e5, 1e7, 1e9] {
        assert_sound(&graph(&transform(shear(Scalar::from(k)), cube())), &[], k);
        let live = Scalar::parameter(ParameterId(0), Interval::new(0.0, k));
        let live = transform(shear(live), cube());
        if k > 1e7 {
            // What is known of all values together has no room then.
            assert!(error(&live).starts_with("this reaches farther"), "{k}: {}", error(&live));
            continue;
        }
        let live = graph(&live);
        for part in [1e-6, 1e-3, 0.3, 1.0] {
            assert_sound(&live, &[part * k], part * k);
        }
    }
}

#[test]
fn sheared_plane_shapes_are_sound() {
    for k in [300.0, 1e5, 1e9] {
        let square = transform(shear(Scalar::from(k)), shape(&rows::RECTANGLE, &[1.0, 1.0]));
        let straight = |child| SolidKind::Extrude {
            height: Scalar::from(2.0),
            twist: Scalar::ZERO,
            scale: [Scalar::ONE, Scalar::ONE],
            child,
        };
        assert_sound(&graph(&moved([0.0, 0.0, -1.0], solid(straight(square)))), &[], k);
    }
}

/// Turns have the determinant 1, whatever their angles are: so a shear under live turns stays live.
#[test]
fn a_shear_between_live_turns_is_finite() {
    let angle = |id| Scalar::parameter(ParameterId(id), Interval::new(-360.0, 360.0));
    let stretch = Affine::scaling([1.0, 1.0, 3.0].map(Scalar::from)).after(&shear(Scalar::from(2.0)));
    let turned = Affine::rotation(0, angle(0)).after(&stretch).after(&Affine::rotation(1, angle(1)));
    let graph = graph(&transform(turned, shape(&rows::BOX, &[1.0, 2.0, 3.0])));
    assert!(!graph.slots.is_empty() && graph.slots.iter().all(Scalar::is_finite));
    let lipschitz = graph.facts[graph.root.0 as usize].lipschitz;
    let mut random = Random(3);
    for _ in 0..200 {
        let parameters = [random.within(-360.0, 360.0), random.within(-360.0, 360.0)];
        let evaluator = Evaluator::new(&graph, &parameters);
        let slope = evaluator.gradient(random.point(20.0)).slope();
        assert!(slope <= lipschitz * (1.0 + 1e-9), "{slope} > {lipschitz} at {parameters:?}");
    }
}

#[test]
fn what_is_no_number_is_an_error_wherever_it_is() {
    let ball = || shape(&rows::SPHERE, &[1.0]);
    let live = Scalar::parameter(ParameterId(0), Interval::new(0.0, 5.0));
    let angle = Scalar::apply(Function::Asin, vec![live]);
    let painted = |roughness| Material { roughness, ..Material::default() };
    for odd in [Scalar::from(f64::NAN), Scalar::from(f64::INFINITY), angle] {
        let trees = [
            solid(SolidKind::Shape(&rows::SPHERE, vec![odd.clone()])),
            transform(Affine::translation([Scalar::ZERO, odd.clone(), Scalar::ZERO]), ball()),
            solid(SolidKind::Offset(odd.clone(), ball())),
            solid(SolidKind::Paint(painted(odd.clone()), ball())),
        ];
        for tree in trees {
            assert!(error(&tree).starts_with("a measure of this "), "{odd:?}: {:?}", lower(&tree));
        }
    }
}

#[test]
fn what_is_too_far_away_is_an_error() {
    let far = |x| moved([x, 0.0, 0.0], shape(&rows::BOX, &[1.0; 3]));
    assert_eq!(error(&far(9e14)), "");
    assert_eq!(error(&far(1e20)), "this reaches farther than 1e15 mm, for which numbers have no room");
    let live = Scalar::parameter(ParameterId(0), Interval::new(0.0, 1e20));
    let live = transform(Affine::translation([live, Scalar::ZERO, Scalar::ZERO]), shape(&rows::BOX, &[1.0; 3]));
    assert_eq!(error(&live), "this reaches farther than 1e15 mm, for which numbers have no room");
}
