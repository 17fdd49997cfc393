//! The scene's parameters, as its comments describe them.
//!
//! A parameter that is live in the picture moves without compiling; others are compiled with their new value. The text keeps its
//! own values until the new ones are written into it.

mod control;

use std::collections::BTreeMap;

use chiaro_assist::{Control, Edit, Group, Parameter, apply, parameters, set_parameter};
use egui::{Align, Button, CollapsingHeader, Label, Layout, RichText, Role, ScrollArea, Ui, WidgetInfo, vec2};

use crate::app::Editor;
use crate::session::Session;
use crate::studio::LiveValue;
use crate::theme::sign;

/// The part of the panel's width that names have.
const NAME: f32 = 0.32;

/// The parameters of the text they were found in.
#[derive(Default)]
pub(crate) struct Parameters {
    text: String,
    groups: Vec<Group>,
    /// Values that are being written, by the parameters' names: no literals yet, perhaps.
    drafts: BTreeMap<String, String>,
    /// The revision whose live numbers the values were fitted to.
    fitted: Option<u64>,
}

/// Shows them.
pub(crate) fn show(editor: &mut Editor, ui: &mut Ui) {
    let memory = std::mem::take(&mut editor.panels.parameters);
    if memory.groups.is_empty() {
        ui.label("This scene has no parameters yet.");
        ui.weak("Variables at its beginning are shown here, and comments behind them say how:");
        for line in ["width = 20; // [10:50]", "hollow = true;", "style = \"round\"; // [round, sharp]"] {
            ui.monospace(line);
        }
    } else {
        head(editor, ui, &memory);
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            let mut drafts = memory.drafts.clone();
            for group in &memory.groups {
                CollapsingHeader::new(RichText::new(&group.name).strong()).default_open(true).show(ui, |ui| {
                    for parameter in &group.parameters {
                        row(editor, ui, parameter, &mut drafts);
                    }
                });
            }
            editor.panels.parameters.drafts = drafts;
        });
    }
    let drafts = std::mem::take(&mut editor.panels.parameters.drafts);
    editor.panels.parameters = Parameters { drafts, ..memory };
}

/// Finds the parameters of the text as it is now, and fits their values to the scene in the picture.
pub(crate) fn follow(editor: &mut Editor) {
    let text = &editor.session.scene_document().text;
    let memory = &mut editor.panels.parameters;
    if memory.text != *text {
        memory.text.clone_from(text);
        memory.groups = parameters(text);
        memory.drafts.clear();
        let names: Vec<&str> = all(&memory.groups).map(|parameter| parameter.name.as_str()).collect();
        let session = &mut editor.session;
        let is_known = |name: &str| names.contains(&name) || name.starts_with(['$', '@']);
        session.values.retain(|value| is_known(&value.name));
        session.definitions.retain(|name, _| is_known(name));
    }
    fit(editor);
}

/// A value that waits for a live number which the scene no longer has becomes a definition.
fn fit(editor: &mut Editor) {
    let Some(shown) = &editor.session.shown else { return };
    if editor.panels.parameters.fitted == Some(shown.revision) || editor.session.is_outdated() {
        return;
    }
    editor.panels.parameters.fitted = Some(shown.revision);
    let groups = std::mem::take(&mut editor.panels.parameters.groups);
    for parameter in all(&groups) {
        let session = &editor.session;
        let waits = session.values.iter().any(|value| value.name == parameter.name);
        if waits && !is_live(session, &parameter.name) {
            let value = value(session, parameter);
            editor.session.values.retain(|value| value.name != parameter.name);
            define(&mut editor.session, parameter, value);
        }
    }
    editor.panels.parameters.groups = groups;
}

fn all(groups: &[Group]) -> impl Iterator<Item = &Parameter> {
    groups.iter().flat_map(|group| &group.parameters)
}

/// What concerns all of them.
fn head(editor: &mut Editor, ui: &mut Ui, memory: &Parameters) {
    let changed: Vec<&Parameter> =
        all(&memory.groups).filter(|parameter| is_changed(&editor.session, parameter)).collect();
    ui.add_enabled_ui(!changed.is_empty(), |ui| {
        ui.horizontal(|ui| {
            if ui.button("Reset all").on_hover_text("Back to the values of the text").clicked() {
                for parameter in &changed {
                    reset(&mut editor.session, &parameter.name);
                }
            }
            if ui.button("Write to the text").on_hover_text("Makes these values the text's own").clicked() {
                write_back(&mut editor.session, &changed);
            }
        });
    });
}

