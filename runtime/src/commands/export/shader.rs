//! Shader code, alone or as what engines take.

use anyhow::Result;
use chiaro_compiler::export::{self, Camera};
use chiaro_compiler::{Compilation, ModuleNames, Scene};
use chiaro_render::{Gpu, Lighting, Model, Picture, View};

use super::output::File;
use crate::arguments::Export;

/// The width and height, in pixels, of the picture that the scene's own view is framed for.
const SIZE: [u32; 2] = [960, 720];

/// The files of an export. An error is a diagnostic of the scene if it is about that.
pub(super) fn files(
    compilation: &Compilation,
    scene: &Scene,
    target: export::Target,
    arguments: &Export,
) -> Result<Vec<File>> {
    let gpu = Gpu::new(&arguments.adapter.preference())?;
    let graph = scene.picture();
    let values = scene.defaults();
    let model = Model::new(&gpu, &graph, &values)?;
    let view = View::framing_model(&gpu, &model, &scene.camera, f64::from(SIZE[0]) / f64::from(SIZE[1]))?;
    let mut picture = Picture::new(&gpu, &model, view, SIZE)?;
    if !scene.lights.is_empty() {
        picture.set_lighting(Lighting::of(&scene.lights, &values, &view))?;
    }
    let title = arguments.scene.file.file_stem().unwrap_or_default().to_string_lossy();
    let names = ModuleNames::new(&compilation.sources);
    let exported = export::Scene {
        title: &title,
        graph: &graph,
        parameters: &scene.parameters,
        names: &|span| names.of(span),
        setting: &picture.setting(),
        camera: camera(&view),
    };
    let files =
        export::export(&exported, target).map_err(|diagnostic| chiaro_render::Error::Scene(Box::new(diagnostic)))?;
    let place = |file: export::File| match file.path.is_empty() {
        true => File::new(&arguments.output, file.bytes),
        false => File::new(arguments.output.join(file.path), file.bytes),
    };
    Ok(files.into_iter().map(place).collect())
}

fn camera(view: &View) -> Camera {
    let (right, up) = view.sideways();
    Camera {
        eye: view.eye(),
        target: view.target,
        right,
        up,
        half_height: (0.5 * view.field_of_view).to_radians().tan(),
        aspect: f64::from(SIZE[0]) / f64::from(SIZE[1]),
    }
}
