//! Files written whole or not at all.

use std::io::Write;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use tempfile::{NamedTempFile, TempPath};

/// Files that belong together and are made one after the other: none takes its place before all are written, and nothing is
/// left of them where that doesn't come.
#[derive(Debug, Default)]
pub struct Batch {
    staged: Vec<(PathBuf, TempPath)>,
}

impl Batch {
    /// Writes `bytes`, which are to become the file at `path`.
    pub fn write(&mut self, path: &Path, bytes: &[u8]) -> Result<()> {
        let staged = stage(path, bytes).with_context(|| failure(path))?;
        self.staged.push((path.to_owned(), staged));
        Ok(())
    }

    /// Puts all of them in their places.
    pub fn finish(self) -> Result<()> {
        for (path, file) in self.staged {
            file.persist(&path).map_err(|error| error.error).with_context(|| failure(&path))?;
        }
        Ok(())
    }
}

/// Writes `bytes` to `path`: into a temporary file beside it, which then takes its place.
pub fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    write_all(&[(path, bytes)])
}

/// Writes files that belong together: none takes its place before all are written.
pub fn write_all(files: &[(&Path, &[u8])]) -> Result<()> {
    let mut batch = Batch::default();
    files.iter().try_for_each(|(path, bytes)| batch.write(path, bytes))?;
    batch.finish()
}

/// Writes files that are all in one folder. Where there is no folder yet, it appears with all of them in it.
pub fn write_folder(folder: &Path, files: &[(&Path, &[u8])]) -> Result<()> {
    let create = |folder: &Path| std::fs::create_dir_all(folder).with_context(|| failure(folder));
    if folder.exists() {
        files.iter().filter_map(|(path, _)| path.parent()).try_for_each(create)?;
        return write_all(files);
    }
    let around = match folder.parent() {
        Some(around) if !around.as_os_str().is_empty() => around,
        _ => Path::new("."),
    };
    let staged = tempfile::Builder::new().prefix(".chiaro-").tempdir_in(around).with_context(|| failure(folder))?;
    for (path, bytes) in files {
        let path = staged.path().join(path.strip_prefix(folder).unwrap_or(path));
        path.parent().map_or(Ok(()), create)?;
        write(&path, bytes)?;
    }
    make_folder_readable(staged.path()).with_context(|| failure(folder))?;
    std::fs::rename(staged.keep(), folder).with_context(|| failure(folder))
}

fn failure(path: &Path) -> String {
    format!("cannot write {}", path.display())
}

/// The temporary file that is to become the one at `path`.
fn stage(path: &Path, bytes: &[u8]) -> std::io::Result<TempPath> {
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let mut file = NamedTempFile::new_in(folder)?;
    file.write_all(bytes)?;
    make_readable(file.path(), path)?;
    Ok(file.into_temp_path())
}

/// Temporary files are private; what takes the place of a file may be read by the same people, and what is new by all.
#[cfg(unix)]
fn make_readable(temporary: &Path, path: &Path) -> std::io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    let before = std::fs::metadata(path).map(|metadata| metadata.permissions());
    std::fs::set_permissions(temporary, before.unwrap_or_else(|_| std::fs::Permissions::from_mode(0o644)))
}

#[cfg(unix)]
fn make_folder_readable(folder: &Path) -> std::io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    std::fs::set_permissions(folder, std::fs::Permissions::from_mode(0o755))
}

#[cfg(not(unix))]
fn make_folder_readable(_: &Path) -> std::io::Result<()> {
    Ok(())
}

#[cfg(not(unix))]
fn make_readable(_: &Path, _: &Path) -> std::io::Result<()> {
    Ok(())
}
