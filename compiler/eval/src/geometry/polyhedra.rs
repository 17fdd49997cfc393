//! `polyhedron`, as far as it is convex or only its hull counts: then its corners alone make it.

use std::sync::Arc;

use chiaro_solid::{Scalar, Solid, SolidKind};
use chiaro_syntax::{Diagnostic, Span};
use rustc_hash::{FxHashMap, FxHashSet};

use super::arguments::numbers;
use super::instance::{Instance, Module, error};
use super::make::empty;
use super::vectors::{Point, cross, dot, length, normalised, sub};
use super::{Built, Stop, decide};
use crate::value::Value;

pub(super) const MODULES: &[Module] =
    &[Module { name: "polyhedron", positional: &["points", "faces"], named: &["triangles"], build: polyhedron }];

/// How far a corner may be above the plane of a face, relative to the polyhedron's size: dumps round to six digits.
const TOLERANCE: f64 = 1e-5;

fn polyhedron(instance: &mut Instance) -> Built {
    instance.without_children();
    let points = read_points(instance)?;
    let faces = read_faces(instance, points.len())?;
    let used: Vec<Point> = used_points(&points, &faces);
    let Some(size) = size(&used) else { return Ok(empty(instance.head)) };
    if instance.only_hull {
        return Ok(corners_hull(&used, instance.head));
    }
    let tolerance = TOLERANCE * size;
    let mut is_flat = true;
    for face in &faces {
        let Some((origin, normal)) = plane(&points, face) else { continue };
        let heights = used.iter().map(|point| dot(sub(*point, origin), normal));
        let (least, most) = heights.fold((0.0, 0.0), |(a, b): (f64, f64), height| (a.min(height), b.max(height)));
        if least < -tolerance && most > tolerance {
            return Err(concave(instance.head));
        }
        is_flat &= most - least <= tolerance;
    }
    if is_flat {
        return Ok(empty(instance.head));
    }
    if !is_closed(&points, &faces, tolerance) {
        return Err(open(instance.head));
    }
    Ok(corners_hull(&used, instance.head))
}

fn corners_hull(points: &[Point], span: Span) -> Arc<Solid> {
    let corner = |point: &Point| (point.map(Scalar::from), Scalar::ZERO);
    Solid::new(SolidKind::SphereHull(points.iter().map(corner).collect()), span)
}

fn concave(span: Span) -> Stop {
    let diagnostic = Diagnostic::error(span, "a polyhedron that is not convex is not supported yet")
        .with_hint("unions, differences and extrusions can often replace it");
    Stop::Error(Box::new(diagnostic))
}

fn open(span: Span) -> Stop {
    let diagnostic = Diagnostic::error(span, "the faces of this polyhedron do not enclose a solid")
        .with_hint("each edge has to be one of two faces, with the same two corners in both");
    Stop::Error(Box::new(diagnostic))
}

/// Whether each edge belongs to an even number of faces.
///
/// Faces that all lie in the hull's boundary and have no boundary themselves are the whole of it.
fn is_closed(points: &[Point], faces: &[Vec<usize>], tolerance: f64) -> bool {
    let corners = corners(points, tolerance);
    let mut open = FxHashSet::default();
    for face in faces {
        for (from, to) in face.iter().zip(face.iter().cycle().skip(1)) {
            let (from, to) = (corners[*from], corners[*to]);
            let edge = (from.min(to), from.max(to));
            if from != to && !open.insert(edge) {
                open.remove(&edge);
            }
        }
    }
    open.is_empty()
}

