//! Hulls and Minkowski sums against their definitions.

mod common;

use chiaro_plane::{Point, Region};
use common::{assert_closed, outline, region, samples};
use proptest::prelude::*;

/// How far a region reaches in a direction.
fn support(corners: &[Point], direction: Point) -> f64 {
    corners.iter().map(|p| p[0] * direction[0] + p[1] * direction[1]).fold(f64::NEG_INFINITY, f64::max)
}

fn directions() -> impl Iterator<Item = Point> {
    (0..72).map(|k| f64::from(k) * std::f64::consts::TAU / 72.0 + 0.01).map(|angle| [angle.cos(), angle.sin()])
}

fn corners(regions: &[Region]) -> Vec<Point> {
    regions.iter().flat_map(|region| region.flatten(1e-4).concat()).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn hulls_reach_exactly_as_far(a in region(), b in region(), c in region()) {
        let regions = [Region::union(&[a, b]), c];
        let hull = Region::hull(&regions);
        assert_closed(&hull);
        let (before, after) = (corners(&regions), corners(std::slice::from_ref(&hull)));
        let spread = directions().map(|d| support(&before, d) + support(&before, [-d[0], -d[1]]));
        if spread.fold(f64::INFINITY, f64::min) > 1e-3 {
            let reach: Vec<(Point, f64)> = directions().map(|d| (d, support(&before, d))).collect();
            for (d, reach) in &reach {
                prop_assert!((reach - support(&after, *d)).abs() < 2e-4, "{regions:?} {hull:?}");
            }
            for p in samples().filter(|p| hull.signed_distance(*p).abs() > 1e-5) {
                let inside = reach.iter().all(|(d, reach)| p[0] * d[0] + p[1] * d[1] <= *reach);
                prop_assert!(inside || !hull.contains(p));
            }
            prop_assert!(outline(&hull).iter().all(|p| p.iter().all(|x| x.is_finite())));
        }
    }
}
