//! Between plane shapes and solids: `linear_extrude`, `rotate_extrude`, `projection`; and `twist`.

use std::sync::Arc;

use chiaro_plane::Region;
use chiaro_solid::{Affine, Boolean, Dimension, Scalar, Solid, SolidKind};
use chiaro_syntax::{Diagnostic, Span};
use chiaro_vocabulary::rows;

use super::decide::{self, Sign};
use super::extent::{self, Extent};
use super::instance::{Instance, Module, error};
use super::make::{self, empty, half, is_empty, moved, radians, region, shape, transformed};
use super::outline::{grown_region, opened, outline};
use super::pieces::{Ball, Prism};
use super::stages::{Change, staged};
use super::{Built, Stop};

pub(super) const MODULES: &[Module] = &[
    Module {
        name: "linear_extrude",
        positional: &["height", "v", "scale", "center", "twist", "slices", "segments"],
        named: &["h", "r"],
        build: linear_extrude,
    },
    Module { name: "rotate_extrude", positional: &["angle", "start"], named: &["a", "r"], build: rotate_extrude },
    Module { name: "projection", positional: &["cut"], named: &[], build: projection },
    Module { name: "twist", positional: &["rate"], named: &[], build: twist },
];

fn linear_extrude(instance: &mut Instance) -> Built {
    let child = instance.union_in(Dimension::Plane);
    let [x, y, height] = read_direction(instance);
    if is_empty(&child) || !instance.are_sizes(std::slice::from_ref(&height), instance.head)? {
        return Ok(empty(instance.head));
    }
    let twist = instance.number("twist").filter(Scalar::is_finite).unwrap_or(Scalar::ZERO);
    let scale = read_scale(instance)?;
    let straight = twist.is(0.0) && scale.iter().all(|factor| factor.is(1.0));
    let solid = match instance.number("r") {
        Some(_) if straight => rounded_prism(instance, height.clone(), child)?,
        Some(_) => {
            return Err(error(instance.place("r"), "the edges of a twisted or scaled extrusion cannot be rounded yet"));
        }
        None => {
            let change = Change { height: &height, twist: &twist, scale: &scale };
            match staged(instance, &change, &child)? {
                Some(stages) => stages,
                None => {
                    // OpenSCAD's twist turns clockwise.
                    let twist = radians(-twist);
                    Solid::new(SolidKind::Extrude { height: height.clone(), twist, scale, child }, instance.head)
                }
            }
        }
    };
    let leaning = lean(&x, &y, &height, solid, instance.head);
    let back = -half(&instance.truth("center").unwrap_or(Scalar::ZERO));
    Ok(moved([x, y, height].map(|component| component * back.clone()), leaning, instance.head))
}

/// The vector from the bottom to the top: `v`, made as long as `height` if that is given too.
fn read_direction(instance: &mut Instance) -> [Scalar; 3] {
    let height = read_height(instance);
    let upright = |height: Scalar| [Scalar::ZERO, Scalar::ZERO, height];
    match (instance.vector::<3>("v", 3, 0.0), height) {
        (None, height) => upright(height.unwrap_or(Scalar::from(100.0))),
        (Some(v), None) => v,
        (Some([x, y, _]), Some(height)) if x.is(0.0) && y.is(0.0) => upright(height),
        (Some(v), Some(height)) => {
            let squares = v.iter().map(|c| c.clone() * c.clone());
            let length = squares.fold(Scalar::ZERO, |sum, square| sum + square).sqrt();
            v.map(|c| c * height.clone() / length.clone())
        }
    }
}

/// The height; 100 if it is no finite number.
fn read_height(instance: &mut Instance) -> Option<Scalar> {
    let default = || Some(Scalar::from(100.0));
    let parameter = if instance.value("height").is_some() { "height" } else { "h" };
    instance.value(parameter)?;
    let Some(height) = instance.number(parameter) else { return default() };
    if !height.is_finite() {
        instance.warn(instance.place(parameter), "this height is not finite; the default of 100 is used");
        return default();
    }
    Some(height)
}

/// How the top is scaled; what is negative counts as zero.
fn read_scale(instance: &mut Instance) -> Result<[Scalar; 2], Stop> {
    let scale = instance.number_or_vector::<2>("scale", 2, 1.0).unwrap_or([Scalar::ONE, Scalar::ONE]);
    let span = instance.place("scale");
    for factor in &scale {
        if !factor.is_finite() {
            instance.warn(span, "this scale is not finite and does not count");
            return Ok([Scalar::ONE, Scalar::ONE]);
        }
        if decide::is_negative(factor, span, "whether a scale is negative")? {
            instance.warn(span, "this scale is negative: 0 is used");
        }
    }
    Ok(scale.map(|factor| if factor.range().min < 0.0 { Scalar::ZERO } else { factor }))
}

