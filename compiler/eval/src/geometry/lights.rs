//! Lights and the camera: modules that leave no solid behind, but something beside it.

use std::sync::Arc;

use chiaro_solid::{Affine, Camera, Emitter, Light, PlacedLight, SHADOW_METHODS, Scalar, Strength};
use chiaro_syntax::{Diagnostic, Span};

use super::arguments::numbers;
use super::instance::{Instance, Module, error};
use super::make::{empty, radians};
use super::{Built, Stop, colors, decide};
use crate::suggest;
use crate::value::Value;

/// What a scene has beside its solids.
#[derive(Debug, Default)]
pub(crate) struct Aside {
    /// The lights, in the order of the text, each where the transforms around it so far put it.
    pub(crate) lights: Vec<PlacedLight>,
    /// The last camera, and where it is set.
    pub(crate) camera: Option<(Camera, Span)>,
}

macro_rules! light {
    ($name:literal, [$($positional:literal),*], [$($named:literal),*], $build:ident) => {
        Module {
            name: $name,
            positional: &[$($positional),*],
            named: &[$($named,)* "power", "luminance", "color", "visible", "shadows"],
            build: $build,
        }
    };
}

pub(super) const MODULES: &[Module] = &[
    light!("sphere_light", ["r"], ["d"], sphere_light),
    light!("disk_light", ["r"], ["d", "two_sided"], disk_light),
    light!("rect_light", ["size"], ["two_sided"], rect_light),
    light!("tube_light", ["r", "length"], ["d"], tube_light),
    light!("polygon_light", ["points"], ["two_sided"], polygon_light),
    light!("sun", ["angle"], ["illuminance"], sun),
    light!("environment", ["zenith"], ["horizon", "ground"], environment),
    Module { name: "camera", positional: &["eye", "target", "fov"], named: &[], build: camera },
];

/// The luminous flux of a light that doesn't say, in lumens.
const POWER: f64 = 1000.0;
/// The illuminance of a sun that doesn't say, in lux.
const SUNLIGHT: f64 = 100_000.0;
/// The luminance of a sky that doesn't say, in candela per square metre.
const SKY: f64 = 2_000.0;
/// The angle that the sun is seen under, in degrees.
const SUN_ANGLE: f64 = 0.53;

fn sphere_light(instance: &mut Instance) -> Built {
    let radius = instance.radius("r", "d").unwrap_or(Scalar::ONE);
    let place = instance.place_of_radius();
    require(&radius, Least::Zero, place, "a light's radius")?;
    light(instance, Emitter::Sphere { radius })
}

fn disk_light(instance: &mut Instance) -> Built {
    let radius = instance.radius("r", "d").unwrap_or(Scalar::ONE);
    let place = instance.place_of_radius();
    require(&radius, Least::AboveZero, place, "the radius of a flat light")?;
    light(instance, Emitter::Disk { radius })
}

fn rect_light(instance: &mut Instance) -> Built {
    let size = instance.number_or_vector::<2>("size", 2, 0.0).unwrap_or([Scalar::ONE, Scalar::ONE]);
    for side in &size {
        require(side, Least::AboveZero, instance.place("size"), "the side of a light")?;
    }
    light(instance, Emitter::Rect { size })
}

fn tube_light(instance: &mut Instance) -> Built {
    let radius = instance.radius("r", "d").unwrap_or(Scalar::ONE);
    let length = instance.number("length").unwrap_or(Scalar::from(10.0));
    let place = instance.place_of_radius();
    require(&radius, Least::AboveZero, place, "the radius of a tube")?;
    require(&length, Least::AboveZero, instance.place("length"), "the length of a tube")?;
    light(instance, Emitter::Tube { radius, length })
}

fn polygon_light(instance: &mut Instance) -> Built {
    let Some((value, span)) = instance.value("points") else {
        return Err(error(instance.head, "`polygon_light` needs `points`, a list of three or more [x, y]"));
    };
    let point = |value: &Value| match numbers(value).as_deref() {
        Some([x, y, ..]) => Some([x.clone(), y.clone()]),
        _ => None,
    };
    let corners: Option<Vec<[Scalar; 2]>> = match &value {
        Value::List(points) if points.len() >= 3 => points.iter().map(point).collect(),
        _ => None,
    };
    let Some(corners) = corners else {
        return Err(error(span, "`points` of `polygon_light` has to be a list of three or more [x, y]"));
    };
    for coordinate in corners.iter().flatten() {
        require(coordinate, Least::Any, span, "a corner of a light")?;
    }
    light(instance, Emitter::Polygon { corners })
}

fn sun(instance: &mut Instance) -> Built {
    let angle = instance.number("angle").unwrap_or(Scalar::from(SUN_ANGLE));
    require(&angle, Least::Zero, instance.place("angle"), "the angle of a sun")?;
    light(instance, Emitter::Sun { angle: radians(angle.min(Scalar::from(179.0))) })
}

fn environment(instance: &mut Instance) -> Built {
    let white = || [Scalar::ONE, Scalar::ONE, Scalar::ONE];
    let zenith = filter(instance, "zenith").unwrap_or_else(white);
    let horizon = filter(instance, "horizon").unwrap_or_else(|| zenith.clone());
    let ground = filter(instance, "ground").unwrap_or_else(|| horizon.clone());
    light(instance, Emitter::Environment { zenith, horizon, ground })
}

