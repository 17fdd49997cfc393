//! `chiaro check`: compiles a scene and reports what is wrong with it.

use std::process::ExitCode;

use anyhow::Result;

use crate::arguments::{Check, Global};
use crate::{compile, terminal};

pub(crate) fn run(arguments: &Check, global: &Global) -> Result<ExitCode> {
    let compilation = compile::compilation(&arguments.scene, global)?;
    let Some(scene) = &compilation.scene else { return Ok(ExitCode::FAILURE) };
    // The shader is part of what can go wrong with a scene.
    if compile::wgsl(&compilation, scene, global)?.is_none() {
        return Ok(ExitCode::FAILURE);
    }
    let nodes = scene.graph.nodes.len();
    terminal::note(global, &format!("{}: no errors; {nodes} nodes in its field", arguments.scene.file.display()));
    Ok(ExitCode::SUCCESS)
}
