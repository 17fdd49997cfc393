//! The files a scene may name.

use std::collections::HashMap;
use std::env;
use std::fs::{self, File, Metadata, OpenOptions};
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use anyhow::{Context, Result, bail};
use chiaro_compiler::World;

/// No text of this size is a scene; reading it would only fill the memory.
const MAX_BYTES: u64 = 256 << 20;

/// What the worlds of this process are confined to, if nothing else is said of them.
static JAIL: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

fn jail() -> MutexGuard<'static, Vec<PathBuf>> {
    JAIL.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Confines all worlds that this process makes from then on to these folders, if there are any.
pub fn confine(folders: &[PathBuf]) -> Result<()> {
    *jail() = real_folders(folders)?;
    Ok(())
}

/// Adds a folder to those that the worlds of this process are confined to, if they are.
pub fn admit(folder: &Path) {
    let mut jail = jail();
    if !jail.is_empty() {
        jail.push(fs::canonicalize(folder).unwrap_or_else(|_| folder.to_owned()));
    }
}

/// Folders without links on the way to them.
fn real_folders(folders: &[PathBuf]) -> Result<Vec<PathBuf>> {
    let real = |folder: &PathBuf| {
        let found = fs::canonicalize(folder).with_context(|| format!("cannot find {}", folder.display()))?;
        if !found.is_dir() {
            bail!("{} is not a folder", folder.display());
        }
        Ok(found)
    };
    folders.iter().map(real).collect()
}

/// The file system: paths are relative to the file that names them, then to OpenSCAD's library folders.
///
/// A scene may read whatever its user may read, as in OpenSCAD, unless the world is [confined](Self::confined), or all worlds
/// of the process [are](confine()).
#[derive(Debug)]
pub struct FileWorld {
    libraries: Vec<PathBuf>,
    /// The folders that all that is read has to be in, if there are such.
    jail: Vec<PathBuf>,
    /// The paths that can't be said in Unicode, by the names they have instead.
    unspeakable: Mutex<HashMap<String, PathBuf>>,
}

impl Default for FileWorld {
    fn default() -> Self {
        Self::new()
    }
}

impl FileWorld {
    /// With the library folders of `OPENSCADPATH`, of the user and of the system, in this order.
    pub fn new() -> Self {
        let mut libraries: Vec<PathBuf> = env::var_os("OPENSCADPATH")
            .map(|paths| env::split_paths(&paths).filter(|path| !path.as_os_str().is_empty()).collect())
            .unwrap_or_default();
        if let Some(home) = env::var_os("HOME") {
            libraries.push(Path::new(&home).join(".local/share/OpenSCAD/libraries"));
            libraries.push(Path::new(&home).join("Documents/OpenSCAD/libraries"));
        }
        libraries.push(PathBuf::from("/usr/share/openscad/libraries"));
        Self { libraries, jail: jail().clone(), unspeakable: Mutex::default() }
    }

    /// The same, but what is outside of these folders is not there, wherever links lead. Without any folder, nothing is confined.
    pub fn confined(folders: &[PathBuf]) -> Result<Self> {
        Ok(Self { jail: real_folders(folders)?, ..Self::new() })
    }

    /// What the compiler and messages call a file. Two files never have the same name.
    pub fn name_of(&self, path: &Path) -> String {
        if let Some(name) = path.to_str() {
            return name.to_owned();
        }
        let mut named = self.unspeakable.lock().unwrap_or_else(PoisonError::into_inner);
        let mut name = path.to_string_lossy().into_owned();
        while Path::new(&name).exists() || named.get(&name).is_some_and(|known| known != path) {
            name.insert(name.rfind('.').unwrap_or(name.len()), '\'');
        }
        named.insert(name.clone(), path.to_owned());
        name
    }

    /// The file of a name.
    fn path_of(&self, name: &str) -> PathBuf {
        let named = self.unspeakable.lock().unwrap_or_else(PoisonError::into_inner);
        named.get(name).cloned().unwrap_or_else(|| PathBuf::from(name))
    }

