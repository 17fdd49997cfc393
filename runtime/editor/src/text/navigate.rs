//! Going to other places of the text, and back.

use std::path::Path;

use chiaro_assist::definition_in;
use egui::{Key, TextEdit, Ui};

use crate::app::Editor;
use crate::document::DocumentId;

/// So many places are remembered.
const MOST_VISITED: usize = 100;

/// A place that one went away from.
pub(super) struct Visited {
    document: DocumentId,
    caret: usize,
}

/// Goes to where what stands at a byte is defined, in whichever file that is.
pub(super) fn to_definition(editor: &mut Editor, at: usize) {
    let document = editor.session.active();
    let Some(place) = definition_in(&editor.world(), &document.name(), &document.text, at) else { return };
    remember(editor);
    let open = editor.session.documents().iter().position(|open| open.name() == place.file);
    match open {
        Some(index) => editor.session.activate(index),
        None => {
            if let Err(reason) = editor.session.open(Path::new(&place.file)) {
                editor.session.failure = Some(reason);
                return;
            }
        }
    }
    editor.reveal(place.range);
    editor.text.wants_focus = true;
}

fn remember(editor: &mut Editor) {
    let document = editor.session.active();
    editor.text.visited.push(Visited { document: document.id, caret: document.caret });
    if editor.text.visited.len() > MOST_VISITED {
        editor.text.visited.remove(0);
    }
}

/// Goes back to where one was before.
pub(super) fn back(editor: &mut Editor) {
    while let Some(visited) = editor.text.visited.pop() {
        let open = editor.session.documents().iter().position(|open| open.id == visited.document);
        let Some(index) = open else { continue };
        editor.session.activate(index);
        editor.reveal(visited.caret..visited.caret);
        editor.text.wants_focus = true;
        return;
    }
}

/// Asks for the number of a line.
pub(super) fn ask_for_line(editor: &mut Editor) {
    editor.text.line = Some(String::new());
}

/// Shows the question for a line.
pub(super) fn show(editor: &mut Editor, ui: &mut Ui) {
    let Some(line) = &mut editor.text.line else { return };
    let count = editor.text.layout.line_count();
    let response = ui
        .horizontal(|ui| {
            let label = ui.label("Go to line");
            ui.add(TextEdit::singleline(line).desired_width(80.0).hint_text(format!("1 to {count}")))
                .labelled_by(label.id)
        })
        .inner;
    let number = line.trim().parse::<usize>().ok();
    if !response.has_focus() && !response.lost_focus() {
        response.request_focus();
    }
    if !response.lost_focus() {
        return;
    }
    editor.text.line = None;
    editor.text.wants_focus = true;
    if ui.input(|input| input.key_pressed(Key::Enter))
        && let Some(number) = number
    {
        remember(editor);
        let start = editor.text.layout.line(number.clamp(1, count) - 1).start;
        editor.reveal(start..start);
    }
}
