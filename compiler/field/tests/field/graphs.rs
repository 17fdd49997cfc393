//! Trees whose graphs and distances are known.

use std::sync::Arc;

use crate::trees::{boolean, extrude, moved, scaled, shape, solid, transform};
use chiaro_field::{Evaluator, Graph, lower, print};
use chiaro_plane::Region;
use chiaro_solid::{Affine, Boolean, Joint, Material, ParameterId, Profile, Scalar, Solid, SolidKind};
use chiaro_vocabulary::{Interval, rows};

/// The graph of a tree that nothing is to be said about.
fn quiet(root: &Arc<Solid>) -> Graph {
    let (graph, diagnostics) = lower(root);
    assert_eq!(diagnostics, [], "{}", print(&graph));
    graph
}

fn distances<const N: usize>(root: &Arc<Solid>, points: [[f64; 3]; N]) -> [f64; N] {
    let graph = quiet(root);
    let evaluator = Evaluator::new(&graph, &[]);
    points.map(|point| evaluator.distance(point))
}

fn assert_near(found: &[f64], expected: &[f64]) {
    let near = found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-6);
    assert!(near && found.len() == expected.len(), "{found:?} is not {expected:?}");
}

fn assert_prints(graph: &Graph, expected: &str) {
    let squeezed = |text: &str| -> String {
        let lines = text.lines().map(|line| line.split_whitespace().collect::<Vec<_>>().join(" "));
        lines.filter(|line| !line.is_empty()).collect::<Vec<_>>().join("\n")
    };
    assert_eq!(squeezed(&print(graph)), squeezed(expected));
}

#[test]
fn transforms_end_in_one_map_at_the_shape() {
    let turn = Affine::rotation(2, Scalar::from(90.0));
    let root = moved(
        [1.0, 2.0, 3.0],
        transform(turn, scaled([2.0; 3], moved([1.0, 0.0, 0.0], shape(&rows::BOX, &[1.0, 2.0, 3.0])))),
    );
    assert_prints(
        &quiet(&root),
        "q0 = world
         q1 = q0 mapped [0 1 0 -4; -1 0 0 1; 0 0 1 -3]
         d0 = box 2 4 6 at q1    exact (-3 2 -3) to (5 6 9)
         scene d0",
    );
}

#[test]
fn round_shapes_forget_turns_and_stretched_ones_stay_exact() {
    let turn = Affine::rotation(0, Scalar::from(30.0));
    let ball = transform(turn, moved([0.0, 0.0, 2.0], shape(&rows::SPHERE, &[1.0])));
    let boxed = scaled([1.0, 2.0, 3.0], shape(&rows::BOX, &[1.0; 3]));
    assert_prints(
        &quiet(&boolean(Boolean::Union, None, vec![ball, boxed])),
        "q0 = world
         q1 = q0 moved 0 1 -1.73205
         d0 = sphere 1 at q1    exact (-1 -2 0.732051) to (1 0 2.73205)
         d1 = box 1 2 3 at q0    exact (-1 -2 -3) to (1 2 3)
         d2 = union of d0 d1    exact outside (-1 -2 -3) to (1 2 3)
         scene d2",
    );
}

#[test]
fn equal_subtrees_are_one_and_nested_unions_too() {
    let ball = || shape(&rows::SPHERE, &[1.0]);
    let inner = boolean(Boolean::Union, None, vec![ball(), moved([3.0, 0.0, 0.0], ball())]);
    let root = boolean(Boolean::Union, None, vec![moved([3.0, 0.0, 0.0], ball()), inner]);
    assert_prints(
        &quiet(&root),
        "q0 = world
         q1 = q0 moved -3 0 0
         d0 = sphere 1 at q1    exact (2 -1 -1) to (4 1 1)
         d1 = sphere 1 at q0    exact (-1 -1 -1) to (1 1 1)
         d2 = union of d0 d1    exact outside (-1 -1 -1) to (4 1 1)
         scene d2",
    );
}

