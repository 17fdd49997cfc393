//! Godot: a project with the solid and the picture as materials, and a scene for each.

use chiaro_syntax::Diagnostic;

use super::folder::Folder;
use crate::context::Context;
use crate::languages::translated;
use crate::subject::Scene;
use crate::target::File;
use crate::translate::Dialect;

/// What differs between the engine's versions.
struct Version {
    dialect: Dialect,
    /// How the names of files with shaders end.
    ending: &'static str,
    /// Declares the live numbers.
    uniforms: &'static str,
    /// What stands behind the name of a time, to read the one that is now.
    now: &'static str,
    solid: &'static str,
    picture: &'static str,
    solid_scene: &'static str,
    picture_scene: &'static str,
    project: &'static str,
    readme: &'static str,
}

const GODOT_4: Version = Version {
    dialect: Dialect::Godot4,
    ending: "gdshader",
    uniforms: include_str!("../../packages/godot/4/uniforms.gdshader"),
    now: "_now()",
    solid: include_str!("../../packages/godot/4/solid.gdshader"),
    picture: include_str!("../../packages/godot/4/picture.gdshader"),
    solid_scene: concat!(
        include_str!("../../packages/godot/frame.txt"),
        include_str!("../../packages/godot/4/solid.tscn")
    ),
    picture_scene: concat!(
        include_str!("../../packages/godot/frame.txt"),
        include_str!("../../packages/godot/4/picture.tscn")
    ),
    project: include_str!("../../packages/godot/4/project.godot"),
    readme: include_str!("../../packages/godot/4/readme.md"),
};

const GODOT_3: Version = Version {
    dialect: Dialect::Godot3,
    ending: "shader",
    uniforms: include_str!("../../packages/godot/3/uniforms.shader"),
    // Functions don't see the clock.
    now: "_now",
    solid: include_str!("../../packages/godot/3/solid.shader"),
    picture: include_str!("../../packages/godot/3/picture.shader"),
    solid_scene: concat!(
        include_str!("../../packages/godot/frame.txt"),
        include_str!("../../packages/godot/3/solid.tscn")
    ),
    picture_scene: concat!(
        include_str!("../../packages/godot/frame.txt"),
        include_str!("../../packages/godot/3/picture.tscn")
    ),
    project: include_str!("../../packages/godot/3/project.godot"),
    readme: include_str!("../../packages/godot/3/readme.md"),
};

pub(super) fn godot_4(scene: &Scene) -> Result<Vec<File>, Diagnostic> {
    files(scene, &GODOT_4)
}

pub(super) fn godot_3(scene: &Scene) -> Result<Vec<File>, Diagnostic> {
    files(scene, &GODOT_3)
}

fn files(scene: &Scene, version: &Version) -> Result<Vec<File>, Diagnostic> {
    let (solid, lit) = scene.solid_and_lit()?;
    let parameters = &solid.source.parameters;
    let is_time = |name: &str| parameters.iter().any(|parameter| parameter.is_time && parameter.name == name);
    // Time is what its uniform says, or the engine's clock.
    let read = |name: &str| if is_time(name) { format!("{name}{}", version.now) } else { name.to_owned() };
    let context = Context::new(scene, parameters)?;
    let uniforms = context.fill(version.uniforms, "")?;
    let solid_code = uniforms.clone() + &translated(&solid, version.dialect, &read)?;
    let lit_code = uniforms + &translated(&lit, version.dialect, &read)?;
    let folder = Folder::new(context)
        .add_code(&format!("{{}}_solid.{}", version.ending), version.solid, &solid_code)?
        .add_code(&format!("{{}}_picture.{}", version.ending), version.picture, &lit_code)?
        .add("{}_solid.tscn", version.solid_scene)?
        .add("{}_picture.tscn", version.picture_scene)?
        .add("project.godot", version.project)?
        .add("README.md", version.readme)?;
    Ok(folder.files())
}
