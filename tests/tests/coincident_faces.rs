//! Booleans of solids whose faces lie in each other come to what they come to when one of them is pushed out by hand.
//!
//! Two shapes of the vocabulary are put so that a face of one lies in a face of the other, at a random place and turn. Their
//! twin takes the second shape twice, once moved across that face by a little, so that nothing coincides. Signs have to be
//! the same wherever the twin's surface is not near, and where the twin is clear of its surface on the face itself, so has
//! the field to be.

use std::f64::consts::{PI, TAU};
use std::ops::ControlFlow;

use chiaro_compiler::field::Evaluator;
use chiaro_compiler::{Options, Scene, compile};
use chiaro_mesh::{Detail, GraphField, model};
use chiaro_tests::MemoryWorld;
use chiaro_tests::sampling::Random;

type Vec3 = [f64; 3];

/// How far the twin's second shape is moved.
const PUSHED: f64 = 0.02;
/// Where the twin's surface is nearer than this, signs may differ.
const NEAR: f64 = 0.06;

/// A shape with one of its flat faces: a point within it and the direction out of the shape.
struct Shape {
    text: &'static str,
    face: Vec3,
    normal: Vec3,
}

const fn shape(text: &'static str, face: Vec3, normal: Vec3) -> Shape {
    Shape { text, face, normal }
}

/// 1 / √3.
const T: f64 = 0.577_350_269_189_625_8;

/// Shapes of every kind that has a flat face, some ten millimetres in size.
const SHAPES: &[Shape] = &[
    shape("cube([10, 8, 6], center = true);", [0.0, 0.0, 3.0], [0.0, 0.0, 1.0]),
    shape("cube([10, 8, 6], center = true);", [-5.0, 0.0, 0.0], [-1.0, 0.0, 0.0]),
    shape("cylinder(h = 8, r = 4);", [0.0, 0.0, 8.0], [0.0, 0.0, 1.0]),
    shape("cylinder(h = 8, r = 4);", [0.0, 0.0, 0.0], [0.0, 0.0, -1.0]),
    shape("cylinder(h = 7, r1 = 5, r2 = 2);", [0.0, 0.0, 7.0], [0.0, 0.0, 1.0]),
    shape("cylinder(h = 7, r1 = 5, r2 = 2);", [0.0, 0.0, 0.0], [0.0, 0.0, -1.0]),
    shape("cylinder(h = 6, r1 = 3, r2 = 5);", [0.0, 0.0, 6.0], [0.0, 0.0, 1.0]),
    shape("cylinder(h = 9, r = 4, $fn = 6);", [0.0, 0.0, 9.0], [0.0, 0.0, 1.0]),
    shape("cylinder(h = 9, r = 4, $fn = 6);", [3.0, 1.732_050_807_568_877_2, 4.0], [0.866_025_403_784_438_6, 0.5, 0.0]),
    shape(
        "linear_extrude(5) polygon([[0, 0], [8, 0], [8, 3], [3, 3], [3, 9], [0, 9]]);",
        [4.0, 1.5, 5.0],
        [0.0, 0.0, 1.0],
    ),
    shape(
        "linear_extrude(5) polygon([[0, 0], [8, 0], [8, 3], [3, 3], [3, 9], [0, 9]]);",
        [4.0, 0.0, 2.5],
        [0.0, -1.0, 0.0],
    ),
    shape("linear_extrude(6) polygon([[0, 0], [9, 0], [4, 7]]);", [4.5, 0.0, 3.0], [0.0, -1.0, 0.0]),
    shape("linear_extrude(8, twist = 60) square(6, center = true);", [0.0, 0.0, 8.0], [0.0, 0.0, 1.0]),
    shape("linear_extrude(6) square([9, 7]);", [9.0, 3.0, 3.0], [1.0, 0.0, 0.0]),
    shape("rotate_extrude() translate([2, 0]) square([3, 7]);", [3.5, 0.0, 7.0], [0.0, 0.0, 1.0]),
    shape("pyramid(base = 9, h = 7);", [0.0, 0.0, 0.0], [0.0, 0.0, -1.0]),
    shape("octahedron(r = 6);", [2.0, 2.0, 2.0], [T, T, T]),
    shape("tetrahedron(r = 6);", [-2.0 * T, -2.0 * T, -2.0 * T], [-T, -T, -T]),
    shape("icosahedron(r = 6);", [2.752_765_6, 2.752_765_6, 2.752_765_6], [T, T, T]),
    shape("dome(r = 6, cut = 2);", [0.0, 0.0, 2.0], [0.0, 0.0, -1.0]),
    shape("dome(r = 6, cut = -2);", [0.0, 0.0, -2.0], [0.0, 0.0, -1.0]),
    shape(
        "difference() { cube(9, center = true); cylinder(h = 20, r = 2, center = true); }",
        [3.5, 3.5, 4.5],
        [0.0, 0.0, 1.0],
    ),
    shape("intersection() { cube(9, center = true); sphere(5.5); }", [0.0, 4.5, 0.0], [0.0, 1.0, 0.0]),
    shape("union() { cylinder(h = 4, r = 5); cylinder(h = 9, r = 2); }", [0.0, 0.0, 0.0], [0.0, 0.0, -1.0]),
];

