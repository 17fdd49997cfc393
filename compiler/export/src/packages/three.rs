//! three.js: a mesh for its WebGL renderer and one for its WebGPU renderer, the picture for each, and pages that show them.

use chiaro_syntax::Diagnostic;

use super::folder::Folder;
use crate::context::Context;
use crate::languages::translated;
use crate::subject::{Scene, Text};
use crate::target::File;
use crate::translate::Dialect;

macro_rules! template {
    ($path:literal) => {
        include_str!(concat!("../../packages/three/", $path))
    };
}

pub(super) fn files(scene: &Scene) -> Result<Vec<File>, Diagnostic> {
    let (solid, lit) = scene.solid_and_lit()?;
    let context = Context::new(scene, &solid.source.parameters)?;
    let folder = Folder::new(context)
        .add("README.md", template!("README.md"))?
        .add("index.html", template!("webgl/index.html"))?
        .add("webgpu.html", template!("webgpu/index.html"))?
        .add("demo.js", template!("demo.js"))?
        .add("scene.js", template!("scene.js"))?
        .add("scene.d.ts", template!("scene.d.ts"))?
        .add_code("webgl/{}.js", template!("webgl/solid.js"), &glsl(&solid)?)?
        .add("webgl/{}.d.ts", template!("webgl/solid.d.ts"))?
        .add_code("webgl/{}_picture.js", template!("webgl/picture.js"), &glsl(&lit)?)?
        .add("webgl/{}_picture.d.ts", template!("picture.d.ts"))?
        .add_code("webgpu/{}.js", template!("webgpu/solid.js"), &wgsl(&solid))?
        .add("webgpu/{}.d.ts", template!("webgpu/solid.d.ts"))?
        .add_code("webgpu/{}_picture.js", template!("webgpu/picture.js"), &wgsl(&lit))?
        .add("webgpu/{}_picture.d.ts", template!("picture.d.ts"))?;
    Ok(folder.files())
}

fn glsl(text: &Text) -> Result<String, Diagnostic> {
    translated(text, Dialect::Glsl, &|name| format!("parameters.{name}"))
}

/// Nodes of three.js have no bindings of their own: the live numbers are a variable.
fn wgsl(text: &Text) -> String {
    [&*text.source.text, &text.below].concat()
}
