//! Keeping a model in sight whose size changes.
//!
//! Practice: while a text is edited the picture stands still, so that small changes are seen as
//! such. When the model has grown out of the picture, or has become small in it, and stays so for a
//! moment, a view that nobody chose is framed anew. One that somebody chose is theirs: a hint tells
//! how to see all. Time moves models on purpose, so that `$t` counts as at the start.

use std::time::{Duration, Instant};

use chiaro_compiler::Scene;
use chiaro_compiler::vocabulary::Bounds;
use chiaro_render::View;
use egui::Ui;

use crate::app::Editor;
use crate::darkroom::CLOCK;
use crate::studio::Eye;

/// A model that reaches this much farther over the picture than when it was framed has grown out of
/// it.
const GROWN: f64 = 1.25;
/// One that reaches this much less far has become small.
const SHRUNK: f64 = 0.6;
/// So long it must stay so.
const SETTLED: Duration = Duration::from_millis(400);

/// How a view came about, and how the model fitted it then.
#[derive(Debug, Default)]
pub(crate) struct Stance {
    /// Somebody moved there.
    is_chosen: bool,
    /// How far the model reached over the picture at first, and in which view.
    fitted: Option<(View, f64)>,
    /// Since when it doesn't fit any more.
    off_since: Option<Instant>,
    /// It does not, and the view is one that was chosen.
    pub(super) is_off: bool,
    /// The model's box, of a revision with these values of its live numbers.
    known: Option<(u64, Vec<f64>, Bounds)>,
}

impl Stance {
    /// Somebody moved the view.
    pub(super) fn choose(&mut self) {
        (self.is_chosen, self.fitted, self.is_off) = (true, None, false);
    }

    /// Whether nothing is about to change.
    #[cfg(test)]
    pub(crate) fn is_settled(&self) -> bool {
        self.off_since.is_none() || self.is_off
    }
}

/// Follows the model with a view that nobody chose.
pub(super) fn follow(editor: &mut Editor, ui: &Ui) {
    let bounds = bounds(editor);
    let is_moving = editor.viewport.is_moving
        || editor.viewport.handle.is_some()
        || editor.clock.is_running()
        // What draws does not know the model yet.
        || editor.session.is_outdated()
        || ui.input(|input| input.pointer.any_down());
    let viewport = &mut editor.viewport;
    let stance = &mut viewport.stance;
    let Eye::At(view) = viewport.eye else {
        // It is framed by whoever draws it.
        (stance.is_chosen, stance.fitted, stance.off_since, stance.is_off) = (false, None, None, false);
        return;
    };
    let Some(reach) = bounds.and_then(|bounds| reach(view, &bounds)) else {
        (stance.off_since, stance.is_off) = (None, false);
        return;
    };
    let fitted = match stance.fitted {
        Some((of, fitted)) if of == view => fitted,
        _ => stance.fitted.insert((view, reach)).1,
    };
    if reach <= GROWN * fitted && reach >= SHRUNK * fitted {
        (stance.off_since, stance.is_off) = (None, false);
        return;
    }
    let since = stance.off_since.filter(|_| !is_moving).unwrap_or_else(Instant::now);
    stance.off_since = Some(since);
    match SETTLED.checked_sub(since.elapsed()) {
        Some(left) if !left.is_zero() => ui.ctx().request_repaint_after(left),
        _ if stance.is_chosen => stance.is_off = true,
        _ => viewport.frame_all(),
    }
}

/// The box of the scene in the picture, at the start of its time.
fn bounds(editor: &mut Editor) -> Option<Bounds> {
    let shown = editor.session.shown.as_ref()?;
    let values = at_start(&shown.scene, editor.session.parameters());
    let known = editor.viewport.stance.known.take();
    let known = known.filter(|(revision, of, _)| *revision == shown.revision && *of == values);
    let (_, _, bounds) = editor.viewport.stance.known.insert(match known {
        Some(known) => known,
        None => {
            let graph = &shown.scene.graph;
            let bounds = graph.bounds_at(&values)[graph.root.0 as usize];
            (shown.revision, values, bounds)
        }
    });
    Some(*bounds)
}

fn at_start(scene: &Scene, mut values: Vec<f64>) -> Vec<f64> {
    for (value, parameter) in values.iter_mut().zip(&scene.parameters) {
        if &*parameter.name == CLOCK {
            *value = parameter.default;
        }
    }
    values
}

/// How far a box reaches from the middle of the picture, in halves of its height; none, if it is
/// empty or has no end there. Of a plane shape the plane counts.
fn reach(view: View, bounds: &Bounds) -> Option<f64> {
    /// Pictures of another shape are as high.
    const EDGE: u32 = 2;
    if bounds.is_empty() {
        return None;
    }
    let end = |end: f64| if end.is_finite() { end } else { 0.0 };
    let mut reach = 0.0_f64;
    for corner in 0..8 {
        let side = |axis: usize| if corner >> axis & 1 == 0 { bounds.min[axis] } else { bounds.max[axis] };
        let Some(([x, y], _)) = view.project([0, 1, 2].map(|axis| end(side(axis))), [EDGE; 2]) else {
            return Some(f64::INFINITY);
        };
        reach = reach.max((x - 1.0).abs()).max((y - 1.0).abs());
    }
    (reach > 0.0).then_some(reach)
}

#[cfg(test)]
mod tests {
    use chiaro_compiler::vocabulary::Interval;

    use super::*;

    #[test]
    fn a_box_reaches_as_far_as_its_farthest_corner() {
        let view = View { target: [0.0; 3], rotation: [0.0; 3], distance: 100.0, field_of_view: 90.0 };
        let flat = |edge: f64, height| Bounds::new(Interval::new(-edge, edge), Interval::new(-1.0, 1.0), height);
        let at_zero = Interval::new(0.0, 0.0);
        assert!((reach(view, &flat(50.0, at_zero)).unwrap() - 0.5).abs() < 1e-9);
        assert!((reach(view, &flat(50.0, Interval::new(0.0, 50.0))).unwrap() - 1.0).abs() < 1e-9);
        // A plane shape's box has no end upwards.
        assert!(
            (reach(view, &flat(50.0, Interval::new(f64::NEG_INFINITY, f64::INFINITY))).unwrap() - 0.5).abs() < 1e-9
        );
        assert_eq!(reach(view, &flat(50.0, Interval::new(0.0, 200.0))), Some(f64::INFINITY));
        assert_eq!(reach(view, &Bounds::EMPTY), None);
    }
}
