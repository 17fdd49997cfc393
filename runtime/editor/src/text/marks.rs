//! What is painted behind and below the text.

use std::ops::Range;

use chiaro_compiler::syntax::Severity;
use egui::layers::ShapeIdx;
use egui::text_edit::TextEditOutput;
use egui::{Painter, Rect, Shape, Stroke, StrokeKind, Ui, pos2};

use super::colors::{self, Mark};
use crate::app::Editor;

/// How long what was asked for from elsewhere is marked, in seconds.
const FLASH: f64 = 0.8;
/// The least width of a mark, in points.
const LEAST: f32 = 2.0;
/// Half a wave of a squiggle, in points.
const WAVE: f32 = 2.5;
/// From one dot to the next, in points.
const DOT: f32 = 3.0;

/// A place behind the text, for what is known only when the text is laid out.
pub(super) fn place(ui: &Ui) -> ShapeIdx {
    ui.painter().add(Shape::Noop)
}

/// Paints the marks at their place, and squiggles over the text.
pub(super) fn paint(editor: &mut Editor, ui: &Ui, output: &TextEditOutput, behind: ShapeIdx) {
    let page = Page { output, clip: ui.clip_rect() };
    let mut shapes = Vec::new();
    for (mark, range) in marked(editor, ui, output.response.has_focus()) {
        let color = mark.color(ui.visuals().dark_mode);
        for rect in page.rects(editor, &range) {
            let rect = match mark {
                Mark::Line => Rect::from_x_y_ranges(page.clip.x_range(), rect.y_range()),
                _ => rect.expand2(egui::vec2(1.0, 0.0)),
            };
            shapes.push(match mark {
                Mark::Line => Shape::rect_filled(rect, 0.0, color),
                // Filled, it would be too bright for the words in it.
                Mark::Flash => Shape::rect_stroke(rect, 2.0, Stroke::new(1.5, color), StrokeKind::Outside),
                _ => Shape::rect_filled(rect, 2.0, color),
            });
        }
    }
    ui.painter().set(behind, Shape::Vec(shapes));
    let text = &editor.session.active().text;
    for message in &editor.text.messages.found {
        let stroke = Stroke::new(1.2, colors::of_severity(message.severity(), ui.visuals().dark_mode));
        for rect in page.rects(editor, &message.marked(text)) {
            match message.severity() {
                Severity::Note => dots(ui.painter(), rect, stroke),
                Severity::Warning | Severity::Error => squiggle(ui.painter(), rect, stroke),
            }
        }
    }
}

/// The page as it lies in the window.
struct Page<'a> {
    output: &'a TextEditOutput,
    clip: Rect,
}

impl Page<'_> {
    /// Where a part of the text is seen.
    fn rects(&self, editor: &Editor, range: &Range<usize>) -> Vec<Rect> {
        let origin = self.output.galley_pos;
        let (top, bottom) = (self.clip.top() - origin.y, self.clip.bottom() - origin.y);
        let least = egui::vec2(LEAST, 0.0);
        let rects = editor.text.layout.rects(range, top, bottom).into_iter();
        let widened = rects.map(|rect| Rect::from_min_size(rect.min, rect.size().max(least)));
        widened.map(|rect| rect.translate(origin.to_vec2())).collect()
    }
}

/// What is to be marked, the weakest first.
fn marked(editor: &mut Editor, ui: &Ui, has_focus: bool) -> Vec<(Mark, Range<usize>)> {
    let document = editor.session.active();
    let caret = document.caret;
    let selection = document.anchor.min(caret)..document.anchor.max(caret);
    let mut marked = vec![(Mark::Line, caret..caret)];
    if let Some(range) = solid(editor) {
        marked.push((Mark::Solid, range));
    }
    if let Some(find) = &editor.text.find {
        marked.extend(find.hits().iter().map(|hit| (Mark::Hit, hit.clone())));
    }
    if !has_focus && !selection.is_empty() {
        marked.push((Mark::Selection, selection.clone()));
    }
    if has_focus {
        let around = &editor.text.around;
        // A name that stands only here needs no mark.
        let references = around.references.iter().filter(|_| around.references.len() > 1);
        marked.extend(references.map(|range| (Mark::Reference, range.clone())));
        marked.extend(around.brackets.iter().map(|range| (Mark::Bracket, range.clone())));
    }
    if let Some(range) = editor.text.drag.as_ref().map(super::numbers::Drag::range) {
        marked.push((Mark::Number, range));
    }
    if let Some((range, until)) = &mut editor.text.flash {
        let now = ui.input(|input| input.time);
        *until = until.min(now + FLASH);
        if *until > now {
            marked.push((Mark::Flash, range.clone()));
            ui.ctx().request_repaint_after_secs((*until - now) as f32);
        } else {
            editor.text.flash = None;
        }
    }
    marked
}

/// The expression that is selected in the picture, if it is one of this text.
fn solid(editor: &Editor) -> Option<Range<usize>> {
    let span = editor.viewport.selection.as_ref()?.origin()?.span;
    let shown = editor.session.shown.as_ref()?;
    let file = shown.sources.get(span.file);
    let document = editor.session.active();
    (file.name == document.name() && *file.text == *document.text).then(|| span.range())
}

/// A line of dots, for what is no fault.
fn dots(painter: &Painter, rect: Rect, stroke: Stroke) {
    let y = rect.bottom() - 1.0;
    let count = ((rect.width() / DOT) as usize).clamp(2, 2000);
    for at in 0..count {
        painter.circle_filled(pos2(rect.left() + (at as f32 + 0.5) * DOT, y), 0.5 * stroke.width, stroke.color);
    }
}

fn squiggle(painter: &Painter, rect: Rect, stroke: Stroke) {
    let width = rect.width().max(3.0 * WAVE);
    let waves = ((width / WAVE) as usize).clamp(2, 2000);
    let y = rect.bottom() - 1.0;
    let point = |at: usize| pos2(rect.left() + at as f32 * WAVE, if at.is_multiple_of(2) { y } else { y - WAVE });
    painter.add(Shape::line((0..=waves).map(point).collect(), stroke));
}
