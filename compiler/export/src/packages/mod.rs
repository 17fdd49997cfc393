//! Packages: what engines and pages take as files of their own. Each is made of the templates in its folder of `packages`.

mod bevy;
mod blender;
mod folder;
mod godot;
mod pages;
mod three;
mod unity;
mod unreal;

use chiaro_syntax::Diagnostic;

use crate::subject::Scene;
use crate::target::{File, Package};

/// The files of a package.
pub(crate) fn files(scene: &Scene, package: Package) -> Result<Vec<File>, Diagnostic> {
    match package {
        Package::Shadertoy => pages::shadertoy(scene),
        Package::GlslViewer => pages::glsl_viewer(scene),
        Package::WebGl => pages::webgl(scene),
        Package::WebGpu => pages::webgpu(scene),
        Package::Godot4 => godot::godot_4(scene),
        Package::Godot3 => godot::godot_3(scene),
        Package::Bevy => bevy::files(scene),
        Package::Blender => blender::files(scene),
        Package::Isf => pages::isf(scene),
        Package::Three => three::files(scene),
        Package::Unity => unity::files(scene),
        Package::Unreal => unreal::files(scene),
    }
}
