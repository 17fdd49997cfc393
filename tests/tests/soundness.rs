//! What the compiler claims of a field holds at sampled points, for every scene of ours, every one of the suite and every
//! example that OpenSCAD's package brings: the Lipschitz constant, the bounds, and that sphere tracing misses no surface.

use std::path::{Path, PathBuf};

use chiaro_compiler::field::{Evaluator, Facts};
use chiaro_compiler::vocabulary::Bounds;
use chiaro_compiler::{Options, Scene, compile};
use chiaro_tests::sampling::{Random, distance, sample_box};
use chiaro_tests::world::DiskWorld;
use chiaro_tests::{OPENSCAD_EXAMPLES, scad_files, workspace};

/// Rounding of f64 through some hundred operations, relative to the coordinates.
const ROUNDING: f64 = 1e-9;

#[test]
fn values_change_no_faster_than_the_lipschitz_constant() {
    for_every_scene(|path, facts, evaluator, bounds| {
        let mut random = Random::new(1);
        let slack = ROUNDING * (1.0 + bounds.diagonal());
        for _ in 0..400 {
            let p = random.point(bounds);
            // Neighbours show the slope, far points the claim that values are distances.
            for reach in [1e-3, 0.03, 1.0] {
                let other = random.point(bounds);
                let q = std::array::from_fn(|axis| p[axis] + reach * (other[axis] - p[axis]));
                let change = (evaluator.distance(p) - evaluator.distance(q)).abs();
                let most = facts.lipschitz * distance(p, q);
                assert!(change <= most * (1.0 + ROUNDING) + slack, "{path:?}: from {p:?} to {q:?}: {change} > {most}");
            }
        }
    });
}

#[test]
fn there_is_nothing_outside_the_bounds() {
    for_every_scene(|path, facts, evaluator, bounds| {
        let mut random = Random::new(2);
        for _ in 0..2_000 {
            let p = random.point(bounds);
            if facts.bounds.distance(p) > 0.0 {
                let value = evaluator.distance(p);
                assert!(value > 0.0, "{path:?}: {value} at {p:?}, outside {:?}", facts.bounds);
            }
        }
    });
}

#[test]
fn sphere_tracing_misses_no_surface_that_tiny_steps_find() {
    for_every_scene(|path, facts, evaluator, bounds| {
        let mut random = Random::new(3);
        let step = bounds.diagonal() / 1000.0;
        for _ in 0..30 {
            let (from, to) = (random.point(bounds), random.point(bounds));
            let length = distance(from, to);
            let at = |t: f64| std::array::from_fn(|axis| from[axis] + (to[axis] - from[axis]) * t / length);
            if evaluator.distance(from) <= 0.0 {
                continue;
            }
            let tiny = (1..).map(|i| f64::from(i) * step).take_while(|t| *t < length);
            let Some(inside) = tiny.into_iter().find(|t| evaluator.distance(at(*t)) < 0.0) else { continue };
            let mut t = 0.0;
            while t < inside {
                let value = evaluator.distance(at(t)) / facts.lipschitz;
                if value < 1e-6 * step {
                    break;
                }
                t += value;
            }
            assert!(t <= inside, "{path:?}: sphere tracing passed the surface before {inside} from {from:?} to {to:?}");
        }
    });
}

/// Calls `check` with the facts and the evaluator of every scene that compiles, and a box to sample.
fn for_every_scene(check: impl Fn(&Path, Facts, &Evaluator, &Bounds)) {
    let ours: Vec<PathBuf> = scad_files(&workspace().join("examples_csg"));
    let small = scad_files(&workspace().join("tests/scenes"));
    let theirs = scad_files(Path::new(OPENSCAD_EXAMPLES));
    assert!(ours.len() >= 20, "our examples are not where they should be");
    assert!(theirs.len() >= 40, "OpenSCAD's examples are missing: run tools/setup.sh --tests");
    for path in ours.into_iter().chain(small).chain(theirs) {
        let Some(scene) = compiled(&path) else { continue };
        let facts = scene.graph.facts[scene.graph.root.0 as usize];
        let evaluator = Evaluator::new(&scene.graph, &scene.defaults());
        check(&path, facts, &evaluator, &sample_box(&facts.bounds));
    }
}

fn compiled(path: &Path) -> Option<Scene> {
    compile(&DiskWorld, &path.to_string_lossy(), &Options::default()).scene
}
