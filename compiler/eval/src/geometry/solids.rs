//! OpenSCAD's solids: cube, sphere, cylinder.

use std::f64::consts::PI;

use chiaro_plane::{Point, Region};
use chiaro_solid::{Affine, Scalar, Solid, SolidKind};
use chiaro_vocabulary::rows;

use super::arguments::not_finite;
use super::decide::{self, Sign};
use super::facets::apothem_factor;
use super::instance::{Instance, Module, error};
use super::make::{empty, half, moved, offset, prism, region, shape, transformed};
use super::{Built, Stop};

pub(super) const MODULES: &[Module] = &[
    Module { name: "cube", positional: &["size", "center"], named: &["r"], build: cube },
    Module { name: "sphere", positional: &["r"], named: &["d"], build: sphere },
    Module {
        name: "cylinder",
        positional: &["h", "r1", "r2", "center"],
        named: &["r", "d", "d1", "d2", "edge"],
        build: cylinder,
    },
];

fn cube(instance: &mut Instance) -> Built {
    instance.without_children();
    let size = instance.number_or_vector::<3>("size", 3, 0.0).unwrap_or([Scalar::ONE, Scalar::ONE, Scalar::ONE]);
    if !instance.are_sizes(&size, instance.place("size"))? {
        return Ok(empty(instance.head));
    }
    let half = size.map(|side| half(&side));
    let [x, y, z] = half.clone();
    let rounding = instance.rounding("r", &x.min(y).min(z))?;
    let inner = half.clone().map(|side| side - rounding.clone().unwrap_or(Scalar::ZERO));
    let solid = shape(&rows::BOX, inner, instance.head);
    let solid = offset(rounding.unwrap_or(Scalar::ZERO), solid, instance.head);
    let corner = Scalar::ONE - instance.truth("center").unwrap_or(Scalar::ZERO);
    Ok(moved(half.map(|side| side * corner.clone()), solid, instance.head))
}

fn sphere(instance: &mut Instance) -> Built {
    instance.without_children();
    let radius = instance.radius("r", "d").unwrap_or(Scalar::ONE);
    if !instance.are_sizes(std::slice::from_ref(&radius), instance.place_of_radius())? {
        return Ok(empty(instance.head));
    }
    let Some(sides) = instance.sides()? else { return Ok(shape(&rows::SPHERE, [radius], instance.head)) };
    let profile = region(sphere_profile(sides), instance.head);
    let unit = Solid::new(SolidKind::Revolve { sweep: None, facets: Some(sides), child: profile }, instance.head);
    Ok(transformed(Affine::scaling([radius.clone(), radius.clone(), radius]), unit, instance.head))
}

/// The right half of OpenSCAD's unit sphere: rings of corners at equal angles, none at the poles.
fn sphere_profile(sides: u32) -> Region {
    let rings = sides.div_ceil(2);
    let corner = |ring: u32| -> Point {
        let from_pole = PI * (f64::from(ring) + 0.5) / f64::from(rings);
        [from_pole.sin(), from_pole.cos()]
    };
    let top = [0.0, corner(0)[1]];
    let bottom = [0.0, corner(rings - 1)[1]];
    // Anticlockwise: up the axis comes last.
    let down = (0..rings).map(corner);
    let outline: Vec<Point> = std::iter::once(top).chain(down).chain([bottom]).rev().collect();
    Region::polygon(&outline, None)
}

/// A cylinder, cone or frustum between z = 0 and its height.
struct Frustum {
    height: Scalar,
    bottom: Scalar,
    top: Scalar,
}

fn cylinder(instance: &mut Instance) -> Built {
    instance.without_children();
    let Some(frustum) = read_frustum(instance)? else { return Ok(empty(instance.head)) };
    let height = frustum.height.clone();
    let sides = instance.sides()?;
    let solid =
        if is_straight(&frustum) { straight(instance, &frustum, sides)? } else { tapered(instance, frustum, sides)? };
    let centred = instance.truth("center").unwrap_or(Scalar::ZERO);
    let up = half(&height) * (Scalar::ONE - centred);
    Ok(moved([Scalar::ZERO, Scalar::ZERO, up], solid, instance.head))
}