#[test]
fn what_is_cut_flush_is_open() {
    let mut looked_at = 0;
    for_pairs(1, |random, a, b| {
        let place = flush(random, a, b, 1.0);
        let twin = moved(place, b, PUSHED);
        let scene = format!("difference() {{ {} {} }}", a.text, place_text(place, b));
        let twin = format!("difference() {{ {} {} {twin} }}", a.text, place_text(place, b));
        looked_at += compare(random, a, &scene, &twin);
    });
    assert!(looked_at > 15_000, "{looked_at} points on faces");
}

#[test]
fn what_abuts_is_one_inside() {
    let mut looked_at = 0;
    for_pairs(2, |random, a, b| {
        let place = flush(random, a, b, -1.0);
        let twin = moved(place, b, -PUSHED);
        let scene = format!("{} {}", a.text, place_text(place, b));
        let twin = format!("{} {} {twin}", a.text, place_text(place, b));
        looked_at += compare(random, a, &scene, &twin);
    });
    assert!(looked_at > 12_000, "{looked_at} points on faces");
}

#[test]
fn what_only_touches_meets_in_nothing_and_cuts_nothing() {
    let mut empty = 0;
    for_pairs(3, |random, a, b| {
        let place = flush(random, a, b, -1.0);
        let scene = format!("intersection() {{ {} {} }}", a.text, place_text(place, b));
        let field = field(&scene);
        let bounds = field.facts().bounds;
        let apart = moved(place, b, 3.0);
        let cut = self::field(&format!("difference() {{ {} {} }}", a.text, place_text(place, b)));
        let whole = self::field(&format!("difference() {{ {} {apart} }}", a.text));
        empty += usize::from(bounds.is_empty());
        for _ in 0..100 {
            let p = on_face(random, a);
            assert!(field.distance(p) >= 0.0, "{scene}: {} at {p:?}", field.distance(p));
            let beside = std::array::from_fn(|i| p[i] - 0.05 * a.normal[i]);
            assert_eq!(cut.distance(beside) < 0.0, whole.distance(beside) < 0.0, "{scene}: at {beside:?}");
        }
    });
    assert!(empty > SHAPES.len() * SHAPES.len() / 2, "{empty} are known to be nothing");
}

/// Shapes about z with a round side of radius 6 about z, or a sphere of radius 6 about the origin, or a hollow of radius 4:
/// where their side is, from what height to what.
const ROUND_SHAPES: &[(&str, f64, [f64; 2])] = &[
    ("cylinder(h = 10, r = 6, center = true);", 6.0, [-5.0, 5.0]),
    ("translate([0, 0, -2]) cylinder(h = 5, r = 6);", 6.0, [-2.0, 3.0]),
    ("rotate_extrude() translate([3, -3]) square([3, 4]);", 6.0, [-3.0, 1.0]),
    ("linear_extrude(4) circle(6);", 6.0, [0.0, 4.0]),
    ("linear_extrude(4) ring(outer = 6, inner = 4);", 6.0, [0.0, 4.0]),
    (
        "difference() { cylinder(h = 6, r = 6, center = true); cylinder(h = 9, r = 4, center = true); }",
        6.0,
        [-3.0, 3.0],
    ),
    ("difference() { cylinder(h = 2, r = 6, center = true); cube([2, 20, 20], center = true); }", 6.0, [-1.0, 1.0]),
    ("linear_extrude(5, center = true) ring(outer = 6, inner = 4);", 4.0, [-2.5, 2.5]),
    (
        "difference() { cylinder(h = 8, r = 7, center = true); cylinder(h = 9, r = 4, center = true); }",
        4.0,
        [-4.0, 4.0],
    ),
    (
        "difference() { cylinder(h = 3, r = 5, center = true); cylinder(h = 9, r = 4, center = true); }",
        4.0,
        [-1.5, 1.5],
    ),
    ("rotate_extrude() translate([4, -1]) square([1.5, 2]);", 4.0, [-1.0, 1.0]),
];

