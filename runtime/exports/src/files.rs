//! What an export writes: one file, or several that belong together.

use std::path::{Path, PathBuf};

use anyhow::Result;

/// A file to be written.
pub struct File {
    /// Where it is to be.
    pub path: PathBuf,
    /// What is in it.
    pub bytes: Vec<u8>,
}

impl File {
    pub(crate) fn new(path: impl Into<PathBuf>, bytes: impl Into<Vec<u8>>) -> Self {
        Self { path: path.into(), bytes: bytes.into() }
    }
}

/// The first place that these files would take and where something is already, unless it is a pipe or a device. `output` is their
/// own, or the folder that all of them are in.
pub fn occupied<'a>(files: &'a [File], output: &'a Path) -> Option<&'a Path> {
    let mut places = match is_folder(files, output) {
        true => vec![output],
        false => files.iter().map(|file| &*file.path).collect(),
    };
    places.retain(|place| place.exists() && !chiaro_files::is_stream_at(place));
    places.first().copied()
}

/// Writes all files, or none. What is there is written over; a folder is no place for a file.
pub fn write(files: &[File], output: &Path) -> Result<()> {
    let named: Vec<(&Path, &[u8])> = files.iter().map(|file| (&*file.path, &*file.bytes)).collect();
    match is_folder(files, output) {
        true => chiaro_files::write_folder(output, &named),
        false => chiaro_files::write_all(&named),
    }
}

/// Whether `output` is a folder that all files are in.
fn is_folder(files: &[File], output: &Path) -> bool {
    files.iter().all(|file| file.path != output && file.path.starts_with(output))
}
