//! Triangle meshes.

use std::ops::ControlFlow;
use std::path::Path;

use anyhow::Result;
use chiaro_compiler::Scene;
use chiaro_exports::{File, MeshFormat, mesh, mesh_files};
use chiaro_mesh::{Detail, Model, Progress, Stage};
use indicatif::ProgressBar;

use crate::arguments::{Export, Global};
use crate::terminal;

/// The files of a scene's mesh, the main one of which has this path.
pub(super) fn files(
    scene: &Scene,
    format: MeshFormat,
    path: &Path,
    arguments: &Export,
    global: &Global,
) -> Result<Vec<File>> {
    let detail = Detail { tolerance: arguments.tolerance, resolution: arguments.resolution };
    let progress = terminal::progress(global, 0, "");
    let model = mesh(scene, &scene.defaults(), &detail, &mut |now| {
        show(&progress, now);
        ControlFlow::Continue(())
    });
    progress.finish_and_clear();
    let model = model?;
    say(&model, path, global);
    Ok(mesh_files(&model, format, path))
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
