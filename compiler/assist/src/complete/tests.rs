use super::*;
use crate::testing::{Files, caret};

fn at(text: &str) -> Completions {
    let (text, offset) = caret(text);
    complete(&text, offset)
}

fn labels(text: &str) -> Vec<String> {
    at(text).items.into_iter().map(|item| item.label).collect()
}

/// The first labels.
fn first(text: &str, count: usize) -> Vec<String> {
    labels(text).into_iter().take(count).collect()
}

#[test]
fn what_begins_like_the_word_comes_first() {
    assert_eq!(first("cyl|", 1), ["cylinder"]);
    assert_eq!(first("sph|ere(1);", 2), ["sphere", "sphere_light"]);
    assert_eq!(first("ltr|", 1), ["linear_extrude"]);
    assert_eq!(first("x = sq|;", 1), ["sqrt"]);
    assert!(labels("light|").contains(&"rect_light".to_owned()));
    assert!(labels("ctrx|").is_empty());
    assert_eq!(first("tl|", 2), ["translate", "tube_light"]);
}

#[test]
fn statements_take_modules_and_values_take_functions() {
    let statement = labels("|");
    assert!(statement.contains(&"cube".to_owned()) && statement.contains(&"module".to_owned()));
    assert!(!statement.contains(&"sin".to_owned()) && !statement.contains(&"text".to_owned()));
    let value = labels("a = |;");
    assert!(value.contains(&"sin".to_owned()) && value.contains(&"$t".to_owned()));
    assert!(!value.contains(&"cube".to_owned()));
    let child = labels("translate([1, 0, 0]) |");
    assert!(child.contains(&"cube".to_owned()) && !child.contains(&"module".to_owned()));
}

#[test]
fn parameters_of_the_call_come_first() {
    assert_eq!(first("cylinder(|", 9), ["center", "d", "d1", "d2", "edge", "h", "r", "r1", "r2"]);
    assert_eq!(first("cylinder(h = 2, r|);", 3), ["r", "r1", "r2"]);
    assert!(!first("cylinder(|, h = 2);", 9).contains(&"h".to_owned()));
    assert_eq!(at("cylinder(h|);").items[0].insert, "h = ");
    assert_eq!(first("module wall(l, h = 2) cube(h); wall(|", 2), ["h", "l"]);
    let inside = labels("cylinder(h = |");
    assert!(!inside.contains(&"r1".to_owned()));
}

#[test]
fn names_in_scope_are_offered() {
    let text = "width = 2; module m(size) { inner = 3; cube(s|); } module n(other) cube(1);";
    let found = labels(text);
    assert!(found.contains(&"size".to_owned()) && !found.contains(&"other".to_owned()));
    let found = labels("width = 2; module m(size) { inner = 3; cube([|");
    assert_eq!(&found[..3], ["inner", "size", "width"]);
}

#[test]
fn calls_get_their_parentheses() {
    let item = |text: &str| at(text).items.into_iter().next().expect("an item");
    assert_eq!((&*item("cub|").insert, item("cub|").caret), ("cube()", 5));
    assert_eq!((&*item("unio|").insert, item("unio|").caret), ("union()", 7));
    assert_eq!((&*item("cub|(1);").insert, item("cub|(1);").caret), ("cube", 4));
    assert_eq!(at("cub|x").replaces, 0..4);
}

#[test]
fn texts_offer_what_their_parameter_takes() {
    assert_eq!(first("color(\"tom|\") cube(1);", 1), ["tomato"]);
    assert_eq!(at("color(\"tom|ato\") cube(1);").replaces, 7..13);
    assert_eq!(first("color(c = \"tom|", 1), ["tomato"]);
    assert_eq!(first("union(joint = \"|\");", 3), ["chamfer", "fillet", "smooth"]);
    assert_eq!(first("sphere_light(shadows = \"prox|\");", 1), ["proxy"]);
    assert_eq!(labels("echo(\"tom|\");"), [] as [&str; 0]);
}

#[test]
fn paths_are_the_callers() {
    let found = at("use <li|b.scad>");
    assert_eq!((found.path.as_deref(), found.replaces), (Some("li"), 5..13));
    assert_eq!(at("include <li|").path.as_deref(), Some("li"));
}

#[test]
fn comments_numbers_and_names_being_given_have_none() {
    for text in ["// cu|", "/* cu| */", "x = 12|;", "module cu|", "a = 1; /* cu|"] {
        assert_eq!(labels(text), [] as [&str; 0], "{text}");
    }
    assert_eq!(labels("v.|"), ["x", "y", "z"]);
}

#[test]
fn other_files_have_names_too() {
    let files = Files::new(&[("parts.scad", "// A part.\nmodule part(size) cube(size); total = 3;")]);
    let (text, offset) = caret("use <parts.scad>\npar|");
    let item = complete_in(&files, "main.scad", &text, offset).items.remove(0);
    assert_eq!((&*item.label, &*item.detail, &*item.documentation), ("part", "module part(size)", "A part."));
    let (text, offset) = caret("use <parts.scad>\nx = tot|");
    assert!(complete_in(&files, "main.scad", &text, offset).items.is_empty());
}