/// For each point, the first one that is within the tolerance of it: many a program lists a corner once for each face.
fn corners(points: &[Point], tolerance: f64) -> Vec<usize> {
    let cell = |point: &Point| point.map(|c| (c / tolerance).floor() as i64);
    let is_near = |a: usize, b: usize| (0..3).all(|axis| (points[a][axis] - points[b][axis]).abs() <= tolerance);
    let mut cells: FxHashMap<[i64; 3], usize> = FxHashMap::default();
    let mut corners = Vec::with_capacity(points.len());
    for (index, point) in points.iter().enumerate() {
        let center = cell(point);
        let around =
            (0..27).map(|i| [0, 1, 2].map(|axis| center[axis].saturating_add(i / 3i64.pow(axis as u32) % 3 - 1)));
        let known = around.filter_map(|cell| cells.get(&cell)).find(|corner| is_near(**corner, index)).copied();
        if known.is_none() {
            cells.insert(center, index);
        }
        corners.push(known.unwrap_or(index));
    }
    corners
}

fn read_points(instance: &mut Instance) -> Result<Vec<Point>, Stop> {
    let Some((value, span)) = instance.value("points") else {
        instance.warn(instance.head, "this polyhedron has no points, so that there is nothing");
        return Ok(Vec::new());
    };
    let Value::List(items) = &value else {
        instance.unfit::<()>("points", &value, span, "a list of points");
        return Ok(Vec::new());
    };
    let mut points = Vec::with_capacity(items.len());
    for (index, item) in items.iter().enumerate() {
        let numbers = numbers(item).unwrap_or_default();
        let known = |axis: usize| match numbers.get(axis) {
            Some(number) => decide::constant(number, span, "a point of a polyhedron"),
            None => Ok(f64::NAN),
        };
        let point = [known(0)?, known(1)?, known(2)?];
        if !point.iter().all(|c| c.is_finite()) {
            return Err(error(span, format!("point {index} of this polyhedron is not three finite numbers")));
        }
        points.push(point);
    }
    Ok(points)
}

/// The faces, as indices of points.
fn read_faces(instance: &mut Instance, points: usize) -> Result<Vec<Vec<usize>>, Stop> {
    let given = instance.value("faces").or_else(|| instance.value("triangles"));
    let Some((value, span)) = given else {
        instance.warn(instance.head, "this polyhedron has no faces, so that there is nothing");
        return Ok(Vec::new());
    };
    let Value::List(items) = &value else {
        instance.unfit::<()>("faces", &value, span, "a list of lists of indices");
        return Ok(Vec::new());
    };
    let mut invalid = false;
    let mut faces = Vec::with_capacity(items.len());
    for list in items.iter().map(|item| numbers(item).unwrap_or_default()) {
        let mut face = Vec::with_capacity(list.len());
        for index in list {
            let index = decide::constant(&index, span, "an index of a polyhedron's face")?;
            let valid = index >= 0.0 && (index as usize) < points;
            invalid |= !valid;
            face.extend(valid.then_some(index as usize));
        }
        faces.push(face);
    }
    if invalid {
        instance.warn(span, format!("indices that are not of one of the {points} points are left out of the faces"));
    }
    Ok(faces)
}

/// The points that faces have as corners.
fn used_points(points: &[Point], faces: &[Vec<usize>]) -> Vec<Point> {
    let mut indices: Vec<usize> = faces.iter().flatten().copied().collect();
    indices.sort_unstable();
    indices.dedup();
    indices.into_iter().map(|index| points[index]).collect()
}

/// The longest edge of the box around some points, if there are any.
fn size(points: &[Point]) -> Option<f64> {
    let extent = |axis: usize| {
        let along = || points.iter().map(|point| point[axis]);
        along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
    };
    (!points.is_empty()).then(|| extent(0).max(extent(1)).max(extent(2)))
}

/// A point of a face's plane and its normal, of length 1, by Newell's method; none for a face without area.
fn plane(points: &[Point], face: &[usize]) -> Option<(Point, Point)> {
    let origin = points[*face.first()?];
    let pairs = face.iter().zip(face.iter().cycle().skip(1));
    let normal = pairs.fold([0.0; 3], |sum: Point, (a, b)| {
        let area = cross(sub(points[*a], origin), sub(points[*b], origin));
        std::array::from_fn(|axis| sum[axis] + area[axis])
    });
    (length(normal) > 0.0).then(|| (origin, normalised(normal)))
}
