//! Compiling a scene from the command line, with its diagnostics reported.

use std::process::ExitCode;

use anyhow::Result;
use chiaro_compiler::field::Node;
use chiaro_compiler::syntax::Sources;
use chiaro_compiler::{Compilation, Facets, Options, Scene, shader};
use chiaro_files::FileWorld;

use crate::arguments::{FacetPolicy, Global, SceneArguments};
use crate::terminal;

/// Compiles the scene and reports what there is to say. None means that errors were reported.
pub(crate) fn scene(arguments: &SceneArguments, global: &Global) -> Result<Option<Scene>> {
    Ok(compilation(arguments, global)?.scene)
}

/// Compiles the scene and reports what there is to say.
pub(crate) fn compilation(arguments: &SceneArguments, global: &Global) -> Result<Compilation> {
    let options = Options {
        definitions: arguments.definitions.clone(),
        facets: match arguments.facets {
            FacetPolicy::Auto => Facets::Auto,
            FacetPolicy::Exact => Facets::Exact,
            FacetPolicy::Smooth => Facets::Smooth,
        },
        ..Options::default()
    };
    let world = FileWorld::new();
    let compilation = chiaro_compiler::compile(&world, &world.name_of(&arguments.file), &options);
    terminal::report(&compilation.sources, &compilation.diagnostics, global)?;
    let is_empty = |scene: &Scene| matches!(scene.graph.nodes[scene.graph.root.0 as usize], Node::Nothing);
    if compilation.scene.as_ref().is_some_and(is_empty) {
        terminal::note(global, &format!("{}: the scene is empty", arguments.file.display()));
    }
    Ok(compilation)
}

/// What a command came to that drew the scene. One that fits into no shader is reported as the compiler's errors are.
pub(crate) fn drawn(result: Result<ExitCode>, sources: &Sources, global: &Global) -> Result<ExitCode> {
    match result.as_ref().err().and_then(|error| error.downcast_ref()) {
        Some(chiaro_render::Error::Scene(diagnostic)) => {
            terminal::report(sources, std::slice::from_ref(&**diagnostic), global)?;
            Ok(ExitCode::FAILURE)
        }
        _ => result,
    }
}

/// The scene's shader code. None means that an error was reported.
pub(crate) fn wgsl(compilation: &Compilation, scene: &Scene, global: &Global) -> Result<Option<String>> {
    match shader::wgsl(&scene.graph) {
        Ok(text) => Ok(Some(text)),
        Err(diagnostic) => {
            terminal::report(&compilation.sources, &[diagnostic], global)?;
            Ok(None)
        }
    }
}
