//! Programs put together at random: whatever they say, the compiler answers, and what it claims of their fields holds.

use arbitrary::Unstructured;
use chiaro_compiler::{Compilation, Options, compile};
use chiaro_tests::sampling::Random;
use chiaro_tests::{MemoryWorld, claims, programs};

/// How many programs of each kind are made.
const COUNT: u64 = 250;

fn compiled(text: &str) -> Compilation {
    compile(&MemoryWorld::of("random.scad", text), "random.scad", &Options::default())
}

/// A program of random bytes.
fn program(seed: u64, make: fn(&mut Unstructured) -> String) -> String {
    let mut random = Random::new(seed);
    let bytes: Vec<u8> = (0..400).map(|_| (256.0 * random.unit()) as u8).collect();
    make(&mut Unstructured::new(&bytes))
}

#[test]
fn any_program_is_a_scene_or_an_error() {
    let (mut scenes, mut errors) = (0, 0);
    for seed in 0..COUNT {
        let text = program(seed, programs::wild);
        let compilation = compiled(&text);
        assert!(compilation.scene.is_some() != compilation.has_errors(), "{text}");
        *(if compilation.scene.is_some() { &mut scenes } else { &mut errors }) += 1;
    }
    assert!(scenes >= 40 && errors >= 100, "{scenes} scenes, {errors} errors");
}

#[test]
fn what_is_claimed_of_random_scenes_holds() {
    let (mut compiled_count, mut something, mut live) = (0, 0, 0);
    for seed in 0..COUNT {
        let text = program(seed, programs::scene);
        let Some(scene) = compiled(&text).scene else { continue };
        let mut random = Random::new(seed);
        let moved: Vec<f64> = scene
            .parameters
            .iter()
            .map(|parameter| parameter.range.min + random.unit() * (parameter.range.max - parameter.range.min))
            .collect();
        for parameters in [scene.defaults(), moved] {
            let broken = claims::broken(&scene.graph, &parameters, &mut random, 60);
            assert!(broken.is_none(), "{}\nseed {seed}, {parameters:?}\n{text}", broken.unwrap_or_default());
        }
        compiled_count += 1;
        something += usize::from(!scene.graph.facts[scene.graph.root.0 as usize].bounds.is_empty());
        live += usize::from(!scene.graph.slots.is_empty());
    }
    assert!(compiled_count >= 180, "only {compiled_count} compile");
    assert!(something >= 180 && live >= 130, "{something} are something, {live} are live");
}
