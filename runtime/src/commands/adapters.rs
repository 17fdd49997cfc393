//! `chiaro adapters`: lists the graphics adapters that pictures can be drawn on.

use std::io::{Write, stdout};
use std::process::ExitCode;

use anyhow::{Context, Result};
use chiaro_render::Error;

pub(crate) fn run() -> Result<ExitCode> {
    let adapters = chiaro_render::adapters();
    if adapters.is_empty() {
        return Err(Error::NoDriver.into());
    }
    let mut output = stdout().lock();
    for adapter in adapters {
        let kind = if adapter.software { "software" } else { "hardware" };
        writeln!(output, "{} ({kind}, {}, {})", adapter.name, adapter.interface, adapter.driver)
            .context("cannot write to standard output")?;
    }
    Ok(ExitCode::SUCCESS)
}
