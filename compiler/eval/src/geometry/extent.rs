//! How far solids reach: exact boxes for `resize`, and sides of the axis for `rotate_extrude`.

use std::sync::Arc;

use chiaro_plane::Region;
use chiaro_solid::{Affine, Boolean, Scalar, Solid, SolidKind};
use chiaro_vocabulary::{Bounds, Interval};

use super::exactness::is_straight;

/// Where a profile lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Extent {
    /// At x ≥ 0.
    Right,
    /// At x ≤ 0.
    Left,
    /// On both sides.
    Both,
}

/// How far a profile may cross the axis, relative to its extent: dumps round to six digits.
const TOLERANCE: f64 = 1e-5;

/// Where a plane shape lies, as far as boxes around it tell, for all values of live numbers.
pub(super) fn side_of_axis(solid: &Solid) -> Extent {
    side(horizontal(solid))
}

/// Where an outline lies.
pub(super) fn side_of_outline(outline: &Region) -> Extent {
    outline.bounds().map_or(Extent::Right, |(min, max)| side(Interval::new(min[0], max[0])))
}

fn side(x: Interval) -> Extent {
    let tolerance = TOLERANCE * x.magnitude();
    if x.min >= -tolerance {
        Extent::Right
    } else if x.max <= tolerance {
        Extent::Left
    } else {
        Extent::Both
    }
}

/// A range that holds the x of all points of a plane shape.
fn horizontal(solid: &Solid) -> Interval {
    plane_box(solid).axis(0)
}

/// A box around a plane shape, for all values of live numbers.
fn plane_box(solid: &Solid) -> Bounds {
    match &solid.kind {
        SolidKind::Shape(row, arguments) => (row.bounds)(&arguments.iter().map(Scalar::range).collect::<Vec<_>>()),
        SolidKind::Region(region) => region_box(region),
        SolidKind::Boolean { operation: Boolean::Difference, children, .. } => plane_box(&children[0]),
        SolidKind::Boolean { children, .. } => {
            children.iter().fold(Bounds::EMPTY, |all, child| all.union(&plane_box(child)))
        }
        SolidKind::Transform(map, child) => image(map, &plane_box(child)),
        SolidKind::Paint(_, child) => plane_box(child),
        SolidKind::Offset(by, child) => plane_box(child).inflate(by.range().max.max(0.0)),
        SolidKind::Shell(thickness, child) => plane_box(child).inflate(0.5 * thickness.range().max),
        _ => Bounds::ALL,
    }
}

fn region_box(region: &Region) -> Bounds {
    region.bounds().map_or(Bounds::EMPTY, |(min, max)| {
        Bounds::new(Interval::new(min[0], max[0]), Interval::new(min[1], max[1]), Interval::ALL)
    })
}

/// A box around a box under a map.
fn image(map: &Affine, bounds: &Bounds) -> Bounds {
    let axis = |i: usize| {
        let row = &map.rows()[i];
        (0..3).fold(row[3].range(), |sum, j| if row[j].is(0.0) { sum } else { sum + row[j].range() * bounds.axis(j) })
    };
    if bounds.is_empty() { *bounds } else { Bounds::new(axis(0), axis(1), axis(2)) }
}

/// The smallest box around a solid without live numbers, if it is known. That of a plane shape is all of z.
pub(super) fn exact_box(solid: &Arc<Solid>) -> Option<Bounds> {
    match &solid.kind {
        SolidKind::Shape(row, arguments) => {
            let arguments: Option<Vec<f64>> = arguments.iter().map(Scalar::constant).collect();
            let arguments: Vec<Interval> = arguments?.into_iter().map(Interval::point).collect();
            fits_its_box(row.name).then(|| (row.bounds)(&arguments))
        }
        SolidKind::Region(region) => Some(region_box(region)),
        SolidKind::Boolean { operation: Boolean::Union, joint: None, children } => {
            children.iter().try_fold(Bounds::EMPTY, |all, child| Some(all.union(&exact_box(child)?)))
        }
        SolidKind::Transform(map, child) if keeps_axes(map) => Some(image(map, &exact_box(child)?)),
        SolidKind::Transform(map, child) => corners_box(map, child),
        SolidKind::Paint(_, child) => exact_box(child),
        SolidKind::Offset(by, child) => {
            by.constant().filter(|by| *by > 0.0).and_then(|by| Some(exact_box(child)?.inflate(by)))
        }
        SolidKind::Extrude { height, twist, scale, child } if is_straight(twist, scale) => {
            let base = exact_box(child)?;
            Some(Bounds::new(base.axis(0), base.axis(1), Interval::new(0.0, height.constant()?)))
        }
        SolidKind::Revolve { sweep: None, facets: None, child } => {
            let profile = exact_box(child)?;
            let (radius, z) = (profile.max[0], profile.axis(1));
            Some(Bounds::new(Interval::new(-radius, radius), Interval::new(-radius, radius), z))
        }
        _ => None,
    }
}

/// Whether the table's box of a shape is the smallest.
fn fits_its_box(shape: &str) -> bool {
    let shapes = [
        "sphere",
        "box",
        "cylinder",
        "cone",
        "torus",
        "capsule",
        "ellipsoid",
        "box_frame",
        "octahedron",
        "link",
        "pyramid",
        "circle",
        "rectangle",
        "ellipse",
        "ring",
    ];
    shapes.contains(&shape)
}

/// Whether a constant map takes axes to axes, so that the box of an image is the image of the box.
fn keeps_axes(map: &Affine) -> bool {
    let counts = |i: usize| (0..3).filter(|j| !map.rows()[i][*j].is(0.0)).count() == 1;
    map.rows().iter().flatten().all(|entry| entry.constant().is_some()) && (0..3).all(counts)
}

/// The box around a shape with corners under any constant map, or around a ball under a similarity.
fn corners_box(map: &Affine, child: &Solid) -> Option<Bounds> {
    if map.rows().iter().flatten().any(|entry| entry.constant().is_none()) {
        return None;
    }
    match &child.kind {
        SolidKind::Shape(row, arguments) if matches!(row.name, "box" | "rectangle") => {
            let half: Option<Vec<f64>> = arguments.iter().map(Scalar::constant).collect();
            let half = half?;
            let reach = |i: usize| Interval::new(-half[i], half[i]);
            let z = if half.len() == 3 { reach(2) } else { Interval::ALL };
            Some(image(map, &Bounds::new(reach(0), reach(1), z)))
        }
        SolidKind::Transform(inner, child) if keeps_axes(&map.after(inner)) => {
            Some(image(&map.after(inner), &exact_box(child)?))
        }
        SolidKind::Transform(inner, child) => corners_box(&map.after(inner), child),
        SolidKind::Paint(_, child) => corners_box(map, child),
        _ => None,
    }
}
