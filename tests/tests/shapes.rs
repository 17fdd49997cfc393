//! `docs/shapes.md`, the manual of the shapes that OpenSCAD does not have, is what the vocabulary's table says.

use std::fmt::Write;
use std::fs;

use chiaro_compiler::field::Evaluator;
use chiaro_compiler::solid::Dimension;
use chiaro_compiler::vocabulary::{Kind, Parameter, Row, Type, Unit, rows};
use chiaro_compiler::{Options, compile};
use chiaro_tests::sampling::{Random, sample_box};
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
    let mut shapes = 0;
    for row in modules(Kind::Solid).chain(modules(Kind::Plane)) {
        let world = MemoryWorld::of("example.csg", row.example);
        let compilation = compile(&world, "example.csg", &Options::default());
        let messages: Vec<&str> = compilation.diagnostics.iter().map(|report| report.message.as_str()).collect();
        let scene = compilation.scene.unwrap_or_else(|| panic!("{}: {messages:?}", row.name));
        assert!(messages.is_empty(), "{}: {messages:?}", row.name);
        let evaluator = Evaluator::new(&scene.graph, &scene.defaults());
        let bounds = evaluator.bounds();
        let is_finite = |axis| bounds.axis(axis).magnitude().is_finite();
        assert!(!bounds.is_empty() && is_finite(0) && is_finite(1), "{}: {bounds:?}", row.name);
        assert_eq!(is_finite(2), scene.dimension() == Some(Dimension::Space), "{}: {bounds:?}", row.name);
        // There is an inside and an outside.
        let mut random = Random::new(1);
        let around = sample_box(&bounds);
        let inside = (0..2_000).filter(|_| evaluator.distance(random.point(&around)) < 0.0).count();
        assert!((10..=1_900).contains(&inside), "{}: {inside} of 2000 points are inside", row.name);
        shapes += 1;
    }
    assert!(shapes >= 21, "{shapes}");
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
