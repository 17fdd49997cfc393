//! Bevy: a crate with the scene's materials.

use chiaro_syntax::Diagnostic;

use super::folder::Folder;
use crate::context::Context;
use crate::subject::{Scene, Text};
use crate::target::File;

const CRATE: &str = include_str!("../../packages/bevy/crate.toml");
const PLUGIN: &str = include_str!("../../packages/bevy/lib.rs");
const SHOW: &str = include_str!("../../packages/bevy/show.rs");
const HIT: &str = include_str!("../../packages/bevy/hit.wgsl");
const SOLID: &str = include_str!("../../packages/bevy/solid.wgsl");
const DEPTH: &str = include_str!("../../packages/bevy/depth.wgsl");
const PICTURE: &str = include_str!("../../packages/bevy/picture.wgsl");
const README: &str = include_str!("../../packages/bevy/readme.md");

/// What no crate may be called: Rust's keywords and own crates, Bevy's, and what would make a second `StandardMaterial`.
const TAKEN: &str = "abstract alloc as async await become bevy box break const continue core crate do dyn else enum extern false \
                     final fn for gen if impl in let loop macro match mod move mut override priv proc_macro pub ref return self \
                     standard static std struct super test trait true try type typeof unsafe unsized use virtual where while \
                     yield";

pub(super) fn files(scene: &Scene) -> Result<Vec<File>, Diagnostic> {
    let (solid, lit) = scene.solid_and_lit()?;
    let hit = format!("{}\n{HIT}", material(&solid));
    let context = Context::new(scene, &solid.source.parameters)?.with_other_name(TAKEN);
    let folder = Folder::new(context)
        .add("Cargo.toml", CRATE)?
        .add("src/lib.rs", PLUGIN)?
        .add_code("src/{}.wgsl", SOLID, &hit)?
        .add_code("src/{}_depth.wgsl", DEPTH, &hit)?
        .add_code("src/{}_picture.wgsl", PICTURE, &material(&lit))?
        .add("examples/show.rs", SHOW)?
        .add("README.md", README)?;
    Ok(folder.files())
}

/// A text as Bevy wants it: live numbers are in the bind group of materials.
fn material(text: &Text) -> String {
    text.wgsl_bound("#{MATERIAL_BIND_GROUP}", 0)
}
