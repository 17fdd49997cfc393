//! Triangle meshes.

use std::path::Path;

use anyhow::{Result, bail};
use chiaro_compiler::Scene;
use chiaro_compiler::solid::Dimension;
use chiaro_mesh::{Detail, GraphField, Model, Watch, model, write};

use crate::files::File;
use crate::format::MeshFormat;
use crate::parallel::Parallel;

/// The mesh of a scene whose parameters have these values. An error if the scene is no solid, or if `watch` ends it.
pub fn mesh(scene: &Scene, values: &[f64], detail: &Detail, watch: &mut Watch) -> Result<Model> {
    if scene.dimension() == Some(Dimension::Plane) {
        bail!("the scene is plane, and a mesh is of solids: put linear_extrude(height = …) around it");
    }
    let field = Parallel::new(GraphField::new(&scene.graph, values));
    Ok(model(&field, detail, watch)?)
}

/// The files of a mesh, the main one at `path`.
pub fn mesh_files(model: &Model, format: MeshFormat, path: &Path) -> Vec<File> {
    let beside = |ending: &str| path.with_extension(ending);
    let name = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    match format {
        MeshFormat::Stl => vec![File::new(path, write::stl(&model.mesh))],
        MeshFormat::Ply => vec![File::new(path, write::ply(model))],
        MeshFormat::ThreeMf => {
            vec![File::new(path, write::threemf(model, &path.file_stem().unwrap_or_default().to_string_lossy()))]
        }
        MeshFormat::Glb => vec![File::new(path, write::glb(model))],
        MeshFormat::Obj => {
            let materials = beside("mtl");
            let text = write::obj(model, &name(&materials));
            vec![File::new(materials, write::mtl(model)), File::new(path, text)]
        }
        MeshFormat::Gltf => {
            let data = beside("bin");
            let (document, bytes) = write::gltf(model, &name(&data));
            vec![File::new(data, bytes), File::new(path, document)]
        }
    }
}
