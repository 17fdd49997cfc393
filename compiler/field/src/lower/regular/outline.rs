//! The straight edges of outlines, and outlines with edges moved outwards.

use chiaro_plane::{Contour, Edge, Region};
use chiaro_solid::Scalar;
use chiaro_vocabulary::{Row, rows};

use super::face::{Face, Faces};
use super::linear::Linear;
use super::place::SAME;

/// The outline of a shape of constant numbers whose row doesn't tell its faces.
pub(super) fn of_shape(row: &Row, arguments: &[Scalar]) -> Option<Region> {
    if *row != rows::NGON {
        return None;
    }
    let [radius, sides] = arguments else { return None };
    Some(Region::ngon(radius.constant()?, sides.constant()? as u32))
}

/// The sides of a region's straight edges.
pub(super) fn faces(region: &Region) -> Faces {
    let region = region.normalized();
    let list = region.edges().filter_map(|edge| {
        let (normal, offset) = side(edge)?;
        Some(Face::Flat { normal: [normal[0], normal[1], 0.0], offset: Linear::from(offset) })
    });
    Faces { list: list.collect(), are_whole: is_convex_polygon(&region) }
}

/// The direction out of a region across one of its straight edges, and how far the edge's line is from the origin along it.
fn side(edge: &Edge) -> Option<([f64; 2], f64)> {
    let Edge::Line { from, to } = *edge else { return None };
    let along = [to[0] - from[0], to[1] - from[1]];
    let length = along[0].hypot(along[1]);
    let normal = [along[1] / length, -along[0] / length];
    (length > 0.0).then_some((normal, from[0] * normal[0] + from[1] * normal[1]))
}

fn is_convex_polygon(region: &Region) -> bool {
    let [contour] = region.contours.as_slice() else { return false };
    let directions: Option<Vec<[f64; 2]>> = contour.edges.iter().map(|edge| Some(side(edge)?.0)).collect();
    let Some(normals) = directions else { return false };
    let mut turned = 0.0;
    for (a, b) in normals.iter().zip(normals.iter().cycle().skip(1)) {
        let turn = (a[0] * b[1] - a[1] * b[0]).atan2(a[0] * b[0] + a[1] * b[1]);
        if turn < -SAME {
            return false;
        }
        turned += turn;
    }
    turned < 1.5 * std::f64::consts::TAU
}

/// The region with its edges on a line moved out by a length, and what that adds; none if no edge lies there.
pub(super) fn grown(region: &Region, normal: [f64; 2], offset: f64, by: f64, tolerance: f64) -> Option<[Region; 2]> {
    let region = region.normalized();
    let is_there = |edge: &Edge| {
        side(edge).is_some_and(|(direction, at)| {
            direction[0] * normal[0] + direction[1] * normal[1] > 1.0 - SAME && (at - offset).abs() <= tolerance
        })
    };
    let added: Vec<Region> = region.edges().filter(|edge| is_there(edge)).map(|edge| strip(edge, normal, by)).collect();
    if added.is_empty() {
        return None;
    }
    let beyond = |point: [f64; 2]| point[0] * normal[0] + point[1] * normal[1] > offset + tolerance;
    let goes_beyond = region.edges().any(|edge| match edge {
        Edge::Line { from, .. } => beyond(*from),
        Edge::Arc { center, radius, .. } => beyond([center[0] + radius * normal[0], center[1] + radius * normal[1]]),
    });
    let whole = if goes_beyond {
        Region::union(&[std::slice::from_ref(&region), added.as_slice()].concat())
    } else {
        let moved = |contour: &Contour| Contour { edges: moved_edges(contour, &is_there, normal, by) };
        Region { contours: region.contours.iter().map(moved).collect() }
    };
    Some([whole, Region { contours: added.into_iter().flat_map(|region| region.contours).collect() }])
}

/// What an edge sweeps over when it is moved out.
fn strip(edge: &Edge, normal: [f64; 2], by: f64) -> Region {
    let out = |point: [f64; 2]| [point[0] + by * normal[0], point[1] + by * normal[1]];
    let (from, to) = (edge.start(), edge.end());
    Region::polygon(&[from, out(from), out(to), to], None)
}

/// A contour's edges with some moved out, and straight ones to where they were. Those that go on straight are one.
fn moved_edges(contour: &Contour, is_there: &impl Fn(&Edge) -> bool, normal: [f64; 2], by: f64) -> Vec<Edge> {
    let out = |point: [f64; 2]| [point[0] + by * normal[0], point[1] + by * normal[1]];
    let mut edges: Vec<Edge> = Vec::with_capacity(contour.edges.len() + 2);
    for edge in &contour.edges {
        let (from, to) = (edge.start(), edge.end());
        if is_there(edge) {
            edges.push(Edge::Line { from, to: out(from) });
            edges.push(Edge::Line { from: out(from), to: out(to) });
            edges.push(Edge::Line { from: out(to), to });
        } else {
            edges.push(*edge);
        }
    }
    joined(edges)
}

/// Successive straight edges of one direction as one.
fn joined(edges: Vec<Edge>) -> Vec<Edge> {
    let mut kept: Vec<Edge> = Vec::with_capacity(edges.len());
    for edge in edges {
        match kept.last_mut() {
            Some(last) if goes_on(last, &edge) => *last = Edge::Line { from: last.start(), to: edge.end() },
            _ => kept.push(edge),
        }
    }
    if let [first, .., last] = kept.as_slice()
        && goes_on(last, first)
    {
        let whole = Edge::Line { from: last.start(), to: first.end() };
        kept.pop();
        kept[0] = whole;
    }
    kept
}

fn goes_on(edge: &Edge, next: &Edge) -> bool {
    match (side(edge), side(next)) {
        (Some((a, _)), Some((b, _))) => a[0] * b[0] + a[1] * b[1] > 1.0 - SAME * SAME.sqrt(),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_notch_flush_with_a_line_is_drawn_out_beyond_it() {
        let triangle = Region::polygon(&[[5.0, 0.0], [15.0, 0.0], [10.0, 8.0]], None);
        let [whole, added] = grown(&triangle, [0.0, -1.0], 0.0, 2.0, 1e-6).unwrap();
        assert!((whole.area() - 60.0).abs() < 1e-6 && (added.area() - 20.0).abs() < 1e-6);
        assert!(whole.contains([10.0, -1.0]));
        let square = Region::rectangle([0.0, 0.0], [4.0, 4.0]);
        let [whole, _] = grown(&square, [0.0, 1.0], 4.0, 3.0, 1e-6).unwrap();
        assert_eq!((whole.edges().count(), whole.area()), (4, 28.0));
    }
}
