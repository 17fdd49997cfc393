//! Convex hulls: of balls and points, of upright prisms of one height, and of plane shapes.

use std::sync::Arc;

use chiaro_plane::Region;
use chiaro_solid::affine::Similarity;
use chiaro_solid::{Affine, Boolean, Dimension, Scalar, Solid, SolidKind};
use chiaro_syntax::{Diagnostic, Span};

use super::exactness::is_straight;
use super::instance::{Instance, Module};
use super::make::{empty, moved, prism, region};
use super::outline::outline;
use super::pieces::{Prism, image};
use super::{Built, Stop};

pub(super) const MODULES: &[Module] = &[Module { name: "hull", positional: &[], named: &[], build: hull }];

fn hull(instance: &mut Instance) -> Built {
    let operands = instance.operands();
    match operands.as_slice() {
        [] => Ok(empty(instance.head)),
        [only] if is_convex(only) => Ok(only.clone()),
        _ if operands[0].dimension() == Some(Dimension::Plane) => plane_hull(&operands, instance.head),
        _ => space_hull(&operands, instance.head),
    }
}

fn plane_hull(operands: &[Arc<Solid>], span: Span) -> Built {
    let outlines = operands.iter().map(|operand| outline(operand)).collect::<Result<Vec<_>, _>>()?;
    Ok(region(Region::hull(&outlines), span))
}

/// The hull of solids made of balls, or of prisms that stand side by side.
fn space_hull(operands: &[Arc<Solid>], span: Span) -> Built {
    let mut balls = Vec::new();
    let made_of_balls = operands.iter().try_for_each(|operand| hull_balls(operand, &Affine::identity(), &mut balls));
    let Err(other) = made_of_balls else {
        return Ok(Solid::new(SolidKind::SphereHull(balls), span));
    };
    let mut prisms = Vec::new();
    if operands.iter().try_for_each(|operand| Prism::all_of(operand, &mut prisms)).is_some()
        && let Some((bottom, height)) = common_extent(&prisms)
    {
        let bases: Vec<Arc<Solid>> = prisms.into_iter().map(|prism| prism.base).collect();
        let base = plane_hull(&bases, span)?;
        return Ok(moved([Scalar::ZERO, Scalar::ZERO, bottom], prism(height, base, span), span));
    }
    let diagnostic = Diagnostic::error(span, "the hull of these solids is not supported yet")
        .with_related(other.span, "for one, this is no ball")
        .with_hint(
            "hulls are made of balls, of boxes, of upright prisms and cylinders of equal height, and of plane shapes",
        );
    Err(Stop::Error(Box::new(diagnostic)))
}

/// Where all of the prisms start and how high they are, if they agree.
fn common_extent(prisms: &[Prism]) -> Option<(Scalar, Scalar)> {
    let (first, others) = prisms.split_first()?;
    let agrees = |prism: &Prism| is_same(&prism.bottom, &first.bottom) && is_same(&prism.height, &first.height);
    others.iter().all(agrees).then(|| (first.bottom.clone(), first.height.clone()))
}

/// Whether two lengths are equal up to what dumps round off.
fn is_same(a: &Scalar, b: &Scalar) -> bool {
    match (a.constant(), b.constant()) {
        (Some(a), Some(b)) => (a - b).abs() <= 1e-5 * a.abs().max(b.abs()).max(1e-3),
        _ => a == b,
    }
}

/// Adds the balls, under a map, whose hull is a solid's hull. The error is what has none.
fn hull_balls(solid: &Arc<Solid>, map: &Affine, balls: &mut Vec<([Scalar; 3], Scalar)>) -> Result<(), Arc<Solid>> {
    match &solid.kind {
        SolidKind::Shape(row, arguments) => {
            let own = shape_balls(row.name, arguments).ok_or_else(|| solid.clone())?;
            add_balls(&own, map, solid, balls)
        }
        SolidKind::SphereHull(own) => add_balls(own, map, solid, balls),
        SolidKind::Boolean { operation: Boolean::Union, joint: None, children } => {
            children.iter().try_for_each(|child| hull_balls(child, map, balls))
        }
        SolidKind::Transform(inner, child) => hull_balls(child, &map.after(inner), balls),
        SolidKind::Paint(_, child) => hull_balls(child, map, balls),
        SolidKind::Offset(by, child) if by.range().min >= 0.0 => {
            let mut own = Vec::new();
            hull_balls(child, &Affine::identity(), &mut own)?;
            own.iter_mut().for_each(|(_, radius)| *radius = radius.clone() + by.clone());
            add_balls(&own, map, solid, balls)
        }
        _ => Err(solid.clone()),
    }
}

/// The balls, points among them, whose hull is that of a shape.
fn shape_balls(name: &str, arguments: &[Scalar]) -> Option<Vec<([Scalar; 3], Scalar)>> {
    let zero = || Scalar::ZERO;
    match (name, arguments) {
        ("sphere", [radius]) => Some(vec![([zero(), zero(), zero()], radius.clone())]),
        ("capsule", [height, radius]) => {
            Some(vec![([zero(), zero(), zero()], radius.clone()), ([zero(), zero(), height.clone()], radius.clone())])
        }
        ("round_cone", [bottom, top, height]) => {
            Some(vec![([zero(), zero(), zero()], bottom.clone()), ([zero(), zero(), height.clone()], top.clone())])
        }
        ("box", half) => {
            let side = |corner: usize, axis: usize| {
                let side = half[axis].clone();
                if corner >> axis & 1 == 1 { side } else { -side }
            };
            Some((0..8).map(|corner| (std::array::from_fn(|axis| side(corner, axis)), zero())).collect())
        }
        _ => None,
    }
}

fn add_balls(
    own: &[([Scalar; 3], Scalar)],
    map: &Affine,
    solid: &Arc<Solid>,
    balls: &mut Vec<([Scalar; 3], Scalar)>,
) -> Result<(), Arc<Solid>> {
    for (center, radius) in own {
        // Points stay points under any map, but balls only under similarities.
        let radius = match map.similarity() {
            _ if radius.is(0.0) => Scalar::ZERO,
            Similarity::Uniform(factor) => radius.clone() * factor,
            Similarity::AtLeast(_) => return Err(solid.clone()),
        };
        balls.push((image(map, center), radius));
    }
    Ok(())
}

/// Whether a solid is surely convex.
fn is_convex(solid: &Solid) -> bool {
    match &solid.kind {
        SolidKind::Shape(row, _) => matches!(
            row.name,
            "sphere"
                | "box"
                | "cylinder"
                | "cone"
                | "capsule"
                | "round_cone"
                | "ellipsoid"
                | "half_space"
                | "octahedron"
                | "pyramid"
                | "circle"
                | "rectangle"
                | "ngon"
                | "ellipse"
        ),
        SolidKind::SphereHull(_) => true,
        SolidKind::Transform(_, child) | SolidKind::Paint(_, child) => is_convex(child),
        SolidKind::Offset(by, child) => by.range().min >= 0.0 && is_convex(child),
        SolidKind::Extrude { twist, scale, child, .. } => is_straight(twist, scale) && is_convex(child),
        _ => false,
    }
}
