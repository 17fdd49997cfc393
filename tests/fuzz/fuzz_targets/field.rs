//! Fields of random scenes keep to their Lipschitz constants and bounds.
#![no_main]

use arbitrary::Unstructured;
use chiaro_compiler::{Options, compile};
use chiaro_tests::sampling::Random;
use chiaro_tests::{MemoryWorld, claims, programs};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let text = programs::scene(&mut Unstructured::new(bytes));
    let compilation = compile(&MemoryWorld::of("fuzz.scad", &*text), "fuzz.scad", &Options::default());
    let Some(scene) = compilation.scene else { return };
    let broken = claims::broken(&scene.graph, &scene.defaults(), &mut Random::new(1), 32);
    assert!(broken.is_none(), "{}\n{text}", broken.unwrap_or_default());
});
