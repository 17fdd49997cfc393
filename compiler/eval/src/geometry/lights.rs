//! The lights. They leave no solid behind, but something beside it.

mod aim;
mod corners;

use std::sync::Arc;

use chiaro_solid::{Affine, Emitter, Light, PlacedLight, SHADOW_METHODS, Scalar, Strength};
use chiaro_syntax::{Diagnostic, Span};

use super::colors;
use super::instance::{Instance, Module, error};
use super::make::{empty, radians};
use super::{Built, Stop, decide};
use crate::suggest;

/// What round lights can be told.
const ROUND: &[&str] = &["d", "power", "luminance", "color", "visible", "shadows"];
/// What tubes can be told; OpenSCAD calls the length of a cylinder `h`.
const TUBE: &[&str] = &["d", "h", "power", "luminance", "color", "visible", "shadows"];
/// What disks can be told.
const DISK: &[&str] = &["d", "power", "luminance", "color", "two_sided", "aim", "visible", "shadows"];
/// What other flat lights can be told.
const FLAT: &[&str] = &["power", "luminance", "color", "two_sided", "aim", "visible", "shadows"];
/// What suns can be told.
const SUN: &[&str] = &["illuminance", "luminance", "color", "aim", "visible", "shadows"];

pub(super) const MODULES: &[Module] = &[
    Module { name: "sphere_light", positional: &["r"], named: ROUND, build: sphere_light },
    Module { name: "disk_light", positional: &["r"], named: DISK, build: disk_light },
    Module { name: "rect_light", positional: &["size"], named: FLAT, build: rect_light },
    Module { name: "tube_light", positional: &["r", "length"], named: TUBE, build: tube_light },
    Module { name: "polygon_light", positional: &["points"], named: FLAT, build: polygon_light },
    Module { name: "sun", positional: &["angle"], named: SUN, build: sun },
    Module {
        name: "environment",
        positional: &["color"],
        named: &["zenith", "horizon", "ground", "luminance"],
        build: environment,
    },
];

/// No light is larger, in millimetres: pictures know lengths in single precision, and multiply up to four.
const LARGEST: f64 = 1e9;
/// No light is brighter, nor is one dimmer that is not dark, in lumens, lux or candela per square metre: pictures have
/// these numbers in single precision, divided and multiplied by areas. The sun has 2e9 candela per square metre.
const BRIGHTEST: f64 = 1e20;
const DIMMEST: f64 = 1e-20;
/// The luminous flux of a light that doesn't say, in lumens.
const POWER: f64 = 1000.0;
/// The illuminance of a sun that doesn't say, in lux.
const SUNLIGHT: f64 = 100_000.0;
/// The luminance of an environment that doesn't say, in candela per square metre.
const SKYLIGHT: f64 = 2_000.0;
/// The angle that the sun is seen under, in degrees.
const SUN_ANGLE: f64 = 0.53;
/// A sun can't be seen under more than this, in degrees.
const WIDEST_SUN: f64 = 170.0;

fn sphere_light(instance: &mut Instance) -> Built {
    let radius = instance.radius("r", "d").unwrap_or(Scalar::ONE);
    check_size(&radius, Least::Zero, instance.place_of_radius())?;
    lamp(instance, Emitter::Sphere { radius }, Affine::identity())
}

fn disk_light(instance: &mut Instance) -> Built {
    let radius = instance.radius("r", "d").unwrap_or(Scalar::ONE);
    check_size(&radius, Least::More, instance.place_of_radius())?;
    flat(instance, Emitter::Disk { radius })
}

fn rect_light(instance: &mut Instance) -> Built {
    let size = instance.number_or_vector::<2>("size", 2, 0.0).unwrap_or([Scalar::ONE, Scalar::ONE]);
    for side in &size {
        check_size(side, Least::More, instance.place("size"))?;
    }
    flat(instance, Emitter::Rect { size })
}

fn tube_light(instance: &mut Instance) -> Built {
    let radius = instance.radius("r", "d").unwrap_or(Scalar::ONE);
    check_size(&radius, Least::More, instance.place_of_radius())?;
    let length = instance.number("length");
    if length.is_some() && instance.value("h").is_some() {
        instance.warn(instance.place("h"), "`h` is ignored, because `length` is given too");
    }
    let name = if length.is_some() { "length" } else { "h" };
    let length = length.or_else(|| instance.number("h")).unwrap_or(Scalar::ONE);
    check_size(&length, Least::More, instance.place(name))?;
    lamp(instance, Emitter::Tube { radius, length }, Affine::identity())
}

fn polygon_light(instance: &mut Instance) -> Built {
    let corners = corners::read(instance)?;
    flat(instance, Emitter::Polygon { corners })
}

fn sun(instance: &mut Instance) -> Built {
    let angle = instance.number("angle").unwrap_or(Scalar::from(SUN_ANGLE));
    let span = instance.place("angle");
    let reason = "whether a sun's angle is within its bounds";
    let is_narrow = !decide::is_negative(&(Scalar::from(WIDEST_SUN) - angle.clone()), span, reason)?;
    if !angle.is_finite() || !is_narrow || decide::is_negative(&angle, span, reason)? {
        return Err(error(span, format!("a sun is seen under an angle from 0 to {WIDEST_SUN} degrees")));
    }
    // A sun stands where +z is, so that it shines towards −z.
    let placement = aim::read(instance)?.map_or_else(Affine::identity, |aim| aim.backwards());
    let strength = match luminance(instance, "illuminance")? {
        Some(luminance) => luminance,
        None => Strength::Illuminance(brightness(instance, "illuminance", SUNLIGHT)?),
    };
    shine(instance, Emitter::Sun { angle: radians(angle) }, strength, placement)
}

