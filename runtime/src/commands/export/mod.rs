//! `chiaro export`: writes a scene as another program reads it.
//!
//! A target makes the bytes of [`output::File`]s in memory; [`output::write`] then puts all of them into place, or none.

mod mesh;
mod output;
mod parallel;
mod shader;

use std::path::Path;
use std::process::ExitCode;

use anyhow::{Result, bail};
use chiaro_compiler::export::{self, Language, Package};
use chiaro_compiler::{Compilation, Scene};

use crate::arguments::{Export, Global, Target};
use crate::compile;
use output::File;

pub(crate) fn run(arguments: &Export, global: &Global) -> Result<ExitCode> {
    let target = target(arguments)?;
    output::refuse(&arguments.output, arguments.force)?;
    let compilation = compile::compilation(&arguments.scene, global)?;
    let Some(scene) = &compilation.scene else { return Ok(ExitCode::FAILURE) };
    let written = files(&compilation, scene, target, arguments, global).and_then(|files| {
        output::write(&files, &arguments.output, arguments.force)?;
        Ok(ExitCode::SUCCESS)
    });
    compile::drawn(written, &compilation.sources, global)
}

fn files(
    compilation: &Compilation,
    scene: &Scene,
    target: Target,
    arguments: &Export,
    global: &Global,
) -> Result<Vec<File>> {
    match shader_target(target, arguments.program) {
        Some(target) => shader::files(compilation, scene, target, arguments),
        None if arguments.program => bail!("--program is for shading languages, such as --to glsl-330"),
        None => mesh::files(scene, target, arguments, global),
    }
}

/// What the compiler calls a target, if it isn't a mesh.
fn shader_target(target: Target, program: bool) -> Option<export::Target> {
    let language = match target {
        Target::Stl | Target::Obj | Target::Ply | Target::ThreeMf | Target::Gltf | Target::Glb => return None,
        Target::Wgsl => Language::Wgsl,
        Target::Glsl330 => Language::Glsl330,
        Target::Glsl450 => Language::Glsl450,
        Target::GlslEs300 => Language::GlslEs300,
        Target::Hlsl => Language::Hlsl,
        Target::Msl => Language::Metal,
        Target::SpirV => return Some(export::Target::Program(Language::SpirV)),
        Target::Shadertoy => return Some(export::Target::Package(Package::Shadertoy)),
        Target::GlslViewer => return Some(export::Target::Package(Package::GlslViewer)),
        Target::WebGl => return Some(export::Target::Package(Package::WebGl)),
        Target::WebGpu => return Some(export::Target::Package(Package::WebGpu)),
    };
    Some(if program { export::Target::Program(language) } else { export::Target::Library(language) })
}

/// What the command line asks for, else what the ending of the file's name stands for.
fn target(arguments: &Export) -> Result<Target> {
    match arguments.to.or_else(|| of_ending(&arguments.output)) {
        Some(target) => Ok(target),
        None => bail!(
            "cannot tell the format of {}: say --to with one of the targets that `chiaro export --help` lists, or end the name \
             in .stl, .obj, .ply, .3mf, .gltf, .glb, .wgsl, .glsl, .hlsl, .metal, .spv or .html",
            arguments.output.display()
        ),
    }
}

fn of_ending(path: &Path) -> Option<Target> {
    let ending = path.extension()?.to_string_lossy().to_ascii_lowercase();
    match ending.as_str() {
        "stl" => Some(Target::Stl),
        "obj" => Some(Target::Obj),
        "ply" => Some(Target::Ply),
        "3mf" => Some(Target::ThreeMf),
        "gltf" => Some(Target::Gltf),
        "glb" => Some(Target::Glb),
        "wgsl" => Some(Target::Wgsl),
        "glsl" => Some(Target::Glsl330),
        "hlsl" => Some(Target::Hlsl),
        "metal" => Some(Target::Msl),
        "spv" => Some(Target::SpirV),
        "html" => Some(Target::WebGl),
        _ => None,
    }
}
