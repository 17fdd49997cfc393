//! Lights and cameras as text: one line each.

use std::fmt::Write;

use super::{angle, describe_map, list, number};
use crate::affine::Affine;
use crate::light::{Emitter, Light, PlacedLight, Strength};
use crate::scalar::Scalar;
use crate::scene::Camera;

/// The lights, in their order.
pub fn print_lights(lights: &[PlacedLight]) -> String {
    let mut text = String::new();
    for placed in lights {
        let _ = writeln!(text, "{}{}", describe_light(&placed.light), describe_place(&placed.placement));
    }
    text
}

/// What the scene says about its view; nothing, if it leaves all of it open.
pub fn print_camera(camera: &Camera) -> String {
    let point = |name: &str, point: &Option<[Scalar; 3]>| point.as_ref().map(|p| format!("{name} {}", list(p)));
    let single = |name: &str, value: &Option<Scalar>| value.as_ref().map(|value| format!("{name} {}", number(value)));
    let parts = [
        point("eye", &camera.eye),
        point("target", &camera.target),
        point("rotation", &camera.rotation),
        single("distance", &camera.distance),
        single("fov", &camera.field_of_view),
    ];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    if parts.is_empty() { String::new() } else { format!("camera {}\n", parts.join(", ")) }
}

/// Its shape and strength, and what is unlike most lights.
fn describe_light(light: &Light) -> String {
    let mut line = format!("{}, {}", describe_emitter(&light.emitter), describe_strength(&light.strength));
    if !light.color.iter().all(|component| component.is(1.0)) {
        let _ = write!(line, ", color {}", list(&light.color));
    }
    if light.two_sided {
        line.push_str(", two-sided");
    }
    if !light.visible {
        line.push_str(", invisible");
    }
    if let Some(method) = &light.shadows {
        let _ = write!(line, ", shadows {method}");
    }
    line
}

fn describe_emitter(emitter: &Emitter) -> String {
    match emitter {
        Emitter::Sphere { radius } => format!("sphere_light {}", number(radius)),
        Emitter::Disk { radius } => format!("disk_light {}", number(radius)),
        Emitter::Rect { size } => format!("rect_light {}", list(size)),
        Emitter::Tube { radius, length } => format!("tube_light {} {}", number(radius), number(length)),
        Emitter::Polygon { corners } => {
            let corners: Vec<String> = corners.iter().map(|corner| format!("({})", list(corner))).collect();
            format!("polygon_light {}", corners.join(" "))
        }
        Emitter::Sun { angle: seen } => format!("sun {}", angle(seen)),
        Emitter::Environment { zenith, horizon, ground } => {
            format!("environment zenith {} horizon {} ground {}", list(zenith), list(horizon), list(ground))
        }
    }
}

fn describe_strength(strength: &Strength) -> String {
    match strength {
        Strength::Power(power) => format!("{} lm", number(power)),
        Strength::Luminance(luminance) => format!("{} cd/m²", number(luminance)),
        Strength::Illuminance(illuminance) => format!("{} lx", number(illuminance)),
    }
}

fn describe_place(placement: &Affine) -> String {
    let is_identity = placement.is_translation() && placement.rows().iter().all(|row| row[3].is(0.0));
    if is_identity { String::new() } else { format!(", {}", describe_map(placement)) }
}
