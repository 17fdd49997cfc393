//! Packages: what engines and pages take as files of their own. Each is a template, or several, in the folder `packages`.

use chiaro_syntax::Diagnostic;

use crate::context::Context;
use crate::languages::translated;
use crate::subject::Scene;
use crate::target::{File, Package};
use crate::translate::Dialect;

const SHADERTOY: &str = include_str!("../packages/shadertoy/image.glsl");
const GLSL_VIEWER: &str = include_str!("../packages/glslviewer/scene.frag");
const WEBGL: &str = include_str!("../packages/web/webgl.html");
const WEBGPU: &str = include_str!("../packages/web/webgpu.html");

/// The files of a package.
pub(crate) fn files(scene: &Scene, package: Package) -> Result<Vec<File>, Diagnostic> {
    let text = scene.program()?;
    let glsl = || translated(&text, Dialect::Glsl, &|name| name.to_owned());
    let (code, template) = match package {
        Package::Shadertoy => (glsl()?, SHADERTOY),
        Package::GlslViewer => (glsl()?, GLSL_VIEWER),
        Package::WebGl => (glsl()?, WEBGL),
        Package::WebGpu => (text.wgsl(1), WEBGPU),
    };
    Ok(File::alone(Context::new(scene, &text.source.parameters, &code)?.fill(template)?))
}