#[test]
fn grooves_in_round_sides_are_open() {
    let mut random = Random::new(4);
    let mut looked_at = 0;
    for (solid, radius, _) in ROUND_SHAPES {
        for (cutter, side, [low, high]) in ROUND_SHAPES.iter().filter(|(_, side, _)| side == radius) {
            let turn = format!("rotate([{0}, {0}, 50]) translate([1, 2, 3])", 360.0 * random.unit());
            let scaled = if *side > 5.0 { 1.01 } else { 0.99 };
            let scene = format!("{turn} difference() {{ {solid} {cutter} }}");
            let twin = format!("{turn} difference() {{ {solid} {cutter} scale([{scaled}, {scaled}, 1]) {cutter} }}");
            let (field, twin_field) = (field(&scene), self::field(&twin));
            let placed = self::field(&format!("{turn} {cutter}"));
            assert!(placed.facts().bounds.is_finite());
            for _ in 0..300 {
                let p: Vec3 = std::array::from_fn(|i| 18.0 * random.unit() - 9.0 + (i as f64) + 1.0);
                let (value, expected) = (field.distance(p), twin_field.distance(p));
                if expected.abs() > 0.2 {
                    assert!(value * expected > 0.0, "{value} instead of {expected} at {p:?}\n{scene}\n{twin}");
                }
            }
            // On the side itself, midway between the cutter's ends.
            let plain = self::field(&format!("difference() {{ {solid} {cutter} }}"));
            let plain_twin =
                self::field(&format!("difference() {{ {solid} {cutter} scale([{scaled}, {scaled}, 1]) {cutter} }}"));
            for _ in 0..60 {
                let (angle, z) = (TAU * random.unit(), low + (high - low) * random.unit());
                let p = [radius * angle.cos(), radius * angle.sin(), z];
                let value = plain.distance(p);
                if value.abs() > 0.005 {
                    looked_at += 1;
                    continue;
                }
                let around: Vec<f64> = ball(p, 0.3).map(|q| plain_twin.distance(q)).collect();
                assert!(around.iter().any(|value| *value < 0.01), "{value} at {p:?}\n{scene}");
            }
        }
    }
    assert!(looked_at > 2_000, "{looked_at} points on sides");
}

