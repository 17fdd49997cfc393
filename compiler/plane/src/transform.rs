//! Affine maps of regions.

use std::f64::consts::FRAC_PI_4;

use crate::biarc::approximate;
use crate::contour::unit;
use crate::flatten::default_tolerance;
use crate::region::{Contour, Edge, Point, Region, on_circle};

/// How far the columns of a matrix may be from equally long and perpendicular, relative to their length, for it to
/// be a similarity: scene files often carry six digits.
const SIMILARITY: f64 = 1e-5;

impl Region {
    /// Its image under the matrix with rows `m`, applied to (x, y, 1).
    ///
    /// Lines stay lines; under rotations, reflections and uniform scale arcs stay arcs. Other matrices turn them into
    /// arcs of ellipses, and those become smooth chains of circular arcs within the
    /// [default tolerance](crate::default_tolerance) of the image. A singular matrix, or one that is not finite,
    /// leaves nothing.
    pub fn transform(&self, m: [[f64; 3]; 2]) -> Region {
        let determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
        if m.iter().flatten().any(|x| !x.is_finite()) || determinant == 0.0 || !determinant.is_finite() {
            return Region::default();
        }
        let has_arcs = self.edges().any(|edge| matches!(edge, Edge::Arc { .. }));
        match nearest_similarity(m) {
            _ if !has_arcs => self.map_edges(|edge| map_line(edge, m)),
            Some(similarity) => self.map_edges(|edge| map_similar(edge, similarity)),
            None => self.map_to_ellipses(m),
        }
    }

    /// Itself, moved.
    pub fn translate(&self, by: Point) -> Region {
        self.transform([[1.0, 0.0, by[0]], [0.0, 1.0, by[1]]])
    }

    fn map_edges(&self, map: impl Fn(&Edge) -> Edge) -> Region {
        let image = |contour: &Contour| Contour { edges: contour.edges.iter().map(&map).collect() };
        Region { contours: self.contours.iter().map(image).collect() }
    }

    fn map_to_ellipses(&self, m: [[f64; 3]; 2]) -> Region {
        let corners = self.flatten(default_tolerance(self)).concat();
        let image = Region::polygon(&corners.into_iter().map(|p| apply(m, p)).collect::<Vec<_>>(), None);
        let tolerance = default_tolerance(&image);
        let contour = |contour: &Contour| Contour {
            edges: contour.edges.iter().flat_map(|edge| map_edge(edge, m, tolerance)).collect(),
        };
        Region { contours: self.contours.iter().map(contour).collect() }
    }
}

fn apply(m: [[f64; 3]; 2], point: Point) -> Point {
    m.map(|row| row[0] * point[0] + row[1] * point[1] + row[2])
}

fn map_line(edge: &Edge, m: [[f64; 3]; 2]) -> Edge {
    Edge::Line { from: apply(m, edge.start()), to: apply(m, edge.end()) }
}

fn map_similar(edge: &Edge, m: [[f64; 3]; 2]) -> Edge {
    let Edge::Arc { center, radius, start, sweep } = *edge else { return map_line(edge, m) };
    let turn = m[1][0].atan2(m[0][0]);
    let mirrored = m[0][0] * m[1][1] < m[0][1] * m[1][0];
    let (start, sweep) = if mirrored { (turn - start, -sweep) } else { (turn + start, sweep) };
    Edge::Arc { center: apply(m, center), radius: radius * m[0][0].hypot(m[1][0]), start, sweep }
}

fn map_edge(edge: &Edge, m: [[f64; 3]; 2], tolerance: f64) -> Vec<Edge> {
    let Edge::Arc { center, radius, start, sweep } = *edge else { return vec![map_line(edge, m)] };
    let at = |t: f64| {
        let angle = start + t * sweep;
        let (sin, cos) = angle.sin_cos();
        let [dx, dy] = [-sin * sweep, cos * sweep];
        let direction = [m[0][0] * dx + m[0][1] * dy, m[1][0] * dx + m[1][1] * dy];
        (apply(m, on_circle(center, radius, angle)), unit(direction))
    };
    let pieces = (sweep.abs() / FRAC_PI_4).ceil().max(1.0) as u32;
    approximate(at, pieces, tolerance)
}

