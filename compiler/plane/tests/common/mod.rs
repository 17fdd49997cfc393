//! Random regions, and what must hold of every result.
#![allow(dead_code)]

use chiaro_plane::{Edge, Point, Region};
use proptest::prelude::*;

pub(crate) fn distance(a: Point, b: Point) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// Discs, rectangles, regular polygons, even-odd polygons that may cross themselves, and stadiums.
pub(crate) fn region() -> impl Strategy<Value = Region> {
    let coordinate = || -10.0..10.0f64;
    let disc = (coordinate(), coordinate(), 0.5..8.0f64).prop_map(|(x, y, r)| Region::disc([x, y], r));
    let polygon = prop::collection::vec([coordinate(), coordinate()], 3..9).prop_map(|p| Region::polygon(&p, None));
    let lattice = prop::collection::vec((-5..6i32, -5..6i32), 3..7).prop_map(|points| {
        let points: Vec<Point> = points.into_iter().map(|(x, y)| [f64::from(x) * 2.0, f64::from(y) * 2.0]).collect();
        Region::polygon(&points, None)
    });
    let lattice_disc = (-5..6i32, -5..6i32, 1..6i32)
        .prop_map(|(x, y, r)| Region::disc([f64::from(x) * 2.0, f64::from(y) * 2.0], f64::from(r)));
    let turned = (3..8u32, 0.5..8.0f64, 0.0..6.0f64, coordinate(), coordinate()).prop_map(|(sides, r, angle, x, y)| {
        let (sin, cos) = angle.sin_cos();
        Region::ngon(r, sides).transform([[cos, -sin, x], [sin, cos, y]])
    });
    let slot = (0.3..3.0f64, 0.5..8.0f64, 0.0..6.0f64, coordinate(), coordinate()).prop_map(|(r, l, angle, x, y)| {
        let (sin, cos) = angle.sin_cos();
        stadium(r, l).transform([[cos, -sin, x], [-sin, -cos, y]])
    });
    prop_oneof![disc, polygon, lattice, lattice_disc, turned, slot]
}

/// The points within `radius` of a segment of a length on the x axis.
pub(crate) fn stadium(radius: f64, length: f64) -> Region {
    use std::f64::consts::{FRAC_PI_2, PI};
    let arc = |x: f64, start: f64| Edge::Arc { center: [x, 0.0], radius, start, sweep: PI };
    let line = |from, to| Edge::Line { from, to };
    let edges = vec![
        line([0.0, -radius], [length, -radius]),
        arc(length, -FRAC_PI_2),
        line([length, radius], [0.0, radius]),
        arc(0.0, FRAC_PI_2),
    ];
    Region { contours: vec![chiaro_plane::Contour { edges }] }
}

/// Points all over the space that the regions take.
pub(crate) fn samples() -> impl Iterator<Item = Point> {
    let golden = 0.618_033_988_749_895;
    (0..900).map(move |k| [f64::from(k).mul_add(36.0 / 900.0, -18.0), (f64::from(k) * golden).fract() * 36.0 - 18.0])
}

pub(crate) fn assert_closed(region: &Region) {
    for contour in &region.contours {
        assert!(!contour.edges.is_empty());
        for (edge, next) in contour.edges.iter().zip(contour.edges.iter().cycle().skip(1)) {
            assert!(edge.is_finite(), "{edge:?}");
            assert!(distance(edge.end(), next.start()) < 1e-9, "{edge:?} {next:?}");
        }
    }
}

/// Points along the outlines.
pub(crate) fn outline(region: &Region) -> Vec<Point> {
    region.flatten(1e-3).concat()
}
