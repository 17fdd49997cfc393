//! `chiaro watch`: the picture of a scene, beside an editor of the user's own.

use std::process::ExitCode;

use anyhow::{Result, anyhow};
use chiaro_editor::Options;
use chiaro_files::FileWorld;

use crate::arguments::Watch;

pub(crate) fn run(arguments: &Watch) -> Result<ExitCode> {
    // What isn't there is better said here than in a window without a text.
    FileWorld::new()
        .read_file(&arguments.file)
        .map_err(|reason| anyhow!("cannot read {}: {reason}", arguments.file.display()))?;
    super::edit::open(Options {
        files: vec![arguments.file.clone()],
        definitions: arguments.definitions.clone(),
        adapter: arguments.adapter.preference(),
        only_picture: true,
        ..Default::default()
    })
}