#[test]
fn what_a_difference_does_not_reach_is_left_out() {
    let hole = |x: f64| moved([x, 0.0, 0.0], shape(&rows::SPHERE, &[1.0]));
    let root = boolean(Boolean::Difference, None, vec![shape(&rows::BOX, &[2.0; 3]), hole(2.0), hole(9.0)]);
    assert_prints(
        &quiet(&root),
        "q0 = world
         q1 = q0 moved -2 0 0
         d0 = box 2 2 2 at q0    exact (-2 -2 -2) to (2 2 2)
         d1 = sphere 1 at q1    exact (1 -1 -1) to (3 1 1)
         d2 = complement of d1    exact (-inf -inf -inf) to (inf inf inf)
         d3 = intersection of d0 d2    bound (-2 -2 -2) to (2 2 2)
         scene d3",
    );
}

#[test]
fn the_outermost_paint_counts() {
    let paint = |red: f64, child| {
        let color = [red, 0.0, 0.0, 1.0].map(Scalar::from);
        solid(SolidKind::Paint(Material::of_color(color), child))
    };
    let graph = quiet(&paint(0.5, paint(1.0, shape(&rows::SPHERE, &[1.0]))));
    assert_prints(
        &graph,
        "q0 = world
         d0 = sphere 1 at q0    exact (-1 -1 -1) to (1 1 1)
         d1 = paint m0 of d0    exact (-1 -1 -1) to (1 1 1)
         m0 = 0.5 0 0 1, roughness 0.45, metallic 0, emission 0
         scene d1",
    );
}

#[test]
fn live_sizes_and_turns_keep_facts_tight() {
    let size = Scalar::parameter(ParameterId(0), Interval::new(1.0, 2.0));
    let angle = Scalar::parameter(ParameterId(1), Interval::new(0.0, 360.0));
    let scale = Affine::scaling([size.clone(), size.clone(), size]);
    let root = transform(scale, transform(Affine::rotation(2, angle), shape(&rows::BOX, &[3.0, 4.0, 1.0])));
    let graph = quiet(&root);
    let facts = graph.facts[graph.root.0 as usize];
    assert_eq!((facts.lipschitz, facts.class), (1.0, chiaro_field::Class::Exact));
    assert_eq!((facts.bounds.min, facts.bounds.max), ([-10.0, -10.0, -2.0], [10.0, 10.0, 2.0]));
    let evaluator = Evaluator::new(&graph, &[2.0, 90.0]);
    assert_near(&evaluator.bounds().max, &[8.0, 6.0, 2.0]);
    assert_near(&[evaluator.distance([10.0, 0.0, 0.0]), evaluator.distance([0.0, 0.0, 0.0])], &[2.0, -2.0]);
}

#[test]
fn extrusions_and_revolutions_are_exact() {
    let tilted =
        transform(Affine::rotation(0, Scalar::from(90.0)), extrude(4.0, 0.0, [1.0; 2], shape(&rows::CIRCLE, &[2.0])));
    assert_near(&distances(&tilted, [[0.0, 1.0, 0.0], [5.0, -2.0, 0.0], [0.0, -6.0, 0.0]]), &[1.0, 3.0, 2.0]);
    let bounds = Evaluator::new(&quiet(&tilted), &[]).bounds();
    assert_near(&bounds.min, &[-2.0, -4.0, -2.0]);

    let region = Region::disc([5.0, 1.0], 1.0);
    let profile = || solid(SolidKind::Region(Arc::new(region.clone())));
    let ring = solid(SolidKind::Revolve { sweep: None, facets: None, child: profile() });
    assert_near(&distances(&ring, [[0.0, 8.0, 1.0], [0.0, 0.0, 1.0]]), &[2.0, 4.0]);

    let sweep = Some([Scalar::ZERO, Scalar::from(std::f64::consts::FRAC_PI_2)]);
    let quarter = solid(SolidKind::Revolve { sweep, facets: None, child: profile() });
    assert_near(&distances(&quarter, [[4.0, 3.0, 1.0], [5.0, -2.0, 1.0]]), &[-1.0, 2.0]);
}

