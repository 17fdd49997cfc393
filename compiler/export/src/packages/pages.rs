//! Pages and viewers: what takes a scene as one file.

use chiaro_syntax::Diagnostic;

use crate::context::Context;
use crate::languages::translated;
use crate::subject::Scene;
use crate::target::File;
use crate::translate::Dialect;

const SHADERTOY: &str = include_str!("../../packages/shadertoy/image.glsl");
const GLSL_VIEWER: &str = include_str!("../../packages/glslviewer/scene.frag");
const ISF: &str = include_str!("../../packages/isf/picture.fs");
const WEBGL: &str = include_str!("../../packages/web/webgl.html");
const WEBGPU: &str = include_str!("../../packages/web/webgpu.html");

pub(super) fn shadertoy(scene: &Scene) -> Result<Vec<File>, Diagnostic> {
    glsl(scene, SHADERTOY)
}

pub(super) fn glsl_viewer(scene: &Scene) -> Result<Vec<File>, Diagnostic> {
    glsl(scene, GLSL_VIEWER)
}

pub(super) fn isf(scene: &Scene) -> Result<Vec<File>, Diagnostic> {
    glsl(scene, ISF)
}

pub(super) fn webgl(scene: &Scene) -> Result<Vec<File>, Diagnostic> {
    glsl(scene, WEBGL)
}

pub(super) fn webgpu(scene: &Scene) -> Result<Vec<File>, Diagnostic> {
    let text = scene.program()?;
    let context = Context::new(scene, &text.source.parameters)?;
    Ok(File::alone(context.fill(WEBGPU, &text.wgsl(1))?))
}

fn glsl(scene: &Scene, template: &str) -> Result<Vec<File>, Diagnostic> {
    let text = scene.program()?;
    let code = translated(&text, Dialect::Glsl, &|name| name.to_owned())?;
    Ok(File::alone(Context::new(scene, &text.source.parameters)?.fill(template, &code)?))
}
