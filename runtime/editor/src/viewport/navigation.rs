//! Orbit, pan and zoom.

use chiaro_render::View;
use egui::{PointerButton, Response, Ui, Vec2};

use crate::app::Editor;

/// Degrees a point of the window.
const ORBIT: f32 = 0.35;
/// How much nearer a notch of the wheel brings.
const ZOOM: f32 = 0.0015;

/// Moves the view as the pointer says.
pub(crate) fn navigate(editor: &mut Editor, ui: &Ui, response: &Response) {
    let Some(view) = editor.viewport.view.or(editor.viewport.drawn) else { return };
    let drag = response.drag_delta();
    let is_panning = response.dragged_by(PointerButton::Secondary)
        || response.dragged_by(PointerButton::Middle)
        || response.dragged_by(PointerButton::Primary) && ui.input(|input| input.modifiers.shift);
    let mut moved = None;
    if is_panning && drag != Vec2::ZERO {
        moved = Some(panned(view, drag / response.rect.height()));
    } else if response.dragged_by(PointerButton::Primary) && drag != Vec2::ZERO {
        moved = Some(orbited(view, drag));
    }
    let notches = if response.hovered() { ui.input(|input| input.smooth_scroll_delta.y) } else { 0.0 };
    if notches != 0.0 {
        moved = Some(zoomed(moved.unwrap_or(view), notches));
    }
    editor.viewport.is_moving = response.dragged() || notches != 0.0;
    if let Some(moved) = moved {
        editor.viewport.view = Some(moved);
    }
}

/// Turned about the target.
fn orbited(view: View, drag: Vec2) -> View {
    let [x, y, z] = view.rotation;
    let tilt = (x - f64::from(drag.y * ORBIT)).clamp(0.0, 180.0);
    View { rotation: [tilt, y, (z - f64::from(drag.x * ORBIT)).rem_euclid(360.0)], ..view }
}

/// Moved sideways by a part of the picture's height.
fn panned(view: View, part: Vec2) -> View {
    let height = 2.0 * view.distance * (0.5 * view.field_of_view.to_radians()).tan();
    let (right, up) = view.sideways();
    let shift = [-f64::from(part.x) * height, f64::from(part.y) * height];
    View { target: [0, 1, 2].map(|axis| view.target[axis] + shift[0] * right[axis] + shift[1] * up[axis]), ..view }
}

/// Nearer or farther.
fn zoomed(view: View, notches: f32) -> View {
    View { distance: view.distance * f64::from(-notches * ZOOM).exp(), ..view }
}
