//! Convex hulls: of balls and convex polytopes, of upright prisms of one height, and of plane shapes.

use std::sync::Arc;

use chiaro_plane::Region;
use chiaro_solid::{Dimension, Scalar, Solid, SolidKind};
use chiaro_syntax::Span;

use super::balls::Balls;
use super::convexity::is_convex;
use super::instance::{Instance, Module};
use super::make::{empty, moved, prism, region};
use super::outline::outline;
use super::pieces::Prism;
use super::vectors::{Point, cross, dot, length, normalised, sub};
use super::{Built, Stop};

/// The modules that make the hull of what they make from no more than the hulls of their children.
const OF_HULLS: [&str; 11] = [
    "translate",
    "rotate",
    "scale",
    "mirror",
    "multmatrix",
    "resize",
    "union",
    "group",
    "render",
    "color",
    "minkowski",
];

/// How flat a hull of corners is that counts as empty, relative to its size.
const TOLERANCE: f64 = 1e-9;

pub(super) const MODULES: &[Module] = &[Module { name: "hull", positional: &[], named: &[], build: hull }];

/// Whether all that counts of a module's children is their convex hull, if that is so of the module itself or not.
pub(crate) fn only_hull_counts(module: &str, of_itself: bool) -> bool {
    module == "hull" || of_itself && OF_HULLS.contains(&module)
}

fn hull(instance: &mut Instance) -> Built {
    let operands = instance.operands();
    let hull = match operands.as_slice() {
        [] => return Ok(empty(instance.head)),
        [only] if is_convex(only) => only.clone(),
        _ if operands[0].dimension() == Some(Dimension::Plane) => plane_hull(&operands, instance.head)?,
        _ => space_hull(&operands, instance.head)?,
    };
    Ok(if is_flat(&hull) { empty(instance.head) } else { hull })
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

/// Whether a hull is one of corners in a plane.
fn is_flat(hull: &Solid) -> bool {
    match &hull.kind {
        SolidKind::Transform(_, child) | SolidKind::Paint(_, child) => is_flat(child),
        SolidKind::SphereHull(balls) => {
            let corner = |(center, radius): &([Scalar; 3], Scalar)| {
                let [x, y, z] = center;
                radius.is(0.0).then_some([x.constant()?, y.constant()?, z.constant()?])
            };
            balls.iter().map(corner).collect::<Option<Vec<_>>>().is_some_and(|corners| are_coplanar(&corners))
        }
        _ => false,
    }
}

/// Whether points are in one plane, judged by three of them that are far from each other.
fn are_coplanar(points: &[Point]) -> bool {
    let Some(origin) = points.first() else { return true };
    let arms: Vec<Point> = points.iter().map(|point| sub(*point, *origin)).collect();
    let longest = farthest(&arms, length);
    let along = normalised(longest);
    let widest = farthest(&arms, |arm| length(cross(arm, along)));
    let normal = normalised(cross(widest, along));
    arms.iter().all(|arm| dot(*arm, normal).abs() <= TOLERANCE * length(longest))
}

/// The vector of which the measure is greatest; zero if there is none.
fn farthest(vectors: &[Point], measure: impl Fn(Point) -> f64) -> Point {
    let greatest = vectors.iter().max_by(|a, b| measure(**a).total_cmp(&measure(**b)));
    greatest.copied().unwrap_or_default()
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
