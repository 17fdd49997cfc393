//! `chiaro dump`: prints what one stage of the compiler makes of a scene.

use std::process::ExitCode;

use anyhow::Result;
use chiaro_compiler::syntax::{Dialect, FileId, parse, print};
use chiaro_compiler::{field, solid};

use crate::arguments::{Dump, Global, Stage};
use crate::{compile, output};

pub(crate) fn run(arguments: &Dump, global: &Global) -> Result<ExitCode> {
    let compilation = compile::compilation(&arguments.scene, global)?;
    let text = match (arguments.stage, &compilation.scene) {
        (Stage::Syntax, _) => {
            // A text that has errors further on still has a syntax tree.
            let Some((id, file)) = compilation.sources.iter().next() else { return Ok(ExitCode::FAILURE) };
            debug_assert_eq!(id, FileId(0));
            print(&parse(id, &file.text, Dialect::of_file(&file.name)).0)
        }
        (_, None) => return Ok(ExitCode::FAILURE),
        (Stage::Solid, Some(scene)) => {
            let (lights, camera) = (solid::print_lights(&scene.lights), solid::print_camera(&scene.camera));
            solid::print(&scene.solid) + &lights + &camera
        }
        (Stage::Field, Some(scene)) => field::print(&scene.graph),
        (Stage::Wgsl, Some(scene)) => match compile::wgsl(&compilation, scene, global)? {
            Some(text) => text,
            None => return Ok(ExitCode::FAILURE),
        },
    };
    output::text(&text)?;
    Ok(if compilation.has_errors() { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}
