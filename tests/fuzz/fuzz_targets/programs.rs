//! Any program made by the grammar compiles or has errors, within its limits.
#![no_main]

use arbitrary::Unstructured;
use chiaro_compiler::{Options, compile};
use chiaro_tests::{MemoryWorld, programs};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let text = programs::wild(&mut Unstructured::new(bytes));
    let compilation = compile(&MemoryWorld::of("fuzz.scad", &*text), "fuzz.scad", &Options::default());
    assert!(compilation.scene.is_some() != compilation.has_errors(), "{text}");
});