/// Scenes with coincident faces and their volumes in cubic millimetres.
const VOLUMES: &[(&str, f64)] = &[
    ("difference() { cube([20, 20, 6]); translate([4, 4, 2]) cube([12, 12, 4]); }", 1824.0),
    ("difference() { cube([20, 20, 6]); translate([10, 10, 0]) cylinder(h = 6, r = 6); }", 2400.0 - 216.0 * PI),
    ("difference() { cube([20, 20, 6]); translate([0, 8, 3]) cube([20, 4, 3]); }", 2160.0),
    ("difference() { cube([20, 20, 6]); translate([16, 0, 0]) cube([4, 4, 6]); }", 2304.0),
    ("difference() { cylinder(h = 10, r = 10); translate([0, 0, 5]) cylinder(h = 5, r = 5); }", 875.0 * PI),
    (
        "difference() { cylinder(h = 10, r = 10); difference() { translate([0, 0, 4]) cylinder(h = 2, r = 10); \
         cylinder(h = 10, r = 8); } }",
        928.0 * PI,
    ),
    ("difference() { cylinder(h = 10, r = 10); cylinder(h = 10, r1 = 3, r2 = 6); }", (1000.0 - 210.0) * PI),
    ("difference() { cube(10); rotate([0, 90, 0]) cylinder(h = 10, r = 4); }", 1000.0 - 40.0 * PI),
    ("difference() { translate([-10, -10, 0]) cube([20, 20, 12]); pyramid(base = 12, h = 8); }", 4800.0 - 384.0),
    (
        "difference() { sphere(10); intersection() { sphere(10); translate([0, -20, -20]) cube(40); } }",
        2000.0 / 3.0 * PI,
    ),
    ("linear_extrude(5) difference() { square(20); translate([5, 0]) square([10, 8]); }", 1600.0),
    ("linear_extrude(5) difference() { circle(10); translate([-10, 0]) square([20, 10]); }", 250.0 * PI),
    ("rotate_extrude() difference() { square([10, 10]); translate([6, 0]) square([4, 10]); }", 360.0 * PI),
    ("cube(10); translate([10, 0, 0]) cube(10); translate([0, 10, 0]) cube([20, 3, 10]);", 2600.0),
    ("cube(10); translate([3, 3, 10]) cylinder(h = 5, r = 3);", 1000.0 + 45.0 * PI),
    ("cylinder(h = 5, r = 6); translate([0, 0, 5]) cylinder(h = 5, r1 = 6, r2 = 2);", 180.0 * PI + 260.0 / 3.0 * PI),
    (
        "difference() { union() { cube([20, 20, 5]); translate([0, 10, 5]) cube([20, 10, 5]); } translate([8, 0, 2]) cube([4, 20, 3]); }",
        2760.0,
    ),
    ("intersection() { cube(10); cube([10, 10, 4]); translate([0, 0, -2]) cylinder(h = 20, r = 30); }", 400.0),
    (
        "difference() { cube(12); translate([6, 6, 6]) cylinder(h = 6, r = 3); translate([6, 6, 0]) cylinder(h = 6, r = 1); }",
        1728.0 - 60.0 * PI,
    ),
    (
        "rotate([20, 30, 40]) difference() { cube([20, 10, 10]); translate([5, 0, 5]) cube([10, 10, 5]); cube([5, 5, 10]); }",
        1250.0,
    ),
];

#[test]
fn meshes_have_the_volume_of_the_set() {
    for (text, expected) in VOLUMES {
        let scene = field(text).scene;
        let graph = scene.picture();
        let found = GraphField::new(&graph, &[]);
        let detail = Detail { tolerance: None, resolution: None };
        let model = model(&found, &detail, &mut |_| ControlFlow::Continue(())).unwrap();
        let volume: f64 = (0..model.mesh.triangles.len())
            .map(|index| {
                let [a, b, c] = model.mesh.corners(index);
                let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
                (0..3).map(|i| a[i] * cross[i]).sum::<f64>() / 6.0
            })
            .sum();
        assert!((volume - expected).abs() < 1e-3 * expected, "{volume} instead of {expected}: {text}");
        assert!(!model.report.misses_parts, "nothing is missing: {text}");
    }
}

/// Calls `check` with every pair of shapes.
fn for_pairs(seed: u64, mut check: impl FnMut(&mut Random, &Shape, &Shape)) {
    let mut random = Random::new(seed);
    for a in SHAPES {
        for b in SHAPES {
            check(&mut random, a, b);
        }
    }
}

/// Compares a scene with its twin: signs everywhere, and values on the face. How many points of the face were clear.
fn compare(random: &mut Random, a: &Shape, scene: &str, twin: &str) -> usize {
    let (field, twin_field) = (field(scene), field(twin));
    let context = || format!("{scene}\n{twin}");
    for _ in 0..150 {
        let p: Vec3 = std::array::from_fn(|_| 24.0 * random.unit() - 12.0);
        let expected = twin_field.distance(p);
        let value = field.distance(p);
        if expected.abs() > NEAR * twin_field.facts().lipschitz {
            assert!(value * expected > 0.0, "{value} instead of {expected} at {p:?}\n{}", context());
        }
    }
    // Where the value is next to nothing, the surface has to be near.
    const REACH: f64 = 0.5;
    let mut clear = 0;
    for _ in 0..40 {
        let p = on_face(random, a);
        let value = field.distance(p);
        if value.abs() > 0.01 * REACH {
            clear += 1;
            continue;
        }
        let around: Vec<f64> = ball(p, REACH).map(|q| twin_field.distance(q)).collect();
        let is_clear = |sign: f64| around.iter().all(|value| sign * value > 0.3 * PUSHED);
        assert!(!is_clear(1.0) && !is_clear(-1.0), "{value} within {REACH} of nothing at {p:?}\n{}", context());
    }
    clear
}