    /// Reads a file whole, or says why it can't be.
    pub fn read_file(&self, path: &Path) -> Result<Vec<u8>, String> {
        let path = self.admitted(path)?;
        // Opening a pipe or a device may do something, or wait for ever.
        ordinary(&fs::metadata(&path).map_err(reason)?)?;
        let file = open(&path).map_err(reason)?;
        let metadata = file.metadata().map_err(reason)?;
        ordinary(&metadata)?;
        // Folders may have become links before the file was opened.
        if !self.jail.is_empty() && !fs::metadata(self.admitted(&path)?).is_ok_and(|found| is_same(&found, &metadata)) {
            return Err("it changed while it was opened".to_owned());
        }
        let mut bytes = Vec::new();
        // What has no length and is not empty is no file of a disk's, such as /proc/kmsg, which has no end.
        let most = if metadata.len() == 0 { 1 } else { MAX_BYTES + 1 };
        file.take(most).read_to_end(&mut bytes).map_err(reason)?;
        if metadata.len() == 0 && !bytes.is_empty() {
            return Err("it is no ordinary file".to_owned());
        }
        if bytes.len() as u64 > MAX_BYTES {
            return Err(format!("it is larger than {} MB", MAX_BYTES >> 20));
        }
        Ok(bytes)
    }

    /// A path without links, if what is read has to be somewhere and it is there; or the path as it is.
    fn admitted(&self, path: &Path) -> Result<PathBuf, String> {
        if self.jail.is_empty() {
            return Ok(path.to_owned());
        }
        let real = fs::canonicalize(path).map_err(reason)?;
        if !self.admits(&real) {
            return Err("it is outside of the folders that may be read".to_owned());
        }
        Ok(real)
    }

    /// Whether a path without links is one that may be read.
    fn admits(&self, real: &Path) -> bool {
        self.jail.is_empty() || self.jail.iter().any(|folder| real.starts_with(folder))
    }
}

impl World for FileWorld {
    fn find(&self, from: &str, path: &str) -> Option<String> {
        let beside = self.path_of(from).parent().map(|folder| folder.join(path));
        let in_libraries = self.libraries.iter().map(|folder| folder.join(path));
        let real = |candidate: PathBuf| match candidate.is_file() {
            // One file has one name, however it is reached: so that include cycles are seen.
            true => Some(fs::canonicalize(&candidate).unwrap_or(candidate)),
            false => None,
        };
        let found = beside.into_iter().chain(in_libraries).filter_map(real).find(|real| self.admits(real))?;
        Some(self.name_of(&found))
    }

    fn read(&self, name: &str) -> Result<Vec<u8>, String> {
        self.read_file(&self.path_of(name))
    }
}

/// Refuses what is not a file.
fn ordinary(metadata: &Metadata) -> Result<(), String> {
    let kind = metadata.file_type();
    if kind.is_file() {
        return Ok(());
    }
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        let what = [(kind.is_fifo(), "a pipe"), (kind.is_socket(), "a socket")];
        let device = (kind.is_block_device() || kind.is_char_device(), "a device");
        if let Some((_, what)) = what.into_iter().chain([device]).find(|(is, _)| *is) {
            return Err(format!("it is {what}, and scenes are files"));
        }
    }
    Err("it is a folder".to_owned())
}

/// Opens a file to be read. What came to be there meanwhile doesn't make anybody wait.
#[cfg(unix)]
fn open(path: &Path) -> std::io::Result<File> {
    use std::os::unix::fs::OpenOptionsExt;
    let flags = rustix::fs::OFlags::NONBLOCK.bits().cast_signed();
    OpenOptions::new().read(true).custom_flags(flags).open(path)
}

#[cfg(not(unix))]
fn open(path: &Path) -> std::io::Result<File> {
    OpenOptions::new().read(true).open(path)
}

#[cfg(unix)]
fn is_same(a: &Metadata, b: &Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    (a.dev(), a.ino()) == (b.dev(), b.ino())
}

#[cfg(not(unix))]
fn is_same(_: &Metadata, _: &Metadata) -> bool {
    true
}

fn reason(error: std::io::Error) -> String {
    match error.kind() {
        std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
        std::io::ErrorKind::PermissionDenied => "it may not be read by this user".to_owned(),
        std::io::ErrorKind::WouldBlock => "it is no ordinary file".to_owned(),
        _ => error.to_string(),
    }
}
