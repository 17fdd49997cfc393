//! Scenes as exports.

use chiaro_compiler::ModuleNames;
use chiaro_compiler::export::{self, Camera, File, Language, Package, Target};
use chiaro_compiler::field::Graph;
use chiaro_compiler::shader::Setting;
use chiaro_compiler::solid::LiveParameter;
use chiaro_compiler::syntax::{Diagnostic, Sources};

use crate::sampling::sample_box;

/// Every target there is.
pub const TARGETS: [Target; 25] = [
    Target::Library(Language::Wgsl),
    Target::Library(Language::Glsl330),
    Target::Library(Language::Glsl450),
    Target::Library(Language::GlslEs300),
    Target::Library(Language::Hlsl),
    Target::Library(Language::Metal),
    Target::Program(Language::Wgsl),
    Target::Program(Language::Glsl330),
    Target::Program(Language::Glsl450),
    Target::Program(Language::GlslEs300),
    Target::Program(Language::Hlsl),
    Target::Program(Language::Metal),
    Target::Program(Language::SpirV),
    Target::Package(Package::Shadertoy),
    Target::Package(Package::GlslViewer),
    Target::Package(Package::WebGl),
    Target::Package(Package::WebGpu),
    Target::Package(Package::Godot4),
    Target::Package(Package::Godot3),
    Target::Package(Package::Bevy),
    Target::Package(Package::Blender),
    Target::Package(Package::Isf),
    Target::Package(Package::Three),
    Target::Package(Package::Unity),
    Target::Package(Package::Unreal),
];

/// The files of a scene's export, from a camera in front of it and without lights.
pub fn exported(
    title: &str,
    graph: &Graph,
    parameters: &[LiveParameter],
    sources: &Sources,
    target: Target,
) -> Result<Vec<File>, Diagnostic> {
    let names = ModuleNames::new(sources);
    let root = &graph.facts[graph.root.0 as usize];
    let bounds = sample_box(&root.bounds);
    let setting = Setting {
        lipschitz: root.lipschitz as f32,
        epsilon: 1e-4,
        bounds: [bounds.min, bounds.max].map(|corner| corner.map(|x| x as f32)),
        floor: Some(bounds.min[2] as f32),
        azimuth: [1.0, 0.0],
        sky: None,
        lights: Vec::new(),
    };
    let camera = Camera {
        eye: [0.0, -200.0, 0.0],
        target: [0.0; 3],
        right: [1.0, 0.0, 0.0],
        up: [0.0, 0.0, 1.0],
        half_height: 0.2,
        aspect: 4.0 / 3.0,
    };
    let names = |span| names.of(span);
    export::export(&export::Scene { title, graph, parameters, names: &names, setting: &setting, camera }, target)
}
