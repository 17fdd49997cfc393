//! Lights by name, for programs that have lights of their own.

use chiaro_shader::lights::{DISK, QUAD, RECTANGLE, SPHERE, TUBE, TWO_SIDED, VISIBLE};
use chiaro_shader::{Light, Setting, Sky};
use serde::Serialize;

/// The studio's sky, as even as its light on surfaces that face upwards, sideways and downwards (`ambient` of `trace_studio.wgsl`).
const STUDIO: Sky = Sky { zenith: [0.62, 0.64, 0.67], horizon: [0.48, 0.49, 0.51], ground: [0.34, 0.34, 0.35] };

/// What lights a scene. Lengths are in millimetres, radiances linear.
#[derive(Serialize)]
pub(crate) struct Lamps {
    /// Overhead, at the horizon, from below.
    sky: [[f32; 3]; 3],
    /// The floor's height, if there is a floor.
    floor: Option<f32>,
    /// Whether the floor only catches shadows.
    is_studio: bool,
    lights: Vec<Lamp>,
}

#[derive(Serialize)]
struct Lamp {
    #[serde(flatten)]
    emitter: Emitter,
    radiance: [f32; 3],
    two_sided: bool,
    visible: bool,
}

#[derive(Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
enum Emitter {
    Sphere {
        centre: [f32; 3],
        radius: f32,
    },
    Disk {
        centre: [f32; 3],
        radius: f32,
        normal: [f32; 3],
    },
    /// `along` is the direction of its width.
    Rectangle {
        centre: [f32; 3],
        normal: [f32; 3],
        along: [f32; 3],
        size: [f32; 2],
    },
    /// Anticlockwise as seen from the side that shines.
    Polygon {
        corners: Vec<[f32; 3]>,
    },
    /// `axis` goes from the centre to one end.
    Tube {
        centre: [f32; 3],
        axis: [f32; 3],
        radius: f32,
    },
    /// `direction` goes to it, `sine` is that of its angular radius.
    Sun {
        direction: [f32; 3],
        sine: f32,
    },
}

impl Lamps {
    pub(crate) fn of(setting: &Setting) -> Self {
        let Sky { zenith, horizon, ground } = setting.sky.unwrap_or(STUDIO);
        Self {
            sky: [zenith, horizon, ground],
            floor: setting.floor,
            is_studio: setting.sky.is_none(),
            lights: setting.lights.iter().map(Lamp::of).collect(),
        }
    }
}

impl Lamp {
    fn of(light: &Light) -> Self {
        let has = |flag: u32| light.flags & flag != 0;
        let [a, b, c, d] = light.numbers;
        let (centre, radius) = (xyz(a), a[3]);
        let emitter = match light.kind {
            SPHERE => Emitter::Sphere { centre, radius },
            DISK => Emitter::Disk { centre, radius, normal: xyz(b) },
            QUAD if has(RECTANGLE) => rectangle([xyz(a), xyz(b), xyz(c), xyz(d)]),
            QUAD if c == d => Emitter::Polygon { corners: [a, b, c].map(xyz).to_vec() },
            QUAD => Emitter::Polygon { corners: [a, b, c, d].map(xyz).to_vec() },
            TUBE => Emitter::Tube { centre, axis: xyz(b), radius },
            _ => Emitter::Sun { direction: centre, sine: radius },
        };
        Self { emitter, radiance: light.radiance, two_sided: has(TWO_SIDED), visible: has(VISIBLE) }
    }
}

fn rectangle([a, b, c, d]: [[f32; 3]; 4]) -> Emitter {
    let way = |from: [f32; 3], to: [f32; 3]| [0, 1, 2].map(|i| to[i] - from[i]);
    let length = |v: [f32; 3]| v.iter().map(|x| x * x).sum::<f32>().sqrt();
    let (u, v) = (way(a, b), way(a, d));
    let across = [0, 1, 2].map(|i| u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3]);
    let area = length(across);
    Emitter::Rectangle {
        centre: [0, 1, 2].map(|i| 0.25 * (a[i] + b[i] + c[i] + d[i])),
        normal: across.map(|x| x / area),
        along: u.map(|x| x / length(u)),
        size: [length(u), length(v)],
    }
}

fn xyz([x, y, z, _]: [f32; 4]) -> [f32; 3] {
    [x, y, z]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rectangles_face_the_side_from_which_their_corners_are_anticlockwise() {
        let corner = |x: f32, y: f32| [x, y, 5.0, 0.0];
        let numbers = [corner(-2.0, -1.0), corner(2.0, -1.0), corner(2.0, 1.0), corner(-2.0, 1.0)];
        let light = Light { numbers, radiance: [1.0; 3], kind: QUAD, flags: RECTANGLE | VISIBLE };
        let lamp = serde_json::to_value(Lamp::of(&light)).unwrap();
        let expected = serde_json::json!({
            "kind": "rectangle", "centre": [0.0, 0.0, 5.0], "normal": [0.0, 0.0, 1.0], "along": [1.0, 0.0, 0.0],
            "size": [4.0, 2.0], "radiance": [1.0, 1.0, 1.0], "two_sided": false, "visible": true,
        });
        assert_eq!(lamp, expected);
    }
}