fn camera(instance: &mut Instance) -> Built {
    let eye = instance.vector::<3>("eye", 3, 0.0);
    let target = instance.vector::<3>("target", 3, 0.0);
    let field_of_view = instance.number("fov");
    for (parameter, given) in [("eye", &eye), ("target", &target)] {
        for coordinate in given.iter().flatten() {
            require(coordinate, Least::Any, instance.place(parameter), "a point of the camera")?;
        }
    }
    if let Some(angle) = &field_of_view {
        require(angle, Least::AboveZero, instance.place("fov"), "the field of view")?;
    }
    instance.without_children();
    if let Some((_, first)) = instance.aside.camera {
        let message = "there is another `camera` in the scene; the last one counts";
        instance.report(Diagnostic::warning(instance.head, message).with_related(first, "set here before"));
    }
    let camera = Camera { eye, target, rotation: None, distance: None, field_of_view };
    instance.aside.camera = Some((camera, instance.head));
    Ok(empty(instance.head))
}

/// Puts a light of this shape aside, with what all lights have in common.
fn light(instance: &mut Instance, emitter: Emitter) -> Built {
    instance.without_children();
    let two_sided = instance.flag("two_sided")?;
    let visible = instance.value("visible").is_none() || instance.flag("visible")?;
    let light = Light {
        strength: strength(instance, &emitter)?,
        color: filter(instance, "color").unwrap_or([Scalar::ONE, Scalar::ONE, Scalar::ONE]),
        two_sided,
        visible,
        shadows: shadows(instance)?,
        emitter,
    };
    let placed = PlacedLight { light, placement: Affine::identity(), span: instance.head };
    instance.aside.lights.push(placed);
    Ok(empty(instance.head))
}

fn strength(instance: &mut Instance, emitter: &Emitter) -> Result<Strength, Stop> {
    let given = ["luminance", "power", "illuminance"].map(|name| (name, instance.value(name)));
    let mut given = given.into_iter().filter_map(|(name, value)| value.map(|(_, span)| (name, span)));
    let first = given.next();
    if let (Some((first, _)), Some((second, span))) = (first, given.next()) {
        instance.warn(span, format!("`{second}` is ignored, because `{first}` is given too"));
    }
    let kind: fn(Scalar) -> Strength = match (first.map(|(name, _)| name), emitter) {
        (Some("power"), Emitter::Sun { .. } | Emitter::Environment { .. }) => {
            let message = format!("`{}` is infinitely far away and has no power in lumens", instance.name);
            let hint = match emitter {
                Emitter::Sun { .. } => "give `illuminance`, in lux",
                _ => "give `luminance`, in candela per square metre",
            };
            let diagnostic = Diagnostic::error(instance.place("power"), message).with_hint(hint);
            return Err(Stop::Error(Box::new(diagnostic)));
        }
        (Some("luminance"), _) | (None, Emitter::Environment { .. }) => Strength::Luminance,
        (Some("illuminance"), _) | (None, Emitter::Sun { .. }) => Strength::Illuminance,
        _ => Strength::Power,
    };
    let default = match emitter {
        Emitter::Sun { .. } => SUNLIGHT,
        Emitter::Environment { .. } => SKY,
        _ => POWER,
    };
    let number = first.and_then(|(name, _)| instance.number(name)).unwrap_or(Scalar::from(default));
    require(&number, Least::Zero, first.map_or(instance.head, |(_, span)| span), "the strength of a light")?;
    Ok(kind(number))
}

/// A colour without opacity.
fn filter(instance: &mut Instance, parameter: &str) -> Option<[Scalar; 3]> {
    colors::read_components(instance, parameter).map(|[r, g, b, _]| [r, g, b])
}

fn shadows(instance: &mut Instance) -> Result<Option<Arc<str>>, Stop> {
    let Some((name, span)) = instance.text("shadows") else { return Ok(None) };
    if SHADOW_METHODS.contains(&&*name) {
        return Ok(Some(name));
    }
    let mut unknown = Diagnostic::error(span, format!("there is no shadow method \"{name}\""));
    unknown.hints.extend(suggest::hint(&name, SHADOW_METHODS.iter().copied()));
    Err(Stop::Error(Box::new(unknown.with_hint(format!("there are: {}", SHADOW_METHODS.join(", "))))))
}

/// The least that a number of a light may be.
#[derive(PartialEq)]
enum Least {
    Any,
    Zero,
    AboveZero,
}

fn require(number: &Scalar, least: Least, span: Span, what: &str) -> Result<(), Stop> {
    if number.constant().is_some_and(|value| !value.is_finite()) {
        return Err(error(span, format!("{what} has to be a finite number")));
    }
    let reason = "whether a light's number is allowed";
    if least != Least::Any && decide::is_negative(number, span, reason)? {
        return Err(error(span, format!("{what} can't be negative")));
    }
    if least == Least::AboveZero && number.is(0.0) {
        return Err(error(span, format!("{what} has to be more than zero")));
    }
    Ok(())
}
