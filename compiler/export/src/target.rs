//! The programs that scenes are exported to.

use chiaro_syntax::Diagnostic;

use crate::subject::Scene;
use crate::{languages, packages};

/// What a scene can be exported to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Target {
    /// Functions in a shading language.
    Library(Language),
    /// A whole program in a shading language, which draws the scene.
    Program(Language),
    /// The files of an engine.
    Package(Package),
}

/// A shading language.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "the names say it")]
pub enum Language {
    Wgsl,
    Glsl330,
    /// For Vulkan as for OpenGL 4.5: uniforms are in blocks.
    Glsl450,
    GlslEs300,
    /// Shader model 5 and later.
    Hlsl,
    Metal,
    /// Only whole programs.
    SpirV,
}

/// What takes a scene as files of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "the names say it")]
pub enum Package {
    Shadertoy,
    GlslViewer,
    /// A page that draws with WebGL 2.
    WebGl,
    /// A page that draws with WebGPU.
    WebGpu,
    /// A project for Godot 4.
    Godot4,
    /// The same for Godot 3.
    Godot3,
    /// A crate with materials.
    Bevy,
    /// A script that adds lights, sky and camera to the mesh `NAME.obj`, which is left to whoever exports.
    Blender,
    /// The Interactive Shader Format of VJs' programs.
    Isf,
    /// Modules for three.js.
    Three,
    /// Shaders for both of its pipelines, and a menu.
    Unity,
    /// A material, and a script that installs it.
    Unreal,
}

/// A file of an export.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Its path within the export's folder; empty, if the export is this file alone.
    pub path: String,
    /// What is in it.
    pub bytes: Vec<u8>,
}

impl File {
    pub(crate) fn alone(text: impl Into<Vec<u8>>) -> Vec<Self> {
        vec![Self { path: String::new(), bytes: text.into() }]
    }
}

/// The files of an export. An error tells what the target can't express.
pub fn export(scene: &Scene, target: Target) -> Result<Vec<File>, Diagnostic> {
    if scene.graph.facts[scene.graph.root.0 as usize].bounds.is_empty() {
        return Err(Diagnostic::error(None, "the scene is empty: there is nothing to export"));
    }
    match target {
        Target::Library(language) => languages::library(scene, language),
        Target::Program(language) => languages::program(scene, language),
        Target::Package(package) => packages::files(scene, package),
    }
}
