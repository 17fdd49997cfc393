//! Files written whole or not at all.

use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};

use crate::place::{Place, followed};
use crate::temporaries::{Folders, Temporary};

/// Files that belong together and are made one after the other: none takes its place before all are written, and nothing is
/// left of them where that doesn't come.
#[derive(Debug, Default)]
pub struct Batch {
    /// Those that take the place of what may be there.
    whole: Vec<(Temporary, PathBuf)>,
    /// Those that are written over files that are there, each with a temporary one: a disk that has room for it has room for them.
    over: Vec<(PathBuf, Vec<u8>, Temporary)>,
    /// What goes to pipes and devices.
    streams: Vec<(PathBuf, Vec<u8>)>,
}

impl Batch {
    /// Writes `bytes`, which are to become the file at `path`.
    pub fn write(&mut self, path: &Path, bytes: &[u8]) -> Result<()> {
        said(path, self.stage(path, bytes))
    }

    fn stage(&mut self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        match Place::of(path)? {
            Place::Whole(place) => self.whole.push((staged(&place, bytes)?, place)),
            Place::Shared(place) => {
                let room = staged(&place, bytes)?;
                self.over.push((place, bytes.to_owned(), room));
            }
            Place::Stream(place) => self.streams.push((place, bytes.to_owned())),
        }
        Ok(())
    }

    /// Puts all of them in their places.
    pub fn finish(self) -> Result<()> {
        Temporary::settle(self.whole).or_else(|(place, error)| said(&place, Err(error)))?;
        for (place, bytes, room) in self.over {
            drop(room);
            said(&place, write_over(&place, &bytes))?;
        }
        self.streams.iter().try_for_each(|(place, bytes)| said(place, write_to_stream(place, bytes)))
    }
}

/// What came of writing to a path, with an error in words that names it.
fn said<T>(path: &Path, result: io::Result<T>) -> Result<T> {
    result.map_err(in_words).with_context(|| format!("cannot write {}", path.display()))
}

/// Writes `bytes` to `path`: into a temporary file beside it, which then takes its place.
///
/// What a link leads to is written, and the link stays. A pipe or a device gets the bytes. A file that may not be written to is
/// an error.
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
    let place = said(folder, followed(folder))?;
    if place.is_dir() {
        let mut folders = Folders::default();
        files.iter().map(|(path, _)| around(path)).try_for_each(|folder| said(folder, folders.make(folder)))?;
        return write_all(files);
    }
    let staged = said(folder, Temporary::folder_in(around(&place)))?;
    for (path, bytes) in files {
        let place = staged.path().join(path.strip_prefix(folder).unwrap_or(path));
        said(path, fs::create_dir_all(around(&place)).and_then(|()| write_new(&place, bytes)))?;
    }
    said(folder, make_folder_readable(staged.path()))?;
    Temporary::settle(vec![(staged, place)]).or_else(|(_, error)| said(folder, Err(error)))
}

fn write_new(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = OpenOptions::new().write(true).create_new(true).open(path)?;
    file.write_all(bytes)?;
    file.sync_all()
}

/// An error of the system's in words. It comes with the path that was meant, and tells no other one.
fn in_words(error: io::Error) -> io::Error {
    let words = match error.kind() {
        io::ErrorKind::NotFound => "there is no such folder",
        io::ErrorKind::NotADirectory => "what should be a folder is a file",
        io::ErrorKind::PermissionDenied => "this user may not write there",
        io::ErrorKind::StorageFull => "the disk is full",
        io::ErrorKind::QuotaExceeded => "this user may not take more room on the disk",
        io::ErrorKind::ReadOnlyFilesystem => "the disk is read-only",
        io::ErrorKind::DirectoryNotEmpty | io::ErrorKind::AlreadyExists => "something else came to be there meanwhile",
        io::ErrorKind::BrokenPipe => "nobody reads what is written",
        _ => return error,
    };
    io::Error::new(error.kind(), words)
}

/// The folder that something is in.
fn around(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// The temporary file that is to become the one at `path`. It is on the disk before it does, whatever happens to the machine.
fn staged(path: &Path, bytes: &[u8]) -> io::Result<Temporary> {
    let (staged, mut file) = Temporary::file_in(around(path))?;
    file.write_all(bytes)?;
    make_readable(staged.path(), path)?;
    file.sync_all()?;
    Ok(staged)
}

/// Writes over a file that has other names too.
fn write_over(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = OpenOptions::new().write(true).open(path)?;
    file.write_all(bytes)?;
    file.set_len(bytes.len() as u64)?;
    file.sync_all()
}

/// Writes to a pipe or a device; or behind what is in a file, where that is what a process has open.
fn write_to_stream(path: &Path, bytes: &[u8]) -> io::Result<()> {
    OpenOptions::new().append(true).open(path)?.write_all(bytes)
}

/// Temporary files are private; what takes the place of a file may be read by the same people, and what is new by all.
#[cfg(unix)]
fn make_readable(temporary: &Path, path: &Path) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    let before = fs::metadata(path).map(|metadata| metadata.permissions());
    fs::set_permissions(temporary, before.unwrap_or_else(|_| fs::Permissions::from_mode(0o644)))
}

#[cfg(unix)]
fn make_folder_readable(folder: &Path) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    fs::set_permissions(folder, fs::Permissions::from_mode(0o755))
}

#[cfg(not(unix))]
fn make_folder_readable(_: &Path) -> io::Result<()> {
    Ok(())
}

#[cfg(not(unix))]
fn make_readable(_: &Path, _: &Path) -> io::Result<()> {
    Ok(())
}
