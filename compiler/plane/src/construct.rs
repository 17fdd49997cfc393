//! Regions from their measures.

use std::f64::consts::TAU;

use crate::region::{Contour, Edge, Point, Region, on_circle};

impl Region {
    /// The even-odd polygon of `paths`, each a list of indices into `points`; of one path of all points if `None`.
    ///
    /// Indices out of range, edges without length and paths of fewer than three different points are left out.
    pub fn polygon(points: &[Point], paths: Option<&[Vec<usize>]>) -> Region {
        let contours = match paths {
            None => vec![Contour::polygon(points.iter().copied())],
            Some(paths) => paths.iter().map(|path| path_contour(points, path)).collect(),
        };
        Region::of(contours)
    }

    /// The disc of a radius about the origin; empty unless the radius is positive.
    pub fn circle(radius: f64) -> Region {
        Region::disc([0.0, 0.0], radius)
    }

    /// The disc of a radius about a point; empty unless the radius is positive.
    pub fn disc(center: Point, radius: f64) -> Region {
        let edge = Edge::Arc { center, radius, start: 0.0, sweep: TAU };
        if edge.is_finite() { Region { contours: vec![Contour { edges: vec![edge] }] } } else { Region::default() }
    }

    /// The rectangle between two corners; empty unless `max` exceeds `min` on both axes.
    pub fn rectangle(min: Point, max: Point) -> Region {
        if min[0] < max[0] && min[1] < max[1] {
            Region::polygon(&[min, [max[0], min[1]], max, [min[0], max[1]]], None)
        } else {
            Region::default()
        }
    }

    /// The regular polygon with corners on the circle of a radius about the origin, the first on the x axis;
    /// empty for fewer than three sides.
    pub fn ngon(radius: f64, sides: u32) -> Region {
        if sides < 3 || radius <= 0.0 {
            return Region::default();
        }
        let corner = |k| {
            let point = on_circle([0.0, 0.0], radius, TAU * f64::from(k) / f64::from(sides));
            // Corners on an axis are exactly there.
            point.map(|x| if x.abs() < radius * 1e-15 { 0.0 } else { x })
        };
        Region::polygon(&(0..sides).map(corner).collect::<Vec<_>>(), None)
    }

    /// The region of those contours that have edges.
    pub(crate) fn of(contours: Vec<Contour>) -> Region {
        Region { contours: contours.into_iter().filter(|contour| !contour.edges.is_empty()).collect() }
    }
}

impl Contour {
    /// The closed outline through some points; without edges if they are fewer than three or not all finite.
    pub fn polygon(points: impl IntoIterator<Item = Point>) -> Contour {
        let mut corners: Vec<Point> = points.into_iter().collect();
        corners.dedup();
        while corners.len() > 1 && corners.first() == corners.last() {
            corners.pop();
        }
        if corners.len() < 3 || corners.iter().flatten().any(|x| !x.is_finite()) {
            return Contour::default();
        }
        let next = corners.iter().cycle().skip(1);
        Contour { edges: corners.iter().zip(next).map(|(&from, &to)| Edge::Line { from, to }).collect() }
    }
}

fn path_contour(points: &[Point], path: &[usize]) -> Contour {
    Contour::polygon(path.iter().filter_map(|&index| points.get(index).copied()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polygons_leave_out_what_is_degenerate() {
        let points = [[0.0, 0.0], [0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]];
        assert_eq!(Region::polygon(&points, None).edges().count(), 4);
        assert!(Region::polygon(&points[..3], None).is_empty());
        assert!(Region::polygon(&[[0.0, 0.0], [1.0, f64::NAN], [1.0, 1.0]], None).is_empty());
        let paths = [vec![0, 2, 3, 99], vec![4, 5]];
        assert_eq!(Region::polygon(&points, Some(&paths)).edges().count(), 3);
    }

    #[test]
    fn measures_that_are_not_positive_give_empty_regions() {
        assert!(Region::circle(0.0).is_empty());
        assert!(Region::circle(f64::INFINITY).is_empty());
        assert!(Region::rectangle([0.0, 0.0], [0.0, 1.0]).is_empty());
        assert!(Region::ngon(1.0, 2).is_empty());
        assert!(Region::ngon(f64::NAN, 5).is_empty());
        assert_eq!(Region::ngon(2.0, 4).contours[0].edges[1].start(), [0.0, 2.0]);
    }
}
