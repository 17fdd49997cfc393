//! Convex hulls: of balls and convex polytopes, of upright prisms of one height, and of plane shapes.

use std::sync::Arc;

use chiaro_plane::Region;
use chiaro_solid::{Dimension, Scalar, Solid};
use chiaro_syntax::Span;

use super::balls::Balls;
use super::convexity::is_convex;
use super::instance::{Instance, Module};
use super::make::{empty, moved, prism, region};
use super::outline::outline;
use super::pieces::Prism;
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
    let outlines = operands.iter().map(|operand| outline(operand)).collect::<Result<Vec<_>, Stop>>()?;
    Ok(region(Region::hull(&outlines), span))
}

/// The hull of upright prisms of one height, or of solids made of balls and corners.
fn space_hull(operands: &[Arc<Solid>], span: Span) -> Built {
    let mut prisms = Vec::new();
    if operands.iter().try_for_each(|operand| Prism::all_of(operand, &mut prisms)).is_some()
        && let Some((bottom, height)) = common_extent(&prisms)
    {
        let bases: Vec<Arc<Solid>> = prisms.into_iter().map(|prism| prism.base).collect();
        let base = plane_hull(&bases, span)?;
        return Ok(moved([Scalar::ZERO, Scalar::ZERO, bottom], prism(height, base, span), span));
    }
    let mut balls = Balls::default();
    operands.iter().try_for_each(|operand| balls.add(operand, span))?;
    balls.hull(span)
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
