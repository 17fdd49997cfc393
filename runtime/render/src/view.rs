//! From where a scene is seen.

use std::convert::Infallible;

use chiaro_solid::{Camera, Scalar};
use chiaro_vocabulary::Bounds;

use crate::error;
use crate::gpu::Gpu;
use crate::measure;
use crate::model::Model;

/// OpenSCAD's turn of the scene before the camera, in degrees, where none is given.
const DEFAULT_ROTATION: [f64; 3] = [55.0, 0.0, 25.0];
/// OpenSCAD's vertical field of view in degrees, where none is given.
const DEFAULT_FIELD_OF_VIEW: f64 = 22.5;
/// How much of the picture's width or height a framed scene may take.
const FILLED: f64 = 0.82;
/// Where a scene has no end, it is drawn this many times as far as its parts with an end reach.
const ENDLESS: f64 = 3.0;
/// The edge in millimetres of what is framed where there is nothing, or nothing with an end.
const NOTHING_EDGE: f64 = 100.0;

/// OpenSCAD's gimbal camera: it looks from a distance at a target, before which the scene is turned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The point looked at, in millimetres.
    pub target: [f64; 3],
    /// How the camera is turned about x, then y, then z, in degrees; unturned it looks straight down, y upwards.
    pub rotation: [f64; 3],
    /// The distance of the eye from the target, in millimetres.
    pub distance: f64,
    /// The vertical field of view, in degrees.
    pub field_of_view: f64,
}

/// The camera's axes in the world, each of length 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Axes {
    pub(crate) right: [f64; 3],
    pub(crate) up: [f64; 3],
    pub(crate) forward: [f64; 3],
}

impl View {
    /// The view that a scene asks for; what it leaves open is chosen so that these bounds fill the picture.
    pub fn framing(camera: &Camera, parameters: &[f64], bounds: &Bounds, aspect: f64) -> Self {
        let bounds = drawn_bounds(bounds);
        let support = |direction| Ok::<_, Infallible>(bounds_support(&bounds, direction));
        let Ok(view) = Self::filled(camera, parameters, &bounds, support, aspect);
        view
    }

    /// The view that a scene asks for; what it leaves open is chosen so that the model, for its present live numbers,
    /// fills the picture.
    pub fn framing_model(gpu: &Gpu, model: &Model, camera: &Camera, aspect: f64) -> error::Result<Self> {
        let extent = drawn_bounds(&model.extent(gpu)?);
        let support = |direction| measure::support(gpu, model, direction);
        Self::filled(camera, &model.parameters(), &extent, support, aspect)
    }

    /// The view that a scene asks for; what it leaves open is chosen so that something within these bounds, whose
    /// support function this is, fills the picture.
    fn filled<E>(
        camera: &Camera,
        parameters: &[f64],
        bounds: &Bounds,
        support: impl FnMut([f64; 3]) -> Result<f64, E>,
        aspect: f64,
    ) -> Result<Self, E> {
        let value = |scalar: &Scalar| scalar.value(parameters);
        let rotation = camera.rotation.as_ref().map_or(DEFAULT_ROTATION, |r| [0, 1, 2].map(|axis| value(&r[axis])));
        let field_of_view = camera.field_of_view.as_ref().map_or(DEFAULT_FIELD_OF_VIEW, value).clamp(0.1, 170.0);
        if let Some(eye) = &camera.eye {
            let point = |p: &[Scalar; 3]| [0, 1, 2].map(|axis| value(&p[axis]));
            let target = camera.target.as_ref().map_or([0.0; 3], point);
            return Ok(View::from_eye(point(eye), target, field_of_view));
        }
        let target = camera.target.as_ref().map(|t| [0, 1, 2].map(|axis| value(&t[axis])));

        let undirected = View { target: target.unwrap_or(bounds.center()), rotation, distance: 0.0, field_of_view };
        let is_open = target.is_none() || camera.distance.is_none();
        let fit = if is_open { undirected.fit(support, aspect, target.is_none())? } else { Default::default() };
        let (shift, fitting) = fit;
        let axes = undirected.axes();
        let distance = camera.distance.as_ref().map_or(fitting, value).max(1e-6 * bounds.diagonal());
        let shifted = |axis: usize| undirected.target[axis] + shift[0] * axes.right[axis] + shift[1] * axes.up[axis];
        Ok(View { target: [0, 1, 2].map(shifted), distance, ..undirected })
    }

    /// From an eye to a target, z upwards; straight down and straight up, x is to the right.
    pub(crate) fn from_eye(eye: [f64; 3], target: [f64; 3], field_of_view: f64) -> Self {
        let [x, y, z] = [0, 1, 2].map(|axis| target[axis] - eye[axis]);
        let across = x.hypot(y);
        let tilt = across.atan2(-z).to_degrees();
        let turn = if across > 0.0 { (-x).atan2(y).to_degrees() } else { 0.0 };
        View { target, rotation: [tilt, 0.0, turn], distance: across.hypot(z).max(1e-9), field_of_view }
    }

