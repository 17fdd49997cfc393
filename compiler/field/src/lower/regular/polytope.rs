//! The faces of convex polytopes, and polytopes with faces moved.

use std::sync::Arc;

use chiaro_solid::Scalar;
use chiaro_vocabulary::Row;

use super::face::{Face, Faces, weighted};
use super::linear::Linear;
use crate::hull::{Hull, Vec3, add, cross, dot, hull, length, scale, sub};

/// The triangles of a polytope's surface, anticlockwise seen from outside.
pub(super) type Triangles = Arc<[[Vec3; 3]]>;

/// Normals nearer to each other than this are of one face.
const SAME_NORMAL: f64 = 1e-9;

/// The polytope that a shape of constant numbers is, if it is one.
pub(super) fn of_shape(row: &Row, arguments: &[Scalar]) -> Option<Triangles> {
    if !row.form.is_polytope || arguments.iter().any(|argument| argument.constant().is_none()) {
        return None;
    }
    let corner = |disc: &chiaro_vocabulary::form::Disc| disc.center.map(|at| weighted(at, arguments).range().min);
    let corners: Vec<Vec3> = row.form.discs.iter().map(corner).collect();
    solid(&corners)
}

fn solid(corners: &[Vec3]) -> Option<Triangles> {
    match hull(corners) {
        Hull::Solid(triangles) => Some(triangles.into()),
        _ => None,
    }
}

/// The planes of the faces.
fn planes(triangles: &[[Vec3; 3]]) -> Vec<(Vec3, f64)> {
    let mut planes: Vec<(Vec3, f64)> = Vec::new();
    for [a, b, c] in triangles {
        let normal = cross(sub(*b, *a), sub(*c, *a));
        let size = length(normal);
        if size == 0.0 {
            continue;
        }
        let normal = scale(normal, 1.0 / size);
        if !planes.iter().any(|(known, _)| length(sub(*known, normal)) < SAME_NORMAL.sqrt()) {
            planes.push((normal, dot(normal, *a)));
        }
    }
    planes
}

/// The faces of a polytope.
pub(super) fn faces(triangles: &[[Vec3; 3]]) -> Faces {
    let list =
        planes(triangles).into_iter().map(|(normal, offset)| Face::Flat { normal, offset: Linear::from(offset) });
    Faces { list: list.collect(), are_whole: true }
}

/// The polytope with the face in a plane moved out by a length, and what that adds; none if it has no such face.
pub(super) fn grown(
    triangles: &[[Vec3; 3]],
    normal: Vec3,
    offset: f64,
    by: f64,
    tolerance: f64,
) -> Option<[Triangles; 2]> {
    let mut planes = planes(triangles);
    let face = planes
        .iter_mut()
        .find(|(direction, at)| dot(*direction, normal) > 1.0 - SAME_NORMAL && (*at - offset).abs() <= tolerance)?;
    face.1 += by;
    let corners: Vec<Vec3> = triangles.iter().flatten().copied().collect();
    let middle = corners.iter().fold([0.0; 3], |sum, corner| add(sum, *corner));
    let middle = scale(middle, 1.0 / corners.len() as f64);
    let grown = corners_within(&planes, middle)?;
    let (low, high) = if by > 0.0 { (offset, offset + by) } else { (offset + by, offset) };
    let between = |corner: &&Vec3| {
        let height = dot(**corner, normal);
        height >= low - tolerance && height <= high + tolerance
    };
    let added: Vec<Vec3> = corners.iter().chain(&grown).filter(between).copied().collect();
    Some([solid(&grown)?, solid(&added)?])
}

/// The corners of what lies below planes, all of which a point is below: by the hull of the planes' poles about it.
fn corners_within(planes: &[(Vec3, f64)], middle: Vec3) -> Option<Vec<Vec3>> {
    let mut poles = Vec::with_capacity(planes.len());
    for (normal, offset) in planes {
        let depth = offset - dot(*normal, middle);
        if depth <= 0.0 {
            return None;
        }
        poles.push(scale(*normal, 1.0 / depth));
    }
    let Hull::Solid(triangles) = hull(&poles) else { return None };
    let mut corners = Vec::with_capacity(triangles.len());
    for [a, b, c] in triangles {
        // A face of the poles' hull is the polar plane of a corner: dot(pole, corner) = 1.
        let normal = cross(sub(b, a), sub(c, a));
        let height = dot(normal, a);
        if height.abs() < f64::MIN_POSITIVE {
            return None;
        }
        corners.push(add(middle, scale(normal, 1.0 / height)));
    }
    // Without an end, a corner lies far off.
    let reach = planes.iter().map(|(_, offset)| offset.abs()).fold(1.0, f64::max);
    corners.iter().all(|corner| length(*corner) < 1e4 * reach).then_some(corners)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pyramid_grows_at_its_base() {
        let corners = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [-1.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let triangles = solid(&corners).unwrap();
        let [grown, added] = grown(&triangles, [0.0, 0.0, -1.0], 0.0, 1.0, 1e-6).unwrap();
        let lowest = |triangles: &Triangles| triangles.iter().flatten().map(|corner| corner[2]).fold(1.0, f64::min);
        let widest = |triangles: &Triangles| triangles.iter().flatten().map(|corner| corner[0]).fold(0.0, f64::max);
        assert!((lowest(&grown) + 1.0).abs() < 1e-9 && (widest(&grown) - 2.0).abs() < 1e-9);
        assert!((lowest(&added) + 1.0).abs() < 1e-9);
        assert_eq!(faces(&grown).list.len(), 5);
    }
}
