//! Nodes of the solid tree, made so that the tree's laws hold: what is empty swallows the operators above it.

use std::sync::Arc;

use chiaro_plane::Region;
use chiaro_solid::{Affine, Scalar, Solid, SolidKind};
use chiaro_syntax::Span;
use chiaro_vocabulary::Row;

/// No point at all.
pub(super) fn empty(span: Span) -> Arc<Solid> {
    Solid::new(SolidKind::Empty, span)
}

/// Whether a solid is empty.
pub(super) fn is_empty(solid: &Solid) -> bool {
    matches!(solid.kind, SolidKind::Empty)
}

/// A shape of the vocabulary.
pub(super) fn shape(row: &'static Row, arguments: impl Into<Vec<Scalar>>, span: Span) -> Arc<Solid> {
    let arguments = arguments.into();
    debug_assert_eq!(row.arity(), arguments.len(), "{}", row.name);
    Solid::new(SolidKind::Shape(row, arguments), span)
}

/// A plane shape with that outline.
pub(super) fn region(region: Region, span: Span) -> Arc<Solid> {
    if region.is_empty() { empty(span) } else { Solid::new(SolidKind::Region(Arc::new(region)), span) }
}

/// A solid under a regular map; for a plane shape, the map keeps the plane.
pub(super) fn transformed(map: Affine, child: Arc<Solid>, span: Span) -> Arc<Solid> {
    let is_identity = map.is_translation() && (0..3).all(|i| map.rows()[i][3].is(0.0));
    if is_empty(&child) || is_identity {
        return child;
    }
    Solid::new(SolidKind::Transform(map, child), span)
}

/// A solid, moved.
pub(super) fn moved(by: [Scalar; 3], child: Arc<Solid>, span: Span) -> Arc<Solid> {
    transformed(Affine::translation(by), child, span)
}

/// A solid, grown by a distance (shrunk, if negative).
pub(super) fn offset(by: Scalar, child: Arc<Solid>, span: Span) -> Arc<Solid> {
    if is_empty(&child) || by.is(0.0) {
        return child;
    }
    Solid::new(SolidKind::Offset(by, child), span)
}

/// A plane shape, drawn out from z = 0 to a positive height.
pub(super) fn prism(height: Scalar, child: Arc<Solid>, span: Span) -> Arc<Solid> {
    if is_empty(&child) {
        return child;
    }
    let straight = SolidKind::Extrude { height, twist: Scalar::ZERO, scale: [Scalar::ONE, Scalar::ONE], child };
    Solid::new(straight, span)
}

/// Half of a number.
pub(super) fn half(number: &Scalar) -> Scalar {
    number.clone() * Scalar::from(0.5)
}

/// An angle in radians.
pub(super) fn radians(degrees: Scalar) -> Scalar {
    degrees * Scalar::from(std::f64::consts::PI / 180.0)
}