/// The measures of a cylinder, if there is anything to it.
fn read_frustum(instance: &mut Instance) -> Result<Option<Frustum>, Stop> {
    let height = instance.number("h").unwrap_or(Scalar::ONE);
    let both = instance.radius("r", "d");
    let (bottom, top) = (instance.radius("r1", "d1"), instance.radius("r2", "d2"));
    if both.is_some() && (bottom.is_some() || top.is_some()) {
        instance.warn(instance.head, "`r1` and `r2` (or `d1` and `d2`) replace `r` (or `d`), which is given too");
    }
    let bottom = bottom.or(both.clone()).unwrap_or(Scalar::ONE);
    let top = top.or(both).unwrap_or(Scalar::ONE);
    let head = instance.head;
    if !instance.are_sizes(std::slice::from_ref(&height), instance.place("h"))? {
        return Ok(None);
    }
    for (radius, names) in [(&bottom, ["d1", "r1", "d", "r"]), (&top, ["d2", "r2", "d", "r"])] {
        if !radius.is_finite() {
            let given = names.into_iter().find(|name| instance.value(name).is_some()).unwrap_or("r");
            return Err(not_finite(given, radius, instance.place(given)));
        }
        if decide::is_negative(radius, head, "whether a radius is negative")? {
            instance.warn(head, "a radius is negative, so that there is nothing");
            return Ok(None);
        }
    }
    let exists = instance.are_sizes(&[bottom.clone().max(top.clone())], head)?;
    Ok(exists.then_some(Frustum { height, bottom, top }))
}

fn is_straight(frustum: &Frustum) -> bool {
    frustum.bottom == frustum.top
}

/// A cylinder or a prism, centred.
fn straight(instance: &mut Instance, frustum: &Frustum, sides: Option<u32>) -> Built {
    let half_height = half(&frustum.height);
    let factor = sides.map_or(Scalar::ONE, apothem_factor);
    let reach = frustum.bottom.clone() * factor.clone();
    let rounding = instance.rounding("edge", &reach.min(half_height.clone()))?;
    let inset = rounding.clone().unwrap_or(Scalar::ZERO);
    let radius = frustum.bottom.clone() - inset.clone() / factor;
    let inner = half_height - inset.clone();
    let solid = match sides {
        None => shape(&rows::CYLINDER, [radius, inner], instance.head),
        Some(sides) => {
            let base = shape(&rows::NGON, [radius, Scalar::from(f64::from(sides))], instance.head);
            let height = inner.clone() * Scalar::from(2.0);
            moved([Scalar::ZERO, Scalar::ZERO, -inner], prism(height, base, instance.head), instance.head)
        }
    };
    Ok(offset(inset, solid, instance.head))
}

/// A cone or a pyramid, or what is left with its top cut off; centred.
fn tapered(instance: &mut Instance, frustum: Frustum, sides: Option<u32>) -> Built {
    let Frustum { height, bottom, top } = frustum;
    let half_height = half(&height);
    let Some(sides) = sides else {
        let slope = (bottom.clone() - top.clone()) / height.clone();
        return rounded_cone(instance, [bottom, top], half_height, slope);
    };
    if instance.number("edge").is_some() {
        let span = instance.place("edge");
        return Err(error(span, "the edges of a pyramid cannot be rounded yet"));
    }
    let reason = "the shape of a pyramid";
    let known = |number: &Scalar| decide::constant(number, instance.head, reason);
    let (bottom, top, z) = (known(&bottom)?, known(&top)?, known(&half_height)?);
    let profile = Region::polygon(&[[0.0, -z], [bottom, -z], [top, z], [0.0, z]], None);
    let child = region(profile, instance.head);
    Ok(Solid::new(SolidKind::Revolve { sweep: None, facets: Some(sides), child }, instance.head))
}

/// A cone whose rims may be rounded: a smaller one, every face moved in by the radius, grown by it.
fn rounded_cone(instance: &mut Instance, radii: [Scalar; 2], half_height: Scalar, slope: Scalar) -> Built {
    let rounding = instance.rounding("edge", &half_height)?;
    let Some(edge) = rounding else {
        let [bottom, top] = radii;
        return Ok(shape(&rows::CONE, [bottom, top, half_height], instance.head));
    };
    // Going in by `edge` at right angles to the slanted side is going in by this much horizontally.
    let across = edge.clone() * (Scalar::ONE + slope.clone() * slope.clone()).sqrt();
    let climb = edge.clone() * slope;
    let [bottom, top] = radii;
    let bottom = bottom - climb.clone() - across.clone();
    let top = top + climb - across;
    let span = instance.place("edge");
    for radius in [&bottom, &top] {
        if decide::sign(radius, span, "whether rounded edges fit the shape")? == Sign::Negative {
            return Err(error(span, "edges of this radius do not fit the cone: they leave none of its flat ends"));
        }
    }
    let inner = half_height - edge.clone();
    Ok(offset(edge, shape(&rows::CONE, [bottom, top, inner], instance.head), instance.head))
}
