//! What is not in its place yet: files and folders that disappear unless they get there, also if a signal ends the process.

use std::fs::{self, File, OpenOptions};
use std::io;
use std::mem;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// What disappears when the process is told to end.
static REGISTERED: Mutex<Vec<(PathBuf, Kind)>> = Mutex::new(Vec::new());

/// How something disappears.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    File,
    /// With all that is in it.
    Folder,
    /// Unless something is in it.
    EmptyFolder,
}

impl Kind {
    /// Removes what is at a path. What can't be removed stays: this is done where something else went wrong already.
    fn remove(self, path: &Path) {
        let _ = match self {
            Kind::File => fs::remove_file(path),
            Kind::Folder => fs::remove_dir_all(path),
            Kind::EmptyFolder => fs::remove_dir(path),
        };
    }
}

/// Removes all that is not in its place yet, and lets nothing be put anywhere from then on: who tries to waits for the process
/// to end. For whoever is told to end it.
pub fn abandon() {
    let mut registered = registered();
    for (path, kind) in registered.drain(..).rev() {
        kind.remove(&path);
    }
    mem::forget(registered);
}

fn registered() -> MutexGuard<'static, Vec<(PathBuf, Kind)>> {
    REGISTERED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A file or a folder that is removed in the end, unless it took a place of its own.
#[derive(Debug)]
pub struct Temporary {
    path: PathBuf,
    kind: Kind,
}

impl Temporary {
    /// A new folder in the system's folder of such things.
    pub fn folder() -> io::Result<Self> {
        Self::folder_in(&std::env::temp_dir())
    }

    /// A new folder in this one, for its user alone.
    pub(crate) fn folder_in(folder: &Path) -> io::Result<Self> {
        Self::create(folder, Kind::Folder, make_private_folder).map(|(temporary, ())| temporary)
    }

    /// A new file in this folder, for its user alone.
    pub(crate) fn file_in(folder: &Path) -> io::Result<(Self, File)> {
        Self::create(folder, Kind::File, |path| private(OpenOptions::new().write(true).create_new(true)).open(path))
    }

    fn create<T>(folder: &Path, kind: Kind, make: impl FnMut(&Path) -> io::Result<T>) -> io::Result<(Self, T)> {
        // A signal must not come between making and registering.
        let mut registered = registered();
        let named = tempfile::Builder::new().prefix(".chiaro-").disable_cleanup(true).make_in(folder, make)?;
        let (made, path) = named.into_parts();
        let path = path.to_path_buf();
        registered.push((path.clone(), kind));
        Ok((Self { path, kind }, made))
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Puts all of these into their places, without a signal in between. Where one can't be, neither are those behind it.
    pub(crate) fn settle(all: Vec<(Self, PathBuf)>) -> Result<(), (PathBuf, io::Error)> {
        let mut registered = registered();
        let mut result = Ok(());
        let mut left = Vec::new();
        for (temporary, place) in all {
            if result.is_ok() {
                match fs::rename(&temporary.path, &place) {
                    Ok(()) => {
                        registered.retain(|(path, _)| *path != temporary.path);
                        mem::forget(temporary);
                        continue;
                    }
                    Err(error) => result = Err((place, error)),
                }
            }
            left.push(temporary);
        }
        drop(registered);
        result
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        registered().retain(|(path, _)| *path != self.path);
        self.kind.remove(&self.path);
    }
}

/// Folders that were made for what is to be written into them. Those that nothing was written into are removed in the end.
#[derive(Debug, Default)]
pub struct Folders(Vec<Temporary>);

impl Folders {
    /// Makes a folder, and those it is in, unless they are there.
    pub fn make(&mut self, folder: &Path) -> io::Result<()> {
        let missing = folder.ancestors().take_while(|folder| !folder.as_os_str().is_empty() && !folder.exists());
        let missing: Vec<&Path> = missing.collect();
        for folder in missing.into_iter().rev() {
            let mut registered = registered();
            match fs::create_dir(folder) {
                Ok(()) => {
                    let (path, kind) = (folder.to_owned(), Kind::EmptyFolder);
                    registered.push((path.clone(), kind));
                    self.0.push(Temporary { path, kind });
                }
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
        Ok(())
    }
}

impl Drop for Folders {
    fn drop(&mut self) {
        // What is in another goes first.
        while self.0.pop().is_some() {}
    }
}

#[cfg(unix)]
fn private(options: &mut OpenOptions) -> &OpenOptions {
    use std::os::unix::fs::OpenOptionsExt;
    options.mode(0o600)
}

#[cfg(not(unix))]
fn private(options: &mut OpenOptions) -> &OpenOptions {
    options
}

#[cfg(unix)]
fn make_private_folder(path: &Path) -> io::Result<()> {
    use std::os::unix::fs::DirBuilderExt;
    fs::DirBuilder::new().mode(0o700).create(path)
}

#[cfg(not(unix))]
fn make_private_folder(path: &Path) -> io::Result<()> {
    fs::create_dir(path)
}