/// A straight extrusion whose edges are rounded: of the shrunk shape, grown again. Corners of the shape become round
/// too, as far as they are convex.
fn rounded_prism(instance: &mut Instance, height: Scalar, child: Arc<Solid>) -> Built {
    let Some(radius) = instance.rounding("r", &half(&height))? else {
        return Ok(make::prism(height, child, instance.head));
    };
    let span = instance.place("r");
    let known = decide::constant(&radius, span, "the radius of an extrusion's edges")?;
    let core = grown_region(&child, -known, chiaro_plane::Join::Round)?;
    if core.is_empty() {
        return Err(error(span, "edges of this radius do not fit the shape: it is narrower than twice the radius"));
    }
    let inner = height - radius.clone() * Scalar::from(2.0);
    // A sheet without thickness is as good to grow as any.
    let core = make::prism(inner, region(core, instance.head), instance.head);
    let core = moved([Scalar::ZERO, Scalar::ZERO, radius.clone()], core, instance.head);
    Ok(make::offset(radius, core, instance.head))
}

/// A solid whose layers are moved along (x, y) up to the height.
fn lean(x: &Scalar, y: &Scalar, height: &Scalar, solid: Arc<Solid>, span: Span) -> Arc<Solid> {
    if x.is(0.0) && y.is(0.0) {
        return solid;
    }
    let (zero, one) = (|| Scalar::ZERO, || Scalar::ONE);
    let rows = [
        [one(), zero(), x.clone() / height.clone(), zero()],
        [zero(), one(), y.clone() / height.clone(), zero()],
        [zero(), zero(), one(), zero()],
    ];
    transformed(Affine::new(rows), solid, span)
}

fn rotate_extrude(instance: &mut Instance) -> Built {
    let child = instance.union_in(Dimension::Plane);
    if is_empty(&child) {
        return Ok(child);
    }
    let Some(turn) = read_turn(instance)? else { return Ok(empty(instance.head)) };
    let child = rounded_profile(instance, child)?;
    let (profile, mirrored) = match side(&child)? {
        Extent::Right => (child, false),
        Extent::Left => (flipped(child, instance.head), true),
        Extent::Both => return Err(on_both_sides(instance.head, &child)),
    };
    let facets = instance.sides()?;
    let Some(sweep) = turn.sweep else {
        // Without facets, it makes no difference where a full turn starts.
        let solid = Solid::new(SolidKind::Revolve { sweep: None, facets, child: profile }, instance.head);
        let start = if facets.is_some() { turn.start } else { Scalar::ZERO };
        return Ok(transformed(Affine::rotation(2, start), solid, instance.head));
    };
    let opposite = Scalar::from(if mirrored { 180.0 } else { 0.0 });
    let start = turn.start + opposite;
    let Some(sides) = facets else {
        let sweep = Some([radians(start), radians(sweep)]);
        return Ok(Solid::new(SolidKind::Revolve { sweep, facets: None, child: profile }, instance.head));
    };
    faceted_sector(instance, start, sweep, sides, profile)
}

/// How far a profile is turned, in degrees.
struct Turn {
    start: Scalar,
    /// Positive; none for a full turn.
    sweep: Option<Scalar>,
}

/// The turn, if it is any. A negative angle turns clockwise.
fn read_turn(instance: &mut Instance) -> Result<Option<Turn>, Stop> {
    let angle = instance.number("angle").or_else(|| instance.number("a"));
    let given = angle.is_some();
    let start = instance.number("start").filter(Scalar::is_finite);
    let start = start.unwrap_or(Scalar::from(if given { 0.0 } else { 180.0 }));
    let Some(angle) = angle.filter(Scalar::is_finite) else { return Ok(Some(Turn { start, sweep: None })) };
    let span = instance.head;
    let reason = "how far a profile is turned";
    let negative = match decide::sign(&angle, span, reason)? {
        Sign::Zero => return Ok(None),
        sign => sign == Sign::Negative,
    };
    let sweep = if negative { -angle.clone() } else { angle.clone() };
    let is_partial = decide::is_negative(&(sweep.clone() - Scalar::from(360.0)), span, reason)?;
    let start = if negative { start + angle } else { start };
    Ok(Some(Turn { start, sweep: is_partial.then_some(sweep) }))
}

/// A sector with flat sides. Only sectors that are a whole number of sides of a full turn are known.
fn faceted_sector(instance: &mut Instance, start: Scalar, sweep: Scalar, sides: u32, profile: Arc<Solid>) -> Built {
    let degrees = decide::constant(&sweep, instance.head, "the sides of a partial turn")?;
    // OpenSCAD divides the sector into as many equal sides as whole ones of a full turn fit in, one at the least.
    let count = (f64::from(sides) * degrees / 360.0 + 1e-9).floor().max(1.0);
    let full = 360.0 * count / degrees;
    if (full - full.round()).abs() > 1e-6 || full < 2.5 {
        let message = format!("{count} flat sides in {degrees}° are not supported yet: this curve is a true curve");
        instance.report(Diagnostic::warning(instance.head, message));
        let sweep = Some([radians(start), radians(sweep)]);
        return Ok(Solid::new(SolidKind::Revolve { sweep, facets: None, child: profile }, instance.head));
    }
    let (facets, sweep) = (Some(full.round() as u32), Some([Scalar::ZERO, radians(sweep)]));
    let solid = Solid::new(SolidKind::Revolve { sweep, facets, child: profile }, instance.head);
    Ok(transformed(Affine::rotation(2, start), solid, instance.head))
}

