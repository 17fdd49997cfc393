//! Whether solids are convex.

use chiaro_plane::Region;
use chiaro_solid::{Solid, SolidKind};

use super::exactness::is_straight;

/// The vocabulary's convex shapes.
const CONVEX: [&str; 18] = [
    "sphere",
    "box",
    "cylinder",
    "cone",
    "capsule",
    "round_cone",
    "ellipsoid",
    "half_space",
    "tetrahedron",
    "octahedron",
    "dodecahedron",
    "icosahedron",
    "pyramid",
    "dome",
    "circle",
    "rectangle",
    "ngon",
    "ellipse",
];

/// Whether a solid is surely convex.
pub(super) fn is_convex(solid: &Solid) -> bool {
    match &solid.kind {
        SolidKind::Shape(row, _) => CONVEX.contains(&row.name),
        SolidKind::SphereHull(_) => true,
        SolidKind::Region(region) => is_own_hull(&[region]),
        SolidKind::Transform(_, child) | SolidKind::Paint(_, child) => is_convex(child),
        SolidKind::Offset(by, child) => by.range().min >= 0.0 && is_convex(child),
        SolidKind::Extrude { twist, scale, child, .. } => is_straight(twist, scale) && is_convex(child),
        SolidKind::Revolve { sweep: None, child, .. } => match &child.kind {
            SolidKind::Region(half) => is_own_hull(&[half, &half.transform([[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])]),
            _ => false,
        },
        _ => false,
    }
}

/// Whether regions that do not overlap are their own hull.
fn is_own_hull(regions: &[&Region]) -> bool {
    let regions: Vec<Region> = regions.iter().copied().cloned().collect();
    let (own, hull) = (regions.iter().map(Region::area).sum::<f64>(), Region::hull(&regions).area());
    hull - own <= 1e-9 * hull
}
