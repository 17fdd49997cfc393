//! `chiaro export`: writes a scene as another program reads it.
//!
//! A target makes the bytes of [`output::File`]s in memory; [`output::write`] then puts all of them into place, or none.

mod mesh;
mod output;
mod parallel;

use std::path::Path;
use std::process::ExitCode;

use anyhow::{Result, bail};

use crate::arguments::{Export, Global, Target};
use crate::compile;

pub(crate) fn run(arguments: &Export, global: &Global) -> Result<ExitCode> {
    let target = target(arguments)?;
    output::refuse(&arguments.output, arguments.force)?;
    let compilation = compile::compilation(&arguments.scene, global)?;
    let Some(scene) = &compilation.scene else { return Ok(ExitCode::FAILURE) };
    let files = match target {
        Target::Stl | Target::Obj | Target::Ply | Target::ThreeMf | Target::Gltf | Target::Glb => {
            mesh::files(scene, target, arguments, global)?
        }
    };
    output::write(&files, arguments.force)?;
    Ok(ExitCode::SUCCESS)
}

/// What the command line asks for, else what the ending of the file's name stands for.
fn target(arguments: &Export) -> Result<Target> {
    match arguments.to.or_else(|| of_ending(&arguments.output)) {
        Some(target) => Ok(target),
        None => bail!(
            "cannot tell the format of {}: end its name in .stl, .obj, .ply, .3mf, .gltf or .glb, or say --to",
            arguments.output.display()
        ),
    }
}

fn of_ending(path: &Path) -> Option<Target> {
    let ending = path.extension()?.to_string_lossy().to_ascii_lowercase();
    match ending.as_str() {
        "stl" => Some(Target::Stl),
        "obj" => Some(Target::Obj),
        "ply" => Some(Target::Ply),
        "3mf" => Some(Target::ThreeMf),
        "gltf" => Some(Target::Gltf),
        "glb" => Some(Target::Glb),
        _ => None,
    }
}
