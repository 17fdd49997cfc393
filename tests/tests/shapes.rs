//! `docs/shapes.md`, the manual of the shapes that OpenSCAD does not have, is what the vocabulary's table says.

use std::fmt::Write;
use std::fs;

use chiaro_compiler::vocabulary::{Kind, Parameter, Row, Type, Unit, rows};
use chiaro_compiler::{Options, compile};
use chiaro_tests::{MemoryWorld, blessing, workspace};

#[test]
fn the_manual_is_what_the_table_says() {
    let path = workspace().join("docs/shapes.md");
    let manual = manual();
    if blessing() {
        fs::write(&path, &manual).unwrap();
    }
    let written = fs::read_to_string(&path).unwrap_or_default();
    assert!(written == manual, "docs/shapes.md is stale: CHIARO_BLESS=1 cargo test -p chiaro_tests --test shapes");
}

#[test]
fn every_example_of_the_manual_compiles_without_a_word() {
    for row in modules(Kind::Solid).chain(modules(Kind::Plane)) {
        let world = MemoryWorld::of("example.csg", row.example);
        let compilation = compile(&world, "example.csg", &Options::default());
        let messages: Vec<&str> = compilation.diagnostics.iter().map(|report| report.message.as_str()).collect();
        assert!(compilation.scene.is_some() && messages.is_empty(), "{}: {messages:?}", row.name);
        assert!(!compilation.scene.unwrap().graph.facts.is_empty(), "{}: nothing is there", row.name);
    }
}

fn manual() -> String {
    let mut text = String::from(
        "# Shapes\n\n\
         The shapes that OpenSCAD does not have. This page is written by a test from the table in `compiler/vocabulary`.\n\n\
         Lengths are in millimetres and angles in degrees, anticlockwise. Arguments may be given by name or in this\n\
         order. What is missing has its default; a size that is not positive leaves nothing.\n",
    );
    text.push_str("\n## Solids\n");
    modules(Kind::Solid).for_each(|row| describe(row, &mut text));
    text.push_str("\n## Plane shapes\n");
    modules(Kind::Plane).for_each(|row| describe(row, &mut text));
    text
}

fn modules(kind: Kind) -> impl Iterator<Item = &'static Row> {
    rows().iter().copied().filter(move |row| row.module && row.kind == kind)
}

fn describe(row: &Row, text: &mut String) {
    let _ = write!(text, "\n### {}\n\n{}\n\n", row.name, row.manual);
    text.push_str("| parameter | default | |\n|---|---|---|\n");
    for parameter in row.parameters {
        let default = default(parameter);
        let _ = writeln!(text, "| `{}` {} | {default} | {} |", parameter.name, unit(parameter), parameter.manual);
    }
    let _ = write!(text, "\n```openscad\n{}\n```\n", row.example);
}

/// What a parameter takes: its unit, and how many numbers.
fn unit(parameter: &Parameter) -> String {
    let unit = match parameter.unit {
        Unit::Size => "size",
        Unit::Length => "length",
        Unit::Angle => "angle",
        Unit::Direction => "direction",
        Unit::Number => "number",
    };
    match parameter.ty {
        Type::Float => format!("({unit})"),
        Type::Vec2 => format!("({unit}, or a list of 2)"),
        Type::Vec3 if parameter.unit == Unit::Direction => "(direction, a list of 3)".to_owned(),
        Type::Vec3 => format!("({unit}, or a list of 3)"),
    }
}

fn default(parameter: &Parameter) -> String {
    parameter.default.map_or("needed".to_owned(), |default| default.to_string())
}
