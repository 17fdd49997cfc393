//! Meshes of random scenes are closed, and have finite corners and a finite volume that is not negative.
#![no_main]

use std::ops::ControlFlow;

use arbitrary::Unstructured;
use chiaro_compiler::{Options, compile};
use chiaro_mesh::{Detail, GraphField, model};
use chiaro_tests::{MemoryWorld, programs};
use libfuzzer_sys::fuzz_target;

/// Cells along the longest side: few, so that much is about as thin as they are.
const RESOLUTION: u32 = 12;

fuzz_target!(|bytes: &[u8]| {
    let text = programs::scene(&mut Unstructured::new(bytes));
    let compilation = compile(&MemoryWorld::of("fuzz.scad", &*text), "fuzz.scad", &Options::default());
    let Some(scene) = compilation.scene else { return };
    let graph = scene.picture();
    let field = GraphField::new(&graph, &scene.defaults());
    let detail = Detail { resolution: Some(RESOLUTION), tolerance: None };
    let Ok(made) = model(&field, &detail, &mut |_| ControlFlow::Continue(())) else { return };
    assert!(made.mesh.is_manifold(), "it is not closed\n{text}");
    assert!(made.mesh.vertices.iter().flatten().all(|x| x.is_finite()), "a corner is nowhere\n{text}");
    let volume = made.mesh.volume();
    assert!(volume.is_finite() && volume >= 0.0, "the volume is {volume}\n{text}");
});
