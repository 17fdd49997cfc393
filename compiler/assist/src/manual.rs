//! The manual: what every name of the language is, in a line or two.
//!
//! Shapes that are rows of the vocabulary's table are described there, and only there. Everything else is described here,
//! once; a test holds this against the names that the evaluator knows.

use std::sync::OnceLock;

use chiaro_vocabulary::{Kind, Row, Type, Unit, rows};
use rustc_hash::FxHashMap;

#[cfg(test)]
mod defaults;
mod functions;
mod lights;
mod modules;
mod words;

/// What the manual says of one name.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// The name.
    pub name: &'static str,
    /// What it takes.
    pub parameters: Vec<Parameter>,
    /// What it is, in a sentence.
    pub manual: &'static str,
    /// A scene, or a part of one, that shows it; may be empty.
    pub example: &'static str,
    /// Whether it works. What OpenSCAD has and this does not is described all the same.
    pub is_supported: bool,
    /// Whether it works on what stands behind it, as `translate` does.
    pub takes_children: bool,
}

/// A parameter of a module or function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// Its name.
    pub name: &'static str,
    /// The unit of its numbers; empty for plain numbers and what is no number.
    pub unit: &'static str,
    /// Its value where none is given, as text of the program; empty if there is none.
    pub default: Default,
    /// What it is, in a few words.
    pub manual: &'static str,
    /// Whether an argument without a name can be for it.
    pub positional: bool,
}

/// What a parameter is where it isn't given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Default {
    /// It must be given.
    Needed,
    /// It may be left out, and then has no value of its own.
    Nothing,
    /// This text of the program.
    Text(&'static str),
    /// This number.
    Number(f64),
}

impl Entry {
    /// The name and the parameters on one line: `sphere(r = 1, d)`.
    pub fn signature(&self) -> String {
        let parameters: Vec<_> = self.parameters.iter().map(Parameter::signature).collect();
        format!("{}({})", self.name, parameters.join(", "))
    }

    /// The parameter of that name.
    pub fn parameter(&self, name: &str) -> Option<&Parameter> {
        self.parameters.iter().find(|parameter| parameter.name == name)
    }
}

impl Parameter {
    /// The name with the default.
    pub fn signature(&self) -> String {
        match self.default {
            Default::Needed | Default::Nothing => self.name.to_owned(),
            Default::Text(text) => format!("{} = {text}", self.name),
            Default::Number(number) => format!("{} = {number}", self.name),
        }
    }

    /// What it is, with its unit.
    pub fn description(&self) -> String {
        if self.unit.is_empty() { self.manual.to_owned() } else { format!("{} ({})", self.manual, self.unit) }
    }
}

/// The module of that name, if the language has one.
pub fn module(name: &str) -> Option<&'static Entry> {
    all().modules.get(name)
}

/// The function of that name, if the language has one.
pub fn function(name: &str) -> Option<&'static Entry> {
    all().functions.get(name)
}

/// The variable or constant of that name, if the language sets one.
pub fn variable(name: &str) -> Option<&'static Entry> {
    all().variables.get(name)
}

/// The keyword, if it is one.
pub fn keyword(word: &str) -> Option<&'static Entry> {
    all().keywords.get(word)
}

/// All modules.
pub fn modules() -> impl Iterator<Item = &'static Entry> {
    all().modules.values()
}

/// All functions.
pub fn functions() -> impl Iterator<Item = &'static Entry> {
    all().functions.values()
}

/// All variables and constants.
pub fn variables() -> impl Iterator<Item = &'static Entry> {
    all().variables.values()
}

/// All keywords.
pub fn keywords() -> impl Iterator<Item = &'static Entry> {
    all().keywords.values()
}

type ByName = FxHashMap<&'static str, Entry>;

struct Manual {
    modules: ByName,
    functions: ByName,
    variables: ByName,
    keywords: ByName,
}

fn all() -> &'static Manual {
    static MANUAL: OnceLock<Manual> = OnceLock::new();
    MANUAL.get_or_init(|| {
        let by_name = |entries: Vec<Entry>| entries.into_iter().map(|entry| (entry.name, entry)).collect();
        let described = modules::MODULES.iter().chain(lights::LIGHTS).map(Described::entry);
        Manual {
            modules: by_name(described.chain(shapes()).collect()),
            functions: by_name(functions::FUNCTIONS.iter().map(Described::entry).collect()),
            variables: by_name(words::VARIABLES.iter().map(Described::entry).collect()),
            keywords: by_name(words::KEYWORDS.iter().map(Described::entry).collect()),
        }
    })
}

/// An entry as the tables here have it.
struct Described {
    name: &'static str,
    parameters: &'static [Parameter],
    manual: &'static str,
    example: &'static str,
    is_supported: bool,
    takes_children: bool,
}

impl Described {
    fn entry(&self) -> Entry {
        Entry {
            name: self.name,
            parameters: self.parameters.to_vec(),
            manual: self.manual,
            example: self.example,
            is_supported: self.is_supported,
            takes_children: self.takes_children,
        }
    }

    /// What works on its children.
    const fn with_children(self) -> Self {
        Described { takes_children: true, ..self }
    }

