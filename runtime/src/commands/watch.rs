//! `chiaro watch`: the picture of a scene, beside an editor of the user's own.

use std::fs;
use std::process::ExitCode;

use anyhow::{Context, Result};
use chiaro_editor::Options;

use crate::arguments::Watch;

pub(crate) fn run(arguments: &Watch) -> Result<ExitCode> {
    // What isn't there is better said here than in a window without a text.
    fs::File::open(&arguments.file).with_context(|| format!("cannot read {}", arguments.file.display()))?;
    super::edit::open(Options {
        files: vec![arguments.file.clone()],
        definitions: arguments.definitions.clone(),
        adapter: arguments.adapter.preference(),
        only_picture: true,
        ..Default::default()
    })
}
