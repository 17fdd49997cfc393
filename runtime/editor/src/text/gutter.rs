//! The numbers of the lines, and which of them have something to say.

use egui::text_edit::TextEditOutput;
use egui::{Align2, FontId, Rect, Ui, pos2};

use super::colors;
use crate::app::Editor;

/// Between the numbers and the text, and before them, in points.
const PADDING: f32 = 10.0;

/// How wide the gutter is.
pub(super) fn width(editor: &Editor, ui: &Ui, font: &FontId) -> f32 {
    let digits = editor.text.layout.line_count().max(10).ilog10() + 1;
    let digit = ui.fonts_mut(|fonts| fonts.glyph_width(font, '0'));
    digits as f32 * digit + 2.0 * PADDING
}

/// Paints it beside the text.
pub(super) fn show(editor: &Editor, ui: &Ui, rect: Rect, output: &TextEditOutput, font: &FontId) {
    let layout = &editor.text.layout;
    let origin = output.galley_pos.y;
    let painter = ui.painter_at(rect);
    let current = layout.line_of(editor.session.active().caret);
    for (line, place) in layout.lines_between(rect.top() - origin, rect.bottom() - origin) {
        let visuals = ui.visuals();
        let color = if line == current { visuals.strong_text_color() } else { visuals.weak_text_color() };
        let at = pos2(rect.right() - PADDING, origin + place.top());
        painter.text(at, Align2::RIGHT_TOP, line + 1, font.clone(), color);
    }
    for message in &editor.text.messages.found {
        let place = layout.caret(message.range.start);
        let center = pos2(rect.left() + 0.5 * PADDING, origin + place.center().y);
        if rect.contains(center) {
            painter.circle_filled(center, 3.0, colors::of_severity(message.severity(), ui.visuals().dark_mode));
        }
    }
}
