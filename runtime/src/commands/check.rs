//! `chiaro check`: compiles a scene and reports what is wrong with it.

use std::process::ExitCode;

use anyhow::Result;
use chiaro_compiler::field::Crowds;
use chiaro_compiler::shader::{self, CrowdData, Template};
use chiaro_compiler::syntax::Diagnostic;
use chiaro_compiler::{Compilation, Scene};

use crate::arguments::{Check, Global};
use crate::{compile, terminal};

pub(crate) fn run(arguments: &Check, global: &Global) -> Result<ExitCode> {
    let compilation = compile::compilation(&arguments.scene, global)?;
    let Some(scene) = &compilation.scene else { return Ok(ExitCode::FAILURE) };
    // The shader is part of what can go wrong with a scene.
    if let Err(diagnostic) = shader::wgsl(&scene.graph).map(|_| ()).or_else(|_| drawable(scene)) {
        terminal::report(&compilation.sources, &[diagnostic], global)?;
        return Ok(ExitCode::FAILURE);
    }
    terminal::report(&compilation.sources, &highlights(&compilation, scene)?, global)?;
    let nodes = scene.graph.nodes.len();
    terminal::note(global, &format!("{}: no errors; {nodes} nodes in its field", arguments.scene.file.display()));
    Ok(ExitCode::SUCCESS)
}

/// Whether a scene that is too large for straight-line code can be drawn by loops.
fn drawable(scene: &Scene) -> std::result::Result<(), Diagnostic> {
    let mut crowds = Crowds::of(&scene.graph);
    CrowdData::of(&scene.graph, &mut crowds, &scene.defaults());
    shader::splice_with_crowds(&scene.graph, &crowds, Template::Distances).map(|_| ())
}

/// What `#` marks: only the editor shows that.
fn highlights(compilation: &Compilation, scene: &Scene) -> Result<Vec<Diagnostic>> {
    // To find them takes a while, and most scenes have none.
    if !compilation.sources.iter().any(|(_, file)| file.text.contains('#')) {
        return Ok(Vec::new());
    }
    let provenance = scene.provenance(&compilation.sources)?;
    let note = "`#` highlights this in the editor; elsewhere it is a part of the scene like any other";
    Ok(provenance.highlights().map(|sign| Diagnostic::note(sign, note)).collect())
}
