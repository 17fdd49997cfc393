//! Drawing takes no memory that it does not give back.
#![cfg(target_os = "linux")]

#[allow(dead_code)]
mod support;

use chiaro_field::Graph;
use chiaro_render::{Gpu, Model, Picture, Preference, View};
use chiaro_solid::{Scalar, scalar::ParameterId};
use chiaro_vocabulary::Interval;
use support::Builder;

/// What a sample may leave behind on average, in bytes: a kernel compiled for it would be far more.
const LEFT_BEHIND: usize = 100_000;
const SAMPLES: usize = 60;

#[test]
fn samples_and_moves_leave_nothing_behind() {
    let gpu = Gpu::new(&Preference::Software).or_else(|_| Gpu::new(&Preference::Any)).unwrap();
    let model = Model::new(&gpu, &ball(), &[5.0]).unwrap();
    let view = |turn: usize| View {
        target: [0.0; 3],
        rotation: [60.0, 0.0, turn as f64],
        distance: 60.0,
        field_of_view: 22.5,
    };
    let mut picture = Picture::new(&gpu, &model, view(0), [64, 48]).unwrap();
    let mut draw = |turn: usize| {
        picture.set_view(view(turn)).unwrap();
        picture.set_parameters(&[4.0 + 0.01 * turn as f64]).unwrap();
        picture.sample().unwrap();
        picture.resolve().unwrap();
    };
    (0..5).for_each(&mut draw);
    let before = resident_bytes();
    (5..5 + SAMPLES).for_each(&mut draw);
    let grown = resident_bytes().saturating_sub(before);
    assert!(grown < LEFT_BEHIND * SAMPLES, "{SAMPLES} samples left {grown} bytes behind");
}

/// A ball with a live radius.
fn ball() -> Graph {
    let mut scene = Builder::new();
    scene.shape("sphere", &[Scalar::parameter(ParameterId(0), Interval::new(1.0, 20.0))], [0.0; 3]);
    scene.done()
}

/// How much of the memory this process holds.
fn resident_bytes() -> usize {
    let sizes = std::fs::read_to_string("/proc/self/statm").unwrap();
    4096 * sizes.split(' ').nth(1).unwrap().parse::<usize>().unwrap()
}