    /// What OpenSCAD has and this does not.
    const fn unsupported(self) -> Self {
        Described { is_supported: false, ..self }
    }
}

/// An entry without children.
const fn described(
    name: &'static str,
    parameters: &'static [Parameter],
    manual: &'static str,
    example: &'static str,
) -> Described {
    Described { name, parameters, manual, example, is_supported: true, takes_children: false }
}

/// A parameter that an argument without a name can be for.
const fn parameter(name: &'static str, unit: &'static str, default: &'static str, manual: &'static str) -> Parameter {
    let default = match default.as_bytes() {
        [] => Default::Nothing,
        [b'!'] => Default::Needed,
        _ => Default::Text(default),
    };
    Parameter { name, unit, default, manual, positional: true }
}

/// A parameter that has to be named.
const fn named(name: &'static str, unit: &'static str, default: &'static str, manual: &'static str) -> Parameter {
    Parameter { positional: false, ..parameter(name, unit, default, manual) }
}

/// The entries of the vocabulary's own shapes.
fn shapes() -> impl Iterator<Item = Entry> {
    let shapes = rows().iter().filter(|row| row.module && matches!(row.kind, Kind::Solid | Kind::Plane));
    shapes.map(|row| shape(row))
}

fn shape(row: &Row) -> Entry {
    let parameters = row.parameters.iter().map(|parameter| Parameter {
        name: parameter.name,
        unit: match parameter.unit {
            Unit::Size | Unit::Length => "mm",
            Unit::Angle => "°",
            Unit::Direction | Unit::Number => "",
        },
        default: match (parameter.default, parameter.ty) {
            (None, _) => Default::Needed,
            (Some(number), Type::Float | Type::Vec2 | Type::Vec3) => Default::Number(number),
        },
        manual: parameter.manual,
        positional: true,
    });
    Entry {
        name: row.name,
        parameters: parameters.collect(),
        manual: row.manual,
        example: row.example,
        is_supported: true,
        takes_children: false,
    }
}

#[cfg(test)]
mod tests {
    use chiaro_eval::{Options, evaluate, names};
    use chiaro_syntax::{Severity, SourceFile, Sources};

    use super::*;
    use crate::testing::Files;

    #[test]
    fn every_name_of_the_language_has_an_entry() {
        for name in names::modules() {
            assert!(module(name).is_some(), "the module {name} is not described");
        }
        for name in names::functions() {
            assert!(function(name).is_some(), "the function {name} is not described");
        }
        for name in names::VARIABLES {
            assert!(variable(name).is_some(), "the variable {name} is not described");
        }
    }

    #[test]
    fn every_entry_describes_a_name_of_the_language() {
        let known: Vec<_> = names::modules().collect();
        assert!(modules().all(|entry| known.contains(&entry.name)));
        let known: Vec<_> = names::functions().collect();
        assert!(functions().all(|entry| known.contains(&entry.name)));
        assert!(variables().all(|entry| names::VARIABLES.contains(&entry.name)));
    }

    #[test]
    fn parameters_are_those_of_the_evaluator() {
        // `child` is known by that name both inside modules and where it is an error.
        for entry in modules().filter(|entry| entry.name != "child") {
            let Some(parameters) = names::parameters(entry.name) else { continue };
            let are = |positional: bool| {
                let parameters = entry.parameters.iter().filter(move |parameter| parameter.positional == positional);
                parameters.map(|parameter| parameter.name).collect::<Vec<_>>()
            };
            assert_eq!(are(true), parameters.positional, "{}", entry.name);
            let sorted = |mut names: Vec<&'static str>| {
                names.sort();
                names
            };
            assert_eq!(sorted(are(false)), sorted(parameters.named), "{}", entry.name);
        }
    }

    #[test]
    fn examples_are_scenes_without_errors() {
        let is_scene = |entry: &&Entry| entry.is_supported && !entry.example.is_empty();
        for entry in modules().chain(variables()).chain(keywords()).filter(is_scene) {
            check(entry.name, entry.example);
        }
        for entry in functions().filter(is_scene) {
            check(entry.name, &format!("x = 1; module m() echo({}); m();", entry.example));
        }
    }

    #[track_caller]
    fn check(name: &str, text: &str) {
        let mut sources = Sources::default();
        let file = sources.add(SourceFile::new("example.csg", text));
        let files = Files::new(&[("parts.scad", ""), ("sizes.scad", "")]);
        let diagnostics = evaluate(&files, &mut sources, file, &Options::default()).diagnostics;
        // The example of a light need not have a solid as well.
        let is_wrong = |diagnostic: &&chiaro_syntax::Diagnostic| {
            diagnostic.severity != Severity::Note && !diagnostic.message.starts_with("there is no solid for this light")
        };
        let wrong = diagnostics.iter().find(is_wrong);
        assert!(wrong.is_none(), "the example of {name}: {wrong:?}");
    }

    #[test]
    fn every_entry_says_something() {
        for entry in modules().chain(functions()).chain(variables()).chain(keywords()) {
            assert!(entry.manual.ends_with('.'), "{}: {}", entry.name, entry.manual);
            assert!(entry.parameters.iter().all(|parameter| !parameter.manual.is_empty()), "{}", entry.name);
        }
    }
}
