//! Whatever values live parameters have within their ranges, the field is a number everywhere and no steeper than
//! claimed.
#![no_main]

use arbitrary::Unstructured;
use chiaro_compiler::solid::LiveParameter;
use chiaro_compiler::{Options, compile};
use chiaro_tests::sampling::Random;
use chiaro_tests::{MemoryWorld, claims, programs};
use libfuzzer_sys::fuzz_target;

/// A value that the next byte chooses: the range's ends, its middle and what is between.
fn moved(parameter: &LiveParameter, bytes: &mut Unstructured) -> f64 {
    let part = f64::from(bytes.int_in_range(0..=16_u8).unwrap_or(0)) / 16.0;
    parameter.range.min + part * (parameter.range.max - parameter.range.min)
}

fuzz_target!(|bytes: &[u8]| {
    let mut bytes = Unstructured::new(bytes);
    let text = programs::scene(&mut bytes);
    let compilation = compile(&MemoryWorld::of("fuzz.scad", &*text), "fuzz.scad", &Options::default());
    let Some(scene) = compilation.scene else { return };
    if scene.graph.slots.is_empty() {
        return;
    }
    for _ in 0..3 {
        let values: Vec<f64> = scene.parameters.iter().map(|parameter| moved(parameter, &mut bytes)).collect();
        let broken = claims::broken(&scene.graph, &values, &mut Random::new(2), 16);
        assert!(broken.is_none(), "{} with {values:?}\n{text}", broken.unwrap_or_default());
    }
});
