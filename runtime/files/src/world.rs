//! The files a scene may name.

use std::env;
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

use chiaro_compiler::World;

/// No text of this size is a scene; reading it would only fill the memory.
const MAX_BYTES: u64 = 256 << 20;

/// The file system: paths are relative to the file that names them, then to OpenSCAD's library folders.
pub struct FileWorld {
    libraries: Vec<PathBuf>,
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
        Self { libraries }
    }
}

impl World for FileWorld {
    fn find(&self, from: &str, path: &str) -> Option<String> {
        let beside = Path::new(from).parent().map(|folder| folder.join(path));
        let in_libraries = self.libraries.iter().map(|folder| folder.join(path));
        let found = beside.into_iter().chain(in_libraries).find(|candidate| candidate.is_file())?;
        // One file has one name, however it is reached: so that include cycles are seen.
        let name = fs::canonicalize(&found).unwrap_or(found);
        Some(name.to_string_lossy().into_owned())
    }

    fn read(&self, name: &str) -> Result<Vec<u8>, String> {
        let metadata = fs::metadata(name).map_err(|error| reason(&error))?;
        if metadata.is_dir() {
            return Err("it is a folder".to_owned());
        }
        // Pipes and devices don't say how long they are.
        let mut bytes = Vec::new();
        let file = fs::File::open(name).map_err(|error| reason(&error))?;
        file.take(MAX_BYTES + 1).read_to_end(&mut bytes).map_err(|error| reason(&error))?;
        if bytes.len() as u64 > MAX_BYTES {
            return Err(format!("it is larger than {} MB", MAX_BYTES >> 20));
        }
        Ok(bytes)
    }
}

fn reason(error: &std::io::Error) -> String {
    match error.kind() {
        std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
        std::io::ErrorKind::PermissionDenied => "it may not be read by this user".to_owned(),
        _ => error.to_string(),
    }
}
