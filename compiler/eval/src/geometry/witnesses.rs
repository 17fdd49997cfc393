//! Exact boxes of solids without live numbers, by witnesses: points of the solid, at its farthest where possible. A box
//! that is known to hold the solid is the smallest if witnesses touch all its faces.

use std::sync::Arc;

use chiaro_plane::{Edge, Region};
use chiaro_solid::{Affine, Boolean, Scalar, Solid, SolidKind};
use chiaro_syntax::Span;
use chiaro_vocabulary::{Bounds, Interval};

use super::exactness::is_straight;
use super::extent::outer_box;
use super::outline::outline;
use super::{Stop, decide};

type Point = [f64; 3];

/// How far witnesses may stay away from a face of the box, relative to its diagonal.
const TOLERANCE: f64 = 1e-9;

/// The smallest box around a solid; none if it is not known.
pub(super) fn exact_box(solid: &Arc<Solid>) -> Result<Option<Bounds>, Stop> {
    let points = witnesses(solid)?;
    let (outer, inner) = (outer_box(solid), points.iter().fold(Bounds::EMPTY, with_point));
    let tolerance = TOLERANCE * outer.diagonal();
    let touches =
        |axis: usize| inner.min[axis] - outer.min[axis] <= tolerance && outer.max[axis] - inner.max[axis] <= tolerance;
    Ok((!inner.is_empty() && (0..3).all(touches)).then_some(inner))
}

fn with_point(bounds: Bounds, [x, y, z]: &Point) -> Bounds {
    bounds.union(&Bounds::new(Interval::point(*x), Interval::point(*y), Interval::point(*z)))
}

/// Points of a solid or of its surface, none of them if none are known.
fn witnesses(solid: &Arc<Solid>) -> Result<Vec<Point>, Stop> {
    match &solid.kind {
        SolidKind::Shape(row, arguments) => {
            let arguments = arguments.iter().map(|argument| known(argument, solid.span));
            Ok(of_shape(row.name, &arguments.collect::<Result<Vec<f64>, Stop>>()?))
        }
        SolidKind::SphereHull(balls) => {
            let balls = balls.iter().map(|(center, radius)| {
                let center =
                    [known(&center[0], solid.span)?, known(&center[1], solid.span)?, known(&center[2], solid.span)?];
                Ok(around(center, [known(radius, solid.span)?; 3]))
            });
            Ok(balls.collect::<Result<Vec<_>, Stop>>()?.concat())
        }
        SolidKind::Boolean { operation: Boolean::Union, children, .. } => {
            Ok(children.iter().map(witnesses).collect::<Result<Vec<_>, Stop>>()?.concat())
        }
        SolidKind::Boolean { operation: Boolean::Difference, joint: None, children } => {
            let others: Vec<Bounds> = children[1..].iter().map(|child| outer_box(child)).collect();
            let mut points = witnesses(&children[0])?;
            points.retain(|point| !others.iter().any(|other| contains(other, point)));
            Ok(points)
        }
        SolidKind::Transform(map, child) => {
            let map = known_map(map, solid.span)?;
            Ok(witnesses(child)?.iter().map(|point| image(&map, point)).collect())
        }
        SolidKind::Paint(_, child) => witnesses(child),
        SolidKind::Offset(by, child) => {
            let by = known(by, solid.span)?;
            let points = if by > 0.0 { witnesses(child)? } else { Vec::new() };
            Ok(farthest(&points).into_iter().flat_map(|point| around(point, [by; 3])).collect())
        }
        SolidKind::Extrude { height, twist, scale, child } if is_straight(twist, scale) => {
            let height = known(height, solid.span)?;
            let points = of_outline(&outline(child)?);
            Ok(points.iter().flat_map(|[x, y]| [[*x, *y, 0.0], [*x, *y, height]]).collect())
        }
        SolidKind::Loft(loft) => Ok(loft.corners().collect()),
        SolidKind::Revolve { sweep: None, facets: None, child } => {
            let points = of_outline(&outline(child)?);
            Ok(points.iter().flat_map(|[r, z]| ring(*r, *z)).collect())
        }
        _ => Ok(Vec::new()),
    }
}

