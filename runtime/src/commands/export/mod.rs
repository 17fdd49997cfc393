//! `chiaro export`: writes a scene as another program reads it.
//!
//! What is written, and how, is [`chiaro_exports`]'; here is what the command line says about it.

mod mesh;

use std::path::Path;
use std::process::ExitCode;

use anyhow::{Result, bail};
use chiaro_compiler::export::{self, Language, Package};
use chiaro_compiler::{Compilation, Scene};
use chiaro_exports::{File, Format, MeshFormat, Shaded};
use chiaro_render::{Error, Gpu, Preference};

use crate::arguments::{Export, Global, Target};
use crate::{compile, files, output, terminal};

pub(crate) fn run(arguments: &Export, global: &Global) -> Result<ExitCode> {
    let target = target(arguments)?;
    let to_standard = output::is_standard(&arguments.output);
    if !to_standard && arguments.output.exists() && !files::is_stream_at(&arguments.output) {
        refuse(&arguments.output, arguments.force)?;
    }
    let compilation = compile::compilation(&arguments.scene, global)?;
    let Some(scene) = &compilation.scene else { return Ok(ExitCode::FAILURE) };
    let written = made(&compilation, scene, target, arguments, global).and_then(|files| {
        if to_standard {
            return alone(files).and_then(|bytes| output::to_standard(&bytes)).map(|()| ExitCode::SUCCESS);
        }
        if let Some(place) = chiaro_exports::occupied(&files, &arguments.output) {
            refuse(place, arguments.force)?;
        }
        chiaro_exports::write(&files, &arguments.output)?;
        Ok(ExitCode::SUCCESS)
    });
    compile::drawn(written, &compilation.sources, global)
}

/// Refuses to write where something is, unless forced.
fn refuse(occupied: &Path, force: bool) -> Result<()> {
    if !force {
        bail!("{} is there already; --force writes over it", occupied.display());
    }
    Ok(())
}

/// The bytes of an export that is one file.
fn alone(files: Vec<File>) -> Result<Vec<u8>> {
    match <[File; 1]>::try_from(files) {
        Ok([file]) => Ok(file.bytes),
        Err(files) => {
            bail!("this target is {} files, and standard output is one: name a file or a folder", files.len())
        }
    }
}

/// The files of an export.
fn made(
    compilation: &Compilation,
    scene: &Scene,
    target: Target,
    arguments: &Export,
    global: &Global,
) -> Result<Vec<File>> {
    match format(target, arguments.program) {
        Format::Mesh(_) if arguments.program => bail!("--program is for shading languages, such as --to glsl-330"),
        Format::Mesh(format) => mesh::files(scene, format, &arguments.output, arguments, global),
        Format::Shader(target) => {
            let gpu = device(&arguments.adapter.preference(), global)?;
            let title = arguments.scene.file.file_stem().unwrap_or_default().to_string_lossy();
            let shaded = Shaded { title: &title, scene, sources: &compilation.sources, view: None };
            let mut files = chiaro_exports::shader_files(gpu.as_ref(), &shaded, target, &arguments.output)?;
            if let Some(path) = chiaro_exports::mesh_beside(target, &files, &arguments.output) {
                files.extend(mesh::files(scene, MeshFormat::Obj, &path, arguments, global)?);
            }
            Ok(files)
        }
    }
}

/// What measures the scene. Where there is no driver at all, and no adapter is asked for, an export does without.
fn device(preference: &Preference, global: &Global) -> Result<Option<Gpu>> {
    match Gpu::new(preference) {
        Err(Error::NoDriver) if *preference == Preference::Any => {
            let text = "note: without a graphics driver the view and the floor follow the scene's bounds, which may be larger than it";
            terminal::note(global, text);
            Ok(None)
        }
        gpu => Ok(Some(gpu?)),
    }
}

fn format(target: Target, program: bool) -> Format {
    let language = |language: Language| {
        Format::Shader(if program { export::Target::Program(language) } else { export::Target::Library(language) })
    };
    let package = |package: Package| Format::Shader(export::Target::Package(package));
    match target {
        Target::Stl => Format::Mesh(MeshFormat::Stl),
        Target::Obj => Format::Mesh(MeshFormat::Obj),
        Target::Ply => Format::Mesh(MeshFormat::Ply),
        Target::ThreeMf => Format::Mesh(MeshFormat::ThreeMf),
        Target::Gltf => Format::Mesh(MeshFormat::Gltf),
        Target::Glb => Format::Mesh(MeshFormat::Glb),
        Target::Wgsl => language(Language::Wgsl),
        Target::Glsl330 => language(Language::Glsl330),
        Target::Glsl450 => language(Language::Glsl450),
        Target::GlslEs300 => language(Language::GlslEs300),
        Target::Hlsl => language(Language::Hlsl),
        Target::Msl => language(Language::Metal),
        Target::SpirV => Format::Shader(export::Target::Program(Language::SpirV)),
        Target::Shadertoy => package(Package::Shadertoy),
        Target::GlslViewer => package(Package::GlslViewer),
        Target::WebGl => package(Package::WebGl),
        Target::WebGpu => package(Package::WebGpu),
        Target::Godot => package(Package::Godot4),
        Target::Godot3 => package(Package::Godot3),
        Target::Bevy => package(Package::Bevy),
        Target::Blender => package(Package::Blender),
        Target::Isf => package(Package::Isf),
        Target::Three => package(Package::Three),
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
