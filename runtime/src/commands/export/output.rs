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
    if !force && path.exists() {
        bail!("{} is there already; --force writes over it", path.display());
    }
    Ok(())
}

/// Writes all files, or none if something is where `output` is to be: a file, or the folder that all files are in.
pub(super) fn write(files: &[File], output: &Path, force: bool) -> Result<()> {
    let named: Vec<(&Path, &[u8])> = files.iter().map(|file| (&*file.path, &*file.bytes)).collect();
    let is_folder = files.iter().all(|file| file.path != output && file.path.starts_with(output));
    if is_folder {
        refuse(output, force)?;
        return files::write_folder(output, &named);
    }
    files.iter().try_for_each(|file| refuse(&file.path, force))?;
    if let Some(folder) = files.iter().find(|file| file.path.is_dir()) {
        bail!("cannot write {}: it is a folder", folder.path.display());
    }
    files::write_all(&named)
}
