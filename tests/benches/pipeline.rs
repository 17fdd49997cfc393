//! `cargo bench -p chiaro_tests`: what each stage of the way from text to picture costs, for unions of random spheres.
//!
//! Times are the least of several runs: on a shared machine the least disturbed. Compare them with each other, in one
//! run; no test depends on them.

#![expect(clippy::print_stdout, reason = "a benchmark prints its figures")]

use std::fmt::Write;
use std::hint::black_box;
use std::time::{Duration, Instant};

use chiaro_compiler::solid::Camera;
use chiaro_compiler::syntax::{Dialect, FileId, parse};
use chiaro_compiler::{Options, Scene, compile, field, shader};
use chiaro_render::{Gpu, Model, Picture, Preference, View};
use chiaro_tests::MemoryWorld;
use chiaro_tests::sampling::Random;

const SIZE: u32 = 512;

fn main() {
    stages();
    shader_text();
    pictures();
}

/// The compiler, stage by stage.
fn stages() {
    println!("compiling, in milliseconds");
    println!("{:>9} {:>9} {:>9} {:>9} {:>9} {:>9}", "spheres", "parse", "evaluate", "lower", "splice", "all");
    for count in [10, 100, 1_000, 10_000] {
        let text = spheres(count);
        let scene = compiled(&text);
        let parsing = least(|| parse(FileId(0), &text, Dialect::Program));
        let compiling = least(|| compiled(&text));
        let lowering = least(|| field::lower(&scene.solid));
        let splicing = least(|| shader::splice(&scene.graph, shader::Template::Trace));
        let all = compiling + splicing;
        let evaluating = compiling.saturating_sub(parsing + lowering);
        let columns = [parsing, evaluating, lowering, splicing, all].map(|time| format!("{:9.3}", milliseconds(time)));
        println!("{count:>9} {}", columns.join(" "));
    }
}

/// How much text the scene is as WGSL.
fn shader_text() {
    println!("\nshader text, in bytes");
    for count in [1, 10, 100, 1_000] {
        let text = shader::wgsl(&compiled(&spheres(count)).graph).map_or(0, |text| text.len());
        println!("{count:>9} {text:>9}");
    }
}

/// Pictures of 512 × 512 pixels on the best adapter there is.
fn pictures() {
    let gpu = match Gpu::new(&Preference::Any) {
        Ok(gpu) => gpu,
        Err(error) => return println!("\nno pictures: {error}"),
    };
    println!("\npictures of {SIZE} × {SIZE} on {}: milliseconds and evaluations per pixel", gpu.description().name);
    println!("{:>9} {:>9} {:>9} {:>17} {:>17}", "spheres", "compile", "first", "with prepass", "without");
    for count in [10, 100, 1_000] {
        let text = spheres(count);
        let start = Instant::now();
        let scene = compiled(&text);
        let model = Model::new(&gpu, &scene.graph, &[]).expect("a model");
        let compiling = start.elapsed();
        let bounds = scene.graph.facts[scene.graph.root.0 as usize].bounds;
        let view = View::framing(&Camera::default(), &[], &bounds, 1.0);
        let mut picture = Picture::new(&gpu, &model, view, [SIZE, SIZE]).expect("a picture");
        picture.sample().expect("a sample");
        black_box(picture.resolve().expect("pixels"));
        let first = start.elapsed();
        let [with, without] = [true, false].map(|prepass| {
            picture.set_prepass(prepass).expect("a restart");
            let time = least(|| picture.sample().expect("a sample"));
            let evaluations = picture.evaluations().expect("a count");
            format!("{:8.1} {:8.2}", milliseconds(time), evaluations.sample)
        });
        let (compiling, first) = (milliseconds(compiling), milliseconds(first));
        println!("{count:>9} {compiling:>9.1} {first:>9.1} {with} {without}");
    }
}

/// A union of that many random spheres in the cube of 100 mm, which together fill about a tenth of it.
fn spheres(count: usize) -> String {
    let mut random = Random::new(1);
    let radius = 22.0 * (count as f64).powf(-1.0 / 3.0);
    let mut text = String::new();
    for _ in 0..count {
        let [x, y, z] = [(); 3].map(|()| 100.0 * random.unit());
        let _ = writeln!(text, "translate([{x:.3}, {y:.3}, {z:.3}]) sphere({radius:.3});");
    }
    text
}

fn compiled(text: &str) -> Scene {
    compile(&MemoryWorld::of("bench.csg", text), "bench.csg", &Options::default()).scene.expect("a scene")
}

/// The least time of some runs: up to twenty, or as many as fit in a second or two.
fn least<T>(mut run: impl FnMut() -> T) -> Duration {
    let mut least = Duration::MAX;
    let start = Instant::now();
    for _ in 0..20 {
        let begin = Instant::now();
        black_box(run());
        least = least.min(begin.elapsed());
        if start.elapsed() > Duration::from_secs(1) {
            break;
        }
    }
    least
}

fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}
