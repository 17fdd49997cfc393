//! From a name to where it is defined, and to where it is used.

use std::ops::Range;

use chiaro_eval::World;
use chiaro_syntax::{TokenKind, decode};
use rustc_hash::FxHashSet;

use crate::edit::Edit;
use crate::index::{Index, Namespace, Occurrence, Role};
use crate::tokens;

/// The most other files that are looked through.
const MOST_FILES: usize = 500;

/// A place in some file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The file's full name.
    pub file: String,
    /// The bytes.
    pub range: Range<usize>,
}

/// Where the name at an offset is defined, if that is in this text.
pub fn definition(text: &str, offset: usize) -> Option<Range<usize>> {
    let index = Index::of(text);
    let definition = index.at(offset)?.definition?;
    Some(index.definitions[definition].name_range.clone())
}

/// Where the name at an offset is defined: in this text, which is that of the file `name`, or in a file that it uses or
/// includes. The path of a `use` or `include` leads to the beginning of that file.
pub fn definition_in(world: &dyn World, name: &str, text: &str, offset: usize) -> Option<Place> {
    let index = Index::of(text);
    if let Some(link) = index.links.iter().find(|link| link.range.contains(&offset)) {
        return world.find(name, &link.path).map(|file| Place { file, range: 0..0 });
    }
    let occurrence = index.at(offset)?;
    if let Some(definition) = occurrence.definition {
        let range = index.definitions[definition].name_range.clone();
        return Some(Place { file: name.to_owned(), range });
    }
    linked(world, name, &index).into_iter().find_map(|file| {
        let range = global(&file.index, occurrence, file.with_variables)?;
        Some(Place { file: file.name, range })
    })
}

/// Every place where the thing is named that is named at an offset, its definition included. Of names that are not defined
/// in this text: all that stand for the same kind of thing.
pub fn references(text: &str, offset: usize) -> Vec<Range<usize>> {
    let index = Index::of(text);
    let Some(meant) = index.at(offset) else { return Vec::new() };
    let is_same = |other: &&Occurrence| match meant.definition {
        Some(_) => other.definition == meant.definition,
        None => other.definition.is_none() && other.name == meant.name && other.role == meant.role,
    };
    let mut found: Vec<_> = index.occurrences.iter().filter(is_same).map(|other| other.range.clone()).collect();
    found.dedup();
    found
}

/// The edits that give the thing at an offset another name, everywhere in this text. None, if it is not this text's own, if
/// that is no name, or if something else is called that there.
pub fn rename(text: &str, offset: usize, name: &str) -> Option<Vec<Edit>> {
    let index = Index::of(text);
    let meant = index.at(offset)?.definition?;
    let namespace = index.definitions[meant].what.namespace();
    let is_name =
        matches!(tokens(name)[..], [token] if token.kind == TokenKind::Name && token.range() == (0..name.len()));
    let is_taken = index
        .occurrences
        .iter()
        .any(|other| *other.name == *name && other.definition != Some(meant) && other.role == Role::Of(namespace));
    if !is_name || is_taken {
        return None;
    }
    let edit = |range| Edit { range, text: name.to_owned() };
    Some(references(text, offset).into_iter().map(edit).collect())
}

/// Another file, that what is being written can use.
pub(crate) struct Linked {
    pub(crate) name: String,
    pub(crate) text: String,
    pub(crate) index: Index,
    /// Whether its variables can be used too.
    pub(crate) with_variables: bool,
}

/// The files that a file uses or includes, those of the last statements first, since they count. What they include is
/// theirs; what they use is not handed on.
pub(crate) fn linked(world: &dyn World, name: &str, index: &Index) -> Vec<Linked> {
    let mut seen = FxHashSet::default();
    seen.insert(name.to_owned());
    let mut found: Vec<Linked> = Vec::new();
    let links = |from: &str, index: &Index| -> Vec<_> {
        index.links.iter().rev().map(|link| (from.to_owned(), link.path.clone(), link.is_include)).collect()
    };
    let mut waiting = links(name, index);
    waiting.reverse();
    while let Some((from, path, is_include)) = waiting.pop() {
        let Some(name) = world.find(&from, &path) else { continue };
        if found.len() >= MOST_FILES || !seen.insert(name.clone()) {
            continue;
        }
        let Ok(bytes) = world.read(&name) else { continue };
        let (text, _) = decode(&bytes);
        let index = Index::of(&text);
        let included = links(&name, &index).into_iter().filter(|(_, _, is_include)| *is_include).rev();
        waiting.extend(included.map(|(from, path, _)| (from, path, is_include)));
        found.push(Linked { name, text, index, with_variables: is_include });
    }
    found
}