/// The matrix itself if it is a similarity to the last digit, the nearest one if it is nearly so.
fn nearest_similarity(m: [[f64; 3]; 2]) -> Option<[[f64; 3]; 2]> {
    let [[a, b, x], [c, d, y]] = m;
    let similar = if a * d > b * c {
        let (p, q) = ((a + d) / 2.0, (c - b) / 2.0);
        [[p, -q, x], [q, p, y]]
    } else {
        let (p, q) = ((a - d) / 2.0, (c + b) / 2.0);
        [[p, q, x], [q, -p, y]]
    };
    let size = similar[0][0].hypot(similar[1][0]);
    let error = (0..2).flat_map(|i| (0..2).map(move |j| (i, j))).map(|(i, j)| (m[i][j] - similar[i][j]).abs());
    (error.fold(0.0, f64::max) <= SIMILARITY * size).then_some(similar)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::region::distance;

    fn slot() -> Region {
        let pi = std::f64::consts::PI;
        let arc = |x: f64, start: f64| Edge::Arc { center: [x, 0.0], radius: 1.0, start, sweep: pi };
        let edges = vec![
            Edge::Line { from: [0.0, -1.0], to: [5.0, -1.0] },
            arc(5.0, -pi / 2.0),
            Edge::Line { from: [5.0, 1.0], to: [0.0, 1.0] },
            arc(0.0, pi / 2.0),
        ];
        Region { contours: vec![Contour { edges }] }
    }

    fn assert_closed(region: &Region) {
        for contour in &region.contours {
            for (edge, next) in contour.edges.iter().zip(contour.edges.iter().cycle().skip(1)) {
                assert!(distance(edge.end(), next.start()) < 1e-11 * (1.0 + region.diagonal()), "{edge:?} {next:?}");
            }
        }
    }

    #[test]
    fn similarities_keep_arcs() {
        let (sin, cos) = (0.564642, 0.825336);
        for m in [[[2.0 * cos, -2.0 * sin, 1.0], [2.0 * sin, 2.0 * cos, -3.0]], [[-1.0, 0.0, 0.5], [0.0, 1.0, 0.0]]] {
            let image = slot().transform(m);
            assert_closed(&image);
            assert_eq!(image.edges().filter(|edge| matches!(edge, Edge::Arc { .. })).count(), 2);
            for p in [[5.5, 0.5], [5.9, 0.9], [-0.5, 0.0], [2.0, 2.0]] {
                assert_eq!(slot().contains(p), image.contains(apply(m, p)), "{p:?}");
            }
        }
    }

    #[test]
    fn other_matrices_stay_within_the_tolerance() {
        for ratio in [1.1, 3.0, 50.0, 1e6] {
            let ellipse = Region::circle(1.0).transform([[ratio, 0.0, 0.0], [0.0, 1.0, 0.0]]);
            assert_closed(&ellipse);
            let tolerance = default_tolerance(&ellipse);
            for k in 0..1000 {
                let (sin, cos) = f64::from(k).sin_cos();
                assert!(ellipse.signed_distance([ratio * cos, sin]).abs() < 1.5 * tolerance);
            }
            assert!(ellipse.edges().count() <= 64, "{ratio}: {}", ellipse.edges().count());
        }
        let sheared = slot().transform([[1.0, 0.5, 0.0], [0.0, 1.0, 0.0]]);
        assert_closed(&sheared);
        assert!((sheared.area() - slot().area()).abs() < 1e-3);
        assert!(slot().transform([[1.0, 2.0, 0.0], [2.0, 4.0, 0.0]]).is_empty());
        assert!(slot().transform([[1.0, f64::NAN, 0.0], [2.0, 4.0, 0.0]]).is_empty());
    }
}
