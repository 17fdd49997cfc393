//! What the tracing templates know of a view: the Rust side of `View` in `trace_view.wgsl`.

use chiaro_vocabulary::Bounds;

use crate::lights::{Lighting, Surroundings};
use crate::view::View;

/// The flag of `trace.wgsl`.
const RECEIVERS_ONLY: u32 = 1;

/// `View` of the templates, field by field.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub(crate) struct ViewUniform {
    pub(crate) eye: [f32; 4],
    pub(crate) right: [f32; 4],
    pub(crate) up: [f32; 4],
    pub(crate) forward: [f32; 4],
    pub(crate) box_min: [f32; 4],
    pub(crate) box_max: [f32; 4],
    pub(crate) studio: [f32; 4],
    pub(crate) zenith: [f32; 4],
    pub(crate) horizon: [f32; 4],
    pub(crate) ground: [f32; 4],
    size: [u32; 4],
    part: [u32; 4],
    level: [u32; 4],
}

/// A level of the prepass: its tiles' edge in pixels, and where the first of them is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Level {
    pub(crate) edge: u32,
    pub(crate) first: u32,
}

/// A part of a picture, in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Part {
    pub(crate) origin: [u32; 2],
    pub(crate) size: [u32; 2],
}

/// The floor of the studio and how the studio is turned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Studio {
    /// The floor's height in millimetres, if there is one.
    pub(crate) floor: Option<f64>,
    /// How the studio is turned about z, in radians.
    pub(crate) azimuth: f64,
}

impl ViewUniform {
    /// Of a view of a scene within bounds, whose distance has a Lipschitz constant.
    pub(crate) fn new(view: &View, bounds: &Bounds, lipschitz: f64, studio: Studio, size: [u32; 2]) -> Self {
        let (eye, axes) = (view.eye(), view.axes());
        let half_height = view.half_height();
        let half_width = half_height * f64::from(size[0]) / f64::from(size[1]);
        let pixel_angle = 2.0 * half_height / f64::from(size[1]);
        // Points on rays are sums of f32 as large as the farthest corner, seen from the origin and from the eye.
        let reach = |from: [f64; 3]| {
            let far = |axis: usize| (bounds.min[axis] - from[axis]).abs().max((bounds.max[axis] - from[axis]).abs());
            far(0).max(far(1)).max(far(2))
        };
        let epsilon = 2.0 * f64::from(f32::EPSILON) * reach([0.0; 3]).max(reach(eye));
        let extended = |v: [f64; 3], w: f64| [v[0] as f32, v[1] as f32, v[2] as f32, w as f32];
        let floor_below_eye = studio.floor.filter(|&floor| eye[2] > floor);
        Self {
            eye: extended(eye, lipschitz.max(f64::MIN_POSITIVE)),
            right: extended(axes.right.map(|x| x * half_width), 0.0),
            up: extended(axes.up.map(|x| x * half_height), 0.0),
            forward: extended(axes.forward, pixel_angle),
            box_min: extended(bounds.min.map(|x| x - 2.0 * epsilon), epsilon),
            box_max: extended(bounds.max.map(|x| x + 2.0 * epsilon), 0.0),
            studio: [
                floor_below_eye.unwrap_or_default() as f32,
                f32::from(u8::from(floor_below_eye.is_some())),
                studio.azimuth.cos() as f32,
                studio.azimuth.sin() as f32,
            ],
            zenith: [0.0, 0.0, 0.0, 1.0],
            horizon: [0.0; 4],
            ground: [0.0; 4],
            size: [size[0], size[1], 0, 0],
            part: [0; 4],
            level: [0; 4],
        }
    }

    /// For a level of the prepass that starts where another ended, of cones or of rays without width.
    pub(crate) fn at_level(self, level: Level, before: Option<Level>, cones: bool) -> Self {
        let before = before.unwrap_or(Level { edge: 0, first: 0 });
        let size = [self.size[0], self.size[1], 0, u32::from(cones)];
        Self { size, level: [level.edge, level.first, before.edge, before.first], ..self }
    }

    /// Surrounded by a sky, or by the studio.
    pub(crate) fn within(self, lighting: &Lighting) -> Self {
        let exposed = |v: [f64; 3], w: f32| {
            let [x, y, z] = v.map(|x| (x * lighting.exposure) as f32);
            [x, y, z, w]
        };
        match lighting.surroundings {
            Surroundings::Studio => self,
            Surroundings::Sky { zenith, horizon, ground } => Self {
                zenith: exposed(zenith, 0.0),
                horizon: exposed(horizon, 0.0),
                ground: exposed(ground, 0.0),
                ..self
            },
        }
    }

    /// With paths that end at the surfaces seen through the pixels' centres.
    pub(crate) fn receivers_only(self) -> Self {
        Self { level: [RECEIVERS_ONLY, self.level[1], self.level[2], self.level[3]], ..self }
    }

    /// For a sample of a part, starting at the depths of the prepass's last level or at the box.
    pub(crate) fn at_sample(self, sample: u32, part: Part, start: Level, prepass: bool) -> Self {
        let size = [self.size[0], self.size[1], sample, u32::from(prepass)];
        let part = [part.origin[0], part.origin[1], part.size[0], part.size[1]];
        Self { size, part, level: [0, 0, start.edge, start.first], ..self }
    }
}
