//! Writing.

use egui::{Event, Key, Modifiers, PointerButton, vec2};
use egui_kittest::kittest::Queryable;

use super::person::Person;

#[test]
fn what_is_typed_is_drawn() {
    let mut person = Person::with("\ncube(10);\n");
    person.until_drawn();
    person.goes_to("\n");
    person.types("sphere(8");
    assert_eq!(person.text(), "sphere(8)\ncube(10);\n");
    person.types(");");
    assert_eq!(person.text(), "sphere(8);\ncube(10);\n");
    person.until_linked();
    assert!(!person.editor().session.has_errors());
    person.sees("typing");
    person.presses(Modifiers::COMMAND, Key::Z);
    assert!(person.text().starts_with("sphere"), "{}", person.text());
    while person.editor().session.active().history.can_undo() {
        person.presses(Modifiers::COMMAND, Key::Z);
    }
    assert_eq!(person.text(), "\ncube(10);\n");
}

#[test]
fn names_are_completed() {
    let mut person = Person::with("\n");
    person.goes_to("\n");
    person.types("cyl");
    person.until_compiled();
    person.sees("completion");
    person.presses(Modifiers::NONE, Key::Enter);
    assert!(person.text().starts_with("cylinder("), "{}", person.text());
    assert!(person.editor().text.is_quiet());
}

#[test]
fn what_a_completion_wrote_is_typed_over() {
    // The bracket of a call, the brackets behind which the caret stands already, and the sign of a
    // parameter.
    for (begun, typed, expected) in [
        ("cyl", "(h=10);", "cylinder(h=10);\n"),
        ("unio", "(r=2) ", "union(r=2) \n"),
        ("sphere(", "d=3", "sphere(d = 3)\n"),
    ] {
        let mut person = Person::with("\n");
        person.goes_to("\n");
        person.types(begun);
        if let Some((name, rest)) = typed.split_once('=').filter(|_| begun.ends_with('(')) {
            person.types(name);
            person.presses(Modifiers::NONE, Key::Tab);
            person.types(&format!("={rest}"));
        } else {
            person.presses(Modifiers::NONE, Key::Tab);
            person.types(typed);
        }
        assert_eq!(person.text(), expected);
    }
}

#[test]
fn what_a_completion_wrote_is_forgotten_when_something_else_is_done() {
    let mut person = Person::with("\n");
    person.goes_to("\n");
    person.types("cyl");
    person.presses(Modifiers::NONE, Key::Tab);
    person.types("1");
    person.presses(Modifiers::NONE, Key::Backspace);
    person.types("(");
    assert_eq!(person.text(), "cylinder(())\n");
}

#[test]
fn echoes_are_marked_at_their_word() {
    let mut person = Person::with("echo(version = version());\nsphree(4);\n");
    person.until_compiled();
    person.frames(2);
    person.sees("echo");
}

#[test]
fn broken_texts_keep_the_picture_and_are_mended_by_a_click() {
    let mut person = Person::with("cube(10);\n");
    person.until_drawn();
    let drawn = person.editor().session.shown.as_ref().unwrap().revision;
    person.goes_to("cube");
    person.types("sphree(8);");
    person.until_compiled();
    assert!(person.editor().session.has_errors());
    assert_eq!(person.editor().session.shown.as_ref().unwrap().revision, drawn);
    assert!(person.editor().viewport.samples() > 0);
    person.rests_on("sphree");
    person.sees("mistake");
    person.rests_on("sphree");
    let is_fix = |node: &egui_kittest::kittest::AccessKitNode| {
        node.role() == egui::Role::Button && node.label().is_some_and(|label| label.contains("sphere"))
    };
    person.harness.get_by(is_fix).click();
    person.frames(3);
    assert_eq!(person.text(), "sphere(8);cube(10);\n");
    person.until_drawn();
    assert!(!person.editor().session.has_errors());
}

#[test]
fn numbers_are_dragged_and_the_drag_is_undone_at_once() {
    let mut person = Person::with("translate([5, 0, 0]) sphere(20);\n");
    person.until_drawn();
    let revision = person.editor().session.outcome.as_ref().unwrap().revision;
    let at = person.place(person.text().find("20").unwrap() + 1);
    person.drags(at, vec2(24.0, 0.0), Modifiers::COMMAND);
    assert_eq!(person.text(), "translate([5, 0, 0]) sphere(26);\n");
    person.until_linked();
    person.sees("scrubbing");
    let now = person.editor().session.outcome.as_ref().unwrap().revision;
    assert!(
        now <= revision + 2,
        "one compilation with the number live, and perhaps one when it settled: {revision}, {now}"
    );
    person.presses(Modifiers::COMMAND, Key::Z);
    assert_eq!(person.text(), "translate([5, 0, 0]) sphere(20);\n");
}

/// What a keyboard tells when a key is pressed and released.
fn stroke(key: Key, modifiers: Modifiers, text: Option<&str>) -> Vec<Event> {
    let key = |pressed| Event::Key { key, physical_key: None, pressed, repeat: false, modifiers };
    let letter = text.map(|text| Event::Text(text.to_owned()));
    [Some(key(true)), letter, Some(key(false))].into_iter().flatten().collect()
}