    /// Where the eye is, in millimetres.
    pub fn eye(&self) -> [f64; 3] {
        let axes = self.axes();
        [0, 1, 2].map(|axis| self.target[axis] - self.distance * axes.forward[axis])
    }

    /// To the right and upwards in the picture, as directions of the world with a length of 1.
    pub fn sideways(&self) -> ([f64; 3], [f64; 3]) {
        let axes = self.axes();
        (axes.right, axes.up)
    }

    /// A box about what is looked at.
    pub(crate) fn subject(&self) -> Bounds {
        let reach = 0.6 * self.distance * self.half_height();
        Bounds { min: self.target.map(|x| x - reach), max: self.target.map(|x| x + reach) }
    }

    /// Half the picture's height at a distance of 1.
    pub(crate) fn half_height(&self) -> f64 {
        (0.5 * self.field_of_view).to_radians().tan()
    }

    pub(crate) fn axes(&self) -> Axes {
        let turned = |v: [f64; 3]| {
            let [x, y, z] = self.rotation.map(f64::to_radians);
            let v = [v[0], v[1] * x.cos() - v[2] * x.sin(), v[1] * x.sin() + v[2] * x.cos()];
            let v = [v[0] * y.cos() + v[2] * y.sin(), v[1], v[2] * y.cos() - v[0] * y.sin()];
            [v[0] * z.cos() - v[1] * z.sin(), v[0] * z.sin() + v[1] * z.cos(), v[2]]
        };
        Axes { right: turned([1.0, 0.0, 0.0]), up: turned([0.0, 1.0, 0.0]), forward: turned([0.0, 0.0, -1.0]) }
    }

    /// How far to move the target to the right and upwards, and how far away to look from, so that all of what has
    /// this support function is in the picture.
    ///
    /// A point at (x, y) that lies f behind the target is within the right edge if x − s ≤ w (f + D), for a shift s,
    /// a distance D and half a width w at a distance of 1; and so on for each edge. So only the most that x − w f may
    /// be counts: the support in the direction of the edge's plane. The sum of the conditions of opposite edges bounds
    /// D, and their difference is the shift that is best for every D.
    fn fit<E>(
        &self,
        mut support: impl FnMut([f64; 3]) -> Result<f64, E>,
        aspect: f64,
        may_shift: bool,
    ) -> Result<([f64; 2], f64), E> {
        let axes = self.axes();
        let half_extents = [FILLED * self.half_height() * aspect, FILLED * self.half_height()];
        let mut shift = [0.0; 2];
        let mut distance: f64 = 0.0;
        for (side, (sideways, half_extent)) in [axes.right, axes.up].into_iter().zip(half_extents).enumerate() {
            let mut most = [0.0; 2];
            for (most, sign) in most.iter_mut().zip([1.0, -1.0]) {
                let direction = [0, 1, 2].map(|axis| sign * sideways[axis] - half_extent * axes.forward[axis]);
                *most = support(direction)? - dot(self.target, direction);
            }
            if may_shift {
                shift[side] = 0.5 * (most[0] - most[1]);
            }
            distance = distance.max((most[0] - shift[side]).max(most[1] + shift[side]) / half_extent);
        }
        Ok((shift, distance))
    }
}

/// The box to draw of a scene with these bounds: finite and not empty.
pub(crate) fn drawn_bounds(bounds: &Bounds) -> Bounds {
    if bounds.is_empty() {
        return Bounds::centred([0.5 * NOTHING_EDGE; 3]);
    }
    let finite = |x: f64| Some(x.abs()).filter(|x| x.is_finite());
    let reach = bounds.min.into_iter().chain(bounds.max).filter_map(finite).fold(0.0, f64::max);
    let end = if reach > 0.0 { ENDLESS * reach } else { 0.5 * NOTHING_EDGE };
    let clipped = bounds.intersection(&Bounds::centred([end; 3]));
    // A scene without any extent, such as a live radius of 0, still has a box to look at.
    let margin = if clipped.diagonal() > 0.0 { 0.0 } else { 1e-3 };
    clipped.inflate(margin)
}

