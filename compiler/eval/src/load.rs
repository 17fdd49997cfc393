//! Reading the scene and every file it includes or uses.

use chiaro_syntax::tree::{File, Name, Statement};
use chiaro_syntax::{Diagnostic, Dialect, FileId, SourceFile, Sources, Spanned, parse};
use rustc_hash::FxHashMap;

use crate::options::{Limits, World};

/// The number of a file in a [`Library`].
pub(crate) type FileIndex = usize;

/// All files of a scene, parsed; the scene itself is the first.
pub(crate) struct Library {
    /// The files, in the order they were met.
    pub(crate) files: Vec<Loaded>,
    /// Whether all files that are referred to could be read.
    pub(crate) is_complete: bool,
    links: FxHashMap<(FileId, Name), FileIndex>,
}

/// One parsed file.
pub(crate) struct Loaded {
    /// Its number in the sources.
    pub(crate) id: FileId,
    /// Its statements.
    pub(crate) tree: File,
}

impl Library {
    /// The file that an `include` or `use` of `path` in the file `from` stands for, if it could be read.
    pub(crate) fn linked(&self, from: FileId, path: &Name) -> Option<FileIndex> {
        self.links.get(&(from, path.clone())).copied()
    }
}

/// Parses the scene and, transitively, what it includes or uses.
pub(crate) fn load(
    world: &dyn World,
    sources: &mut Sources,
    main: FileId,
    limits: &Limits,
    diagnostics: &mut Vec<Diagnostic>,
) -> Library {
    let library = Library { files: Vec::new(), is_complete: true, links: FxHashMap::default() };
    let mut loader = Loader { world, sources, limits, diagnostics, library, numbers: FxHashMap::default() };
    let name = loader.sources.get(main).name.clone();
    loader.numbers.insert(name, 0);
    loader.parse(main);
    // Files are appended while this runs: each is looked through once.
    let mut next = 0;
    while next < loader.library.files.len() {
        loader.follow(next);
        next += 1;
    }
    loader.library
}

struct Loader<'a> {
    world: &'a dyn World,
    sources: &'a mut Sources,
    limits: &'a Limits,
    diagnostics: &'a mut Vec<Diagnostic>,
    library: Library,
    numbers: FxHashMap<String, FileIndex>,
}

impl Loader<'_> {
    fn parse(&mut self, id: FileId) {
        let source = self.sources.get(id);
        let (tree, reports) = parse(id, &source.text, Dialect::of_file(&source.name));
        self.diagnostics.extend(reports);
        self.library.files.push(Loaded { id, tree });
    }

    /// Reads the files that one file refers to.
    fn follow(&mut self, from: FileIndex) {
        let id = self.library.files[from].id;
        let mut paths = Vec::new();
        collect_paths(&self.library.files[from].tree.statements, &mut paths);
        for path in paths {
            let key = (id, path.node.clone());
            if !self.library.links.contains_key(&key)
                && let Some(file) = self.file(id, &path)
            {
                self.library.links.insert(key, file);
            }
        }
    }

    /// The file that `path` names, read if it was not yet.
    fn file(&mut self, from: FileId, path: &Spanned<Name>) -> Option<FileIndex> {
        if is_font(&path.node) {
            let message = "fonts are not read, because `text` is not supported yet";
            self.diagnostics.push(Diagnostic::warning(path.span, message));
            return None;
        }
        let Some(name) = self.world.find(&self.sources.get(from).name, &path.node) else {
            let message = format!("can't find `{}`", path.node);
            let error = Diagnostic::error(path.span, message)
                .with_hint("paths are relative to the file they stand in, or to a library folder");
            return self.missing(error);
        };
        if let Some(known) = self.numbers.get(&name) {
            return Some(*known);
        }
        if self.library.files.len() >= self.limits.statements {
            return self.missing(Diagnostic::error(path.span, "the scene consists of too many files"));
        }
        match self.world.read(&name) {
            Ok(bytes) => {
                let text = String::from_utf8_lossy(&bytes).into_owned();
                let number = self.library.files.len();
                let id = self.sources.add(SourceFile::new(name.clone(), text));
                self.numbers.insert(name, number);
                self.parse(id);
                Some(number)
            }
            Err(reason) => self.missing(Diagnostic::error(path.span, format!("can't read `{name}`: {reason}"))),
        }
    }

    /// Says why there is no such file.
    fn missing(&mut self, error: Diagnostic) -> Option<FileIndex> {
        self.library.is_complete = false;
        self.diagnostics.push(error);
        None
    }
}

/// Whether a path is that of a font, which OpenSCAD lets a scene `use` like a library.
fn is_font(path: &str) -> bool {
    let extension = path.rsplit_once('.').map(|(_, extension)| extension.to_ascii_lowercase());
    extension.is_some_and(|extension| matches!(&*extension, "ttf" | "otf"))
}

/// The paths of all `include` and `use` statements, wherever they stand.
fn collect_paths(statements: &[Statement], paths: &mut Vec<Spanned<Name>>) {
    for statement in statements {
        match statement {
            Statement::Include(path) | Statement::Use(path) => paths.push(path.clone()),
            Statement::Block(block) => collect_paths(block, paths),
            Statement::Module(module) => collect_paths(&module.body, paths),
            Statement::Instance(instance) => {
                collect_paths(&instance.children, paths);
                collect_paths(&instance.otherwise, paths);
            }
            Statement::Assignment(_) | Statement::Function(_) => {}
        }
    }
}
