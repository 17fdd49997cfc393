//! Fields of arbitrary trees of shapes and operators keep to their Lipschitz constants and bounds.
#![no_main]

use arbitrary::Arbitrary;
use chiaro_compiler::field::Evaluator;
use chiaro_compiler::{Options, compile};
use chiaro_tests::MemoryWorld;
use chiaro_tests::sampling::{Random, distance, sample_box};
use libfuzzer_sys::fuzz_target;

/// A tree of modules, which prints as a program.
#[derive(Arbitrary, Debug)]
enum Tree {
    Sphere(u8),
    Cube([u8; 3]),
    Cylinder(u8, u8, u8),
    Torus(u8, u8),
    Extruded(i8, u8, u8),
    Revolved(u8, u8),
    Moved([i8; 3], Box<Tree>),
    Turned([i8; 3], Box<Tree>),
    Scaled([i8; 3], Box<Tree>),
    Twisted(i8, Box<Tree>),
    Union(u8, Box<[Tree; 2]>),
    Difference(u8, Box<[Tree; 2]>),
    Intersection(u8, Box<[Tree; 3]>),
}

impl Tree {
    fn program(&self) -> String {
        let all = |trees: &[Tree]| trees.iter().map(Tree::program).collect::<String>();
        match self {
            Tree::Sphere(r) => format!("sphere({r});"),
            Tree::Cube([x, y, z]) => format!("cube([{x}, {y}, {z}]);"),
            Tree::Cylinder(h, a, b) => format!("cylinder({h}, {a}, {b});"),
            Tree::Torus(major, minor) => format!("torus({major}, {minor});"),
            Tree::Extruded(twist, scale, size) => {
                let scale = f64::from(*scale) / 64.0;
                format!("linear_extrude({size}, twist = {twist}, scale = {scale}) square([{size}, 3]);")
            }
            Tree::Revolved(angle, x) => format!("rotate_extrude({angle}) translate([{x}, 1]) square([4, 5]);"),
            Tree::Moved(by, tree) => format!("translate({by:?}) {{ {} }}", tree.program()),
            Tree::Turned(by, tree) => format!("rotate({by:?}) {{ {} }}", tree.program()),
            Tree::Scaled(by, tree) => format!("scale({by:?} / 32) {{ {} }}", tree.program()),
            Tree::Twisted(rate, tree) => format!("twist({rate} / 16) {{ {} }}", tree.program()),
            Tree::Union(r, trees) => format!("union(r = {r} / 16) {{ {} }}", all(&trees[..])),
            Tree::Difference(r, trees) => format!("difference(r = {r} / 16) {{ {} }}", all(&trees[..])),
            Tree::Intersection(r, trees) => format!("intersection(r = {r} / 16) {{ {} }}", all(&trees[..])),
        }
    }
}

fuzz_target!(|tree: Tree| {
    let program = tree.program();
    let Some(scene) = compile(&MemoryWorld::of("f.csg", program.clone()), "f.csg", &Options::default()).scene else {
        return;
    };
    let facts = scene.graph.facts[scene.graph.root.0 as usize];
    let evaluator = Evaluator::new(&scene.graph, &[]);
    let bounds = sample_box(&facts.bounds);
    let mut random = Random::new(1);
    for _ in 0..32 {
        let (p, q) = (random.point(&bounds), random.point(&bounds));
        let (at_p, at_q) = (evaluator.distance(p), evaluator.distance(q));
        let most = facts.lipschitz * distance(p, q) * (1.0 + 1e-9) + 1e-9 * bounds.diagonal();
        assert!((at_p - at_q).abs() <= most, "{program}: {at_p} at {p:?}, {at_q} at {q:?}");
        assert!(at_p > 0.0 || facts.bounds.distance(p) == 0.0, "{program}: {at_p} at {p:?}, outside the bounds");
    }
});
