//! Two light algorithms beside each other, with a divider that can be dragged.

use egui::{Align2, Color32, CursorIcon, FontId, Painter, Rect, Response, Stroke, TextureHandle, Ui, pos2, vec2};

use crate::app::Editor;

/// So near to the divider, in points, a drag takes it.
const REACH: f32 = 10.0;
/// The radius of the knob in the middle of the divider, in points.
const KNOB: f32 = 9.0;

/// Drags the divider. True if the pointer is busy with it.
pub(super) fn drag(editor: &mut Editor, ui: &Ui, response: &Response) -> bool {
    let Some((_, part)) = &mut editor.viewport.compared else { return false };
    let rect = response.rect;
    let divider = rect.left() + *part * rect.width();
    let is_near = |x: f32| (x - divider).abs() <= REACH;
    if response.hover_pos().is_some_and(|pointer| is_near(pointer.x)) {
        ui.ctx().set_cursor_icon(CursorIcon::ResizeHorizontal);
    }
    let held = response.id.with("divider");
    if response.drag_started() {
        let origin = ui.input(|input| input.pointer.press_origin());
        ui.data_mut(|data| data.insert_temp(held, origin.is_some_and(|origin| is_near(origin.x))));
    }
    let is_dragged = response.dragged() && ui.data(|data| data.get_temp(held)).unwrap_or(false);
    if is_dragged {
        *part = ((divider + response.drag_delta().x - rect.left()) / rect.width()).clamp(0.0, 1.0);
    }
    is_dragged
}

/// Paints the other picture at the right of the divider.
pub(super) fn paint(editor: &Editor, painter: &Painter, rect: Rect, other: &TextureHandle, part: f32) {
    let divider = rect.left() + part * rect.width();
    let right = Rect::from_min_max(pos2(divider, rect.top()), rect.max);
    painter.image(other.id(), right, Rect::from_min_max(pos2(part, 0.0), pos2(1.0, 1.0)), Color32::WHITE);
    painter.vline(divider, rect.y_range(), Stroke::new(3.0, Color32::from_black_alpha(120)));
    painter.vline(divider, rect.y_range(), Stroke::new(1.5, Color32::WHITE));
    let knob = pos2(divider, rect.center().y);
    painter.circle(knob, KNOB, Color32::WHITE, Stroke::new(1.0, Color32::from_black_alpha(120)));
    for side in [-1.0, 1.0] {
        let tip = knob + vec2(side * 0.6 * KNOB, 0.0);
        let arrow = [-0.3, 0.3].map(|up| tip + vec2(-side * 0.3 * KNOB, up * KNOB));
        painter.line(vec![arrow[0], tip, arrow[1]], Stroke::new(1.5, Color32::from_gray(60)));
    }
    let Some((method, _)) = editor.viewport.compared else { return };
    let sides = [(Align2::RIGHT_BOTTOM, -8.0, editor.viewport.direct), (Align2::LEFT_BOTTOM, 8.0, method)];
    for (anchor, shift, method) in sides {
        let at = pos2(divider, rect.bottom()) + vec2(shift, -8.0);
        let galley = painter.layout_no_wrap(
            super::overlay::method_name(method).to_owned(),
            FontId::proportional(13.0),
            Color32::WHITE,
        );
        let place = anchor.anchor_size(at, galley.size());
        painter.rect_filled(place.expand(4.0), 4.0, Color32::from_black_alpha(150));
        painter.galley(place.min, galley, Color32::WHITE);
    }
}
