//! Compiling a scene from the command line, with its diagnostics reported.

use anyhow::Result;
use chiaro_compiler::{Compilation, Facets, Options, Scene, shader};

use crate::arguments::{FacetPolicy, Global, SceneArguments};
use crate::terminal;
use crate::world::FileWorld;

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
    let compilation = chiaro_compiler::compile(&FileWorld::new(), &arguments.file.to_string_lossy(), &options);
    terminal::report(&compilation.sources, &compilation.diagnostics, global)?;
    Ok(compilation)
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