/// Where a file defines, at its top level, what a name means.
fn global(index: &Index, occurrence: &Occurrence, with_variables: bool) -> Option<Range<usize>> {
    let (wanted, namespace) = match &occurrence.role {
        Role::Of(namespace) => (&occurrence.name, *namespace),
        Role::Argument { callee, of } => (callee, *of),
    };
    let is_meant = |namespace: Namespace| {
        index.definitions.iter().find(|definition| {
            definition.is_global && definition.name == *wanted && definition.what.namespace() == namespace
        })
    };
    let found = match namespace {
        Namespace::Variable if !with_variables => None,
        Namespace::Function => is_meant(namespace).or_else(|| is_meant(Namespace::Variable).filter(|_| with_variables)),
        namespace => is_meant(namespace),
    }?;
    match &occurrence.role {
        Role::Of(_) => Some(found.name_range.clone()),
        Role::Argument { .. } => {
            let parameters = found.parameters.iter().map(|id| &index.definitions[*id]);
            let mut meant = parameters.filter(|parameter| parameter.name == occurrence.name);
            meant.next().map(|parameter| parameter.name_range.clone())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::edit::apply;
    use crate::testing::{Files, caret};

    /// The place that the name at `|` is defined at, with a `^` in the text.
    fn defined(text: &str) -> Option<usize> {
        let (text, offset) = caret(text);
        definition(&text, offset).map(|range| range.start)
    }

    #[test]
    fn names_lead_to_their_definitions() {
        assert_eq!(defined("wi|dth = 2; cube(width);"), Some(0));
        assert_eq!(defined("width = 2; cube(wid|th);"), Some(0));
        assert_eq!(defined("module m(a) cube(a|); m(1);"), Some(9));
        assert_eq!(defined("module m(a) cube(a); m|(1);"), Some(7));
        assert_eq!(defined("module m(a) cube(a); m(a| = 1);"), Some(9));
        assert_eq!(defined("function f(x) = x| * 2; y = f(2);"), Some(11));
        assert_eq!(defined("function f(x) = x * 2; y = f|(2);"), Some(9));
        assert_eq!(defined("a = (a|);"), Some(0));
        assert_eq!(defined("cu|be(1);"), None);
    }

    #[test]
    fn the_innermost_definition_is_meant() {
        let text = "a = 1; module m(a = 2) { translate([a|, 0, 0]) cube(1); }";
        assert_eq!(defined(text), Some(16));
        assert_eq!(defined("a = 1; translate([0, 0, 0]) { a = 3; cube(a|); }"), Some(30));
        assert_eq!(defined("a = 1; translate([a|, 0, 0]) { a = 3; cube(a); }"), Some(0));
        assert_eq!(defined("i = 1; for (i = [0 : i|]) cube(i);"), Some(0));
        assert_eq!(defined("i = 1; for (i = [0 : i]) cube(i|);"), Some(12));
        assert_eq!(defined("x = let (a = 1, b = a|) b;"), Some(9));
        assert_eq!(defined("x = [for (a = [1]) let (b = a) b|];"), Some(24));
        assert_eq!(defined("f = function (x) x|; y = f(1);"), Some(14));
        assert_eq!(defined("f = function (x) x; y = f|(1);"), Some(0));
    }

    #[test]
    fn names_of_modules_functions_and_variables_are_separate() {
        let text = "m = 1; module m() cube(m); function m() = 2; m(); x = m|();";
        assert_eq!(defined(text), Some(36));
        assert_eq!(defined("m = 1; module m() cube(m|); m();"), Some(0));
    }

    #[test]
    fn references_are_all_mentions_of_the_same_thing() {
        let (text, offset) = caret("r = 1; module m(r) sphere(r = r); m(r = r|); sphere(r);");
        let starts: Vec<_> = references(&text, offset).into_iter().map(|range| range.start).collect();
        assert_eq!(starts, [0, 40, 51]);
        let (text, offset) = caret("r = 1; module m(r|) sphere(r = r); m(r = r); sphere(r);");
        let starts: Vec<_> = references(&text, offset).into_iter().map(|range| range.start).collect();
        assert_eq!(starts, [16, 30, 36]);
    }

    #[test]
    fn renaming_changes_every_mention() {
        let renamed = |text: &str, name: &str| {
            let (text, offset) = caret(text);
            rename(&text, offset, name).map(|edits| apply(&text, &edits))
        };
        let text = "module m(r|) sphere(r = r); r = 1; m(r = r);";
        assert_eq!(renamed(text, "size").as_deref(), Some("module m(size) sphere(r = size); r = 1; m(size = r);"));
        for name in ["", "2 x", "module", "a b", "1"] {
            assert_eq!(renamed(text, name), None, "{name}");
        }
        assert_eq!(renamed("a| = 1; b = a; c = b;", "b"), None);
        assert_eq!(renamed("cu|be(1);", "b"), None);
    }

    #[test]
    fn other_files_define_things_too() {
        let files = Files::new(&[
            ("parts.scad", "include <more.scad>\nmodule part(size) cube(size); n = 3;"),
            ("more.scad", "function twice(x) = 2 * x;"),
        ]);
        let found = |text: &str| {
            let (text, offset) = caret(text);
            definition_in(&files, "main.scad", &text, offset).map(|place| (place.file, place.range.start))
        };
        let place = |file: &str, start: usize| Some((file.to_owned(), start));
        assert_eq!(found("use <parts.scad>\npa|rt(2);"), place("parts.scad", 27));
        assert_eq!(found("use <parts.scad>\npart(size| = 2);"), place("parts.scad", 32));
        assert_eq!(found("use <parts.scad>\nx = twice|(2);"), place("more.scad", 9));
        assert_eq!(found("use <parts.scad>\nx = n|;"), None);
        assert_eq!(found("include <parts.scad>\nx = n|;"), place("parts.scad", 50));
        assert_eq!(found("x = 1; y = x|;"), place("main.scad", 0));
        assert_eq!(found("use <par|ts.scad>"), place("parts.scad", 0));
        assert_eq!(found("use <no|ne.scad>"), None);
    }
}
