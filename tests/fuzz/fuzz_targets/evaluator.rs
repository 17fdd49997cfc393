//! Any program compiles or has errors, within its limits.
#![no_main]

use chiaro_compiler::{Options, compile};
use chiaro_tests::MemoryWorld;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let world = MemoryWorld::of("fuzz.csg", text).with("other.scad", "module m() cube(1); x = 3;");
    let compilation = compile(&world, "fuzz.csg", &Options::default());
    assert!(compilation.scene.is_some() != compilation.has_errors());
});
