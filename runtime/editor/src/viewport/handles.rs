//! Handles in the picture that edit the numbers behind a solid.
//!
//! Practice: a handle sits on a line of the world along which it moves when its number grows. A drag finds the point of the
//! line that is nearest to the pointer's ray, and rewrites the number in the text; which is an edit of one number, so the
//! picture follows at once.

mod found;

use std::ops::Range;

use chiaro_assist::numbers;
use chiaro_render::View;
use egui::{Align2, Color32, CursorIcon, FontId, Painter, Pos2, Rect, Response, Stroke, Ui, pos2, vec2};

use crate::app::Editor;
use crate::document::DocumentId;

/// So near to a handle, in points, the pointer takes it.
const REACH: f32 = 9.0;
const RADIUS: f32 = 5.5;
/// The length of the line that shows which way a handle moves.
const ARROW: f32 = 16.0;

/// A handle of a number, or of what is none.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Handle {
    /// What it moves, such as `r` or `x`.
    label: String,
    /// Where it is, in millimetres of the world.
    at: [f64; 3],
    /// How it moves in the world when its number grows by 1.
    along: [f64; 3],
    /// How far ahead of its place it is drawn, in points, so that several at one place can be told apart.
    ahead: f32,
    /// The number in the text, or why there is none.
    number: Result<Number, String>,
}

/// A number that a handle moves.
#[derive(Clone, Debug, PartialEq)]
struct Number {
    document: DocumentId,
    range: Range<usize>,
    value: f64,
}

/// A drag of a handle.
#[derive(Clone, Debug)]
pub(super) struct Drag {
    handle: Handle,
    number: Number,
    /// Where on its line the pointer took it, in units of the number.
    taken_at: f64,
    value: f64,
}

/// Why the selection has no handles, if something is in their way.
pub(super) fn obstacle(editor: &Editor) -> Option<String> {
    found::handles(editor).err()
}

/// Lets the pointer move handles. True if it is busy with one.
pub(super) fn drag(editor: &mut Editor, ui: &Ui, response: &Response) -> bool {
    let Some(view) = editor.viewport.drawn() else { return false };
    let rect = response.rect;
    if response.drag_started() {
        let origin = ui.input(|input| input.pointer.press_origin());
        editor.viewport.handle = origin.and_then(|origin| taken(editor, view, rect, origin));
    }
    if let Some(pointer) = response.hover_pos()
        && handle_at(editor, view, rect, pointer).is_some()
    {
        ui.ctx().set_cursor_icon(CursorIcon::Grab);
    }
    let Some(drag) = editor.viewport.handle.clone() else { return false };
    if !response.dragged() {
        editor.viewport.handle = None;
        editor.session.active_mut().history.pause();
        return true;
    }
    if let Some(pointer) = response.interact_pointer_pos() {
        let now = on_line(view, rect, pointer, &drag.handle);
        let value = drag.number.value + now - drag.taken_at;
        let is_fine = ui.input(|input| input.modifiers.shift);
        move_number(editor, &drag, rounded(value, view, rect, &drag.handle, is_fine));
    }
    true
}

/// The drag that begins at a point of the window.
fn taken(editor: &Editor, view: View, rect: Rect, pointer: Pos2) -> Option<Drag> {
    let handle = handle_at(editor, view, rect, pointer)?;
    let number = handle.number.clone().ok()?;
    let (taken_at, value) = (on_line(view, rect, pointer, &handle), number.value);
    Some(Drag { handle, number, taken_at, value })
}

fn handle_at(editor: &Editor, view: View, rect: Rect, pointer: Pos2) -> Option<Handle> {
    let near = |handle: &Handle| grip(view, rect, handle.at, handle).map(|(at, _)| at.distance(pointer));
    let handles = found::handles(editor).unwrap_or_default();
    let reached = handles.into_iter().filter_map(|handle| Some((near(&handle)?, handle)));
    let nearest = reached.filter(|(distance, _)| *distance <= REACH).min_by(|(a, _), (b, _)| a.total_cmp(b));
    nearest.map(|(_, handle)| handle)
}

/// Writes a value in the place of the number that is dragged.
fn move_number(editor: &mut Editor, drag: &Drag, value: f64) {
    let start = drag.number.range.start;
    let session = &mut editor.session;
    let Some(document) = session.documents_mut().iter_mut().find(|open| open.id == drag.number.document) else {
        return;
    };
    let Some(number) = numbers(&document.text).into_iter().find(|number| number.range.start == start) else { return };
    let text = written(value);
    if document.text[number.range.clone()] == *text {
        return;
    }
    let mut changed = document.text.clone();
    changed.replace_range(number.range, &text);
    let caret = document.caret.min(changed.len());
    document.replace(changed, caret, true);
    session.text_changed();
    if let Some(drag) = &mut editor.viewport.handle {
        drag.value = value;
    }
}

