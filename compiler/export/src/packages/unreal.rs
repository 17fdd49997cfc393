//! Unreal: the scene's functions, and a script that makes a material of them and adds a cube.

use chiaro_syntax::Diagnostic;

use super::folder::Folder;
use crate::context::Context;
use crate::languages::translated;
use crate::subject::Scene;
use crate::target::File;
use crate::translate::Dialect;

const SOLID: &str = include_str!("../../packages/unreal/solid.ush");
const INSTALL: &str = include_str!("../../packages/unreal/install.py");
const README: &str = include_str!("../../packages/unreal/readme.md");

pub(super) fn files(scene: &Scene) -> Result<Vec<File>, Diagnostic> {
    let (solid, _) = scene.solid_and_lit()?;
    let folder = Folder::new(Context::new(scene, &solid.source.parameters)?)
        .add_code("{}.ush", SOLID, &translated(&solid, Dialect::Hlsl, &|name| name.to_owned())?)?
        .add("install_{}.py", INSTALL)?
        .add("README.md", README)?;
    Ok(folder.files())
}
