//! Where results go: files, or standard output.

use std::io::{IsTerminal, Write, stdout};
use std::path::Path;

use anyhow::{Context, Result};

use crate::files;
use crate::shown::shown;
use crate::terminal::STANDARD;

/// Whether a path on the command line stands for standard output. By its own name too: opened by that, it would be another one,
/// which writes over the beginning of the file that standard output goes to.
pub(crate) fn is_standard(path: &Path) -> bool {
    path == Path::new(STANDARD) || path == Path::new("/dev/stdout")
}

/// Writes a file whole or not at all, or standard output.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    if is_standard(path) {
        return to_standard(bytes);
    }
    files::write(path, bytes)
}

/// Writes a text to standard output. A terminal shows it as it shows messages; what reads a pipe gets the text itself.
pub(crate) fn text(text: &str) -> Result<()> {
    match stdout().is_terminal() {
        true => to_standard(shown(text).as_bytes()),
        false => to_standard(text.as_bytes()),
    }
}

/// Writes to standard output.
pub(crate) fn to_standard(bytes: &[u8]) -> Result<()> {
    let mut output = stdout().lock();
    output.write_all(bytes).and_then(|()| output.flush()).context("cannot write to standard output")
}
