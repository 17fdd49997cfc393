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
    match kind(target, arguments.program) {
        Kind::Shader(target) => shader::files(compilation, scene, target, arguments),
        Kind::Mesh(_) if arguments.program => bail!("--program is for shading languages, such as --to glsl-330"),
        Kind::Mesh(format) => mesh::files(scene, format, &arguments.output, arguments, global),
        Kind::Blender => blender(compilation, scene, arguments, global),
    }
}

/// Blender's script, and the mesh that it imports.
fn blender(compilation: &Compilation, scene: &Scene, arguments: &Export, global: &Global) -> Result<Vec<File>> {
    let mut files = shader::files(compilation, scene, export::Target::Package(Package::Blender), arguments)?;
    let script = files.iter().find(|file| file.path.extension().is_some_and(|ending| ending == "py"));
    let mesh = script.map_or_else(|| arguments.output.join("scene.obj"), |file| file.path.with_extension("obj"));
    files.extend(mesh::files(scene, mesh::Format::Obj, &mesh, arguments, global)?);
    Ok(files)
}

/// What a target is made by.
enum Kind {
    Mesh(mesh::Format),
    /// A mesh with a script.
    Blender,
    Shader(export::Target),
}

fn kind(target: Target, program: bool) -> Kind {
    let language = |language: Language| {
        Kind::Shader(if program { export::Target::Program(language) } else { export::Target::Library(language) })
    };
    let package = |package: Package| Kind::Shader(export::Target::Package(package));
    match target {
        Target::Stl => Kind::Mesh(mesh::Format::Stl),
        Target::Obj => Kind::Mesh(mesh::Format::Obj),
        Target::Ply => Kind::Mesh(mesh::Format::Ply),
        Target::ThreeMf => Kind::Mesh(mesh::Format::ThreeMf),
        Target::Gltf => Kind::Mesh(mesh::Format::Gltf),
        Target::Glb => Kind::Mesh(mesh::Format::Glb),
        Target::Wgsl => language(Language::Wgsl),
        Target::Glsl330 => language(Language::Glsl330),
        Target::Glsl450 => language(Language::Glsl450),
        Target::GlslEs300 => language(Language::GlslEs300),
        Target::Hlsl => language(Language::Hlsl),
        Target::Msl => language(Language::Metal),
        Target::SpirV => Kind::Shader(export::Target::Program(Language::SpirV)),
        Target::Shadertoy => package(Package::Shadertoy),
        Target::GlslViewer => package(Package::GlslViewer),
        Target::WebGl => package(Package::WebGl),
        Target::WebGpu => package(Package::WebGpu),
        Target::Godot => package(Package::Godot4),
        Target::Godot3 => package(Package::Godot3),
        Target::Bevy => package(Package::Bevy),
        Target::Blender => Kind::Blender,
        Target::Isf => package(Package::Isf),
        Target::Unity => package(Package::Unity),
        Target::Unreal => package(Package::Unreal),
    }
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