#[test]
fn what_is_typed_while_the_window_is_slow_is_there_at_once() {
    let mut person = Person::with("\n");
    person.goes_to("\n");
    let letters = |text: &'static str| {
        text.split_inclusive(|_: char| true).flat_map(|letter| stroke(Key::A, Modifiers::NONE, Some(letter)))
    };
    person.at_once(letters("cube(3);sphere("));
    assert_eq!(person.text(), "cube(3);sphere()\n");
    // What was typed before a short cut belongs before it, even if both are seen together.
    person.at_once(letters("2)").chain(stroke(Key::Q, Modifiers::COMMAND, None)));
    assert_eq!(person.text(), "cube(3);sphere(2)\n");
    person.frames(2);
    person.harness.get_by_label_contains("Save the changes").rect();
}

#[test]
fn a_number_is_dragged_even_if_all_of_it_is_seen_in_one_frame() {
    let mut person = Person::with("sphere(20);\ncube(3);\n");
    let at = person.place(person.text().find("20").unwrap() + 1);
    let modifiers = Modifiers::COMMAND;
    let button = |pos, pressed| Event::PointerButton { pos, button: PointerButton::Primary, pressed, modifiers };
    person.at_once([Event::ModifiersChanged(modifiers)]);
    person.at_once([Event::PointerMoved(at), button(at, true), Event::PointerMoved(at + vec2(40.0, 0.0))]);
    assert_eq!(person.text(), "sphere(30);\ncube(3);\n");
    let end = at + vec2(-8.0, 30.0);
    person.at_once([Event::PointerMoved(end), button(end, false), Event::ModifiersChanged(Modifiers::NONE)]);
    person.frames(2);
    assert_eq!(person.text(), "sphere(18);\ncube(3);\n");
    let document = person.editor().session.active();
    assert_eq!((document.anchor, document.caret), (9, 9), "the drag selected something");
}

#[test]
fn words_are_found_and_replaced() {
    let mut person = Person::with("a = 1;\nab = a;\ncube(a + ab);\n");
    person.goes_to("a = 1");
    person.presses(Modifiers::COMMAND, Key::H);
    person.types("a");
    person.clicks_on("word");
    // The first place is shown at once.
    person.harness.get_by_label("1 of 3").rect();
    // Ctrl+H removes a letter in plain text fields, and asks for replacing here.
    person.harness.get_by_role_and_label(egui::Role::TextInput, "Find").focus();
    person.frames(1);
    person.presses(Modifiers::COMMAND, Key::H);
    person.harness.get_by_label("1 of 3").rect();
    person.harness.get_by_label("Replace by").rect();
    person.harness.get_by_role_and_label(egui::Role::TextInput, "Replace by").focus();
    person.frames(1);
    person.types("side");
    person.until_linked();
    person.sees("replacing");
    person.clicks_on("Replace all");
    assert_eq!(person.text(), "side = 1;\nab = side;\ncube(side + ab);\n");
    person.clicks_on("Close");
    person.presses(Modifiers::COMMAND, Key::Z);
    assert_eq!(person.text(), "a = 1;\nab = a;\ncube(a + ab);\n");
}

#[test]
fn definitions_are_found_in_other_files_and_so_is_the_way_back() {
    let mut person = Person::with_files(&[
        ("main.csg", "use <parts.csg>\npin(3);\n"),
        ("parts.csg", "\nmodule pin(r) sphere(r);\n"),
    ]);
    person.until_drawn();
    person.goes_to("pin(3)");
    person.presses(Modifiers::NONE, Key::F12);
    assert_eq!(person.editor().session.active().title(), "parts.csg");
    assert!(person.text()[person.editor().session.active().caret..].starts_with("pin(r)"));
    assert_eq!(person.editor().session.scene_document().title(), "main.csg");
    person.presses(Modifiers::ALT, Key::ArrowLeft);
    assert_eq!(person.editor().session.active().title(), "main.csg");
}

#[test]
fn lines_are_changed_as_a_whole() {
    let mut person = Person::with("cube( 1 );\nsphere(2);\n");
    person.goes_to("sphere");
    person.presses(Modifiers::COMMAND, Key::Slash);
    assert_eq!(person.text(), "cube( 1 );\n// sphere(2);\n");
    person.presses(Modifiers::ALT, Key::ArrowUp);
    assert_eq!(person.text(), "// sphere(2);\ncube( 1 );\n");
    person.presses(Modifiers::COMMAND | Modifiers::SHIFT, Key::F);
    assert_eq!(person.text(), "// sphere(2);\ncube(1);\n");
}

#[test]
fn long_dumps_can_be_written_in() {
    let line = format!("polygon(points = [{}]);\n", "[1.25, 2.5], ".repeat(2000));
    let mut person = Person::with(&format!("cube(1);\n{}", line.repeat(40)));
    person.goes_to("cube");
    person.types("sphere(1);");
    assert!(person.text().starts_with("sphere(1);cube"));
}
