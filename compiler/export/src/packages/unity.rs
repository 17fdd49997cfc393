//! Unity: shaders for the Universal and the built-in pipeline, and a menu that adds the scene.

use chiaro_syntax::Diagnostic;

use super::folder::Folder;
use crate::context::Context;
use crate::languages::translated;
use crate::subject::Scene;
use crate::target::File;
use crate::translate::Dialect;

const SOLID_SHADER: &str = include_str!("../../packages/unity/solid.shader");
const SOLID: &str = include_str!("../../packages/unity/solid.hlsl");
const LIGHT: &str = include_str!("../../packages/unity/light.hlsl");
const PICTURE_SHADER: &str = include_str!("../../packages/unity/picture.shader");
const PICTURE: &str = include_str!("../../packages/unity/picture.hlsl");
const MENU: &str = include_str!("../../packages/unity/menu.cs");
const README: &str = include_str!("../../packages/unity/readme.md");

pub(super) fn files(scene: &Scene) -> Result<Vec<File>, Diagnostic> {
    let (solid, lit) = scene.solid_and_lit()?;
    let property = |name: &str| format!("_{name}");
    let folder = Folder::new(Context::new(scene, &solid.source.parameters)?)
        .add("{}.shader", SOLID_SHADER)?
        .add_code("{}.hlsl", SOLID, &translated(&solid, Dialect::Hlsl, &property)?)?
        .add("{}_light.hlsl", LIGHT)?
        .add("{}_picture.shader", PICTURE_SHADER)?
        .add_code("{}_picture.hlsl", PICTURE, &translated(&lit, Dialect::Hlsl, &property)?)?
        .add("Editor/{}_menu.cs", MENU)?
        .add("README.md", README)?;
    Ok(folder.files())
}
