//! Files for tests.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use chiaro_compiler::World;

/// Files that exist only in memory, by name.
#[derive(Clone, Debug, Default)]
pub struct MemoryWorld {
    files: BTreeMap<String, Vec<u8>>,
}

impl MemoryWorld {
    /// A world of one file.
    pub fn of(name: &str, text: impl Into<Vec<u8>>) -> Self {
        Self::default().with(name, text)
    }

    /// The same world with one file more.
    pub fn with(mut self, name: &str, text: impl Into<Vec<u8>>) -> Self {
        self.files.insert(name.to_owned(), text.into());
        self
    }
}

impl World for MemoryWorld {
    fn find(&self, _from: &str, path: &str) -> Option<String> {
        self.files.contains_key(path).then(|| path.to_owned())
    }

    fn read(&self, name: &str) -> Result<Vec<u8>, String> {
        self.files.get(name).cloned().ok_or_else(|| "there is no such file".to_owned())
    }
}

/// The files of this machine, without any library folders.
#[derive(Clone, Copy, Debug)]
pub struct DiskWorld;

impl World for DiskWorld {
    fn find(&self, from: &str, path: &str) -> Option<String> {
        let beside = Path::new(from).parent()?.join(path);
        beside.is_file().then(|| beside.to_string_lossy().into_owned())
    }

    fn read(&self, name: &str) -> Result<Vec<u8>, String> {
        fs::read(name).map_err(|error| error.to_string())
    }
}