#[test]
fn slices_and_offsets_of_plane_shapes() {
    let disc = solid(SolidKind::Slice(moved([0.0, 0.0, 3.0], shape(&rows::SPHERE, &[5.0]))));
    let column = extrude(10.0, 0.0, [1.0; 2], solid(SolidKind::Offset(Scalar::ONE, disc)));
    // A slice knows the distance to the ball's cut only as a bound.
    let [at_axis, on_surface, beyond] =
        distances(&column, [[0.0, 0.0, 5.0], [27f64.sqrt(), 0.0, 5.0], [30.0, 0.0, 5.0]]);
    assert!(at_axis < 0.0 && on_surface.abs() < 1e-9 && beyond > 0.0, "{at_axis} {on_surface} {beyond}");
}

#[test]
fn hulls_of_spheres() {
    let hull = |spheres: &[([f64; 3], f64)]| {
        let spheres = spheres.iter().map(|(centre, radius)| (centre.map(Scalar::from), Scalar::from(*radius)));
        solid(SolidKind::SphereHull(spheres.collect()))
    };
    let capsule = hull(&[([0.0, 0.0, 0.0], 1.0), ([4.0, 0.0, 0.0], 1.0)]);
    assert_near(&distances(&capsule, [[2.0, 3.0, 0.0], [7.0, 0.0, 0.0]]), &[2.0, 2.0]);
    let plate = hull(&[([0.0, 0.0, 0.0], 1.0), ([4.0, 0.0, 0.0], 1.0), ([0.0, 4.0, 0.0], 1.0)]);
    assert_near(&distances(&plate, [[1.0, 1.0, 3.0], [-3.0, 1.0, 0.0], [1.0, 1.0, 0.0]]), &[2.0, 2.0, -1.0]);
    let corners: Vec<_> =
        (0..8).map(|i| ([f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2)].map(|c| 4.0 * c), 1.0)).collect();
    assert_near(&distances(&hull(&corners), [[2.0, 2.0, 7.0], [2.0, 2.0, 2.0], [7.0, 8.0, 2.0]]), &[2.0, -3.0, 4.0]);

    // A ball between large ones and a far small one: on the cone of half angle asin((3 − 1) / 10) around them.
    let mixed =
        hull(&[([0.0, 0.0, 0.0], 3.0), ([10.0, 0.0, 0.0], 1.0), ([5.0, 0.0, 0.0], 0.5), ([0.0, 9.0, 0.0], 2.0)]);
    let normal_z = (1.0 - 0.2f64.powi(2) - (1.0 / 9.0f64).powi(2)).sqrt();
    let on_plane = |x: f64, y: f64| [x, y, (3.0 - 0.2 * x - y / 9.0) / normal_z];
    let [x, y, z] = on_plane(2.0, 2.0);
    let outside = [x + 0.2, y + 1.0 / 9.0, z + normal_z];
    assert_near(&distances(&mixed, [[x, y, z], outside, [13.0, 0.0, 0.0]]), &[0.0, 1.0, 2.0]);
}

#[test]
fn hulls_of_concentric_spheres_are_the_largest() {
    let ball = |x: Scalar, radius: f64| ([x, Scalar::ZERO, Scalar::ZERO], Scalar::from(radius));
    let hull = |balls: Vec<_>| solid(SolidKind::SphereHull(balls));
    let around = [[0.0, 0.0, 50.0], [0.0, 50.0, 0.0], [50.0, 0.0, 0.0]];
    let two = hull(vec![ball(Scalar::ZERO, 2.0), ball(Scalar::ZERO, 3.0)]);
    assert_near(&distances(&two, around), &[47.0; 3]);
    let inner = hull(vec![ball(Scalar::ZERO, 5.0), ball(Scalar::ZERO, 1.0), ball(Scalar::ONE, 2.0)]);
    assert_near(&distances(&inner, around), &[45.0; 3]);
    // Two that meet for one value of a live number.
    let live = Scalar::parameter(ParameterId(0), Interval::new(0.0, 10.0));
    let graph = quiet(&hull(vec![ball(Scalar::ZERO, 2.0), ball(live, 2.0)]));
    for (x, expected) in [(0.0, [48.0, 48.0, 48.0]), (10.0, [48.0, 48.0, 38.0])] {
        let evaluator = Evaluator::new(&graph, &[x]);
        assert_near(&around.map(|point| evaluator.distance(point)), &expected);
    }
}

