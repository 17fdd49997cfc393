//! Who defines what, and who means whom: the names of a text, by the language's own rules of scope.

use std::ops::Range;

use chiaro_syntax::tree::{File, Name};
use chiaro_syntax::{Dialect, FileId, parse};
use rustc_hash::FxHashMap;

mod walk;

/// What kind of thing a definition makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum What {
    Module,
    Function,
    Variable,
    Parameter,
}

impl What {
    /// Where its name is looked up.
    pub(crate) fn namespace(self) -> Namespace {
        match self {
            What::Module => Namespace::Module,
            What::Function => Namespace::Function,
            What::Variable | What::Parameter => Namespace::Variable,
        }
    }
}

/// Where a name is looked up: modules, functions and variables have separate ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Namespace {
    Module,
    Function,
    Variable,
}

/// Something that the text defines.
#[derive(Clone, Debug)]
pub(crate) struct Definition {
    pub(crate) name: Name,
    pub(crate) what: What,
    /// Where the name stands.
    pub(crate) name_range: Range<usize>,
    /// The whole definition.
    pub(crate) span: Range<usize>,
    /// Where its value, or its value for want of an argument, stands.
    pub(crate) value: Option<Range<usize>>,
    /// The definitions of its parameters.
    pub(crate) parameters: Vec<usize>,
    /// Whether it stands at the top level, from where other files can use it.
    pub(crate) is_global: bool,
}

/// What a name in the text is there for.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Role {
    /// It names something by itself.
    Of(Namespace),
    /// It names a parameter of a module or function that is called.
    Argument { callee: Name, of: Namespace },
}

/// A name in the text.
#[derive(Clone, Debug)]
pub(crate) struct Occurrence {
    pub(crate) range: Range<usize>,
    pub(crate) name: Name,
    pub(crate) role: Role,
    /// The definition it means, if that is the text's own. A definition's name means itself.
    pub(crate) definition: Option<usize>,
}

/// A part of the text in which names have one meaning.
struct Scope {
    range: Range<usize>,
    parent: Option<usize>,
    names: FxHashMap<(Namespace, Name), usize>,
}

/// A `use` or `include` statement.
#[derive(Clone, Debug)]
pub(crate) struct Link {
    pub(crate) path: Name,
    /// The whole statement.
    pub(crate) range: Range<usize>,
    /// Whether variables come along, as they do by `include` only.
    pub(crate) is_include: bool,
}

/// The names of one text.
pub(crate) struct Index {
    pub(crate) definitions: Vec<Definition>,
    /// In the order of the text.
    pub(crate) occurrences: Vec<Occurrence>,
    pub(crate) links: Vec<Link>,
    scopes: Vec<Scope>,
}

impl Index {
    /// The names of a text.
    pub(crate) fn of(text: &str) -> Self {
        let (file, _) = parse(FileId(0), text, Dialect::Dump);
        Self::of_tree(text, &file)
    }

    /// The names of a text that has been parsed.
    pub(crate) fn of_tree(text: &str, file: &File) -> Self {
        let mut index = walk::walk(text, file);
        index.occurrences.sort_by_key(|occurrence| occurrence.range.start);
        index
    }

    /// The name at an offset: the one around it, or the one that ends there.
    pub(crate) fn at(&self, offset: usize) -> Option<&Occurrence> {
        let behind = self.occurrences.partition_point(|occurrence| occurrence.range.start <= offset);
        let last = self.occurrences[..behind].last()?;
        (offset <= last.range.end).then_some(last)
    }

    /// What can be seen at an offset, the innermost definitions first, each name once for each kind of thing.
    pub(crate) fn visible(&self, offset: usize) -> Vec<usize> {
        let around = self
            .scopes
            .iter()
            .enumerate()
            .filter(|(_, scope)| scope.range.start <= offset && offset <= scope.range.end);
        let mut next = around.min_by_key(|(id, scope)| (scope.range.len(), usize::MAX - id)).map(|(id, _)| id);
        let mut seen = FxHashMap::default();
        let mut found = Vec::new();
        while let Some(scope) = next {
            let scope = &self.scopes[scope];
            let mut own: Vec<_> =
                scope.names.iter().filter(|(key, id)| seen.insert((*key).clone(), **id).is_none()).collect();
            own.sort_by_key(|(_, id)| **id);
            found.extend(own.into_iter().map(|(_, id)| *id));
            next = scope.parent;
        }
        found
    }

    /// The definition that a name has from within a scope.
    fn lookup(&self, scope: usize, namespace: Namespace, name: &Name) -> Option<usize> {
        let mut next = Some(scope);
        while let Some(scope) = next {
            let names = &self.scopes[scope].names;
            let found = names.get(&(namespace, name.clone())).or_else(|| match namespace {
                // A variable may hold a function.
                Namespace::Function => names.get(&(Namespace::Variable, name.clone())),
                _ => None,
            });
            if found.is_some() {
                return found.copied();
            }
            next = self.scopes[scope].parent;
        }
        // What follows the calls may be set anywhere.
        let is_special = name.starts_with('$');
        is_special.then(|| self.definitions.iter().position(|definition| definition.name == *name)).flatten()
    }
}
