//! How fast the editor is, and how much memory it takes:
//! `cargo test --release -p chiaro_editor figures -- --ignored --nocapture`.
//!
//! Times are from the moment that the text is what was typed to the moment that its picture is there to be put into the window.

#![expect(clippy::print_stdout, reason = "a benchmark prints its figures")]

use std::fmt::Write;
use std::time::{Duration, Instant};

use chiaro_render::{Preference, View};

use crate::panels::resident;
use crate::session::Session;
use crate::studio::{Eye, Frame, Wanted};

const SIZE: [u32; 2] = [960, 540];
const COUNTS: [usize; 3] = [10, 100, 1000];

/// So many balls and boxes on a grid. The first number of the text is the first one's radius.
fn scene(count: usize) -> String {
    let mut text = "sphere(1.4);\n".to_owned();
    let edge = (count as f64).sqrt().ceil() as usize;
    for at in 1..count {
        let (x, y) = (3 * (at % edge), 3 * (at / edge));
        let shape = if at % 2 == 0 { "sphere(1.3)" } else { "cube(2, center = true)" };
        let _ = writeln!(text, "translate([{x}, {y}, 0]) {shape};");
    }
    text
}

struct Bench {
    session: Session,
}

impl Bench {
    fn new(text: &str, size: [u32; 2]) -> Self {
        let mut session = Session::new(Preference::Software, || {}).unwrap();
        session.open_text("scene.csg", text.to_owned());
        // The first frame is the same whether better ones follow or not; here none do, so that edits don't wait for them.
        session.want(Wanted { size, samples: 1, moving: true, ..Wanted::default() });
        session.text_changed();
        let mut bench = Self { session };
        bench.rest();
        bench
    }

    /// Waits for a frame of the newest text.
    fn frame(&mut self) -> Frame {
        loop {
            self.session.poll();
            match self.session.frame.take() {
                Some(frame) if !self.session.is_outdated() => return *frame,
                _ => std::thread::sleep(Duration::from_micros(200)),
            }
        }
    }

    /// Waits until nothing happens any more.
    fn rest(&mut self) {
        self.frame();
        self.settle();
    }

    fn settle(&mut self) {
        loop {
            std::thread::sleep(Duration::from_millis(60));
            self.session.poll();
            if self.session.frame.take().is_none() {
                return;
            }
        }
    }

    /// What an edit takes to its first frame.
    fn edit(&mut self, text: String) -> f64 {
        self.session.active_mut().text = text;
        let begun = Instant::now();
        self.session.text_changed();
        self.frame();
        let took = begun.elapsed();
        self.settle();
        1e3 * took.as_secs_f64()
    }
}

/// Median and 95th percentile.
fn quantiles(mut times: Vec<f64>) -> [f64; 2] {
    times.sort_by(f64::total_cmp);
    let at = |part: f64| times[((times.len() - 1) as f64 * part).round() as usize];
    [at(0.5), at(0.95)]
}

#[test]
#[ignore = "a benchmark"]
fn figures_of_edits() {
    println!("key to frame in milliseconds: median, 95th percentile; picture of {SIZE:?}");
    println!("{:>10} {:>18} {:>18} {:>24}", "primitives", "number edit", "structural edit", "orbit, frames a second");
    for count in COUNTS {
        let text = scene(count);
        let mut bench = Bench::new(&text, SIZE);
        let rounds = if count > 100 { 8 } else { 20 };
        // The first edit of a number makes it live.
        bench.edit(text.replacen("1.4", "1.41", 1));
        let numbers = (0..rounds).map(|round| bench.edit(text.replacen("1.4", &format!("1.{}", 42 + round), 1)));
        let numbers = quantiles(numbers.collect());
        let structures = (0..rounds).map(|round| bench.edit(format!("{text}translate([0, {round}, 4]) sphere(1);\n")));
        let structures = quantiles(structures.collect());
        let [frames, width] = orbit(&mut bench);
        println!(
            "{count:>10} {:>9.0} {:>8.0} {:>9.0} {:>8.0} {frames:>10.1} ({width} wide)",
            numbers[0], numbers[1], structures[0], structures[1]
        );
    }
}

/// Frames a second while the view turns, and how wide they are.
fn orbit(bench: &mut Bench) -> [f64; 2] {
    let view = View { target: [15.0, 15.0, 0.0], rotation: [55.0, 0.0, 25.0], distance: 120.0, field_of_view: 22.5 };
    let (mut frames, mut width) = (0, 0);
    let begun = Instant::now();
    while begun.elapsed() < Duration::from_secs(6) {
        let turned = View { rotation: [55.0, 0.0, 25.0 + f64::from(frames)], ..view };
        bench.session.want(Wanted { eye: Eye::At(turned), ..bench.session.wanted().clone() });
        width = bench.frame().size[0];
        frames += 1;
    }
    [f64::from(frames) / begun.elapsed().as_secs_f64(), f64::from(width)]
}

#[test]
#[ignore = "a benchmark"]
fn figures_of_memory() {
    println!("resident memory in MiB after so many reloads");
    let text = scene(10);
    let mut bench = Bench::new(&text, [160, 120]);
    for reload in 0..=1000 {
        if reload % 100 == 0 {
            println!("{reload:>6} {:>8.0}", resident().unwrap_or_default() as f64 / f64::from(1 << 20));
        }
        bench.edit(format!("{text}translate([0, 0, {}]) sphere(1);\n", 4 + reload % 7));
        bench.edit(format!("{text}cube({});\n", 1 + reload % 5));
    }
}
