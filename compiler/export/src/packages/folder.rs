//! A package of several files: templates filled in, each at its place.

use chiaro_syntax::Diagnostic;

use crate::context::Context;
use crate::target::File;

/// The files of a package so far.
pub(super) struct Folder {
    context: Context,
    files: Vec<File>,
}

impl Folder {
    pub(super) fn new(context: Context) -> Self {
        Self { context, files: Vec::new() }
    }

    /// Adds a file without shader code. `{}` in the path stands for the scene's name.
    pub(super) fn add(self, path: &str, template: &str) -> Result<Self, Diagnostic> {
        self.add_code(path, template, "")
    }

    /// Adds a file with shader code.
    pub(super) fn add_code(mut self, path: &str, template: &str, code: &str) -> Result<Self, Diagnostic> {
        let bytes = self.context.fill(template, code)?.into_bytes();
        self.files.push(File { path: path.replace("{}", &self.context.name), bytes });
        Ok(self)
    }

    /// All of them.
    pub(super) fn files(self) -> Vec<File> {
        self.files
    }
}
