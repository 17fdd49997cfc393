//! Files: what other programs write, what is saved, and what a crash leaves.

use std::fs;

use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;

use super::person::Person;
use crate::app::Editor;

/// How far the scene in the picture reaches along x.
fn reach(editor: &Editor) -> f64 {
    let graph = &editor.session.shown.as_ref().unwrap().scene.graph;
    graph.facts[graph.root.0 as usize].bounds.max[0]
}

/// Writes a file as careful editors do.
fn replace(path: &std::path::Path, text: &str) {
    let beside = path.with_extension("new");
    fs::write(&beside, text).unwrap();
    fs::rename(&beside, path).unwrap();
}

#[test]
fn what_other_editors_save_is_drawn() {
    let mut person =
        Person::with_files(&[("main.csg", "include <size.csg>\ncube(size);\n"), ("size.csg", "size = 4;\n")]);
    person.until_drawn();
    assert_eq!(reach(person.editor()), 4.0);
    replace(&person.file("size.csg"), "size = 9;\n");
    person.until("reloaded", |editor| reach(editor) == 9.0);
    replace(&person.file("main.csg"), "include <size.csg>\ncube(size * 2);\n");
    person.until("reloaded", |editor| reach(editor) == 18.0);
    assert_eq!(person.text(), "include <size.csg>\ncube(size * 2);\n");
}

#[test]
fn changes_of_ones_own_are_not_lost_to_those_of_others() {
    let mut person = Person::with("cube(1);\n");
    person.until_drawn();
    person.goes_to("cube");
    person.types("sphere(1);");
    person.until_linked();
    replace(&person.file("main.csg"), "cube(5);\n");
    person.until("a conflict", |editor| editor.session.active().conflict.is_some());
    person.frames(2);
    assert_eq!(person.text(), "sphere(1);cube(1);\n");
    person.sees("conflict");
    person.clicks_on("Take that");
    assert_eq!(person.text(), "cube(5);\n");
    person.presses(Modifiers::COMMAND, Key::Z);
    assert_eq!(person.text(), "sphere(1);cube(1);\n");
}

#[test]
fn texts_are_saved_and_shaders_exported() {
    let mut person = Person::with("cube(1);\n");
    person.until_drawn();
    person.goes_to("cube");
    person.types("sphere(1);");
    person.presses(Modifiers::COMMAND, Key::S);
    let path = person.file("main.csg");
    person.until("saved", |editor| !editor.session.active().is_modified());
    assert_eq!(fs::read_to_string(&path).unwrap(), "sphere(1);cube(1);\n");
    person.until_linked();
    person.presses(Modifiers::COMMAND, Key::E);
    person.sees("export");
    person.harness.get_by_role_and_label(egui::Role::Button, "Export").click();
    person.frames(3);
    let shader = person.file("main.wgsl");
    person.until("exported", |_| shader.exists());
    assert!(fs::read_to_string(&shader).unwrap().contains("fn scene_distance"));
}

#[test]
fn an_empty_editor_offers_examples() {
    let mut person = Person::before(tempfile::tempdir().unwrap(), Vec::new());
    person.frames(3);
    person.sees("gallery");
    person.clicks_on("Hello fillet");
    person.until_drawn();
    assert!(person.text().contains("union"));
}

#[test]
fn what_a_crash_leaves_is_found_again() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("data/unsaved");
    fs::create_dir_all(&data).unwrap();
    // No process has this number.
    fs::write(data.join("4194999.json"), r#"[{"path":null,"text":"sphere(3);\n"}]"#).unwrap();
    let mut person = Person::before(folder, Vec::new());
    person.frames(2);
    person.harness.get_by_label("Restore").click();
    person.frames(3);
    assert_eq!(person.text(), "sphere(3);\n");
    assert!(person.editor().session.active().is_modified());
}
