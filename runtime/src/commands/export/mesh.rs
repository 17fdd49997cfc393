//! Triangle meshes.

use std::ops::ControlFlow;
use std::path::Path;

use anyhow::{Result, bail};
use chiaro_compiler::Scene;
use chiaro_compiler::solid::Dimension;
use chiaro_mesh::{Detail, GraphField, Model, Progress, Stage, model, write};
use indicatif::ProgressBar;

use super::output::File;
use super::parallel::Parallel;
use crate::arguments::{Export, Global};
use crate::terminal;

/// The file formats of meshes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Format {
    Stl,
    Obj,
    Ply,
    ThreeMf,
    Gltf,
    Glb,
}

/// The files of a scene's mesh, the first of which has this path.
pub(super) fn files(
    scene: &Scene,
    format: Format,
    path: &Path,
    arguments: &Export,
    global: &Global,
) -> Result<Vec<File>> {
    if scene.dimension() == Some(Dimension::Plane) {
        bail!("the scene is plane, and a mesh is of solids: put linear_extrude(height = …) around it");
    }
    let model = make(scene, arguments, global)?;
    say(&model, path, global);
    Ok(encoded(&model, format, path))
}

fn make(scene: &Scene, arguments: &Export, global: &Global) -> Result<Model> {
    let values = scene.defaults();
    let field = Parallel::new(GraphField::new(&scene.graph, &values));
    let detail = Detail { tolerance: arguments.tolerance, resolution: arguments.resolution };
    let progress = terminal::progress(global, 0, "");
    let model = model(&field, &detail, &mut |now| {
        show(&progress, now);
        ControlFlow::Continue(())
    });
    progress.finish_and_clear();
    Ok(model?)
}

fn show(progress: &ProgressBar, now: Progress) {
    progress.set_message(match now.stage {
        Stage::Searching => "searching the surface",
        Stage::Crossing => "following edges",
        Stage::Placing => "placing vertices",
        Stage::Merging => "merging triangles",
        Stage::Painting => "painting",
    });
    progress.set_length(now.of as u64);
    progress.set_position(now.done as u64);
}

/// What came out, and what to be aware of.
fn say(model: &Model, output: &Path, global: &Global) {
    let report = &model.report;
    terminal::note(
        global,
        &format!(
            "{}: {} triangles, {} vertices, from cells of {:.3} mm; 99 % within {:.4} mm of the surface",
            output.display(),
            model.mesh.triangles.len(),
            model.mesh.vertices.len(),
            report.cell,
            report.deviation,
        ),
    );
    if report.misses_parts {
        let text = "note: some parts are thinner than a cell, and are missing; a higher --resolution finds them";
        terminal::note(global, text);
    }
    if report.deviation > report.tolerance {
        let text = format!(
            "note: that is more than the tolerance of {:.4} mm; a higher --resolution comes nearer",
            report.tolerance
        );
        terminal::note(global, &text);
    }
}

fn encoded(model: &Model, format: Format, path: &Path) -> Vec<File> {
    let beside = |ending: &str| path.with_extension(ending);
    let name = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    match format {
        Format::Stl => vec![File::new(path, write::stl(&model.mesh))],
        Format::Ply => vec![File::new(path, write::ply(model))],
        Format::ThreeMf => vec![File::new(path, write::threemf(model))],
        Format::Glb => vec![File::new(path, write::glb(model))],
        Format::Obj => {
            let materials = beside("mtl");
            let text = write::obj(model, &name(&materials));
            vec![File::new(materials, write::mtl(model)), File::new(path, text)]
        }
        Format::Gltf => {
            let data = beside("bin");
            let (document, bytes) = write::gltf(model, &name(&data));
            vec![File::new(data, bytes), File::new(path, document)]
        }
    }
}
