//! What is asked in windows of its own: films, and what is not saved.

use std::collections::HashSet;
use std::fs;
use std::io::BufReader;

use egui::{Key, Modifiers, Role, ViewportCommand, ViewportId};
use egui_kittest::kittest::Queryable;
use image::AnimationDecoder;
use image::codecs::png::PngDecoder;

use super::person::Person;

const CTRL_SHIFT: Modifiers = Modifiers { shift: true, ..Modifiers::COMMAND };

/// The distinct pictures of an animated PNG, and how many there are.
fn animation(path: &std::path::Path) -> (usize, usize) {
    let decoder = PngDecoder::new(BufReader::new(fs::File::open(path).unwrap())).unwrap();
    let frames = decoder.apng().unwrap().into_frames().collect_frames().unwrap();
    let distinct: HashSet<Vec<u8>> = frames.iter().map(|frame| frame.buffer().as_raw().clone()).collect();
    (distinct.len(), frames.len())
}

#[test]
fn films_are_recorded_to_their_end_or_not_at_all() {
    // The clock moves the ball, and decides how many boxes there are.
    let mut person = Person::with(
        "translate([0, 9, 20 * $t]) sphere(5);\nfor (i = [0 : 2 * $t]) translate([9 * i, 0, 0]) cube(5);\n",
    );
    person.until_linked();
    person.presses(CTRL_SHIFT, Key::R);
    person.sets("Size", &[80.0, 60.0]);
    person.sets("Samples", &[1.0]);
    person.sets("Frames", &[4.0]);
    person.sees("recording");
    person.clicks_button("Record");
    let film = person.file("main.png");
    person.until("recorded", |editor| film.exists() && !editor.dialogs.is_busy());
    assert_eq!(animation(&film), (4, 4));
    person.harness.get_by_role_and_label(Role::ComboBox, "Format").click();
    person.frames(3);
    person.clicks_on("A PNG for each frame");
    let frames = [0, 1, 2, 3].map(|frame| person.file(&format!("main_{frame}.png")));
    // One that is there already is not written over without a word, be it not the first; nor by what is cancelled.
    fs::write(&frames[2], "somebody's work").unwrap();
    person.clicks_button("Record");
    person.harness.get_by_label_contains("Replace main_2.png?").rect();
    person.clicks_on("Cancel");
    person.sets("Samples", &[20000.0]);
    person.clicks_button("Record");
    person.clicks_on("Replace");
    person.until("begun", |editor| editor.dialogs.is_busy());
    person.clicks_on("Cancel");
    person.until("cancelled", |editor| !editor.dialogs.is_busy());
    assert!(!frames[0].exists());
    assert_eq!(fs::read(&frames[2]).unwrap(), b"somebody's work");
    person.sets("Samples", &[1.0]);
    person.clicks_button("Record");
    person.clicks_on("Replace");
    person.until("recorded", |editor| !editor.dialogs.is_busy());
    assert!(frames.iter().all(|frame| image::open(frame).is_ok_and(|picture| picture.width() == 80)));
}

/// Clicks a button. Whether the window closes then.
fn closes_by(person: &mut Person, label: &str) -> bool {
    person.harness.get_by_role_and_label(Role::Button, label).click();
    let mut closes = false;
    for _ in 0..6 {
        person.frames(1);
        let output = &person.harness.output().viewport_output;
        closes |= output[&ViewportId::ROOT].commands.contains(&ViewportCommand::Close);
    }
    closes
}

#[test]
fn quitting_asks_what_to_do_with_changes() {
    let mut person = Person::with("cube(4);\n");
    person.until_drawn();
    person.goes_to("cube");
    person.types("sphere(2);");
    let file = person.file("main.csg");
    person.until_linked();
    person.presses(Modifiers::COMMAND, Key::Q);
    person.sees("quitting");
    assert!(!closes_by(&mut person, "Cancel"));
    assert_eq!(person.text(), "sphere(2);cube(4);\n");
    // The window's own button asks as well.
    person.harness.input_mut().viewports.get_mut(&ViewportId::ROOT).unwrap().events.push(egui::ViewportEvent::Close);
    person.frames(1);
    person.frames(2);
    assert!(closes_by(&mut person, "Discard"));
    assert_eq!(fs::read_to_string(&file).unwrap(), "cube(4);\n");
    person.editor_mut().dialogs.may_quit = false;
    person.presses(Modifiers::COMMAND, Key::Q);
    assert!(closes_by(&mut person, "Save"));
    assert_eq!(fs::read_to_string(&file).unwrap(), "sphere(2);cube(4);\n");
}

