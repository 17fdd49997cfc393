//! `chiaro edit`: opens scenes in the editor.

use std::process::ExitCode;

use anyhow::{Result, anyhow};
use chiaro_editor::Options;

use crate::arguments::Edit;

pub(crate) fn run(arguments: &Edit) -> Result<ExitCode> {
    open(Options { files: arguments.files.clone(), adapter: arguments.adapter.preference(), ..Default::default() })
}

/// Opens the editor's window, until it is closed.
pub(super) fn open(options: Options) -> Result<ExitCode> {
    chiaro_editor::run(options).map_err(|reason| anyhow!("cannot open a window: {reason}"))?;
    Ok(ExitCode::SUCCESS)
}
