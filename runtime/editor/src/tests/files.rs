//! Files: what other programs write, what is saved, and what a crash leaves.

use std::fs;

use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;

use super::person::Person;
use crate::app::Editor;

/// How far the scene in the picture reaches along x; no number while nothing is shown.
fn reach(editor: &Editor) -> f64 {
    editor.session.shown.as_ref().map_or(f64::NAN, |shown| {
        let graph = &shown.scene.graph;
        graph.facts[graph.root.0 as usize].bounds.max[0]
    })
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
    person.until_linked();
    person.sees("reloaded");
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
    person.clicks_button("Export");
    let mesh = person.file("main.stl");
    person.until("exported", |editor| mesh.exists() && !editor.dialogs.is_busy());
    let triangles = fs::metadata(&mesh).unwrap().len() - 84;
    assert!(triangles > 0 && triangles.is_multiple_of(50), "{triangles}");
    // What is there is not written over without a word.
    fs::write(&mesh, "somebody's work").unwrap();
    person.frames(3);
    person.clicks_button("Export");
    person.harness.get_by_label_contains("Replace main.stl?").rect();
    person.clicks_on("Cancel");
    assert_eq!(fs::read(&mesh).unwrap(), b"somebody's work");
    person.clicks_button("Export");
    person.clicks_on("Replace");
    person.until("exported", |editor| fs::metadata(&mesh).unwrap().len() > 84 && !editor.dialogs.is_busy());
    person.frames(3);
    person.harness.get_by_role_and_label(egui::Role::ComboBox, "Format").click();
    person.frames(3);
    person.clicks_on("GLSL 330 functions");
    person.clicks_button("Export");
    let shader = person.file("main.glsl");
    person.until("exported", |_| shader.exists());
    assert!(fs::read_to_string(&shader).unwrap().contains("float scene_distance(vec3 p)"));
}

#[test]
fn other_files_are_not_overwritten_without_asking() {
    let mut person = Person::with_files(&[("main.csg", "cube(4);\n"), ("other.csg", "cube(9);\n")]);
    let (id, other) = (person.editor().session.active().id, person.file("other.csg"));
    // The ending is added: what is written over need not be what was typed.
    let chosen = person.file("other");
    for (answer, then) in [("Cancel", "cube(9);\n"), ("Replace", "cube(4);\n")] {
        person.editor_mut().dialogs.files.save_in_window(id, &chosen);
        person.frames(3);
        person.presses(Modifiers::NONE, Key::Enter);
        person.frames(3);
        assert_eq!(fs::read_to_string(&other).unwrap(), "cube(9);\n");
        person.clicks_on(answer);
        assert_eq!(fs::read_to_string(&other).unwrap(), then);
    }
    assert_eq!(person.editor().session.active().path, Some(other));
}

#[test]
fn what_is_opened_beside_another_text_is_drawn() {
    let mut person = Person::with_files(&[("main.csg", "cube(4);\n"), ("other.csg", "cube(9);\n")]);
    person.until_drawn();
    let before = person.editor().viewport.drawn().unwrap().distance;
    let other = person.file("other.csg");
    person.editor_mut().open(&other);
    person.until("drawn", |editor| reach(editor) == 9.0);
    person.until_drawn();
    let now = person.editor().viewport.drawn().unwrap().distance;
    assert!(
        (now / before - 9.0 / 4.0).abs() < 0.1,
        "it is not framed anew: seen from {now} mm, the one before from {before}"
    );
    assert_eq!(person.editor().session.active().title(), "other.csg");
    // Closing a text before the one that is edited keeps that.
    person.editor_mut().session.close(0);
    person.frames(2);
    assert_eq!(person.text(), "cube(9);\n");
}

#[test]
fn several_texts_without_files_are_drawn_each_as_it_is() {
    let mut person = Person::before(tempfile::tempdir().unwrap(), Vec::new());
    person.presses(Modifiers::COMMAND, Key::N);
    person.types("cube(4);");
    person.until("drawn", |editor| editor.session.shown.is_some() && reach(editor) == 4.0);
    person.until_drawn();
    // It began empty: it is framed nevertheless.
    let distance = person.editor().viewport.drawn().unwrap().distance;
    assert!(distance < 60.0, "a cube of 4 mm is seen from {distance} mm");
    person.presses(Modifiers::COMMAND, Key::N);
    person.types("cube(9);");
    person.until("drawn", |editor| reach(editor) == 9.0);
    let titles: Vec<String> = person.editor().session.documents().iter().map(|document| document.title()).collect();
    assert_eq!(titles, ["untitled.csg", "untitled_2.csg"]);
    person.clicks_on("untitled.csg •");
    person.until("drawn", |editor| reach(editor) == 4.0);
}

