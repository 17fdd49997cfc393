//! Looking and pointing.

use chiaro_render::Inspection;
use egui::{Key, Modifiers, Pos2, vec2};
use egui_kittest::kittest::Queryable;

use super::person::Person;
use crate::app::Editor;
use crate::studio::sabotage::Mishap;
use crate::studio::{Eye, Look};

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
    let outlined = |editor: &Editor| editor.viewport.is_outlined();
    person.until("outlined", outlined);
    person.until_drawn();
    // The place in the text is framed for less than a second.
    person.frames(10);
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
fn handles_edit_the_numbers_behind_a_solid() {
    let mut person = Person::with(SCENE);
    person.until_linked();
    person.goes_to("sphere");
    person.until("outlined", |editor| editor.viewport.is_outlined());
    let (from, to) = (seen(&person, [20.0, 0.0, 0.0]), seen(&person, [23.0, 0.0, 0.0]));
    person.drags(from, to - from, Modifiers::NONE);
    assert!(person.text().ends_with("sphere(11);\n"), "{}", person.text());
}

#[test]
fn where_there_is_no_number_to_drag_a_handle_says_why() {
    let text = "r = 3;\nfor (x = [0 : 1]) translate([20 * x, 0, 0]) sphere(r * 2);\nrotate_extrude() translate([40, 0]) circle(4);\n";
    let mut person = Person::with(text);
    person.until_linked();
    person.goes_to("sphere");
    person.frames(2);
    let handles = person.editor().viewport.handles(person.editor());
    let expected = [("r", "computed from `r`", [6.0, 0.0, 0.0]), ("x", "computed from `x`", [0.0, 0.0, 0.0])];
    for (label, reason, at) in expected {
        assert!(handles.contains(&(label.to_owned(), Err(reason.to_owned()), at)), "{handles:?}");
    }
    assert!(handles.contains(&("z".to_owned(), Ok(0.0), [0.0; 3])), "{handles:?}");
    person.goes_to("circle");
    person.frames(2);
    person.harness.get_by_label_contains("`rotate_extrude` bends the lines").rect();
}

#[test]
fn an_edit_beside_the_field_keeps_the_picture() {
    let mut person = Person::with(SCENE);
    person.until_linked();
    person.goes_to("translate([-12");
    person.until("settled", |editor| editor.viewport.is_outlined());
    let samples = person.editor().viewport.samples();
    person.types("/**/ ");
    person.until("of the new text", |editor| editor.session.is_compiled() && !editor.session.is_outdated());
    assert_eq!(person.editor().viewport.samples(), samples, "the picture began anew");
}

#[test]
fn dragging_turns_the_scene() {
    let mut person = Person::with(SCENE);
    person.until_drawn();
    let before = person.editor().viewport.drawn().unwrap();
    let at = seen(&person, [0.0, 0.0, 0.0]) + vec2(0.0, 150.0);
    person.drags(at, vec2(60.0, 0.0), Modifiers::NONE);
    person.until("turned", move |editor| editor.viewport.drawn().is_some_and(|now| now.rotation != before.rotation));
    person.until_drawn();
    let after = person.editor().viewport.drawn().unwrap();
    assert!((after.rotation[2] - before.rotation[2]).abs() > 5.0, "{before:?} {after:?}");
    assert!(matches!(person.editor().viewport.eye, Eye::At(_)));
    // Moved out of sight and framed again, it is turned as before.
    let are_seen = |person: &Person| {
        let place = person.editor().viewport.place();
        [[-18.0, 0.0, 0.0], [20.0, 0.0, 0.0]].map(|end| place.contains(seen(person, end)))
    };
    person.drags(at, vec2(250.0, 0.0), Modifiers::SHIFT);
    person.until_drawn();
    assert_ne!(are_seen(&person), [true; 2]);
    person.presses(Modifiers::NONE, Key::F6);
    person.until_drawn();
    assert_eq!(are_seen(&person), [true; 2]);
    assert_eq!(person.editor().viewport.drawn().unwrap().rotation, after.rotation);
}

#[test]
fn a_screenshot_shows_what_the_window_does() {
    let mut person = Person::with(SCENE);
    person.until_drawn();
    person.editor_mut().viewport.look = Look::Inspected(Inspection::Normals);
    person.frames(2);
    person.until_drawn();
    person.presses(Modifiers::COMMAND | Modifiers::SHIFT, Key::E);
    person.frames(2);
    person.clicks_button("Export");
    let file = person.file("main.png");
    person.until("exported", |_| file.exists());
    let picture = image::open(&file).unwrap().to_rgb8();
    // The floor and the sky are bright, and have no normals.
    let corner = picture.get_pixel(2, 2).0;
    assert!(corner.iter().all(|channel| *channel < 60), "{corner:?}");
    let colors: std::collections::HashSet<_> = picture.pixels().map(|pixel| pixel.0).collect();
    assert!(colors.len() > 100, "a ball has many normals, and the picture {} colours", colors.len());
}

