//! Triangulates a face from its outlines.

use rustc_hash::{FxHashMap, FxHashSet};
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation, mitigate_underflow};

use super::faces::Outline;
use crate::vector::{Vector, cross, dot, sub, unit};

/// The triangles within the outlines of a face that faces this way; none if they cross themselves or each other.
pub(super) fn triangulate(outlines: &Outline, vertices: &[Vector], facing: Vector) -> Option<Vec<[u32; 3]>> {
    let Some(first) = outlines.iter().flatten().next() else { return Some(Vec::new()) };
    let corners: usize = outlines.iter().map(Vec::len).sum();
    let (right, up) = axes(facing)?;
    let mut numbers: FxHashMap<u32, usize> = FxHashMap::default();
    let mut points = Vec::new();
    let mut names = Vec::new();
    for vertex in outlines.iter().flatten() {
        numbers.entry(*vertex).or_insert_with(|| {
            let way = sub(vertices[*vertex as usize], vertices[*first as usize]);
            points.push(mitigate_underflow(Point2::new(dot(way, right), dot(way, up))));
            names.push(*vertex);
            points.len() - 1
        });
    }
    let borders: Vec<[usize; 2]> = (outlines.iter())
        .flat_map(|outline| (0..outline.len()).map(|place| [outline[place], outline[(place + 1) % outline.len()]]))
        .map(|edge| edge.map(|vertex| numbers[&vertex]))
        .collect();
    let mut crossings = 0;
    let count = points.len();
    let triangulation: ConstrainedDelaunayTriangulation<Point2<f64>> =
        ConstrainedDelaunayTriangulation::try_bulk_load_cdt(points, borders.clone(), |_| crossings += 1).ok()?;
    if crossings > 0 || triangulation.num_vertices() != count {
        return None;
    }
    let triangles = within(&triangulation, &borders)?;
    // Euler: a face with h holes and n corners has n + 2 h − 2 triangles.
    let is_whole = triangles.len() + 2 == corners + 2 * (outlines.len() - 1);
    is_whole.then(|| triangles.into_iter().map(|triangle| triangle.map(|corner| names[corner])).collect())
}

/// Two directions of a plane, of length 1, which turn anticlockwise as seen from where it faces.
fn axes(facing: Vector) -> Option<(Vector, Vector)> {
    let least = (0..3).min_by(|a, b| facing[*a].abs().total_cmp(&facing[*b].abs()))?;
    let axis = std::array::from_fn(|index| f64::from(index == least));
    let right = unit(cross(axis, facing))?;
    Some((right, cross(facing, right)))
}

/// The triangles to the left of the borders, up to where there are others; none if a border is missing or has them on
/// its right, too.
fn within(
    triangulation: &ConstrainedDelaunayTriangulation<Point2<f64>>,
    borders: &[[usize; 2]],
) -> Option<Vec<[usize; 3]>> {
    let borders: FxHashSet<[usize; 2]> = borders.iter().copied().collect();
    let mut seen = vec![false; triangulation.num_all_faces()];
    let mut passed = 0;
    let mut triangles = Vec::new();
    for start in triangulation.inner_faces() {
        let ends = |edge: spade::handles::DirectedEdgeHandle<'_, Point2<f64>, _, _, _>| {
            [edge.from().fix().index(), edge.to().fix().index()]
        };
        if !start.adjacent_edges().into_iter().any(|edge| borders.contains(&ends(edge))) {
            continue;
        }
        let mut open = vec![start];
        while let Some(face) = open.pop() {
            if std::mem::replace(&mut seen[face.fix().index()], true) {
                continue;
            }
            triangles.push(face.vertices().map(|vertex| vertex.fix().index()));
            for edge in face.adjacent_edges() {
                let [from, to] = ends(edge);
                if borders.contains(&[from, to]) {
                    passed += 1;
                } else if borders.contains(&[to, from]) {
                    return None;
                } else {
                    open.push(edge.rev().face().as_inner()?);
                }
            }
        }
    }
    (passed == borders.len()).then_some(triangles)
}