fn environment(instance: &mut Instance) -> Built {
    let zenith = tint(instance, "zenith").unwrap_or([Scalar::ONE, Scalar::ONE, Scalar::ONE]);
    let horizon = tint(instance, "horizon").unwrap_or_else(|| zenith.clone());
    let ground = tint(instance, "ground").unwrap_or_else(|| horizon.clone());
    let strength = Strength::Luminance(brightness(instance, "luminance", SKYLIGHT)?);
    shine(instance, Emitter::Environment { zenith, horizon, ground }, strength, Affine::identity())
}

/// A flat light, which may be aimed.
fn flat(instance: &mut Instance, emitter: Emitter) -> Built {
    let placement = aim::read(instance)?.map_or_else(Affine::identity, |aim| aim.forwards());
    lamp(instance, emitter, placement)
}

/// A light that has a power or a luminance.
fn lamp(instance: &mut Instance, emitter: Emitter, placement: Affine) -> Built {
    let strength = match luminance(instance, "power")? {
        Some(luminance) => luminance,
        None => Strength::Power(brightness(instance, "power", POWER)?),
    };
    shine(instance, emitter, strength, placement)
}

/// Puts a light aside.
fn shine(instance: &mut Instance, emitter: Emitter, strength: Strength, placement: Affine) -> Built {
    instance.without_children();
    if !decide::are_finite(placement.rows().iter().flatten(), instance.head)? {
        return Err(error(instance.place("aim"), "`aim` is too long or too short to be a direction"));
    }
    let light = Light {
        emitter,
        strength,
        color: tint(instance, "color").unwrap_or([Scalar::ONE, Scalar::ONE, Scalar::ONE]),
        two_sided: instance.flag("two_sided", false)?,
        visible: instance.flag("visible", true)?,
        shadows: shadows(instance)?,
    };
    instance.aside.lights.push(PlacedLight { light, placement, span: instance.head });
    Ok(empty(instance.head))
}

/// The luminance, if it is given; it counts more than what else says how bright a light is.
fn luminance(instance: &mut Instance, other: &str) -> Result<Option<Strength>, Stop> {
    let Some(luminance) = instance.number("luminance") else { return Ok(None) };
    if instance.value(other).is_some() {
        instance.warn(instance.place(other), format!("`{other}` is ignored, because `luminance` is given too"));
    }
    check_brightness(&luminance, "luminance", instance.place("luminance"))?;
    Ok(Some(Strength::Luminance(luminance)))
}

fn brightness(instance: &mut Instance, parameter: &str, default: f64) -> Result<Scalar, Stop> {
    let number = instance.number(parameter).unwrap_or(Scalar::from(default));
    check_brightness(&number, parameter, instance.place(parameter))?;
    Ok(number)
}

fn check_brightness(number: &Scalar, parameter: &str, span: Span) -> Result<(), Stop> {
    if !number.is_finite() || decide::is_negative(number, span, "whether a light's brightness is negative")? {
        return Err(error(span, format!("`{parameter}` has to be finite and cannot be negative")));
    }
    let room = Scalar::from(BRIGHTEST) - number.clone();
    let is_too_bright = decide::is_negative(&room, span, "whether a light is too bright")?;
    let is_too_dim = number.constant().is_some_and(|number| number != 0.0 && number < DIMMEST);
    if is_too_bright || is_too_dim {
        let message = format!("`{parameter}` has to be 0, or from {DIMMEST:e} to {BRIGHTEST:e}");
        let beyond = Diagnostic::error(span, message)
            .with_hint("pictures are exposed for their lights, so that numbers in between look the same");
        return Err(Stop::Error(Box::new(beyond)));
    }
    Ok(())
}

/// A colour, of which the opacity does not matter.
fn tint(instance: &mut Instance, parameter: &'static str) -> Option<[Scalar; 3]> {
    let [red, green, blue, _] = colors::read(instance, parameter, "white is used")?;
    Some([red, green, blue])
}

fn shadows(instance: &mut Instance) -> Result<Option<Arc<str>>, Stop> {
    let Some((name, span)) = instance.text("shadows") else { return Ok(None) };
    if SHADOW_METHODS.contains(&&*name) {
        return Ok(Some(name));
    }
    let unknown = Diagnostic::error(span, format!("there is no shadow method \"{name}\""));
    let unknown = match suggest::nearest(&name, SHADOW_METHODS.iter().copied()) {
        Some(near) => {
            unknown.with_hint(format!("did you mean \"{near}\"?")).with_suggestion(span, format!("\"{near}\""))
        }
        None => unknown.with_hint(format!("there are {}", SHADOW_METHODS.join(", "))),
    };
    Err(Stop::Error(Box::new(unknown)))
}

/// What a size has to be at the least. Where a live one may be 0, the light is dark or a point then.
#[derive(Clone, Copy, PartialEq)]
enum Least {
    Zero,
    More,
}

fn check_size(size: &Scalar, least: Least, span: Span) -> Result<(), Stop> {
    if !size.is_finite() {
        return Err(error(span, "the size of a light has to be finite"));
    }
    if decide::is_negative(size, span, "whether a light's size is negative")? {
        return Err(error(span, "the size of a light cannot be negative"));
    }
    if decide::is_negative(&(Scalar::from(LARGEST) - size.clone()), span, "whether a light is too large")? {
        let large = Diagnostic::error(span, "the size of a light cannot be more than 1000 km");
        return Err(Stop::Error(Box::new(large.with_hint("light from very far away is that of a `sun`"))));
    }
    if least == Least::More && size.is(0.0) {
        let none = Diagnostic::error(span, "a light of this shape needs a size");
        return Err(Stop::Error(Box::new(none.with_hint("`sphere_light(r = 0)` is a point"))));
    }
    Ok(())
}
