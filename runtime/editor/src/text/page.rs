//! The page: the text that is being written.
//!
//! Practice: egui's own text field does what a text field does: carets, mouse, clipboard, input methods. What is laid out in
//! it is ours; keys that mean more than a letter, and letters that bring others along, are taken before it sees them.

use egui::text::CCursorRange;
use egui::text_edit::TextEditOutput;
use egui::{FontId, Id, Rect, ScrollArea, TextEdit, TextStyle, Ui, UiBuilder};

use super::edits::Change;
use super::keys::{self, Focus, Pressed};
use super::{around, completion, gutter, hover, marks, messages, numbers, signature};
use crate::app::Editor;

/// Around the caret, so much is kept in sight, in points.
const MARGIN: f32 = 40.0;

/// Shows the page. Completions are offered for what was typed.
pub(super) fn show(editor: &mut Editor, ui: &mut Ui, was_typed: bool) {
    let id = field_id(editor);
    let font = TextStyle::Monospace.resolve(ui.style());
    editor.text.layout.update(ui, &editor.session.active().text, &font);
    messages::update(editor);

    let whole = ui.available_rect_before_wrap();
    let width = gutter::width(editor, ui, &font);
    let beside = Rect::from_min_max(whole.min + egui::vec2(width, 0.0), whole.max);
    let shown = ui.scope_builder(UiBuilder::new().max_rect(beside), |ui| {
        let area = ScrollArea::both().id_salt(id).auto_shrink(false);
        area.show(ui, |ui| written(editor, ui, id, &font)).inner
    });
    let Written { output, edited } = shown.inner;
    gutter::show(editor, ui, Rect::from_min_max(whole.min, egui::pos2(beside.left(), whole.bottom())), &output, &font);
    if was_typed || edited {
        completion::follow(editor, was_typed);
    }
    completion::forget_written(editor);
    around::update(editor);
    let has_focus = output.response.has_focus();
    let origin = output.galley_pos.to_vec2();
    let caret = editor.text.layout.caret(editor.session.active().caret).translate(origin);
    completion::show(editor, ui, caret, has_focus);
    signature::show(editor, ui, caret.intersect(beside), has_focus);
    hover::show(editor, ui, &output, beside);
    ui.advance_cursor_after_rect(whole);
}

/// The text field of the open text.
fn field_id(editor: &Editor) -> Id {
    Id::unique(("page", editor.session.active().id))
}

/// Does what the keys ask for. True if something was typed.
pub(super) fn take_keys(editor: &mut Editor, ui: &Ui) -> bool {
    if editor.dialogs.is_blocking() {
        return false;
    }
    let id = field_id(editor);
    let focus = match ui.memory(egui::Memory::focused) {
        Some(focused) if focused == id => Focus::Text,
        Some(_) if ui.ctx().text_edit_focused() => Focus::Field,
        _ => Focus::Nothing,
    };
    if focus == Focus::Text {
        completion::take_keys(editor, ui);
    }
    let mut was_typed = false;
    let mut aside = std::mem::take(&mut editor.text.aside);
    let all_pressed = keys::take(ui, focus, &mut aside);
    editor.text.aside = aside;
    for pressed in all_pressed {
        match pressed {
            Pressed::Command(command) => {
                editor.text.written_along = None;
                editor.text_command(command);
            }
            Pressed::Letter(text) if completion::is_typed_over(editor, &text) => {}
            Pressed::Letter(text) => {
                let selected = editor.selected();
                let change = selected.typed(&text).unwrap_or_else(|| Change::replacement(selected.range(), text));
                editor.change(&change);
                was_typed = true;
            }
        }
    }
    was_typed
}

/// What came of the text field.
struct Written {
    output: TextEditOutput,
    /// It changed the text itself.
    edited: bool,
}

fn written(editor: &mut Editor, ui: &mut Ui, id: Id, font: &FontId) -> Written {
    let behind = marks::place(ui);
    select(editor, ui, id);
    let Editor { session, text: panel, .. } = editor;
    let document = session.active_mut();
    let before = document.text.clone();
    let layout = &mut panel.layout;
    let mut layouter = |ui: &Ui, text: &dyn egui::TextBuffer, _: f32| layout.update(ui, text.as_str(), font);
    let field = TextEdit::multiline(&mut document.text)
        .id(id)
        .font(font.clone())
        .code_editor()
        .frame(egui::Frame::NONE)
        .clip_text(false)
        .desired_width(ui.available_width())
        .min_size(ui.available_size())
        .layouter(&mut layouter);
    let output = field.show(ui);
    let response = &output.response;
    let title = document.title();
    ui.ctx().accesskit_node_builder(id, |node| node.set_label(format!("Text of {title}")));
    if std::mem::take(&mut panel.wants_focus) {
        response.request_focus();
    }
    let (anchor, caret) = (document.anchor, document.caret);
    let edited = *before != document.text;
    // The pointer that drags a number selects nothing.
    let selects = response.has_focus() && panel.drag.is_none();
    if let Some(range) = output.cursor_range.filter(|_| selects) {
        let bytes = [panel.layout.byte(range.secondary), panel.layout.byte(range.primary)];
        document.select(bytes[0], bytes[1]);
    }
    panel.known = Some((document.id, [document.anchor, document.caret]));
    if edited {
        document.note_edit(&before, caret);
        panel.shows_caret = true;
        session.text_changed();
        messages::update(editor);
    } else if (anchor, caret) != (document.anchor, document.caret) {
        document.history.pause();
    }
    let origin = output.galley_pos.to_vec2();
    numbers::drag(editor, ui, &output);
    if std::mem::take(&mut editor.text.shows_caret) {
        let caret = editor.text.layout.caret(editor.session.active().caret).translate(origin);
        ui.scroll_to_rect(caret.expand2(egui::vec2(MARGIN, MARGIN)), None);
    }
    marks::paint(editor, ui, &output, behind);
    Written { output, edited }
}

/// Tells the text field where the caret is, if it was moved from elsewhere.
fn select(editor: &mut Editor, ui: &Ui, id: Id) {
    let document = editor.session.active();
    let now = (document.id, [document.anchor, document.caret]);
    if editor.text.known == Some(now) {
        return;
    }
    let [secondary, primary] = now.1.map(|at| editor.text.layout.cursor(at));
    let mut state = TextEdit::load_state(ui.ctx(), id).unwrap_or_default();
    state.cursor.set_char_range(Some(CCursorRange { primary, secondary, h_pos: None }));
    TextEdit::store_state(ui.ctx(), id, state);
    editor.text.known = Some(now);
}
