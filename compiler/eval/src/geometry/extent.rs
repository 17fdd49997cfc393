//! How far solids reach: boxes around them, and sides of the axis for `rotate_extrude`.

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
    side(outer_box(solid).axis(0))
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

/// A box around a solid, for all values of live numbers; perhaps not the smallest. That of a plane shape is all of z.
pub(super) fn outer_box(solid: &Solid) -> Bounds {
    match &solid.kind {
        SolidKind::Empty => Bounds::EMPTY,
        SolidKind::Shape(row, arguments) => (row.bounds)(&arguments.iter().map(Scalar::range).collect::<Vec<_>>()),
        SolidKind::Region(region) => region_box(region),
        SolidKind::SphereHull(balls) => {
            let ball = |(center, radius): &([Scalar; 3], Scalar)| {
                let [x, y, z] = [0, 1, 2].map(|axis| center[axis].range());
                Bounds::new(x, y, z).inflate(radius.range().max)
            };
            balls.iter().map(ball).fold(Bounds::EMPTY, |all, ball| all.union(&ball))
        }
        SolidKind::Boolean { operation, joint, children } => {
            let boxes = children.iter().map(|child| outer_box(child));
            let bounds = match operation {
                Boolean::Difference => outer_box(&children[0]),
                Boolean::Union => boxes.fold(Bounds::EMPTY, |all, child| all.union(&child)),
                Boolean::Intersection => boxes.fold(Bounds::ALL, |common, child| common.intersection(&child)),
            };
            // Where surfaces coincide, a joint bulges by less than its radius.
            bounds.inflate(joint.as_ref().map_or(0.0, |joint| joint.radius.range().max))
        }
        SolidKind::Transform(map, child) => image(map, &outer_box(child)),
        SolidKind::Paint(_, child) => outer_box(child),
        SolidKind::Offset(by, child) => outer_box(child).inflate(by.range().max.max(0.0)),
        SolidKind::Shell(thickness, child) => outer_box(child).inflate(0.5 * thickness.range().max),
        SolidKind::Extrude { height, twist, scale, child } if is_straight(twist, scale) => {
            let (base, top) = (outer_box(child), height.range().max);
            Bounds::new(base.axis(0), base.axis(1), Interval::new(0.0, top))
        }
        SolidKind::Revolve { child, .. } => {
            let profile = outer_box(child);
            let around = Interval::new(-profile.max[0], profile.max[0]);
            Bounds::new(around, around, profile.axis(1))
        }
        SolidKind::Slice(child) => {
            let bounds = outer_box(child);
            Bounds::new(bounds.axis(0), bounds.axis(1), Interval::ALL)
        }
        SolidKind::Loft(loft) => corners_box(loft.corners()),
        SolidKind::Extrude { .. } | SolidKind::Twist(..) => Bounds::ALL,
    }
}

fn corners_box(corners: impl Iterator<Item = [f64; 3]>) -> Bounds {
    corners.fold(Bounds::EMPTY, |all, corner| all.union(&Bounds { min: corner, max: corner }))
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