/// A number as people write it.
fn written(value: f64) -> String {
    let text = format!("{value:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// A value with no more digits than the picture shows.
fn rounded(value: f64, view: View, rect: Rect, handle: &Handle, is_fine: bool) -> f64 {
    let length = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let size = pixels(rect);
    let away = length([0, 1, 2].map(|axis| handle.at[axis] - view.eye()[axis]));
    let pixel = view.pixel_angle(size) * away / length(handle.along).max(1e-12);
    let step = 10f64.powf((2.0 * pixel).log10().ceil()) * if is_fine { 0.1 } else { 1.0 };
    (value / step).round() * step
}

/// The point of a handle's line that is nearest to the pointer's ray, in units of its number from the handle.
fn on_line(view: View, rect: Rect, pointer: Pos2, handle: &Handle) -> f64 {
    let at = pointer - rect.min;
    let (eye, ray) = view.ray([f64::from(at.x), f64::from(at.y)], pixels(rect));
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let from_eye = [0, 1, 2].map(|axis| handle.at[axis] - eye[axis]);
    let (along, across) = (dot(handle.along, handle.along), dot(handle.along, ray));
    let denominator = along - across * across;
    // Along the line of sight a drag says nothing.
    if denominator < 1e-6 * along {
        return 0.0;
    }
    (across * dot(from_eye, ray) - dot(from_eye, handle.along)) / denominator
}

fn on_screen(view: View, rect: Rect, point: [f64; 3]) -> Option<Pos2> {
    let ([x, y], _) = view.project(point, pixels(rect))?;
    Some(rect.min + vec2(x as f32, y as f32))
}

/// Where a handle is drawn that belongs to a point, and which way it moves in the window.
fn grip(view: View, rect: Rect, at: [f64; 3], handle: &Handle) -> Option<(Pos2, egui::Vec2)> {
    let place = on_screen(view, rect, at)?;
    let ahead = on_screen(view, rect, [0, 1, 2].map(|axis| at[axis] + handle.along[axis]))?;
    let direction = (ahead - place).normalized();
    Some((place + handle.ahead * direction, direction))
}

fn pixels(rect: Rect) -> [u32; 2] {
    [rect.width().max(1.0) as u32, rect.height().max(1.0) as u32]
}

/// Paints the handles, or the one that is dragged with its value.
pub(super) fn paint(editor: &Editor, ui: &Ui, painter: &Painter) {
    let (Some(view), Some(rect)) = (editor.viewport.drawn(), editor.viewport.rect) else { return };
    if let Some(drag) = &editor.viewport.handle {
        let moved = drag.value - drag.number.value;
        let at = [0, 1, 2].map(|axis| drag.handle.at[axis] + moved * drag.handle.along[axis]);
        paint_one(painter, view, rect, at, &drag.handle, &format!("{} = {}", drag.handle.label, written(drag.value)));
        return;
    }
    let pointer = ui.input(|input| input.pointer.hover_pos());
    let hovered = pointer.and_then(|pointer| handle_at(editor, view, rect, pointer));
    for handle in found::handles(editor).unwrap_or_default() {
        let text = match (&hovered, &handle.number) {
            (Some(hovered), Ok(number)) if *hovered == handle => {
                format!("{} = {}", handle.label, written(number.value))
            }
            (Some(hovered), Err(reason)) if *hovered == handle => format!("{}: {reason}", handle.label),
            _ => String::new(),
        };
        paint_one(painter, view, rect, handle.at, &handle, &text);
    }
}

fn paint_one(painter: &Painter, view: View, rect: Rect, at: [f64; 3], handle: &Handle, text: &str) {
    let Some((place, direction)) = grip(view, rect, at, handle) else { return };
    let fill = match handle.number {
        Ok(_) => Color32::from_rgb(255, 140, 0),
        Err(_) => Color32::from_gray(140),
    };
    painter.line_segment([place - handle.ahead * direction, place + ARROW * direction], Stroke::new(2.0, fill));
    painter.circle(place, RADIUS, fill, Stroke::new(1.5, Color32::WHITE));
    if !text.is_empty() {
        let galley = painter.layout_no_wrap(text.to_owned(), FontId::proportional(13.0), Color32::WHITE);
        let label = Align2::LEFT_BOTTOM.anchor_size(place + vec2(12.0, -8.0), galley.size());
        painter.rect_filled(label.expand(4.0), 4.0, Color32::from_black_alpha(170));
        painter.galley(pos2(label.left(), label.top()), galley, Color32::WHITE);
    }
}

#[cfg(test)]
pub(super) fn described(editor: &Editor) -> Vec<(String, Result<f64, String>, [f64; 3])> {
    let described = |handle: Handle| (handle.label, handle.number.map(|number| number.value), handle.at);
    found::handles(editor).unwrap_or_default().into_iter().map(described).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const VIEW: View = View { target: [0.0; 3], rotation: [55.0, 0.0, 25.0], distance: 100.0, field_of_view: 22.5 };

    #[test]
    fn a_drag_along_a_line_is_measured_in_its_number() {
        let rect = Rect::from_min_size(pos2(50.0, 20.0), vec2(400.0, 300.0));
        let handle = Handle {
            label: "r".to_owned(),
            at: [5.0, 1.0, 2.0],
            along: [0.5, 0.0, 0.0],
            ahead: 0.0,
            number: Err("it is none".to_owned()),
        };
        for value in [-3.0, 0.0, 4.0] {
            let point = [0, 1, 2].map(|axis| handle.at[axis] + value * handle.along[axis]);
            let pointer = on_screen(VIEW, rect, point).unwrap();
            assert!((on_line(VIEW, rect, pointer, &handle) - value).abs() < 1e-3, "{value}");
        }
    }

    #[test]
    fn numbers_are_written_short() {
        for (value, text) in [(2.5, "2.5"), (-0.0, "0"), (10.0, "10"), (0.125, "0.125"), (-1e-9, "0")] {
            assert_eq!(written(value), text);
        }
    }
}
