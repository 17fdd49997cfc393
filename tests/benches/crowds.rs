//! `cargo bench -p chiaro_tests --bench crowds`: large unions as loops over the members that cells list, side by side with
//! code for each member; and how both grow.
//!
//! Scenes are random spheres and boxes that a loop of the text makes. Times are of the processor, all threads together, as
//! Linux tells them; elsewhere those of a clock. They are of single runs: compare those of one row.

#![expect(clippy::print_stdout, reason = "a benchmark prints its figures")]

use std::hint::black_box;
use std::sync::LazyLock;
use std::time::Instant;

use chiaro_compiler::field::{Crowds, Graph};
use chiaro_compiler::solid::Camera;
use chiaro_compiler::{Options, Scene, compile, shader};
use chiaro_render::{Gpu, Model, Picture, Preference, View};
use chiaro_tests::MemoryWorld;

const SIZE: u32 = 512;
/// Code for more members takes drivers minutes.
const MOST_UNROLLED: usize = 1_000;

fn main() {
    let gpu = match Gpu::new(&Preference::Any) {
        Ok(gpu) => gpu,
        Err(error) => return println!("no pictures: {error}"),
    };
    println!("pictures of {SIZE} × {SIZE} on {}, in milliseconds", gpu.description().name);
    println!(
        "{:>8} {:>9} | {:>9} {:>9} {:>9} {:>9} {:>9} | {:>9} {:>9} {:>9}",
        "members", "compile", "cells", "model", "first", "sample", "moved", "unrolled", "first", "sample"
    );
    let counts: Vec<usize> = std::env::args().filter_map(|argument| argument.parse().ok()).collect();
    let counts = if counts.is_empty() { vec![64, 100, 1_000, 10_000, 100_000] } else { counts };
    for count in counts {
        let (scene, compiling) = timed(|| compiled(&mixed(count, 1)));
        let mut crowds = Crowds::of(&scene.graph);
        let (data, pruning) = timed(|| shader::CrowdData::of(&scene.graph, &mut crowds, &[]));
        let looped = drawn(&gpu, &scene.graph, Model::new);
        let moved = compiled(&mixed(count, 2));
        let moving = drawn(&gpu, &moved.graph, Model::new);
        let unrolled = match count <= MOST_UNROLLED {
            true => drawn(&gpu, &scene.graph, Model::unrolled).map(|time| format!("{time:9.0}")),
            false => [(); 3].map(|()| format!("{:>9}", "-")),
        };
        println!(
            "{count:>8} {compiling:>9.0} | {pruning:>9.0} {} {:>9.0} | {}",
            looped.map(|time| format!("{time:9.0}")).join(" "),
            moving[1],
            unrolled.join(" ")
        );
        black_box(data);
    }
}

/// How long it takes until there is a model, until its first sample is there, and a further one.
fn drawn(
    gpu: &Gpu,
    graph: &Graph,
    model: impl FnOnce(&Gpu, &Graph, &[f64]) -> chiaro_render::Result<Model>,
) -> [f64; 3] {
    let start = now();
    let model = model(gpu, graph, &[]).expect("a model");
    let compiling = now() - start;
    let bounds = graph.facts[graph.root.0 as usize].bounds;
    let view = View::framing(&Camera::default(), &[], &bounds, 1.0);
    let mut picture = Picture::new(gpu, &model, view, [SIZE, SIZE]).expect("a picture");
    picture.sample().expect("a sample");
    black_box(picture.resolve().expect("pixels"));
    let first = now() - start;
    let (_, further) = timed(|| picture.sample().expect("a sample"));
    [compiling, first, further]
}

/// That many random spheres and boxes in the cube of 100 mm, which together fill about a tenth of it.
fn mixed(count: usize, seed: u32) -> String {
    let size = 22.0 * (count as f64).powf(-1.0 / 3.0);
    format!(
        "places = rands(0, 100, {all}, {seed});
        for (i = [0 : {last}]) translate([places[3 * i], places[3 * i + 1], places[3 * i + 2]])
            if (i % 2 == 0) sphere({size}); else cube({size}, center = true);",
        all = 3 * count,
        last = count - 1,
    )
}

fn compiled(text: &str) -> Scene {
    let compiled = compile(&MemoryWorld::of("bench.csg", text), "bench.csg", &Options::default());
    compiled.scene.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics))
}

/// What the work comes to, and the milliseconds it takes.
fn timed<T>(run: impl FnOnce() -> T) -> (T, f64) {
    let start = now();
    let done = run();
    (done, now() - start)
}

/// The processor's time so far in milliseconds.
fn now() -> f64 {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    // Behind the name in parentheses, the 12th and 13th numbers are hundredths of a second for the program and the system.
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let numbers = stat.rsplit_once(") ").map_or("", |(_, numbers)| numbers).split(' ');
    let ticks: Vec<f64> = numbers.skip(11).take(2).filter_map(|number| number.parse().ok()).collect();
    match ticks[..] {
        [own, system] => 10.0 * (own + system),
        _ => START.elapsed().as_secs_f64() * 1e3,
    }
}
