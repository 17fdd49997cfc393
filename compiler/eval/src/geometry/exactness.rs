//! How much a solid's distance can be trusted. Offsets need this: moving the surface by a distance is right only where
//! that distance is exact.

use std::sync::Arc;

use chiaro_solid::affine::Similarity;
use chiaro_solid::{Boolean, Scalar, Solid, SolidKind};
use chiaro_vocabulary::Class;

/// What is known of the distance to a solid that is computed from its tree.
pub(super) fn class(solid: &Solid) -> Class {
    match &solid.kind {
        SolidKind::Empty | SolidKind::Region(_) => Class::Exact,
        SolidKind::Shape(row, _) => row.class,
        SolidKind::SphereHull(_) => Class::ExactOutside,
        // Outside, the nearest of the operands is the nearest point of all; inside, the others' insides count too.
        SolidKind::Boolean { operation: Boolean::Union, joint: None, children } => outside_at_best(worst(children)),
        SolidKind::Boolean { .. } => Class::Bound,
        SolidKind::Transform(map, child) => match map.similarity() {
            Similarity::Uniform(_) => class(child),
            Similarity::AtLeast(_) => Class::Bound,
        },
        SolidKind::Paint(_, child) => class(child),
        SolidKind::Offset(by, child) if by.range().min >= 0.0 => outside_at_best(class(child)),
        SolidKind::Offset(..) => Class::Bound,
        SolidKind::Shell(_, child) if class(child) == Class::Exact => Class::ExactOutside,
        SolidKind::Shell(..) | SolidKind::Twist(..) | SolidKind::Loft(_) | SolidKind::Slice(_) => Class::Bound,
        SolidKind::Extrude { twist, scale, child, .. } if is_straight(twist, scale) => class(child),
        SolidKind::Revolve { sweep: None, facets: None, child } => class(child),
        SolidKind::Extrude { .. } | SolidKind::Revolve { .. } => Class::Bound,
    }
}

/// The class where insides are no longer exact.
///
/// It is a call of its own, because rustc 1.95 with optimisation turns `class(child).max(…)` at the end of the recursion
/// into a loop that applies the maximum to every solid.
#[inline(never)]
fn outside_at_best(class: Class) -> Class {
    class.max(Class::ExactOutside)
}

/// Whether an extrusion neither turns nor scales.
pub(super) fn is_straight(twist: &Scalar, scale: &[Scalar; 2]) -> bool {
    twist.is(0.0) && scale.iter().all(|factor| factor.is(1.0))
}

/// The part of a solid that keeps its distance from being of the class needed; the solid itself at the least.
pub(super) fn culprit(solid: &Arc<Solid>, needed: Class) -> &Arc<Solid> {
    let children: &[Arc<Solid>] = match &solid.kind {
        SolidKind::Boolean { operation: Boolean::Union, joint: None, children } => children,
        SolidKind::Transform(map, child) if matches!(map.similarity(), Similarity::Uniform(_)) => {
            std::slice::from_ref(child)
        }
        SolidKind::Paint(_, child) | SolidKind::Offset(_, child) | SolidKind::Shell(_, child) => {
            std::slice::from_ref(child)
        }
        SolidKind::Extrude { child, .. } | SolidKind::Revolve { child, .. } => std::slice::from_ref(child),
        _ => &[],
    };
    match children.iter().find(|child| class(child) > needed) {
        Some(child) => culprit(child, needed),
        None => solid,
    }
}

fn worst(children: &[Arc<Solid>]) -> Class {
    children.iter().map(|child| class(child)).max().unwrap_or(Class::Exact)
}
