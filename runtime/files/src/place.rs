//! Where a file is written, given what is there already.

use std::fs::{self, FileType, Metadata};
use std::io;
use std::path::{Component, Path, PathBuf};

/// The most links that lead from one to the other, as in Linux.
const MOST_LINKS: usize = 40;

/// How bytes come to a path.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// A new file takes this path, in the place of what may be there.
    Whole(PathBuf),
    /// They are written into the file that is there, because it has other names too, which would keep the old bytes.
    Shared(PathBuf),
    /// They are written to a pipe or a device.
    Stream(PathBuf),
}

impl Place {
    /// That of a path. Links are followed. An error says in words why nothing can be written there.
    pub(crate) fn of(path: &Path) -> io::Result<Self> {
        let path = followed(path)?;
        let metadata = match fs::metadata(&path) {
            Ok(metadata) => metadata,
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Place::Whole(path)),
            Err(error) => return Err(error),
        };
        if is_stream(&path, &metadata) {
            return Ok(Place::Stream(path));
        }
        if let Some(what) = special(metadata.file_type()) {
            return Err(io::Error::other(format!("it is {what}")));
        }
        if metadata.permissions().readonly() || !is_writable(&path) {
            return Err(io::Error::other("it is there already, and may not be written to"));
        }
        Ok(if has_other_names(&metadata) { Place::Shared(path) } else { Place::Whole(path) })
    }
}

/// Whether what is at a path takes bytes one after the other, such as a pipe or a terminal: nothing that is there is lost if
/// something is written to it.
pub fn is_stream_at(path: &Path) -> bool {
    matches!(Place::of(path), Ok(Place::Stream(_)))
}

/// What a path stands for if links are followed. The last of them may lead to what isn't there.
pub(crate) fn followed(path: &Path) -> io::Result<PathBuf> {
    let mut path = path.to_owned();
    for _ in 0..MOST_LINKS {
        // The kernel's links to what a process has open don't tell a name.
        if is_of_process(&path) {
            return Ok(path);
        }
        match fs::read_link(&path) {
            Ok(target) => path = path.parent().map_or(target.clone(), |folder| folder.join(&target)),
            Err(_) => return Ok(path),
        }
    }
    Err(io::Error::other("its links lead in a circle"))
}

/// Whether a path is that of what a process has open, such as /dev/stdout.
fn is_of_process(path: &Path) -> bool {
    let is_in = |folder: &str| path.starts_with(folder) && !path.components().any(|part| part == Component::ParentDir);
    ["/dev/stdout", "/dev/stderr", "/dev/fd", "/proc"].into_iter().any(is_in)
}

/// What is neither a file nor takes bytes one after the other.
fn special(kind: FileType) -> Option<&'static str> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        if kind.is_socket() {
            return Some("a socket");
        }
        if kind.is_block_device() {
            return Some("a disk");
        }
    }
    kind.is_dir().then_some("a folder")
}

#[cfg(unix)]
fn is_stream(path: &Path, metadata: &Metadata) -> bool {
    use std::os::unix::fs::FileTypeExt;
    let kind = metadata.file_type();
    kind.is_fifo() || kind.is_char_device() || is_of_process(path) && special(kind).is_none()
}

#[cfg(not(unix))]
fn is_stream(_: &Path, _: &Metadata) -> bool {
    false
}

#[cfg(unix)]
fn is_writable(path: &Path) -> bool {
    rustix::fs::access(path, rustix::fs::Access::WRITE_OK).is_ok()
}

#[cfg(not(unix))]
fn is_writable(_: &Path) -> bool {
    true
}

#[cfg(unix)]
fn has_other_names(metadata: &Metadata) -> bool {
    std::os::unix::fs::MetadataExt::nlink(metadata) > 1
}

#[cfg(not(unix))]
fn has_other_names(_: &Metadata) -> bool {
    false
}