/// The most that p · direction is for a point p of a box.
pub(crate) fn bounds_support(bounds: &Bounds, direction: [f64; 3]) -> f64 {
    (0..3).map(|axis| (bounds.min[axis] * direction[axis]).max(bounds.max[axis] * direction[axis])).sum()
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: [f64; 3], b: [f64; 3]) {
        assert!((0..3).all(|axis| (a[axis] - b[axis]).abs() < 1e-9), "{a:?} is not {b:?}");
    }

    fn corners(bounds: &Bounds) -> impl Iterator<Item = [f64; 3]> + '_ {
        (0..8).map(|corner| {
            [0, 1, 2].map(|axis| if corner >> axis & 1 == 0 { bounds.min[axis] } else { bounds.max[axis] })
        })
    }

    #[test]
    fn rotations_are_openscads() {
        let view = |rotation| View { target: [0.0; 3], rotation, distance: 10.0, field_of_view: 22.5 };
        close(view([0.0; 3]).eye(), [0.0, 0.0, 10.0]);
        close(view([90.0, 0.0, 0.0]).eye(), [0.0, -10.0, 0.0]);
        close(view([90.0, 0.0, 90.0]).eye(), [10.0, 0.0, 0.0]);
        close(view([90.0, 0.0, 90.0]).axes().up, [0.0, 0.0, 1.0]);
        close(view([0.0, 90.0, 0.0]).eye(), [10.0, 0.0, 0.0]);
    }

    #[test]
    fn a_framed_box_touches_the_margin_and_no_corner_leaves_it() {
        for aspect in [0.4, 1.0, 2.5] {
            let bounds = Bounds { min: [-1.0, 5.0, 0.0], max: [8.0, 7.0, 20.0] };
            let view = View::framing(&Camera::default(), &[], &bounds, aspect);
            let (axes, eye) = (view.axes(), view.eye());
            let mut farthest: f64 = 0.0;
            for corner in corners(&bounds) {
                let seen = [0, 1, 2].map(|axis| corner[axis] - eye[axis]);
                let depth = dot(seen, axes.forward);
                let across = dot(seen, axes.right).abs() / (depth * view.half_height() * aspect);
                farthest = farthest.max(across).max(dot(seen, axes.up).abs() / (depth * view.half_height()));
            }
            assert!((farthest - FILLED).abs() < 1e-9, "{aspect}: {farthest}");
        }
    }

    #[test]
    fn what_a_scene_says_of_its_camera_stays() {
        let camera = Camera {
            eye: None,
            target: Some([1.0, 2.0, 3.0].map(Scalar::from)),
            rotation: Some([10.0, 20.0, 30.0].map(Scalar::from)),
            distance: Some(Scalar::from(140.0)),
            field_of_view: Some(Scalar::from(45.0)),
        };
        let view = View::framing(&camera, &[], &Bounds::centred([1.0; 3]), 1.0);
        let expected =
            View { target: [1.0, 2.0, 3.0], rotation: [10.0, 20.0, 30.0], distance: 140.0, field_of_view: 45.0 };
        assert_eq!(view, expected);
    }

    #[test]
    fn an_eye_and_a_target_make_a_view() {
        let target = [0.5, 0.0, 1.0];
        for eye in [[3.0, -4.0, 5.0], [0.5, 0.0, 10.0], [0.5, 0.0, -10.0], [-2.0, 7.0, 1.0], [0.5, 3.0, 0.0]] {
            let camera = Camera {
                eye: Some(eye.map(Scalar::from)),
                target: Some(target.map(Scalar::from)),
                ..Camera::default()
            };
            let view = View::framing(&camera, &[], &Bounds::centred([1.0; 3]), 1.0);
            let axes = view.axes();
            close(view.eye(), eye);
            close([0, 1, 2].map(|axis| eye[axis] + view.distance * axes.forward[axis]), target);
            // The horizon is level, and z is up as far as it can be.
            assert!(axes.right[2].abs() < 1e-9 && axes.up[2] > -1e-9, "{eye:?}: {axes:?}");
        }
    }

    #[test]
    fn who_looks_straight_down_has_y_upwards() {
        let camera = Camera { eye: Some([0.0, 0.0, 10.0].map(Scalar::from)), ..Camera::default() };
        let axes = View::framing(&camera, &[], &Bounds::centred([1.0; 3]), 1.0).axes();
        close(axes.up, [0.0, 1.0, 0.0]);
        close(axes.right, [1.0, 0.0, 0.0]);
    }

    #[test]
    fn an_eye_at_its_target_looks_somewhere() {
        let origin = [0.0; 3].map(Scalar::from);
        let camera = Camera { eye: Some(origin.clone()), target: Some(origin), ..Camera::default() };
        let view = View::framing(&camera, &[], &Bounds::centred([1.0; 3]), 1.0);
        assert!(view.distance > 0.0 && view.rotation.iter().all(|angle| angle.is_finite()), "{view:?}");
    }

    #[test]
    fn endless_and_empty_bounds_are_drawn_as_finite_boxes() {
        for bounds in [Bounds::ALL, Bounds::EMPTY, Bounds { min: [0.0; 3], max: [f64::INFINITY, 5.0, 5.0] }] {
            let drawn = drawn_bounds(&bounds);
            assert!(drawn.is_finite() && drawn.diagonal() > 0.0, "{bounds:?}: {drawn:?}");
        }
    }
}