/// A profile with its edges rounded, as far as they are convex; where it touches the axis there is no edge.
fn rounded_profile(instance: &mut Instance, child: Arc<Solid>) -> Built {
    let Some(radius) = instance.finite_number("r")? else { return Ok(child) };
    let span = instance.place("r");
    match decide::sign(&radius, span, "whether edges are rounded")? {
        Sign::Zero => return Ok(child),
        Sign::Negative => return Err(error(span, "`r` is the radius of rounded edges and cannot be negative")),
        Sign::Positive => {}
    }
    let radius = decide::constant(&radius, span, "the radius of a revolution's edges")?;
    let side = outline(&child)?;
    let Some((min, max)) = side.bounds() else { return Ok(empty(instance.head)) };
    let whole = Region::union(&[side.clone(), side.transform([[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])]);
    let half_plane = if max[0] > -min[0] {
        Region::rectangle([0.0, min[1] - 1.0], [max[0] + 1.0, max[1] + 1.0])
    } else {
        Region::rectangle([min[0] - 1.0, min[1] - 1.0], [0.0, max[1] + 1.0])
    };
    let rounded = Region::intersection(&[opened(&whole, radius, span)?, half_plane]);
    if rounded.is_empty() {
        return Err(error(span, "edges of this radius do not fit the shape: it is narrower than twice the radius"));
    }
    Ok(region(rounded, instance.head))
}

/// On which side of the axis a profile lies.
fn side(child: &Solid) -> Result<Extent, Stop> {
    match extent::side_of_axis(child) {
        // The box around a shape may be larger than the shape: its outline tells.
        Extent::Both => Ok(extent::side_of_outline(&outline(child)?)),
        side => Ok(side),
    }
}

fn flipped(child: Arc<Solid>, span: Span) -> Arc<Solid> {
    transformed(Affine::scaling([Scalar::from(-1.0), Scalar::ONE, Scalar::ONE]), child, span)
}

fn on_both_sides(span: Span, child: &Solid) -> Stop {
    let diagnostic = Diagnostic::error(span, "the profile of `rotate_extrude` lies on both sides of the axis x = 0")
        .with_related(child.span, "the profile")
        .with_hint("intersect it with the half plane x > 0, or move it");
    Stop::Error(Box::new(diagnostic))
}

/// The cut through the plane z = 0, or the shadow that falls on it along z.
fn projection(instance: &mut Instance) -> Built {
    let child = instance.union_in(Dimension::Space);
    if is_empty(&child) {
        return Ok(child);
    }
    if instance.flag("cut", false)? {
        Ok(Solid::new(SolidKind::Slice(child), instance.head))
    } else {
        shadow(&child, instance.head)
    }
}

fn shadow(solid: &Arc<Solid>, span: Span) -> Built {
    if let SolidKind::Boolean { operation: Boolean::Union, joint: None, children } = &solid.kind {
        let children = children.iter().map(|child| shadow(child, span)).collect::<Result<Vec<_>, Stop>>()?;
        return Ok(Solid::new(SolidKind::Boolean { operation: Boolean::Union, joint: None, children }, span));
    }
    if let Some(prism) = Prism::of(solid) {
        return Ok(prism.base);
    }
    if let Some(Ball { center: [x, y, _], radius, .. }) = Ball::of(solid) {
        return Ok(moved([x, y, Scalar::ZERO], shape(&rows::CIRCLE, [radius], span), span));
    }
    let diagnostic = Diagnostic::error(span, "the shadow of this solid is not supported yet")
        .with_related(solid.span, "because of this")
        .with_hint("shadows of balls and upright prisms are, and with `cut = true` the cut through any solid");
    Err(Stop::Error(Box::new(diagnostic)))
}

/// Turns a solid about z by `rate` degrees for each millimetre of height, anticlockwise seen from above.
fn twist(instance: &mut Instance) -> Built {
    let child = instance.union_in(Dimension::Space);
    let Some(rate) = instance.finite_number("rate")? else {
        let message = "`twist` needs its `rate` in degrees per millimetre of height; without, it does nothing";
        instance.warn(instance.head, message);
        return Ok(child);
    };
    if is_empty(&child) || rate.is(0.0) {
        return Ok(child);
    }
    Ok(Solid::new(SolidKind::Twist(radians(rate), child), instance.head))
}