#[test]
fn a_lost_device_comes_back() {
    let mut person = Person::with(SCENE);
    person.until_drawn();
    person.editor().session.sabotage().plan(&[Mishap::Loss]);
    person.editor_mut().viewport.exposure = 1.0;
    person.until("lost", |editor| editor.session.sabotage().is_done());
    person.until("back", |editor| editor.session.trouble.is_none());
    person.until_drawn();
    assert!(person.editor().viewport.drawn().is_some());
}

#[test]
fn a_scene_that_loses_the_device_again_and_again_is_given_up_until_it_is_edited() {
    let mut person = Person::with(SCENE);
    person.until_drawn();
    person.editor().session.sabotage().plan(&[Mishap::Loss; 2]);
    person.editor_mut().viewport.exposure = 1.0;
    let is_lost = |editor: &Editor| editor.session.trouble.is_some();
    person.until("lost twice", |editor| editor.session.sabotage().is_done() && is_lost(editor));
    person.frames(3);
    for _ in 0..20 {
        std::thread::sleep(std::time::Duration::from_millis(50));
        person.frames(1);
        assert!(is_lost(person.editor()), "it was tried a third time");
    }
    person.goes_to("cube");
    person.types("sphere(1);");
    person.until("drawn after an edit", |editor| editor.session.trouble.is_none() && !editor.session.is_outdated());
}

#[test]
fn a_mistake_in_the_drawing_thread_is_a_message() {
    let mut person = Person::with(SCENE);
    person.until_drawn();
    person.editor().session.sabotage().plan(&[Mishap::Panic]);
    person.editor_mut().viewport.exposure = 1.0;
    let says = |editor: &Editor| editor.session.trouble.as_ref().is_some_and(|said| said.contains("mistake in Chiaro"));
    person.until("said", says);
    person.goes_to("cube");
    person.types("sphere(1);");
    person.until("drawn after an edit", |editor| editor.session.trouble.is_none() && !editor.session.is_outdated());
}

/// The colour of the window at a point.
fn color_at(person: &mut Person, at: Pos2) -> [u8; 3] {
    let window = person.harness.render().unwrap();
    let [red, green, blue, _] = window.get_pixel(at.x as u32, at.y as u32).0;
    [red, green, blue]
}

#[test]
fn what_is_marked_is_highlighted_be_it_cut_away() {
    let text = "difference() {\n    sphere(10);\n    #cylinder(r = 4, h = 30, center = true);\n}\n";
    let mut person = Person::with(text);
    person.until_linked();
    person.until("highlighted", |editor| editor.viewport.is_highlighted());
    person.until_drawn();
    // The scene's own colour is orange: less blue than green.
    let is_pink = |color: [u8; 3]| {
        let [red, green, blue] = color.map(i32::from);
        red - green > 40 && (green - blue).abs() < 30
    };
    // The cylinder's end stands out of the ball, where nothing of the scene is; the ball's side
    // hides the rest.
    let (end, side) = (seen(&person, [0.0, 0.0, 15.0]), seen(&person, [0.0, -9.8, 0.0]));
    assert!(is_pink(color_at(&mut person, end)) && !is_pink(color_at(&mut person, side)));
    person.goes_to("#");
    person.types("// ");
    person.until_drawn();
    assert!(!person.editor().viewport.is_highlighted());
}

#[test]
fn a_look_is_that_of_one_text() {
    let mut person = Person::with_files(&[("main.csg", SCENE), ("other.csg", "cube(9);\n")]);
    person.until_drawn();
    let normals = Look::Inspected(Inspection::Normals);
    person.editor_mut().viewport.look = normals;
    person.frames(2);
    person.until_drawn();
    person.presses(Modifiers::COMMAND, Key::N);
    person.frames(2);
    assert_eq!(person.editor().viewport.look, Look::Lit);
    assert!(person.harness.query_by_label("normal").is_none(), "a legend of another text");
    person.clicks_on("main.csg");
    person.frames(2);
    assert_eq!(person.editor().viewport.look, normals);
}

#[test]
fn a_text_that_is_left_and_shown_again_at_once_is_drawn() {
    let mut person = Person::with_files(&[("main.csg", SCENE), ("other.csg", "cube(9);\n")]);
    person.until_drawn();
    // Nothing is compiled meanwhile.
    for name in ["other.csg", "main.csg"] {
        let path = person.file(name);
        person.editor_mut().open(&path);
        assert_eq!(person.editor().session.scene_document().title(), name);
    }
}

