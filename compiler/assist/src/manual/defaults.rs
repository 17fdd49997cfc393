//! A test of the defaults that the manual states: given explicitly, they change nothing.

use chiaro_eval::{Options, evaluate};
use chiaro_solid::{print, print_camera, print_lights};
use chiaro_syntax::{Severity, SourceFile, Sources};

use super::{Default, Entry, Parameter, functions, modules};
use crate::testing::Files;

/// What an entry needs before a parameter of its has a meaning: other parameters, and what they are.
const NEEDED: [(&str, &str); 11] = [
    ("union", "r = 1"),
    ("difference", "r = 1"),
    ("intersection", "r = 1"),
    ("polygon", "points = [[0, 0], [9, 0], [0, 9]]"),
    (
        "polyhedron",
        "points = [[0, 0, 0], [9, 0, 0], [0, 9, 0], [0, 0, 9]], \
         faces = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]",
    ),
    ("rotate", "a = 30"),
    ("color", "c = \"red\""),
    ("round", "r = 1"),
    ("twist", "rate = 3"),
    ("polygon_light", "points = [[0, 0], [9, 0], [0, 9]]"),
    ("camera", "eye = [100, 100, 100]"),
];

/// Whose children are plane shapes.
const OF_THE_PLANE: [&str; 4] = ["linear_extrude", "rotate_extrude", "offset", "fill"];

#[test]
fn stated_defaults_are_those_that_the_evaluator_uses() {
    let mut checked = 0;
    // `child` is an error outside of modules.
    let known = |entry: &&Entry| entry.name != "child" && chiaro_eval::names::parameters(entry.name).is_some();
    for entry in modules().filter(|entry| entry.is_supported).filter(known) {
        for parameter in &entry.parameters {
            let Some(default) = stated(parameter) else { continue };
            let given = format!("{} = {default}", parameter.name);
            let needed = needed(entry, parameter);
            let both = [needed.as_str(), &given].into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>();
            let (without, with) = (module_call(entry, &needed), module_call(entry, &both.join(", ")));
            assert_eq!(meaning(&without), meaning(&with), "{without} and {with}");
            checked += 1;
        }
    }
    assert!(checked > 60, "only {checked} defaults were found");
}

#[test]
fn stated_defaults_of_functions_are_those_that_the_evaluator_uses() {
    let calls = [
        ("log", "log(7)", "log(10, 7)"),
        ("search", "search(\"b\", [[\"a\"], [\"b\"], [\"b\"]])", "search(\"b\", [[\"a\"], [\"b\"], [\"b\"]], 1, 0)"),
        ("parent_module", "parent_module()", "parent_module(1)"),
    ];
    for entry in functions().filter(|entry| entry.parameters.iter().any(|parameter| stated(parameter).is_some())) {
        let known = calls.iter().find(|(name, ..)| *name == entry.name);
        let (_, without, with) = known.unwrap_or_else(|| panic!("the defaults of {} are not checked", entry.name));
        let stated: Vec<String> = entry.parameters.iter().filter_map(stated).collect();
        assert!(stated.iter().all(|default| with.contains(default.as_str())), "{with} has not all of {stated:?}");
        let program = |call: &str| format!("module outer() inner(); module inner() echo({call}); outer();");
        assert_eq!(meaning(&program(without)), meaning(&program(with)), "{without} and {with}");
    }
}

/// The default that the manual states, as text.
fn stated(parameter: &Parameter) -> Option<String> {
    match parameter.default {
        Default::Needed | Default::Nothing => None,
        Default::Text(text) => Some(text.to_owned()),
        Default::Number(number) => Some(number.to_string()),
    }
}

/// Arguments for what has to be given beside a parameter; of the vocabulary's shapes, all that have no default.
fn needed(entry: &Entry, parameter: &Parameter) -> String {
    let listed = NEEDED.iter().find(|(name, _)| *name == entry.name).map(|(_, arguments)| *arguments);
    let is_it = |argument: &str| argument.split('=').next().is_some_and(|name| name.trim() == parameter.name);
    let without_it = |arguments: &str| {
        let others: Vec<&str> = split(arguments).into_iter().filter(|argument| !is_it(argument)).collect();
        others.join(", ")
    };
    match listed {
        Some(arguments) => without_it(arguments),
        None => {
            let open = entry.parameters.iter().filter(|other| other.default == Default::Needed);
            open.map(|other| format!("{} = 5", other.name)).collect::<Vec<_>>().join(", ")
        }
    }
}

/// Arguments one by one.
fn split(arguments: &str) -> Vec<&str> {
    let (mut parts, mut depth, mut start) = (Vec::new(), 0, 0);
    for (at, character) in arguments.char_indices() {
        match character {
            '[' => depth += 1,
            ']' => depth -= 1,
            ',' if depth == 0 => {
                parts.push(arguments[start..at].trim());
                start = at + 1;
            }
            _ => {}
        }
    }
    parts.push(arguments[start..].trim());
    parts
}

fn module_call(entry: &Entry, arguments: &str) -> String {
    let children = match (entry.takes_children, OF_THE_PLANE.contains(&entry.name)) {
        (false, _) => ";",
        (true, true) => "{ translate([5, 0]) square(4); translate([7, 2]) square(4); }",
        // Of solids in each other the distance within is not known, which a wall of one thickness asks for.
        (true, false) if entry.name == "shell" => "{ cube(4); }",
        (true, false) => "{ cube(4); translate([2, 2, 2]) cube(4); }",
    };
    format!("{}({arguments}) {children}", entry.name)
}

/// All that a program comes to, as text.
#[track_caller]
fn meaning(text: &str) -> String {
    let mut sources = Sources::default();
    let file = sources.add(SourceFile::new("defaults.scad", text));
    let evaluation = evaluate(&Files::new(&[]), &mut sources, file, &Options::default());
    // A light alone has nothing to shine on.
    let is_light_alone = |message: &str| message.starts_with("there is no solid for this light");
    let wrong = (evaluation.diagnostics.iter())
        .find(|diagnostic| diagnostic.severity != Severity::Note && !is_light_alone(&diagnostic.message));
    assert!(wrong.is_none(), "{text}: {wrong:?}");
    let echoes: String = evaluation.diagnostics.iter().map(|note| format!("{}\n", note.message)).collect();
    let scene = evaluation.scene.unwrap_or_else(|| panic!("{text} is no scene"));
    [echoes, print(&scene.root), print_lights(&scene.lights), print_camera(&scene.camera)].concat()
}