#[test]
fn a_text_without_a_file_is_saved_where_the_user_says() {
    let mut person = Person::before(tempfile::tempdir().unwrap(), Vec::new());
    person.presses(Modifiers::COMMAND, Key::N);
    person.types("cube(4);");
    person.until_drawn();
    let nowhere = person.file("missing/part.csg");
    let id = person.editor().session.active().id;
    person.editor_mut().dialogs.files.save_in_window(id, &nowhere);
    person.frames(3);
    person.sees("saving");
    person.clicks_on("OK");
    person.until("refused", |editor| editor.session.failure.is_some());
    assert!(person.editor().session.active().path.is_none() && person.editor().session.active().is_modified());
    let path = person.file("part");
    person.editor_mut().dialogs.files.save_in_window(id, &path);
    person.frames(3);
    person.presses(Modifiers::NONE, Key::Enter);
    person.until("saved", |editor| !editor.session.active().is_modified());
    assert_eq!(fs::read_to_string(person.file("part.csg")).unwrap(), "cube(4);");
    assert!(person.editor().session.failure.is_none());
}

#[test]
fn a_path_is_completed_and_an_absolute_one_takes_its_place() {
    let mut person = Person::with_files(&[("main.csg", "cube(4);\n"), ("part_one.csg", ""), ("part_two.scad", "")]);
    person.until_drawn();
    fs::create_dir(person.file("models")).unwrap();
    let elsewhere = tempfile::tempdir().unwrap();
    let (id, folder) = (person.editor().session.active().id, person.file(""));
    person.editor_mut().dialogs.files.save_in_window(id, &folder);
    person.frames(3);
    let field = |person: &Person| person.harness.get_by_role_and_label(egui::Role::TextInput, "File").value().unwrap();
    for name in ["part_one.csg", "part_two.scad", "models/"] {
        person.harness.get_by_role_and_label(egui::Role::Button, name).rect();
    }
    person.types("pa");
    person.presses(Modifiers::NONE, Key::Tab);
    assert_eq!(field(&person), folder.join("part_").display().to_string());
    assert!(person.harness.query_by_role_and_label(egui::Role::Button, "models/").is_none());
    person.sees("path");
    person.clicks_button("part_two.scad");
    assert_eq!(field(&person), folder.join("part_two.scad").display().to_string());
    // A folder is no file to be written: its contents are offered.
    for _ in 0.."part_two.scad".len() {
        person.presses(Modifiers::NONE, Key::Backspace);
    }
    person.types("models");
    person.presses(Modifiers::NONE, Key::Enter);
    assert_eq!(field(&person), folder.join("models/").display().to_string());
    person.types(&elsewhere.path().join("part").display().to_string());
    assert_eq!(field(&person), elsewhere.path().join("part").display().to_string());
    person.presses(Modifiers::NONE, Key::Enter);
    person.until("saved", |editor| editor.session.active().title() == "part.csg");
    assert!(elsewhere.path().join("part.csg").exists());
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
    // The first number is no process's, the second is by now another program's.
    for process in [4_194_999, 1] {
        let folder = tempfile::tempdir().unwrap();
        let data = folder.path().join("data/unsaved");
        fs::create_dir_all(&data).unwrap();
        fs::write(data.join(format!("{process}.json")), r#"[{"path":null,"text":"sphere(3);\n"}]"#).unwrap();
        let mut person = Person::before(folder, Vec::new());
        person.frames(2);
        person.harness.get_by_label("Restore").click();
        person.frames(3);
        assert_eq!(person.text(), "sphere(3);\n");
        assert!(person.editor().session.active().is_modified());
    }
}

#[test]
fn a_text_with_errors_is_not_shown_as_the_scene_before() {
    let mut person = Person::with_files(&[("main.csg", "cube(4);\n"), ("broken.csg", "sphree(9);\n")]);
    person.until_drawn();
    let broken = person.file("broken.csg");
    person.editor_mut().open(&broken);
    person.until("compiled", |editor| editor.session.is_compiled());
    person.frames(2);
    assert!(person.editor().session.shown.is_none(), "that is the scene of another text");
    person.sees("broken");
    person.goes_to("sphree");
    person.types("sphere(2); //");
    person.until("drawn", |editor| editor.session.shown.is_some() && reach(editor) == 2.0);
}

#[test]
fn the_tab_of_what_is_opened_is_in_sight() {
    let names: Vec<String> = (0..12).map(|index| format!("a_scene_with_a_name_{index}.csg")).collect();
    let files: Vec<(&str, &str)> = names.iter().map(|name| (name.as_str(), "cube(1);\n")).collect();
    let mut person = Person::with_files(&files);
    for name in &names {
        let file = person.file(name);
        person.editor_mut().open(&file);
        person.frames(12);
        let tab = person.harness.get_by_label(name).rect();
        assert!(tab.left() >= 0.0 && tab.right() < 600.0, "{name} is at {tab:?}");
    }
}
