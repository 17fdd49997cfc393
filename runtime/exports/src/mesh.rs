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
    match format {
        MeshFormat::Stl => vec![File::new(path, write::stl(&model.mesh))],
        MeshFormat::Ply => vec![File::new(path, write::ply(model))],
        MeshFormat::ThreeMf => {
            vec![File::new(path, write::threemf(model, &path.file_stem().unwrap_or_default().to_string_lossy()))]
        }
        MeshFormat::Glb => vec![File::new(path, write::glb(model))],
        MeshFormat::Obj => {
            let materials = name_beside(path, "mtl", "#\\");
            let text = write::obj(model, &materials);
            vec![File::new(path.with_file_name(materials), write::mtl(model)), File::new(path, text)]
        }
        MeshFormat::Gltf => {
            let data = name_beside(path, "bin", "");
            let (document, bytes) = write::gltf(model, &data);
            vec![File::new(path.with_file_name(data), bytes), File::new(path, document)]
        }
    }
}

/// The name of a file beside another, which refers to it by that: in one line, and without these signs, which mean something there.
fn name_beside(path: &Path, ending: &str, signs: &str) -> String {
    let name = path.with_extension(ending).file_name().unwrap_or_default().to_string_lossy().into_owned();
    name.trim().replace(|c: char| c.is_control() || signs.contains(c), "_")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_beside_others_have_names_that_can_be_referred_to() {
        assert_eq!(name_beside(Path::new("out/part 1.obj"), "mtl", "#\\"), "part 1.mtl");
        assert_eq!(name_beside(Path::new("part #1\nusemtl x.obj"), "mtl", "#\\"), "part _1_usemtl x.mtl");
    }
}
