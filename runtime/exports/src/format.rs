//! What scenes can be written as.

use chiaro_compiler::export::{Language, Package, Target};

/// What a scene can be written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// A triangle mesh.
    Mesh(MeshFormat),
    /// Shader code, or what engines take.
    Shader(Target),
}

/// The file formats of meshes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the names say it")]
pub enum MeshFormat {
    Stl,
    Obj,
    Ply,
    ThreeMf,
    Gltf,
    Glb,
}

impl Format {
    /// All of them: meshes, functions, programs, packages.
    pub const ALL: &[Format] = &[
        Format::Mesh(MeshFormat::Stl),
        Format::Mesh(MeshFormat::ThreeMf),
        Format::Mesh(MeshFormat::Obj),
        Format::Mesh(MeshFormat::Ply),
        Format::Mesh(MeshFormat::Glb),
        Format::Mesh(MeshFormat::Gltf),
        Format::Shader(Target::Library(Language::Wgsl)),
        Format::Shader(Target::Library(Language::Glsl330)),
        Format::Shader(Target::Library(Language::Glsl450)),
        Format::Shader(Target::Library(Language::GlslEs300)),
        Format::Shader(Target::Library(Language::Hlsl)),
        Format::Shader(Target::Library(Language::Metal)),
        Format::Shader(Target::Program(Language::Wgsl)),
        Format::Shader(Target::Program(Language::Glsl330)),
        Format::Shader(Target::Program(Language::Glsl450)),
        Format::Shader(Target::Program(Language::GlslEs300)),
        Format::Shader(Target::Program(Language::Hlsl)),
        Format::Shader(Target::Program(Language::Metal)),
        Format::Shader(Target::Program(Language::SpirV)),
        Format::Shader(Target::Package(Package::Shadertoy)),
        Format::Shader(Target::Package(Package::GlslViewer)),
        Format::Shader(Target::Package(Package::WebGl)),
        Format::Shader(Target::Package(Package::WebGpu)),
        Format::Shader(Target::Package(Package::Isf)),
        Format::Shader(Target::Package(Package::Three)),
        Format::Shader(Target::Package(Package::Godot4)),
        Format::Shader(Target::Package(Package::Godot3)),
        Format::Shader(Target::Package(Package::Bevy)),
        Format::Shader(Target::Package(Package::Blender)),
        Format::Shader(Target::Package(Package::Unity)),
        Format::Shader(Target::Package(Package::Unreal)),
    ];

    /// As people call it.
    pub fn name(self) -> String {
        match self {
            Format::Mesh(format) => mesh_name(format).to_owned(),
            Format::Shader(Target::Library(language)) => format!("{} functions", language_name(language)),
            Format::Shader(Target::Program(language)) => format!("{} program", language_name(language)),
            Format::Shader(Target::Package(package)) => package_name(package).to_owned(),
        }
    }

    /// How its file's name ends; none, if it is a folder.
    pub fn ending(self) -> Option<&'static str> {
        match self {
            Format::Mesh(format) => Some(mesh_ending(format)),
            Format::Shader(Target::Library(language) | Target::Program(language)) => Some(language_ending(language)),
            Format::Shader(Target::Package(package)) => package_ending(package),
        }
    }
}

fn mesh_name(format: MeshFormat) -> &'static str {
    match format {
        MeshFormat::Stl => "STL mesh, no colours",
        MeshFormat::Obj => "OBJ mesh with materials",
        MeshFormat::Ply => "PLY mesh with colours",
        MeshFormat::ThreeMf => "3MF mesh for printing",
        MeshFormat::Gltf => "glTF mesh with materials, two files",
        MeshFormat::Glb => "glTF mesh with materials, GLB",
    }
}

fn mesh_ending(format: MeshFormat) -> &'static str {
    match format {
        MeshFormat::Stl => "stl",
        MeshFormat::Obj => "obj",
        MeshFormat::Ply => "ply",
        MeshFormat::ThreeMf => "3mf",
        MeshFormat::Gltf => "gltf",
        MeshFormat::Glb => "glb",
    }
}

fn language_name(language: Language) -> &'static str {
    match language {
        Language::Wgsl => "WGSL",
        Language::Glsl330 => "GLSL 330",
        Language::Glsl450 => "GLSL 450",
        Language::GlslEs300 => "GLSL ES 300",
        Language::Hlsl => "HLSL",
        Language::Metal => "Metal",
        Language::SpirV => "SPIR-V",
    }
}

fn language_ending(language: Language) -> &'static str {
    match language {
        Language::Wgsl => "wgsl",
        Language::Glsl330 | Language::Glsl450 | Language::GlslEs300 => "glsl",
        Language::Hlsl => "hlsl",
        Language::Metal => "metal",
        Language::SpirV => "spv",
    }
}

fn package_name(package: Package) -> &'static str {
    match package {
        Package::Shadertoy => "Shadertoy",
        Package::GlslViewer => "glslViewer",
        Package::WebGl => "Web page, WebGL 2",
        Package::WebGpu => "Web page, WebGPU",
        Package::Three => "three.js, a folder",
        Package::Godot4 => "Godot 4, a folder",
        Package::Godot3 => "Godot 3, a folder",
        Package::Bevy => "Bevy, a crate",
        Package::Blender => "Blender, a mesh with lights",
        Package::Isf => "Interactive Shader Format",
        Package::Unity => "Unity, a folder",
        Package::Unreal => "Unreal, a folder",
    }
}

fn package_ending(package: Package) -> Option<&'static str> {
    match package {
        Package::Shadertoy | Package::GlslViewer => Some("frag"),
        Package::WebGl | Package::WebGpu => Some("html"),
        Package::Isf => Some("fs"),
        Package::Three
        | Package::Godot4
        | Package::Godot3
        | Package::Bevy
        | Package::Blender
        | Package::Unity
        | Package::Unreal => None,
    }
}
