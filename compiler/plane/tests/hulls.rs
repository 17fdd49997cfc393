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
            for p in samples().filter(|p| hull.signed_distance(*p).abs() > 3e-4) {
                let inside = reach.iter().all(|(d, reach)| p[0] * d[0] + p[1] * d[1] <= *reach);
                prop_assert!(inside || !hull.contains(p));
            }
            prop_assert!(outline(&hull).iter().all(|p| p.iter().all(|x| x.is_finite())));
        }
    }

    #[test]
    fn sums_hold_exactly_where_a_mirrored_copy_meets(a in region(), b in region()) {
        let [a, b] = [&a, &b].map(|region| region.normalized().transform([[0.5, 0.0, 1.0], [0.0, 0.5, 0.0]]));
        let sum = a.minkowski(&b).unwrap();
        assert_closed(&sum);
        if a.is_empty() || b.is_empty() {
            prop_assert!(sum.is_empty());
        } else {
            for p in samples().step_by(17).filter(|p| sum.signed_distance(*p).abs() > 1e-2) {
                let mirrored = b.transform([[-1.0, 0.0, p[0]], [0.0, -1.0, p[1]]]);
                let meet = !Region::intersection(&[a.clone(), mirrored]).is_empty();
                prop_assert_eq!(sum.contains(p), meet, "{:?}: {:?} {:?} {:?}", p, a, b, sum);
            }
        }
    }
}

#[test]
fn convex_sums_are_exact() {
    let square = Region::rectangle([0.0, 0.0], [2.0, 1.0]);
    let sum = square.minkowski(&square).unwrap();
    assert_eq!((sum.edges().count(), sum.bounds()), (4, Some(([0.0, 0.0], [4.0, 2.0]))));
    let rounded = square.minkowski(&Region::disc([1.0, 0.0], 0.5)).unwrap();
    assert_eq!(rounded.edges().count(), 8);
    let stadium = common::stadium(1.0, 3.0);
    let area = stadium.minkowski(&square).unwrap().area();
    assert!((area - (17.0 + std::f64::consts::PI)).abs() < 1e-9, "{area}");
}

#[test]
fn hulls_of_many_discs_are_those_of_the_outermost() {
    let spiral = |k: u32| {
        let angle = 2.4 * f64::from(k);
        let reach = 40.0 * (f64::from(k) / 5000.0).sqrt();
        Region::disc([reach * angle.cos(), reach * angle.sin()], 1.0 + 0.3 * f64::from(k % 7))
    };
    let discs: Vec<Region> = (0..5000).map(spiral).collect();
    let hull = Region::hull(&discs);
    for direction in directions() {
        let reach = |region: &Region| match region.contours[0].edges[0] {
            chiaro_plane::Edge::Arc { center, radius, .. } => {
                center[0] * direction[0] + center[1] * direction[1] + radius
            }
            chiaro_plane::Edge::Line { .. } => f64::NEG_INFINITY,
        };
        let farthest = discs.iter().map(reach).fold(f64::NEG_INFINITY, f64::max);
        let found = support(&corners(std::slice::from_ref(&hull)), direction);
        assert!((found - farthest).abs() < 5e-3, "{found} and {farthest}");
    }
}

/// A star with as many points, turned.
fn star(points: u32, turn: f64) -> Region {
    let corner = |k: u32| {
        let angle = std::f64::consts::PI * f64::from(k) / f64::from(points) + turn;
        let radius = if k.is_multiple_of(2) { 10.0 } else { 6.0 };
        [radius * angle.cos(), radius * angle.sin()]
    };
    Region::polygon(&(0..2 * points).map(corner).collect::<Vec<_>>(), None)
}

#[test]
fn sums_of_jagged_outlines_end() {
    let sum = star(30, 0.0).minkowski(&star(30, 0.01)).unwrap();
    let (min, max) = sum.bounds().unwrap();
    assert!((max[0] - 20.0).abs() < 0.1 && (min[0] + 20.0).abs() < 0.1);
    assert!(sum.contains([0.0, 0.0]) && sum.contains([14.0, 0.0]) && !sum.contains([15.0, 15.0]));
    assert_eq!(sum.contours.len(), 1);
    // Of too many corners there is no sum, rather than one after minutes.
    assert_eq!(star(3000, 0.0).minkowski(&star(3000, 0.01)), None);
}
