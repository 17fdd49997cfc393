//! Numbers that are dragged in the text.
//!
//! Practice: while Ctrl or Alt is held, the number under the pointer can be dragged sideways; Shift makes finer steps. Each step
//! is an edit of the text, and all of them are one to be undone. The first makes the number live, so that the others compile
//! nothing.

use std::ops::Range;

use chiaro_assist::{Edit, NumberLiteral, apply, numbers, scrub};
use egui::text_edit::TextEditOutput;
use egui::{CursorIcon, Pos2, Ui};

use crate::app::Editor;

/// So many points are a step.
const POINTS_A_STEP: f32 = 4.0;
/// A fine step is this part of one.
const FINE: f32 = 0.1;

/// A number that is being changed.
pub(crate) struct Drag {
    /// Where it starts in the text.
    start: usize,
    /// As it was when the drag began, and as it is now.
    before: String,
    now: String,
    steps: f32,
    /// Where the pointer was last, along x, if it drags the number itself.
    by_pointer: Option<f32>,
}

impl Drag {
    pub(super) fn new(text: &str, number: &NumberLiteral) -> Self {
        let literal = text[number.range.clone()].to_owned();
        Self { start: number.range.start, now: literal.clone(), before: literal, steps: 0.0, by_pointer: None }
    }

    pub(super) fn range(&self) -> Range<usize> {
        self.start..self.start + self.now.len()
    }
}

/// The number at a byte of a text.
pub(super) fn at(text: &str, at: usize) -> Option<NumberLiteral> {
    numbers(text).into_iter().find(|number| number.range.contains(&at))
}

/// Lets the number under the pointer be dragged while Ctrl or Alt is held. (Some systems move windows with Alt.)
///
/// What counts is where the button was pressed: where the window is slow, the pointer is elsewhere when that is seen.
pub(super) fn drag(editor: &mut Editor, ui: &Ui, output: &TextEditOutput) {
    if let Some(drag) = editor.text.drag.as_ref().filter(|drag| drag.by_pointer.is_some()) {
        ui.ctx().set_cursor_icon(CursorIcon::ResizeHorizontal);
        return follow(editor, ui, drag.by_pointer);
    }
    let is_held = ui.input(|input| input.modifiers.alt || input.modifiers.command);
    if !is_held {
        return;
    }
    let under = |pointer: Option<Pos2>, editor: &Editor| {
        let byte = editor.text.layout.byte_at(pointer? - output.galley_pos)?;
        at(&editor.session.active().text, byte)
    };
    let (pointer, origin) = ui.input(|input| (input.pointer.hover_pos(), input.pointer.press_origin()));
    if ui.rect_contains_pointer(output.response.rect) && under(pointer, editor).is_some() {
        ui.ctx().set_cursor_icon(CursorIcon::ResizeHorizontal);
    }
    let is_pressed = ui.input(|input| input.pointer.primary_pressed()) && output.response.is_pointer_button_down_on();
    if is_pressed && let Some(number) = under(origin, editor) {
        begin(editor, &number);
        let x = origin.map(|origin| origin.x);
        if let Some(drag) = &mut editor.text.drag {
            drag.by_pointer = x;
        }
        follow(editor, ui, x);
    }
}

/// Changes the number by how far the pointer went since it was at `before`, and ends when the button is released.
fn follow(editor: &mut Editor, ui: &Ui, before: Option<f32>) {
    let now = ui.input(|input| input.pointer.latest_pos()).map(|pointer| pointer.x);
    if let (Some(before), Some(now)) = (before, now) {
        let fine = ui.input(|input| input.modifiers.shift);
        step(editor, (now - before) / POINTS_A_STEP * if fine { FINE } else { 1.0 });
    }
    if let Some(drag) = &mut editor.text.drag {
        drag.by_pointer = now.or(before);
    }
    if !ui.input(|input| input.pointer.primary_down()) {
        end(editor);
    }
}

/// Begins to change a number.
pub(super) fn begin(editor: &mut Editor, number: &NumberLiteral) {
    let document = editor.session.active_mut();
    document.history.pause();
    editor.text.drag = Some(Drag::new(&document.text, number));
}

/// Changes it by so many steps more.
pub(super) fn step(editor: &mut Editor, steps: f32) {
    let Some(drag) = &mut editor.text.drag else { return };
    drag.steps += steps;
    let range = drag.range();
    let literal = scrub(&drag.before, f64::from(drag.steps.round()));
    let document = editor.session.active_mut();
    if literal == drag.now || document.text.get(range.clone()) != Some(&drag.now) {
        return;
    }
    drag.now.clone_from(&literal);
    let text = apply(&document.text, &[Edit { range, text: literal }]);
    let caret = drag.range().end;
    document.replace(text, caret, true);
    editor.session.text_changed();
}

/// Ends the drag: what comes is undone separately.
pub(super) fn end(editor: &mut Editor) {
    editor.text.drag = None;
    // The text field took the drag for a selection: it is told the caret anew.
    editor.text.known = None;
    editor.session.active_mut().history.pause();
}