fn of_shape(name: &str, arguments: &[f64]) -> Vec<Point> {
    match (name, arguments) {
        ("sphere" | "octahedron", [r]) => around([0.0; 3], [*r; 3]),
        ("ellipsoid", [x, y, z]) => around([0.0; 3], [*x, *y, *z]),
        ("box", [x, y, z]) | ("box_frame", [x, y, z, _]) => corners([*x, *y, *z]),
        ("cylinder", [r, half]) => [ring(*r, -half), ring(*r, *half)].concat(),
        ("cone", [bottom, top, half]) => [ring(*bottom, -half), ring(*top, *half)].concat(),
        ("torus", [major, minor]) => [ring(major + minor, 0.0), ring(*major, *minor), ring(*major, -minor)].concat(),
        ("capsule", [h, r]) => [around([0.0; 3], [*r; 3]), around([0.0, 0.0, *h], [*r; 3])].concat(),
        ("round_cone", [bottom, top, h]) => {
            [around([0.0; 3], [*bottom; 3]), around([0.0, 0.0, *h], [*top; 3])].concat()
        }
        ("pyramid", [base, h]) => {
            let mut points = corners([0.5 * base, 0.5 * base, 0.0]);
            points.push([0.0, 0.0, *h]);
            points
        }
        _ => Vec::new(),
    }
}

/// The corners of an outline, and where its arcs reach farthest.
fn of_outline(outline: &Region) -> Vec<[f64; 2]> {
    outline.edges().flat_map(extremes).collect()
}

fn extremes(edge: &Edge) -> Vec<[f64; 2]> {
    let mut points = vec![edge.start(), edge.end()];
    if let Edge::Arc { center: [x, y], radius, .. } = *edge {
        let poles = [[x + radius, y], [x - radius, y], [x, y + radius], [x, y - radius]];
        points.extend(poles.into_iter().filter(|pole| edge.distance(*pole) <= TOLERANCE * radius));
    }
    points
}

/// The points that lie farthest along each axis, six at the most.
fn farthest(points: &[Point]) -> Vec<Point> {
    let along = |axis: usize| move |a: &&Point, b: &&Point| a[axis].total_cmp(&b[axis]);
    let both = (0..3).flat_map(|axis| [points.iter().min_by(along(axis)), points.iter().max_by(along(axis))]);
    both.flatten().copied().collect()
}

/// The points a distance away from a point along each axis.
fn around(center: Point, by: Point) -> Vec<Point> {
    let moved = |axis: usize, by: f64| {
        let mut point = center;
        point[axis] += by;
        point
    };
    (0..3).flat_map(|axis| [moved(axis, by[axis]), moved(axis, -by[axis])]).collect()
}

/// Points of a circle about z.
fn ring(radius: f64, z: f64) -> Vec<Point> {
    vec![[radius, 0.0, z], [-radius, 0.0, z], [0.0, radius, z], [0.0, -radius, z]]
}

fn corners(half: Point) -> Vec<Point> {
    let side = |corner: usize, axis: usize| if corner >> axis & 1 == 1 { half[axis] } else { -half[axis] };
    (0..8).map(|corner| std::array::from_fn(|axis| side(corner, axis))).collect()
}

fn contains(bounds: &Bounds, point: &Point) -> bool {
    (0..3).all(|axis| bounds.axis(axis).contains(point[axis]))
}

fn image(map: &[[f64; 4]; 3], point: &Point) -> Point {
    map.map(|row| row[3] + (0..3).map(|j| row[j] * point[j]).sum::<f64>())
}

fn known_map(map: &Affine, span: Span) -> Result<[[f64; 4]; 3], Stop> {
    for entry in map.rows().iter().flatten() {
        known(entry, span)?;
    }
    Ok(map.value(&[]))
}

fn known(number: &Scalar, span: Span) -> Result<f64, Stop> {
    decide::constant(number, span, "the size of what is resized")
}
