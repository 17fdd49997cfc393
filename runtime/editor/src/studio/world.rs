//! The files of a compilation: open texts first, then the disk.

use std::collections::HashMap;
use std::sync::Arc;

use chiaro_compiler::World;
use chiaro_files::FileWorld;

/// The texts that are open, by the full names of their files.
pub(crate) type Buffers = Arc<HashMap<String, Arc<str>>>;

/// The file system, with the texts that are open in the place of their files.
pub(crate) struct BufferWorld {
    buffers: Buffers,
    files: FileWorld,
}

impl BufferWorld {
    pub(crate) fn new(buffers: Buffers) -> Self {
        Self { buffers, files: FileWorld::new() }
    }
}

impl World for BufferWorld {
    fn find(&self, from: &str, path: &str) -> Option<String> {
        self.files.find(from, path)
    }

    fn read(&self, name: &str) -> Result<Vec<u8>, String> {
        match self.buffers.get(name) {
            Some(text) => Ok(text.as_bytes().to_vec()),
            None => self.files.read(name),
        }
    }
}
