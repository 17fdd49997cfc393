//! Looking and pointing.

use egui::{Key, Modifiers, Pos2, vec2};

use super::person::Person;
use crate::studio::Eye;

const SCENE: &str = "translate([-12, 0, 0]) cube(12, center = true);\ntranslate([12, 0, 0]) sphere(8);\n";

/// Where a point of the scene is seen in the window.
fn seen(person: &Person, point: [f64; 3]) -> Pos2 {
    person.editor().viewport.seen(point).unwrap()
}

#[test]
fn a_click_on_a_surface_goes_to_its_expression() {
    let mut person = Person::with(SCENE);
    person.until_linked();
    let at = seen(&person, [12.0, 0.0, 0.0]);
    person.clicks(at, Modifiers::NONE);
    let caret = person.editor().session.active().caret;
    assert!(person.text()[caret..].starts_with("sphere(8)"), "{caret}");
    let outlined = |editor: &crate::app::Editor| editor.viewport.is_outlined();
    person.until("outlined", outlined);
    person.until_drawn();
    person.sees("selection");
}

#[test]
fn a_caret_in_an_expression_outlines_its_surface() {
    let mut person = Person::with(SCENE);
    person.until_linked();
    person.goes_to("cube");
    person.until("outlined", |editor| editor.viewport.is_outlined());
    let selection = person.editor().viewport.selection.as_ref().unwrap();
    assert_eq!(selection.origin().unwrap().what, "cube");
}

#[test]
fn an_edit_beside_the_field_keeps_the_picture() {
    let mut person = Person::with(SCENE);
    person.until_linked();
    person.goes_to("translate([-12");
    person.until("settled", |editor| editor.viewport.is_outlined());
    let samples = person.editor().viewport.samples;
    person.types("/**/ ");
    person.until("of the new text", |editor| editor.session.is_compiled() && !editor.session.is_outdated());
    assert_eq!(person.editor().viewport.samples, samples, "the picture began anew");
}

#[test]
fn dragging_turns_the_scene() {
    let mut person = Person::with(SCENE);
    person.until_drawn();
    let before = person.editor().viewport.drawn.unwrap();
    let at = seen(&person, [0.0, 0.0, 0.0]) + vec2(0.0, 150.0);
    person.drags(at, vec2(60.0, 0.0), Modifiers::NONE);
    person.until("turned", move |editor| editor.viewport.drawn.is_some_and(|now| now.rotation != before.rotation));
    person.until_drawn();
    let after = person.editor().viewport.drawn.unwrap();
    assert!((after.rotation[2] - before.rotation[2]).abs() > 5.0, "{before:?} {after:?}");
    assert!(matches!(person.editor().viewport.eye, Eye::At(_)));
    person.presses(Modifiers::NONE, Key::F6);
    person.until_drawn();
    assert!(matches!(person.editor().viewport.eye, Eye::Framed(..)));
}
