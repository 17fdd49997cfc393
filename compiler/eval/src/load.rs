//! Reading the scene and every file it includes or uses.

use chiaro_syntax::tree::{File, Name, Statement};
use chiaro_syntax::{Diagnostic, Dialect, FileId, Severity, Sources, Span, Spanned, parse};
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
    let (tree, reports) = parse_source(loader.sources, main);
    loader.keep(main, tree, reports);
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
    fn keep(&mut self, id: FileId, tree: File, reports: Vec<Diagnostic>) {
        self.diagnostics.extend(reports);
        self.library.files.push(Loaded { id, tree });
    }

    /// Parses a file that is named at this place.
    fn parse_named(&mut self, id: FileId, place: Span) {
        let (tree, reports) = parse_source(self.sources, id);
        let first = reports.iter().find(|report| report.severity == Severity::Error);
        match first.filter(|_| !self.sources.get(id).is_called_scene()) {
            Some(error) => self.keep(id, File::default(), vec![foreign(self.sources, id, error, place)]),
            None => self.keep(id, tree, reports),
        }
    }

    /// Reads the files that one file refers to.
    fn follow(&mut self, from: FileIndex) {
        let id = self.library.files[from].id;
        let mut links = Vec::new();
        collect_links(&self.library.files[from].tree.statements, &mut links);
        for link in links {
            let key = (id, link.path.node.clone());
            if !self.library.links.contains_key(&key)
                && let Some(file) = self.file(id, &link)
            {
                self.library.links.insert(key, file);
            }
        }
    }

    /// The file that a statement names, read if it was not yet.
    fn file(&mut self, from: FileId, link: &Link) -> Option<FileIndex> {
        let path = &link.path;
        if is_font(&path.node) {
            let message = "fonts are not read, because `text` is not supported yet";
            self.diagnostics.push(Diagnostic::warning(path.span, message));
            return None;
        }
        let Some(name) = self.world.find(&self.sources.get(from).name, &path.node) else {
            return self.missing(link.missing());
        };
        if let Some(known) = self.numbers.get(&name) {
            return Some(*known);
        }
        if self.library.files.len() >= self.limits.statements {
            return self.missing(Diagnostic::error(path.span, "the scene consists of too many files"));
        }
        match self.world.read(&name) {
            Ok(bytes) => {
                let number = self.library.files.len();
                let (id, warning) = self.sources.add_bytes(name.clone(), &bytes);
                self.diagnostics.extend(warning);
                self.numbers.insert(name, number);
                self.parse_named(id, path.span);
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

fn parse_source(sources: &Sources, id: FileId) -> (File, Vec<Diagnostic>) {
    let source = sources.get(id);
    parse(id, &source.text, Dialect::of_file(&source.name))
}

/// The only error of a file that neither has a scene's name nor parses as one. It does not quote the file's text.
fn foreign(sources: &Sources, id: FileId, error: &Diagnostic, place: Span) -> Diagnostic {
    let file = sources.get(id);
    let line = error.span.map_or(1, |span| file.line_column(span.start).0);
    Diagnostic::error(place, format!("`{}` is not a scene: line {line} can't be understood", file.name))
        .with_hint("messages say more of files that are called .scad or .csg")
}

/// Whether a path is that of a font, which OpenSCAD lets a scene `use` like a library.
fn is_font(path: &str) -> bool {
    let extension = path.rsplit_once('.').map(|(_, extension)| extension.to_ascii_lowercase());
    extension.is_some_and(|extension| matches!(&*extension, "ttf" | "otf"))
}

/// An `include` or `use` statement.
struct Link {
    path: Spanned<Name>,
    is_include: bool,
}

impl Link {
    /// That there is no such file. What it would define is missed where it is used; but what it would draw is not, if
    /// it is included.
    fn missing(&self) -> Diagnostic {
        let message = format!("can't find `{}`", self.path.node);
        let diagnostic = if self.is_include {
            Diagnostic::error(self.path.span, message)
        } else {
            Diagnostic::warning(self.path.span, message).with_label("nothing is used from there")
        };
        diagnostic.with_hint("paths are relative to the file they stand in, or to a library folder")
    }
}

/// All `include` and `use` statements, wherever they stand.
fn collect_links(statements: &[Statement], links: &mut Vec<Link>) {
    for statement in statements {
        match statement {
            Statement::Include(path) => links.push(Link { path: path.clone(), is_include: true }),
            Statement::Use(path) => links.push(Link { path: path.clone(), is_include: false }),
            Statement::Block(block) => collect_links(block, links),
            Statement::Module(module) => collect_links(&module.body, links),
            Statement::Instance(instance) => {
                collect_links(&instance.children, links);
                collect_links(&instance.otherwise, links);
            }
            Statement::Assignment(_) | Statement::Function(_) => {}
        }
    }
}