#[test]
fn nested_warps_are_measured_once_each() {
    let mut root = shape(&rows::BOX, &[1.0; 3]);
    for _ in 0..40 {
        root = solid(SolidKind::Twist(Scalar::from(1e-14), root));
    }
    assert_near(&distances(&root, [[0.0, 0.0, 3.0]]), &[2.0]);
}

#[test]
fn a_fillet_between_walls_is_the_circle_of_its_radius() {
    let wall = |x: f64, y: f64| moved([x, y, 0.0], shape(&rows::BOX, &[5.0, 5.0, 50.0]));
    let joint = Joint { profile: Profile::Fillet, radius: Scalar::from(2.0) };
    let root = boolean(Boolean::Union, Some(joint), vec![wall(-5.0, 0.0), wall(0.0, -5.0)]);
    let on_circle = 2.0 - 2f64.sqrt();
    assert_near(&distances(&root, [[on_circle, on_circle, 0.0], [2.0, 0.0, 0.0]]), &[0.0, 0.0]);
}

#[test]
fn warnings_and_errors_name_what_is_wrong() {
    let messages = |root: &Arc<Solid>| lower(root).1.into_iter().map(|d| d.message).collect::<Vec<_>>();
    let twist = |child| solid(SolidKind::Twist(Scalar::from(0.5), child));
    assert_eq!(
        messages(&twist(shape(&rows::BOX, &[3.0, 4.0, 1.0]))),
        ["this twist makes distances 2.9 times too long here"]
    );
    assert_eq!(messages(&twist(shape(&rows::GYROID, &[3.0, 1.0]))), ["an endless solid can't be twisted"]);
    let fast = |rate: f64, child| solid(SolidKind::Twist(Scalar::from(rate), child));
    assert_eq!(
        messages(&fast(1e12, shape(&rows::BOX, &[1.0; 3]))),
        ["this twist makes distances more than 1e9 times too long"]
    );
    let within_each_other = fast(1e4, fast(1e4, fast(1e4, shape(&rows::BOX, &[1.0; 3]))));
    let last = messages(&within_each_other).pop();
    assert_eq!(last.unwrap(), "twists in one another make distances more than 1e9 times too long here");
    let torus = scaled([1.0, 1.0, 20.0], shape(&rows::TORUS, &[5.0, 1.0]));
    assert_eq!(messages(&torus), ["this stretches one direction 20.0 times more than another"]);
    let live = Scalar::parameter(ParameterId(0), Interval::new(1.0, 2.0));
    let ball = |x: f64| ([Scalar::from(x), live.clone(), Scalar::from(x * x)], Scalar::ONE);
    let hull = solid(SolidKind::SphereHull(vec![ball(0.0), ball(1.0), ball(2.0)]));
    assert_eq!(messages(&hull), ["the centres of three or more hulled spheres have to be constant"]);
}

#[test]
fn deep_trees_fit_on_small_stacks() {
    let mut root = shape(&rows::SPHERE, &[1.0]);
    for _ in 0..1000 {
        root = moved([0.01, 0.0, 0.0], solid(SolidKind::Offset(Scalar::from(0.001), root)));
    }
    assert_near(&distances(&root, [[15.0, 0.0, 0.0]]), &[3.0]);
}

#[test]
fn what_is_steep_slows_nothing_that_is_far_from_it() {
    let thread = extrude(10.0, 3600.0, [1.0; 2], moved([1.0, 0.0, 0.0], shape(&rows::CIRCLE, &[1.0])));
    let ball = moved([100.0, 0.0, 0.0], shape(&rows::SPHERE, &[5.0]));
    let (graph, diagnostics) = lower(&boolean(Boolean::Union, None, vec![thread, ball]));
    assert_eq!(diagnostics.len(), 1, "the thread is warned of");
    assert_eq!(graph.facts[graph.root.0 as usize].lipschitz, 1.0);
    let evaluator = Evaluator::new(&graph, &[]);
    let beside = evaluator.distance([-50.0, 0.0, 5.0]);
    assert!((45.0..50.0).contains(&beside), "{beside}");
    assert!(evaluator.distance([0.0, 0.0, 5.0]) <= 0.0);
}