/// Points around a point, and itself moved off the face.
fn ball(p: Vec3, radius: f64) -> impl Iterator<Item = Vec3> {
    (0..400).map(move |k| {
        // Fibonacci's lattice on a sphere, in shells.
        let z = 1.0 - (2.0 * f64::from(k % 50) + 1.0) / 50.0;
        let (angle, across) = (2.399_963_229_728_653 * f64::from(k), (1.0 - z * z).sqrt());
        let r = radius * (0.2 + 0.8 * f64::from(k / 50) / 7.0);
        [p[0] + r * across * angle.cos(), p[1] + r * across * angle.sin(), p[2] + r * z]
    })
}

/// A random point in the plane of a shape's face.
fn on_face(random: &mut Random, a: &Shape) -> Vec3 {
    let [x, y, _] = basis(a.normal);
    let (u, v) = (9.0 * random.unit() - 4.5, 9.0 * random.unit() - 4.5);
    std::array::from_fn(|i| a.face[i] + u * x[i] + v * y[i])
}

/// Where the second shape stands: rows of a map, and the normal of the faces.
#[derive(Clone, Copy)]
struct Place {
    turn: [Vec3; 3],
    at: Vec3,
    normal: Vec3,
}

/// Puts a face of `b` into that of `a`, to the same side or to the opposite one, somewhere and turned somehow.
fn flush(random: &mut Random, a: &Shape, b: &Shape, side: f64) -> Place {
    let goal = basis(a.normal);
    let own = basis(b.normal.map(|x| side * x));
    let angle = TAU * random.unit();
    let (sin, cos) = angle.sin_cos();
    let spun = [
        std::array::from_fn(|i| cos * goal[0][i] + sin * goal[1][i]),
        std::array::from_fn(|i| cos * goal[1][i] - sin * goal[0][i]),
        goal[2],
    ];
    // The turn that takes the axes of the one basis to those of the other.
    let turn: [Vec3; 3] =
        std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| spun[k][i] * own[k][j]).sum()));
    let (u, v) = (5.0 * random.unit() - 2.5, 5.0 * random.unit() - 2.5);
    let at = std::array::from_fn(|i| {
        a.face[i] + u * goal[0][i] + v * goal[1][i] - (0..3).map(|j| turn[i][j] * b.face[j]).sum::<f64>()
    });
    Place { turn, at, normal: a.normal }
}

fn place_text(place: Place, b: &Shape) -> String {
    let row = |i: usize| {
        let [x, y, z] = place.turn[i];
        format!("[{x:.17}, {y:.17}, {z:.17}, {:.17}]", place.at[i])
    };
    format!("multmatrix([{}, {}, {}, [0, 0, 0, 1]]) {}", row(0), row(1), row(2), b.text)
}

/// The second shape moved across the face.
fn moved(place: Place, b: &Shape, by: f64) -> String {
    let at = std::array::from_fn(|i| place.at[i] + by * place.normal[i]);
    place_text(Place { at, ..place }, b)
}

/// Two directions across a direction, and itself.
fn basis(z: Vec3) -> [Vec3; 3] {
    let aside = if z[0].abs() < 0.8 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    let along: f64 = (0..3).map(|i| aside[i] * z[i]).sum();
    let x: Vec3 = std::array::from_fn(|i| aside[i] - along * z[i]);
    let length = x.iter().map(|c| c * c).sum::<f64>().sqrt();
    let x = x.map(|c| c / length);
    [x, [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]], z]
}

/// The field of a scene while its live numbers have their defaults.
struct Field {
    scene: Scene,
    evaluator: Evaluator,
}

impl Field {
    fn distance(&self, p: Vec3) -> f64 {
        self.evaluator.distance(p)
    }

    fn facts(&self) -> chiaro_compiler::field::Facts {
        self.scene.graph.facts[self.scene.graph.root.0 as usize]
    }
}

fn field(text: &str) -> Field {
    let compilation = compile(&MemoryWorld::of("a.csg", text), "a.csg", &Options::default());
    let scene = compilation.scene.unwrap_or_else(|| panic!("{text}: {:?}", compilation.diagnostics));
    let evaluator = Evaluator::new(&scene.graph, &[]);
    Field { scene, evaluator }
}
