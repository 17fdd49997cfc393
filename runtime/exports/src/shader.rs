//! Shader code, alone or as what engines take.

use std::path::{Path, PathBuf};

use anyhow::Result;
use chiaro_compiler::export::{self, Camera, Package};
use chiaro_compiler::field::Graph;
use chiaro_compiler::shader::Setting;
use chiaro_compiler::syntax::Sources;
use chiaro_compiler::{ModuleNames, Scene};
use chiaro_render::{Gpu, Lighting, Model, Picture, View, setting_within_bounds};

use crate::files::File;

/// The width and height, in pixels, of the picture that views are framed for.
const SIZE: [u32; 2] = [960, 720];

/// A scene to be written as a shader.
pub struct Shaded<'a> {
    /// What it is called.
    pub title: &'a str,
    /// The scene.
    pub scene: &'a Scene,
    /// The text it is of.
    pub sources: &'a Sources,
    /// From where it is seen; none for the view of its own.
    pub view: Option<View>,
}

/// The files of an export, to be written to `output`. An error is a diagnostic of the scene if it is about that.
///
/// A device measures how far the scene reaches, as for pictures; without one, the view and the floor are those of the compiler's
/// bounds, which may be larger.
pub fn shader_files(gpu: Option<&Gpu>, shaded: &Shaded, target: export::Target, output: &Path) -> Result<Vec<File>> {
    let scene = shaded.scene;
    let graph = scene.picture();
    let (view, setting) = match gpu {
        Some(gpu) => measured(gpu, shaded, &graph)?,
        None => within_bounds(shaded, &graph),
    };
    let names = ModuleNames::new(shaded.sources);
    let exported = export::Scene {
        title: shaded.title,
        graph: &graph,
        parameters: &scene.parameters,
        names: &|span| names.of(span),
        setting: &setting,
        camera: camera(&view),
    };
    let files =
        export::export(&exported, target).map_err(|diagnostic| chiaro_render::Error::Scene(Box::new(diagnostic)))?;
    let place = |file: export::File| match file.path.is_empty() {
        true => File::new(output, file.bytes),
        false => File::new(output.join(file.path), file.bytes),
    };
    Ok(files.into_iter().map(place).collect())
}

/// Where the mesh is to be, an OBJ file, that belongs to the files of a target: Blender's script imports one.
pub fn mesh_beside(target: export::Target, files: &[File], output: &Path) -> Option<PathBuf> {
    if target != export::Target::Package(Package::Blender) {
        return None;
    }
    let script = files.iter().find(|file| file.path.extension().is_some_and(|ending| ending == "py"));
    Some(script.map_or_else(|| output.join("scene.obj"), |file| file.path.with_extension("obj")))
}

/// From where the scene is seen and how it is lit, as its picture would be.
fn measured(gpu: &Gpu, shaded: &Shaded, graph: &Graph) -> Result<(View, Setting)> {
    let scene = shaded.scene;
    let values = scene.defaults();
    let model = Model::new(gpu, graph, &values)?;
    let view = match shaded.view {
        Some(view) => view,
        None => View::framing_model(gpu, &model, &scene.camera, aspect())?,
    };
    let mut picture = Picture::new(gpu, &model, view, SIZE)?;
    if !scene.lights.is_empty() {
        picture.set_lighting(Lighting::of(&scene.lights, &values, &view))?;
    }
    Ok((view, picture.setting()))
}

/// The same by what the compiler knows.
fn within_bounds(shaded: &Shaded, graph: &Graph) -> (View, Setting) {
    let scene = shaded.scene;
    let values = scene.defaults();
    let bounds = graph.bounds_at(&values)[graph.root.0 as usize];
    let view = shaded.view.unwrap_or_else(|| View::framing(&scene.camera, &values, &bounds, aspect()));
    let lighting = match scene.lights.is_empty() {
        true => Lighting::studio(view.rotation[2].to_radians()),
        false => Lighting::of(&scene.lights, &values, &view),
    };
    (view, setting_within_bounds(graph, &bounds, &view, &lighting, SIZE))
}

fn aspect() -> f64 {
    f64::from(SIZE[0]) / f64::from(SIZE[1])
}

fn camera(view: &View) -> Camera {
    let (right, up) = view.sideways();
    Camera {
        eye: view.eye(),
        target: view.target,
        right,
        up,
        half_height: (0.5 * view.field_of_view).to_radians().tan(),
        aspect: aspect(),
    }
}
