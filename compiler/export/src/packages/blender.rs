//! Blender: a script that imports the scene's mesh, which whoever exports puts beside it, and adds lights, sky and camera.

use chiaro_syntax::Diagnostic;

use super::folder::Folder;
use crate::context::Context;
use crate::subject::Scene;
use crate::target::File;

const SCRIPT: &str = include_str!("../../packages/blender/scene.py");
const README: &str = include_str!("../../packages/blender/readme.md");

pub(super) fn files(scene: &Scene) -> Result<Vec<File>, Diagnostic> {
    let folder = Folder::new(Context::new(scene, &[])?).add("{}.py", SCRIPT)?.add("README.md", README)?;
    Ok(folder.files())
}
