//! What an export writes: one file, or several that belong together.

use std::path::{Path, PathBuf};

use anyhow::{Result, bail};
use chiaro_files as files;

/// A file to be written.
pub(super) struct File {
    pub(super) path: PathBuf,
    pub(super) bytes: Vec<u8>,
}

impl File {
    pub(super) fn new(path: impl Into<PathBuf>, bytes: impl Into<Vec<u8>>) -> Self {
        Self { path: path.into(), bytes: bytes.into() }
    }
}

/// Refuses to write where something is, unless forced.
pub(super) fn refuse(path: &Path, force: bool) -> Result<()> {
    if path.is_dir() {
        bail!("cannot write {}: it is a folder", path.display());
    }
    if !force && path.exists() {
        bail!("{} is there already; --force writes over it", path.display());
    }
    Ok(())
}

/// Writes all files, or none if something is where one shall be.
pub(super) fn write(files: &[File], force: bool) -> Result<()> {
    files.iter().try_for_each(|file| refuse(&file.path, force))?;
    let named: Vec<(&Path, &[u8])> = files.iter().map(|file| (&*file.path, &*file.bytes)).collect();
    files::write_all(&named)
}
