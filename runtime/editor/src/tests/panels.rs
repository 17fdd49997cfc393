//! The panels.

use chiaro_compiler::export::Language;
use egui_kittest::kittest::Queryable;

use super::person::Person;
use crate::app::Editor;
use crate::settings::Panel;

const SCENE: &str = "width = 20; // [10:40]\nhollow = false;\n\
                     difference() {\n    cube([width, 20, 20], center = true);\n    if (hollow) sphere(9);\n}\n";

#[test]
fn sliders_move_the_picture_and_write_the_text_when_asked() {
    let mut person = Person::with(SCENE);
    person.until_linked();
    person.sees("parameters");
    let revision = person.editor().session.outcome.as_ref().unwrap().revision;
    person.harness.get_by_role_and_label(egui::Role::Slider, "width").set_value_accesskit(30.0);
    person.frames(3);
    assert_eq!(person.editor().session.parameters(), [30.0]);
    assert_eq!(person.text(), SCENE);
    person.until_drawn();
    assert_eq!(person.editor().session.outcome.as_ref().unwrap().revision, revision);
    person.clicks_on("Write to the text");
    assert_eq!(person.text(), SCENE.replace("width = 20", "width = 30"));
    person.until_drawn();
}

#[test]
fn boxes_are_ticked_and_values_reset() {
    let mut person = Person::with(SCENE);
    person.until_drawn();
    let nodes = person.editor().session.shown.as_ref().unwrap().scene.graph.nodes.len();
    person.harness.get_by_role_and_label(egui::Role::CheckBox, "hollow").click();
    person.frames(3);
    person.until_drawn();
    assert!(person.editor().session.shown.as_ref().unwrap().scene.graph.nodes.len() > nodes);
    person.clicks_on("Reset all");
    person.until_drawn();
    assert_eq!(person.editor().session.shown.as_ref().unwrap().scene.graph.nodes.len(), nodes);
    assert_eq!(person.text(), SCENE);
}

#[test]
fn a_row_of_the_tree_leads_to_its_expression() {
    let mut person = Person::with(SCENE);
    person.until_linked();
    person.editor_mut().show_panel(Panel::Solids);
    person.until("listed", |editor| editor.panels.lists("cube"));
    person.sees("solids");
    person.clicks_on("cube");
    let caret = person.editor().session.active().caret;
    assert!(person.text()[caret..].starts_with("cube"), "{caret}");
}

#[test]
fn the_shader_is_that_of_the_scene() {
    let mut person = Person::with("sphere(7);\n");
    person.until_drawn();
    person.editor_mut().show_panel(Panel::Shader);
    person.until("made", |editor| editor.panels.shader_text().contains("fn scene_distance"));
    person.goes_to("sphere");
    person.types("translate([50, 0, 0]) cube(3);");
    person.until_compiled();
    person.until("made again", |editor| editor.panels.shader_text().contains("51.5"));
    person.until_linked();
    person.goes_to("cube");
    person.until("marked", |editor| !editor.panels.marked_lines().is_empty());
    let marked = person.editor().panels.marked_lines();
    assert!(marked.iter().all(|line| line.contains("let box_a = ")), "{marked:?}");
    person.sees("shader");
    person.goes_to("translate");
    person.until("marked", |editor| editor.viewport.is_outlined());
    let marked = person.editor().panels.marked_lines();
    assert!(marked.iter().all(|line| line.contains("let box_a = ")) && !marked.is_empty(), "{marked:?}");
    for (language, declared) in [
        (Language::Glsl330, "float box_a = "),
        (Language::Hlsl, "float box_a = "),
        (Language::Metal, "float box_a = "),
        (Language::Wgsl, "let box_a = "),
    ] {
        person.editor_mut().panels.set_language(language);
        let is_marked = |editor: &Editor| {
            let marked = editor.panels.marked_lines();
            !marked.is_empty() && marked.iter().all(|line| line.contains(declared))
        };
        person.until("marked in another language", is_marked);
    }
}

#[test]
fn a_message_leads_to_its_place() {
    let mut person = Person::with("cube(1);\n\n\nsphree(2);\n");
    person.until_compiled();
    person.editor_mut().show_panel(Panel::Messages);
    person.frames(2);
    person.sees("messages");
    person.harness.get_by_label_contains("there is no module").click();
    person.frames(3);
    let caret = person.editor().session.active().caret;
    assert!(person.text()[caret..].starts_with("sphree"), "{caret}");
}

#[test]
fn time_moves_the_scene() {
    let mut person = Person::with("translate([20 * $t, 0, 0]) cube(5);\n");
    person.until_drawn();
    person.editor_mut().clock.set(0.5);
    crate::panels::time::show_time(person.editor_mut());
    person.until_drawn();
    let value = person.editor().session.wanted().values.first().map(|value| value.value);
    assert_eq!(value, Some(0.5));
}

#[test]
fn only_the_user_makes_a_panel_wider() {
    let mut person = Person::with(&format!("{SCENE}echo(\"{}\");\n", "a long line ".repeat(30)));
    person.until_linked();
    let place = person.editor().viewport.place();
    for panel in Panel::ALL {
        person.editor_mut().show_panel(panel);
        person.frames(4);
        assert_eq!(person.editor().viewport.place(), place, "{panel:?}");
    }
    // What is shown here becomes longer by and by.
    person.editor_mut().show_panel(Panel::Timings);
    for digits in 1..12 {
        let editor = person.editor_mut();
        editor.session.device = "a device of a long name ".repeat(digits);
        editor.viewport.timings.pipelines = std::time::Duration::from_millis(10_u64.pow(digits as u32));
        editor.viewport.timings.to_frame += std::time::Duration::from_millis(7);
        person.frames(2);
        assert_eq!(person.editor().viewport.place(), place);
    }
    let edge = egui::pos2(place.right() + 1.0, place.center().y);
    person.drags(edge, egui::vec2(-60.0, 0.0), egui::Modifiers::NONE);
    person.frames(3);
    let now = person.editor().viewport.place();
    assert!((now.right() - place.right() + 60.0).abs() < 4.0, "{place:?} {now:?}");
}
