//! Numbers that are dragged in the text.
//!
//! Practice: while Ctrl or Alt is held, the number under the pointer can be dragged sideways; Shift makes finer steps. Each step
//! is an edit of the text, and all of them are one to be undone. The first makes the number live, so that the others compile
//! nothing.

use std::ops::Range;

use chiaro_assist::{Edit, NumberLiteral, apply, numbers, scrub};
use egui::text_edit::TextEditOutput;
use egui::{CursorIcon, Rect, Sense, Ui};

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
}

impl Drag {
    pub(super) fn new(text: &str, number: &NumberLiteral) -> Self {
        let literal = text[number.range.clone()].to_owned();
        Self { start: number.range.start, now: literal.clone(), before: literal, steps: 0.0 }
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
pub(super) fn drag(editor: &mut Editor, ui: &Ui, output: &TextEditOutput) {
    let origin = output.galley_pos;
    let is_held = ui.input(|input| input.modifiers.alt || input.modifiers.command);
    let pointer = ui.input(|input| input.pointer.hover_pos());
    let document = editor.session.active();
    let under = pointer.filter(|at| is_held && output.response.rect.contains(*at) && ui.clip_rect().contains(*at));
    let under = under.and_then(|pointer| editor.text.layout.byte_at(pointer - origin));
    let number = under.and_then(|byte| at(&document.text, byte));
    if editor.text.drag.is_none() && number.is_none() {
        return;
    }
    let range = match (&editor.text.drag, &number) {
        (Some(drag), _) => drag.range(),
        (None, Some(number)) => number.range.clone(),
        (None, None) => return,
    };
    let rects = editor.text.layout.rects(&range, f32::NEG_INFINITY, f32::INFINITY);
    let rect = rects.into_iter().reduce(Rect::union).unwrap_or(Rect::NOTHING).translate(origin.to_vec2());
    let handle = ui.interact(rect, output.response.id.with("number"), Sense::drag());
    ui.ctx().set_cursor_icon(CursorIcon::ResizeHorizontal);
    if handle.drag_started()
        && let Some(number) = &number
    {
        begin(editor, number);
    }
    if handle.dragged() {
        let fine = ui.input(|input| input.modifiers.shift);
        let steps = handle.drag_delta().x / POINTS_A_STEP * if fine { FINE } else { 1.0 };
        step(editor, steps);
    }
    if handle.drag_stopped() {
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
    editor.session.active_mut().history.pause();
}