#[test]
fn recent_files_are_listed_but_for_those_that_are_gone() {
    let mut person = Person::with_files(&[("main.csg", "cube(4);\n"), ("other.csg", "cube(9);\n")]);
    let (main, other) = (person.file("main.csg"), person.file("other.csg"));
    person.editor_mut().open(&other);
    assert_eq!(person.editor().settings.recent, [other.clone(), main.clone()]);
    person.editor_mut().session.close(1);
    fs::remove_file(&other).unwrap();
    person.editor_mut().open(&other);
    person.frames(2);
    person.harness.get_by_label_contains("there is no such file").rect();
    assert_eq!(person.editor().settings.recent, [main]);
}

#[test]
fn escape_closes_what_is_open_from_the_top() {
    let mut person = Person::with("cube(4);\n");
    person.until_drawn();
    let is_open = |person: &Person, name: &str| {
        let windows = person.harness.query_all_by_role_and_label(Role::Window, name);
        windows.count() > 0
    };
    for (key, modifiers, window) in
        [(Key::F1, Modifiers::NONE, "Keys"), (Key::E, Modifiers::COMMAND, "Export"), (Key::R, CTRL_SHIFT, "Record")]
    {
        person.presses(modifiers, key);
        assert!(is_open(&person, window), "{window}");
        person.presses(Modifiers::NONE, Key::Escape);
        assert!(!is_open(&person, window), "{window}");
    }
    // A list of formats is nearer than its dialog, and a question nearer than what asks it.
    fs::write(person.file("main.stl"), "somebody's work").unwrap();
    person.presses(Modifiers::COMMAND, Key::E);
    person.harness.get_by_role_and_label(Role::ComboBox, "Format").click();
    person.frames(3);
    person.presses(Modifiers::NONE, Key::Escape);
    assert!(is_open(&person, "Export") && person.harness.query_by_label("OpenSCAD text").is_none());
    person.clicks_button("Export");
    person.harness.get_by_label_contains("Replace main.stl?").rect();
    person.presses(Modifiers::NONE, Key::Escape);
    assert!(is_open(&person, "Export") && person.harness.query_by_label_contains("Replace main.stl?").is_none());
    person.presses(Modifiers::NONE, Key::F1);
    person.presses(Modifiers::NONE, Key::Escape);
    assert!(is_open(&person, "Export") && !is_open(&person, "Keys"));
    person.presses(Modifiers::NONE, Key::Escape);
    assert!(!is_open(&person, "Export"));
    assert_eq!(fs::read(person.file("main.stl")).unwrap(), b"somebody's work");
}

#[test]
fn an_export_is_of_the_scene_in_the_picture() {
    let mut person = Person::with_files(&[("main.csg", "cube(4);\n"), ("other.csg", "cube(9);\n")]);
    person.until_drawn();
    person.presses(Modifiers::COMMAND, Key::E);
    let file = |person: &Person| {
        let field = person.harness.get_by_role_and_label(Role::TextInput, "File").value().unwrap();
        std::path::Path::new(&field).file_name().unwrap().to_owned()
    };
    let says =
        |person: &Person, scene: &str| person.harness.query_all_by_role_and_label(Role::Label, scene).count() > 0;
    assert!(says(&person, "main.csg") && file(&person) == "main.stl");
    let other = person.file("other.csg");
    person.editor_mut().open(&other);
    person.until_drawn();
    assert!(says(&person, "other.csg") && file(&person) == "other.stl");
    person.clicks_button("Export");
    let mesh = person.file("other.stl");
    person.until("exported", |editor| mesh.exists() && !editor.dialogs.is_busy());
    assert!(!person.file("main.stl").exists());
    // Binary STL: corners are three numbers each, behind 84 bytes and a normal.
    let bytes = fs::read(&mesh).unwrap();
    let corners = bytes[84..].chunks_exact(50).flat_map(|triangle| triangle[12..48].chunks_exact(4));
    let farthest = corners.map(|number| f32::from_le_bytes(number.try_into().unwrap())).fold(0.0, f32::max);
    assert!((farthest - 9.0).abs() < 1e-3, "{farthest}: that is another scene");
}
