//! Scenes of many shapes: loops over the members that cells list, beside the field itself and beside code for each member.

use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};

use chiaro_compiler::field::{Crowds, Evaluator, Graph};
use chiaro_compiler::vocabulary::Bounds;
use chiaro_compiler::{Options, Scene, compile};
use chiaro_render::{Error, Gpu, Model, Picture, Preference, View, distances};
use chiaro_tests::MemoryWorld;
use chiaro_tests::sampling::Random;

/// Members of six patterns, two of which have several colours.
const MIXED: &str = "
    module bolt() {
        color(\"gold\") cylinder(h = 6, r = 1);
        color(\"navy\") translate([0, 0, 6]) sphere(1.6);
    }
    places = rands(0, 100, 3 * count, 5);
    for (i = [0 : count - 1]) translate([places[3 * i], places[3 * i + 1], places[3 * i + 2]]) {
        if (i % 6 == 0) sphere(2 + i % 3);
        else if (i % 6 == 1) color([i / count, 0.4, 0.2]) cube(3 + i % 2);
        else if (i % 6 == 2) rotate([10 * i, 25 * i, 0]) cube([2, 3, 6], r = 0.4);
        else if (i % 6 == 3) rotate([0, 7 * i, i]) difference() { cylinder(h = 4, r = 3); cylinder(h = 4, r = 1.5); }
        else if (i % 6 == 4) rotate([i, 0, 0]) union(r = 1) { color(\"red\") sphere(2); color(\"green\") cylinder(h = 5, r = 1); }
        else rotate([0, i, 0]) bolt();
    }";
/// A plate with holes, some of them painted, beside pins.
const PLATE: &str = "
    difference() {
        color(\"silver\") cube([100, 100, 5]);
        for (i = [0 : 11], j = [0 : 11]) translate([5 + 8 * i, 5 + 8 * j, -1]) {
            if ((i + j) % 5 == 0) color(\"red\") cylinder(h = 7, r = 2);
            else if (i % 2 == 0) cylinder(h = 7, r = 1 + j / 6);
            else rotate(j * 9) cube([4, 4, 20], center = true);
        }
    }
    for (i = [0 : 9], j = [0 : 9]) translate([10 * i, 10 * j, 12]) color([i / 9, j / 9, 0.5]) sphere(2);";
/// Members that move with a live number.
const MOVING: &str = "
    height = 10; // [0:40]
    for (i = [0 : 9], j = [0 : 9]) translate([9 * i, 9 * j, (i + j) % 3 * height]) cube(4 + height / 10);";

/// One test at a time draws: software adapters use all of the machine anyway.
fn gpu() -> MutexGuard<'static, Gpu> {
    static GPU: OnceLock<Mutex<Gpu>> = OnceLock::new();
    let gpu = GPU.get_or_init(|| Mutex::new(Gpu::new(&Preference::Any).unwrap_or_else(|error| panic!("{error}"))));
    gpu.lock().unwrap_or_else(PoisonError::into_inner)
}

fn compiled(text: &str) -> Scene {
    let compiled = compile(&MemoryWorld::of("many.scad", text), "many.scad", &Options::default());
    compiled.scene.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics))
}

fn mixed(count: u32) -> Scene {
    compiled(&format!("count = {count};{MIXED}"))
}

fn bounds(graph: &Graph) -> Bounds {
    graph.facts[graph.root.0 as usize].bounds
}

/// The box that all crowds of a scene fill: their grids reach beyond it.
fn crowded(graph: &Graph, parameters: &[f64]) -> Bounds {
    let bounds = graph.bounds_at(parameters);
    let crowds = Crowds::of(graph).crowds;
    let boxes = crowds.iter().map(|crowd| {
        crowd.members.iter().fold(Bounds::EMPTY, |all, member| all.union(&bounds[member.node.0 as usize]))
    });
    boxes.fold(Bounds::ALL, |all, of_crowd| all.intersection(&of_crowd))
}

/// Asks the device at random points and compares what it says with the field.
fn check_distances(scene: &Scene, parameters: &[f64], count: usize) {
    assert!(!Crowds::of(&scene.graph).is_empty());
    let evaluator = Evaluator::new(&scene.graph, parameters);
    let (bounds, crowded) = (evaluator.bounds(), crowded(&scene.graph, parameters));
    let (near, size) = (bounds.inflate(0.05 * bounds.diagonal()), bounds.diagonal());
    let mut random = Random::new(7);
    let points: Vec<[f64; 3]> =
        (0..count).map(|i| random.point(&if i % 3 > 0 { near } else { bounds.inflate(2.0 * size) })).collect();
    let found = distances(&gpu(), &scene.graph, parameters, &points).unwrap();
    for (point, found) in points.iter().zip(found) {
        let (found, value) = (f64::from(found), evaluator.distance(*point));
        let rounding = 2e-6 * (size + value.abs());
        if crowded.distance(*point) == 0.0 {
            assert!((found - value).abs() <= rounding, "{found} instead of {value} at {point:?}");
        } else {
            assert!(found * value >= 0.0 || value.abs() <= rounding, "{found} instead of {value} at {point:?}");
            let (found, value) = (found.abs(), value.abs());
            assert!(found <= value + rounding, "{found}, no bound of {value}, at {point:?}");
            // On the way to the grid and from there, distances grow by no more than √2 times what stands for both.
            assert!(2f64.sqrt() * found >= value - rounding, "{found} is far less than {value} at {point:?}");
        }
    }
}

fn drawn(gpu: &Gpu, model: &Model, graph: &Graph, size: [u32; 2], samples: usize) -> Vec<[f32; 4]> {
    let view = View::framing(&Default::default(), &[], &bounds(graph), f64::from(size[0]) / f64::from(size[1]));
    let mut picture = Picture::new(gpu, model, view, size).unwrap();
    for _ in 0..samples {
        picture.sample().unwrap();
    }
    picture.hdr().unwrap()
}

#[test]
fn distances_are_those_of_the_field() {
    check_distances(&mixed(600), &[], 6_000);
    check_distances(&compiled(PLATE), &[], 6_000);
}

#[test]
fn cells_follow_live_numbers() {
    let scene = compiled(MOVING);
    assert_eq!(scene.parameters.len(), 1);
    for height in [0.0, 10.0, 40.0] {
        check_distances(&scene, &[height], 2_000);
    }
    // A model's table follows too.
    let gpu = gpu();
    let model = Model::new(&gpu, &scene.graph, &[40.0]).unwrap();
    let size = [48, 48];
    let high = drawn(&gpu, &model, &scene.graph, size, 1);
    let pipelines = gpu.pipelines_compiled();
    model.set_parameters(&gpu, &[5.0]).unwrap();
    let low = drawn(&gpu, &model, &scene.graph, size, 1);
    assert_eq!(gpu.pipelines_compiled(), pipelines);
    assert_ne!(high, low);
    let anew = drawn(&gpu, &Model::new(&gpu, &scene.graph, &[5.0]).unwrap(), &scene.graph, size, 1);
    assert_eq!(low, anew);
}

#[test]
fn the_picture_is_that_of_code_for_each_member() {
    let gpu = gpu();
    for scene in [mixed(160), compiled(PLATE)] {
        let [looped, unrolled] = [Model::new, Model::unrolled]
            .map(|model| drawn(&gpu, &model(&gpu, &scene.graph, &[]).unwrap(), &scene.graph, [96, 72], 4));
        let differs = |(a, b): &(&[f32; 4], &[f32; 4])| (0..3).any(|channel| (a[channel] - b[channel]).abs() > 0.05);
        let differing = looped.iter().zip(&unrolled).filter(differs).count();
        assert!(differing < looped.len() / 100, "{differing} of {} pixels differ", looped.len());
    }
}

#[test]
fn moving_members_compiles_nothing() {
    let gpu = gpu();
    let of_seed = |seed: u32| {
        let scene = compiled(&format!(
            "places = rands(0, 90, 300, {seed});
            for (i = [0 : 99]) translate([places[i], places[i + 100], places[i + 200]])
                if (i % 2 == 0) sphere(3 + {seed}); else color([0.1, {seed} / 10, 0]) cube(4);"
        ));
        drawn(&gpu, &Model::new(&gpu, &scene.graph, &[]).unwrap(), &scene.graph, [48, 36], 1)
    };
    let before = of_seed(1);
    let pipelines = gpu.pipelines_compiled();
    assert_ne!(before, of_seed(2));
    // But for what resolves pictures, each picture's own.
    assert_eq!(gpu.pipelines_compiled(), pipelines);
}

#[test]
fn twenty_thousand_shapes_are_drawn() {
    let scene = mixed(20_000);
    let gpu = gpu();
    let model = Model::new(&gpu, &scene.graph, &[]).unwrap();
    assert_eq!(model.notes(&scene.graph), []);
    let picture = drawn(&gpu, &model, &scene.graph, [64, 48], 1);
    // The block of shapes fills most of the picture: everywhere there are colours, and of each kind some.
    let is_colored = |pixel: &[f32; 4]| (pixel[0] - pixel[2]).abs() > 0.05;
    let parts: Vec<usize> = picture.chunks(64 * 12).map(|rows| rows.iter().filter(|p| is_colored(p)).count()).collect();
    assert!(parts.iter().all(|colored| *colored >= 50) && parts.iter().sum::<usize>() >= 780, "{parts:?}");
    let kinds: [fn(&[f32; 4]) -> bool; 4] = [
        |[r, g, b, _]| *r > 2.0 * g && *r > 2.0 * b,
        |[r, g, b, _]| *g > 1.5 * r && *g > 1.5 * b,
        |[r, g, b, _]| *b > 1.5 * r && *b > 1.5 * g,
        |[r, g, b, _]| *r > 1.5 * b && *g > 1.5 * b,
    ];
    let counts = kinds.map(|is_kind| picture.iter().filter(|pixel| is_kind(pixel)).count());
    assert!(counts.iter().all(|count| *count >= 50), "{counts:?}");
    drop(gpu);
    check_distances(&scene, &[], 300);
}

#[test]
fn shapes_that_lie_in_each_other_are_code_for_each_and_that_is_said() {
    let scene = compiled(
        "apart = 8; // [0:10]
        for (i = [0 : 79]) translate([apart * (i % 9), apart * floor(i / 9), i / 100]) sphere(3 + i % 3);",
    );
    let gpu = gpu();
    let model = Model::new(&gpu, &scene.graph, &[8.0]).unwrap();
    assert_eq!(model.notes(&scene.graph), []);
    // Cells can't follow them there.
    let moved = model.set_parameters(&gpu, &[0.0]);
    assert!(matches!(moved, Err(Error::Dense { members: 80 })), "{moved:?}");
    model.set_parameters(&gpu, &[7.0]).unwrap();

    let together = Model::new(&gpu, &scene.graph, &[0.0]).unwrap();
    let notes = together.notes(&scene.graph);
    assert!(notes.len() == 1 && notes[0].message.contains("80 parts"), "{notes:?}");
    let picture = drawn(&gpu, &together, &scene.graph, [48, 36], 1);
    let unrolled = Model::unrolled(&gpu, &scene.graph, &[0.0]).unwrap();
    assert_eq!(picture, drawn(&gpu, &unrolled, &scene.graph, [48, 36], 1));
}