/// A parameter: its name, its control, and a way back to the text's value.
fn row(editor: &mut Editor, ui: &mut Ui, parameter: &Parameter, drafts: &mut BTreeMap<String, String>) {
    let is_changed = is_changed(&editor.session, parameter);
    let now = drafts.get(&parameter.name).cloned().unwrap_or_else(|| value(&editor.session, parameter));
    let (mut next, mut resets) = (None, false);
    ui.horizontal(|ui| {
        name(ui, parameter, is_changed);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            resets = reset_button(ui, parameter, is_changed);
            let size = vec2(ui.available_width(), ui.spacing().interact_size.y);
            ui.allocate_ui_with_layout(size, Layout::left_to_right(Align::Center), |ui| {
                next = control::show(ui, parameter, &now);
            });
        });
    });
    if let Some(description) = &parameter.description {
        ui.label(RichText::new(description).small().weak());
    }
    ui.add_space(2.0);
    match next {
        _ if resets => {
            reset(&mut editor.session, &parameter.name);
            drafts.remove(&parameter.name);
        }
        Some(next) if control::is_value(parameter, &next) => {
            drafts.remove(&parameter.name);
            set(&mut editor.session, parameter, next);
        }
        Some(next) => {
            drafts.insert(parameter.name.clone(), next);
        }
        None => {}
    }
}

/// The name, in a column of its own.
fn name(ui: &mut Ui, parameter: &Parameter, is_changed: bool) {
    let text = RichText::new(&parameter.name);
    let label = Label::new(if is_changed { text.strong() } else { text }).truncate();
    let size = vec2(NAME * ui.available_width(), ui.spacing().interact_size.y);
    let layout = Layout::left_to_right(Align::Center);
    ui.allocate_ui_with_layout(size, layout, |ui| {
        ui.set_min_width(size.x);
        ui.add(label);
    });
}

/// A button that is there when the value is not the text's. Its place is kept.
fn reset_button(ui: &mut Ui, parameter: &Parameter, is_changed: bool) -> bool {
    let button = Button::new(sign("↺")).small().frame(false);
    let response = ui.add_visible(is_changed, button).on_hover_text("Back to the value of the text");
    response.widget_info(|| WidgetInfo::labeled(Role::Button, is_changed, format!("Reset {}", parameter.name)));
    response.clicked()
}

/// Whether the scene in the picture has that number live.
fn is_live(session: &Session, name: &str) -> bool {
    session.shown.as_ref().is_some_and(|shown| shown.scene.parameters.iter().any(|live| *live.name == *name))
}

/// Whether it has another value than in the text.
fn is_changed(session: &Session, parameter: &Parameter) -> bool {
    session.definitions.contains_key(&parameter.name) || session.values.iter().any(|value| value.name == parameter.name)
}

/// Its value now, as the program writes it.
fn value(session: &Session, parameter: &Parameter) -> String {
    if let Some(defined) = session.definitions.get(&parameter.name) {
        return defined.clone();
    }
    let live = |component: Option<usize>| {
        let is_it = |value: &&LiveValue| value.name == parameter.name && value.component == component;
        session.values.iter().find(is_it).map(|value| value.value)
    };
    match &parameter.control {
        Control::Vector { components, .. } => {
            let values = components.iter().enumerate().map(|(index, own)| live(Some(index)).unwrap_or(own.value));
            control::vector(&values.collect::<Vec<_>>())
        }
        _ => live(None).map_or_else(|| parameter.value.clone(), control::number),
    }
}

/// Gives it another value: text of the program.
fn set(session: &mut Session, parameter: &Parameter, value: String) {
    let numbers = control::numbers(&value);
    let is_moved = is_live(session, &parameter.name) && !session.definitions.contains_key(&parameter.name);
    let is_vector = matches!(parameter.control, Control::Vector { .. });
    match numbers {
        Some(numbers) if is_moved => {
            session.values.retain(|value| value.name != parameter.name);
            for (index, value) in numbers.into_iter().enumerate() {
                let component = is_vector.then_some(index);
                session.values.push(LiveValue { name: parameter.name.clone(), component, value });
            }
            session.show();
        }
        _ => define(session, parameter, value),
    }
}

/// Compiles the scene with that value.
fn define(session: &mut Session, parameter: &Parameter, value: String) {
    if session.definitions.insert(parameter.name.clone(), value.clone()) != Some(value) {
        session.compile(None);
    }
}

/// Back to the value of the text.
fn reset(session: &mut Session, name: &str) {
    session.values.retain(|value| value.name != name);
    if session.definitions.remove(name).is_some() {
        session.compile(None);
    } else {
        session.show();
    }
}

/// Writes the values into the text, as one step to undo.
fn write_back(session: &mut Session, changed: &[&Parameter]) {
    let text = session.scene_document().text.clone();
    let edit = |parameter: &&Parameter| set_parameter(&text, &parameter.name, &value(session, parameter));
    let edits: Vec<Edit> = changed.iter().filter_map(edit).collect();
    let written = apply(&text, &edits);
    for parameter in changed {
        session.values.retain(|value| value.name != parameter.name);
        session.definitions.remove(&parameter.name);
    }
    let id = session.scene_document().id;
    if let Some(document) = session.documents_mut().iter_mut().find(|document| document.id == id) {
        let caret = document.caret;
        document.history.pause();
        document.replace(written, caret, false);
    }
    session.compile(None);
}