#[test]
fn a_picture_that_was_there_a_moment_ago_is_there_again() {
    // Nothing is selected by a caret in blank space.
    let scene = format!("\n\n{SCENE}");
    let mut person = Person::with_files(&[("main.csg", &scene), ("other.csg", "cube(9);\n")]);
    person.until_drawn();
    let at = seen(&person, [0.0, 0.0, 0.0]) + vec2(0.0, 150.0);
    person.drags(at, vec2(60.0, 0.0), Modifiers::NONE);
    person.until_drawn();
    let (view, place) = (person.editor().viewport.drawn(), person.editor().viewport.place());
    person.harness.remove_cursor();
    person.frames(2);
    let picture = |person: &mut Person| {
        let window = person.harness.render().unwrap();
        let [x, y, width, height] = [place.left(), place.top() + 40.0, place.width(), place.height() - 80.0];
        image::imageops::crop_imm(&window, x as u32, y as u32, width as u32, height as u32).to_image()
    };
    let before = picture(&mut person);
    let other = person.file("other.csg");
    person.editor_mut().open(&other);
    person.until_drawn();
    assert!(super::likeness::difference(&before, &picture(&mut person)) > 10.0);
    person.clicks_on("main.csg");
    // It is there before anything was drawn anew, and nothing worse takes its place.
    assert_eq!(person.editor().viewport.drawn(), view);
    person.harness.remove_cursor();
    person.frames(2);
    for _ in 0..10 {
        assert_eq!(super::likeness::difference(&before, &picture(&mut person)), 0.0);
        std::thread::sleep(std::time::Duration::from_millis(30));
        person.frames(1);
    }
    person.until_linked();
    assert_eq!(super::likeness::difference(&before, &picture(&mut person)), 0.0);
    // And it can be moved as before.
    person.drags(at, vec2(60.0, 0.0), Modifiers::NONE);
    person.until_drawn();
    assert_ne!(person.editor().viewport.drawn(), view);
}

/// How far a scene's corner is from the middle of the picture, in halves of its height.
fn reach(person: &Person, corner: [f64; 3]) -> f32 {
    let (at, place) = (seen(person, corner), person.editor().viewport.place());
    let from = at - place.center();
    from.x.abs().max(from.y.abs()) / (0.5 * place.height())
}

#[test]
fn a_view_follows_the_size_unless_somebody_chose_it() {
    let mut person = Person::with("width = 10; // [1:1000]\ncube([width, 10, 10], center = true);\n");
    person.until_drawn();
    let sets = |person: &mut Person, width: f64| {
        person.harness.get_by_role_and_label(egui::Role::Slider, "width").set_value_accesskit(width);
        person.frames(3);
    };
    let before = reach(&person, [5.0, 5.0, 5.0]);
    // A little more or less is seen as such.
    sets(&mut person, 11.0);
    let view = person.editor().viewport.drawn();
    person.until_drawn();
    assert_eq!(person.editor().viewport.drawn(), view);
    sets(&mut person, 200.0);
    person.until("followed", move |editor| editor.viewport.drawn() != view);
    person.until_drawn();
    let now = reach(&person, [100.0, 5.0, 5.0]);
    assert!(now < 1.3 * before.max(1.0), "{before} {now}");
    // Whoever moved the picture is asked.
    let at = seen(&person, [0.0, 0.0, 0.0]) + vec2(0.0, 120.0);
    person.drags(at, vec2(30.0, 0.0), Modifiers::NONE);
    person.until_drawn();
    let chosen = person.editor().viewport.drawn();
    sets(&mut person, 900.0);
    person.until("a hint", |editor| editor.viewport.is_off());
    person.frames(2);
    assert_eq!(person.editor().viewport.drawn(), chosen);
    person.presses(Modifiers::NONE, Key::F6);
    person.until_drawn();
    assert!(!person.editor().viewport.is_off() && reach(&person, [450.0, 5.0, 5.0]) < 1.5);
}

#[test]
fn a_selection_can_be_read_from_the_first_moment() {
    let mut person = Person::with(SCENE);
    person.until_linked();
    let at = seen(&person, [12.0, 0.0, 0.0]);
    person.clicks(at, Modifiers::NONE);
    // Behind the words there is a dark colour at once, as dark as it stays.
    let behind = |person: &mut Person| {
        let at = person.place(person.text().find("sphere(8)").unwrap());
        color_at(person, at + vec2(1.0, -6.0))
    };
    let (first, dark) = (behind(&mut person), |color: [u8; 3]| color.iter().all(|channel| *channel < 96));
    person.until("outlined", |editor| editor.viewport.is_outlined());
    person.frames(12);
    let last = behind(&mut person);
    assert!(dark(first) && dark(last), "{first:?} {last:?}");
}
