//! Orbit, pan, zoom and fly.

use chiaro_render::View;
use egui::{Key, PointerButton, Response, Ui, Vec2};

use crate::app::Editor;
use crate::studio::Eye;

/// Degrees a point of the window.
const ORBIT: f32 = 0.35;
/// How much nearer a notch of the wheel brings.
const ZOOM: f32 = 0.0015;
/// The part of the distance to the target that flying covers in a second.
const SPEED: f64 = 0.6;
/// OpenSCAD's vertical field of view, in degrees.
pub(crate) const PERSPECTIVE: f64 = 22.5;
/// So small a field of view, in degrees, that lines stay parallel to the eye: the drawing kernels know one kind of camera.
pub(crate) const PARALLEL: f64 = 1.0;

/// Moves the view as the pointer and the keys say.
pub(super) fn navigate(editor: &mut Editor, ui: &Ui, response: &Response) {
    // Without a scene, a picture that was put by would stay as it is.
    let is_shown = editor.session.shown.is_some();
    let Some(view) = editor.viewport.drawn().filter(|_| is_shown).map(|drawn| match editor.viewport.eye {
        Eye::At(view) => view,
        Eye::Scene | Eye::Framed(..) => drawn,
    }) else {
        return;
    };
    let mut moved = dragged(editor, ui, response, view);
    let notches = if response.hovered() { ui.input(|input| input.smooth_scroll_delta().y) } else { 0.0 };
    if notches != 0.0 {
        moved = Some(zoomed(moved.unwrap_or(view), notches));
    }
    if editor.viewport.flies && response.hovered() {
        moved = flown(ui, moved.unwrap_or(view)).or(moved);
    }
    editor.viewport.is_moving = response.dragged() || moved.is_some();
    if let Some(moved) = moved {
        editor.viewport.eye = Eye::At(moved);
        editor.viewport.stance.choose();
    }
}

fn dragged(editor: &Editor, ui: &Ui, response: &Response, view: View) -> Option<View> {
    let drag = response.drag_delta();
    if drag == Vec2::ZERO {
        return None;
    }
    let has_shift = ui.input(|input| input.modifiers.shift);
    let is_panning = response.dragged_by(PointerButton::Secondary)
        || response.dragged_by(PointerButton::Middle)
        || response.dragged_by(PointerButton::Primary) && has_shift;
    match (is_panning, response.dragged_by(PointerButton::Primary)) {
        (true, _) => Some(panned(view, drag / response.rect.height())),
        (false, true) if editor.viewport.flies => Some(turned(view, drag)),
        (false, true) => Some(orbited(view, drag)),
        (false, false) => None,
    }
}

/// Turned about the target.
fn orbited(view: View, drag: Vec2) -> View {
    let [x, y, z] = view.rotation;
    let tilt = (x - f64::from(drag.y * ORBIT)).clamp(0.0, 180.0);
    View { rotation: [tilt, y, (z - f64::from(drag.x * ORBIT)).rem_euclid(360.0)], ..view }
}

/// Turned about the eye.
fn turned(view: View, drag: Vec2) -> View {
    let turned = orbited(view, -0.5 * drag);
    let (eye, new_eye) = (view.eye(), turned.eye());
    View { target: [0, 1, 2].map(|axis| turned.target[axis] + eye[axis] - new_eye[axis]), ..turned }
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

/// Moved by the keys W, A, S, D, Q and E.
fn flown(ui: &Ui, view: View) -> Option<View> {
    if ui.ctx().text_edit_focused() {
        return None;
    }
    let (eye, (right, up)) = (view.eye(), view.sideways());
    let forward = [0, 1, 2].map(|axis| (view.target[axis] - eye[axis]) / view.distance);
    let keys = [(Key::W, forward, 1.0), (Key::S, forward, -1.0), (Key::D, right, 1.0)];
    let more = [(Key::A, right, -1.0), (Key::E, up, 1.0), (Key::Q, up, -1.0)];
    let step = SPEED * view.distance * ui.input(|input| f64::from(input.stable_dt.min(0.1)));
    let mut target = view.target;
    let mut is_moved = false;
    for (key, direction, sign) in keys.into_iter().chain(more) {
        if ui.input(|input| input.key_down(key)) {
            is_moved = true;
            target = [0, 1, 2].map(|axis| target[axis] + sign * step * direction[axis]);
        }
    }
    if is_moved {
        ui.ctx().request_repaint();
    }
    is_moved.then_some(View { target, ..view })
}

/// The same part of the scene, through a lens of another field of view.
pub(super) fn through(view: View, field_of_view: f64) -> View {
    let half = |degrees: f64| (0.5 * degrees.to_radians()).tan();
    View { distance: view.distance * half(view.field_of_view) / half(field_of_view), field_of_view, ..view }
}

#[cfg(test)]
mod tests {
    use super::*;

    const VIEW: View =
        View { target: [1.0, 2.0, 3.0], rotation: [55.0, 0.0, 25.0], distance: 100.0, field_of_view: PERSPECTIVE };

    fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
        (0..3).map(|axis| (a[axis] - b[axis]).powi(2)).sum::<f64>().sqrt()
    }

    #[test]
    fn an_orbit_keeps_the_target_and_a_turned_head_the_eye() {
        let drag = Vec2::new(30.0, -20.0);
        assert_eq!(orbited(VIEW, drag).target, VIEW.target);
        assert!(apart(orbited(VIEW, drag).eye(), VIEW.eye()) > 10.0);
        assert!(apart(turned(VIEW, drag).eye(), VIEW.eye()) < 1e-9);
    }

    #[test]
    fn nobody_tumbles_over_the_pole() {
        assert_eq!(orbited(VIEW, Vec2::new(0.0, 1e4)).rotation[0], 0.0);
        assert_eq!(orbited(VIEW, Vec2::new(0.0, -1e4)).rotation[0], 180.0);
    }

    #[test]
    fn a_panned_point_moves_with_the_pointer() {
        let (size, target) = ([400, 300], VIEW.target);
        let panned = panned(VIEW, Vec2::new(0.1, 0.2));
        let ([x, y], _) = panned.project(target, size).expect("before the eye");
        assert!((x - 200.0 - 30.0).abs() < 1e-6 && (y - 150.0 - 60.0).abs() < 1e-6, "{x}, {y}");
    }

    #[test]
    fn another_lens_shows_the_target_as_large() {
        let parallel = through(VIEW, PARALLEL);
        let (right, _) = VIEW.sideways();
        let beside = [0, 1, 2].map(|axis| VIEW.target[axis] + right[axis]);
        let seen = |view: View| view.project(beside, [400, 300]).expect("before the eye").0[0];
        assert!((seen(parallel) - seen(VIEW)).abs() < 1e-6);
    }
}
