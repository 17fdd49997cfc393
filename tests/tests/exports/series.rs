//! What scenes repeat is written once.

use chiaro_compiler::export::{Language, Target};

use crate::support::Example;
use crate::{AT_EDGES, colors, differences};

/// A part of several shapes.
const PART: &str = "
module part(h = 8, tint = \"red\") {
    difference() {
        cylinder(h = h, r = 3);
        translate([0, 0, 2]) cylinder(h = h, r = 2);
        rotate([90, 0, 20]) cylinder(h = 9, r = 1, center = true);
    }
    color(tint) translate([1.5, 0, h]) sphere(1.2);
}
";

/// Scenes of parts that differ in many ways.
const SCENES: [(&str, &str); 10] = [
    ("moved", "for (i = [0 : 7]) translate([i * 9, i * i, 0]) part();"),
    ("turned", "for (i = [0 : 7]) rotate(i * 45) translate([20, 0, 0]) rotate([10, 0, 0]) part();"),
    ("mirrored", "for (i = [0 : 5]) translate([i * 9, 0, 0]) mirror([i % 2, 0, 0]) rotate(30) part();"),
    ("scaled", "for (i = [1 : 5]) translate([i * i * 5, 0, 0]) scale(i / 3) part();"),
    ("sized", "for (i = [1 : 6]) translate([i * 9, 0, 0]) part(h = 5 + i);"),
    ("tinted", "for (i = [1 : 6]) translate([i * 9, 0, 0]) part(tint = [i / 6, 1 - i / 6, 0.3]);"),
    ("cut", "difference() { cube([90, 20, 6]); for (i = [0 : 8]) translate([5 + i * 9, 10, 2]) part(); }"),
    (
        "turning",
        "speed = 1; // [0:0.1:2]\nrotate($t * 360 * speed) for (i = [0 : 5]) rotate(i * 60) translate([20, 0, 0]) part();",
    ),
    (
        "plane",
        "linear_extrude(9, twist = 40) for (i = [0 : 6]) rotate(i * 50) translate([9, 0]) difference() { circle(4); translate([1, 1]) square(2); }",
    ),
    (
        "nested",
        "module row() for (i = [0 : 4]) translate([i * 9, 0, 0]) part();\nfor (j = [0 : 4]) color([j / 4, 0.5, 0.5]) translate([0, j * 12, 0]) rotate(j) row();",
    ),
];

#[test]
fn repeated_parts_are_where_they_were() {
    for (name, text) in SCENES {
        let example = Example::of(&format!("{name}.csg"), &format!("{PART}{text}"));
        let (differences, allowed) = differences(&example, 2_000);
        assert!(differences.iter().all(|difference| *difference <= allowed), "{name}: {differences:?} of {allowed}");
        let (found, expected) = colors(&example, 2_000);
        let differ = found.iter().zip(&expected).filter(|(a, b)| (**a - **b).abs() > 0.02).count();
        assert!(differ as f64 <= AT_EDGES * found.len() as f64, "{name}: {differ}");
    }
}

#[test]
fn repeated_parts_are_written_once() {
    for (name, text) in SCENES {
        let library =
            Example::of(&format!("{name}.csg"), &format!("{PART}{text}")).text(Target::Library(Language::Wgsl));
        let shape = if name == "plane" { "sd_circle" } else { "sd_cylinder" };
        let calls = library.matches(&format!("= {shape}(")).count();
        // A part has three cylinders, and the material of its surface asks them once more.
        assert!((1..=6).contains(&calls), "{name}: {calls} calls of {shape}\n{library}");
    }
}

#[test]
fn one_more_of_a_series_is_one_more_line() {
    let size = |count: usize| {
        let text = format!("{PART} for (i = [1 : {count}]) translate([i * 9, i * i, 0]) part();");
        Example::of("row.csg", &text).text(Target::Library(Language::Wgsl)).len()
    };
    let (ten, twenty) = (size(10), size(20));
    assert!(twenty - ten < 10 * 220, "{} bytes each", (twenty - ten) / 10);
}
