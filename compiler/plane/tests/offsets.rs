//! Offsets against distances, point by point.

mod common;

use std::f64::consts::PI;

use chiaro_plane::{Edge, Join, Region};
use common::{assert_closed, region, samples, stadium};
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn round_offsets_agree_with_distances(a in region(), b in region(), by in -3.0..3.0f64) {
        let region = Region::union(&[a, b]).normalized();
        let grown = region.offset(by, Join::Round);
        assert_closed(&grown);
        for p in samples() {
            let distance = region.signed_distance(p);
            if (distance - by).abs() > 2e-3 {
                assert_eq!(grown.contains(p), distance < by, "{p:?} at {distance} of {region:?} by {by}: {grown:?}");
            }
        }
        for p in common::outline(&grown) {
            let off = (region.signed_distance(p) - by).abs();
            assert!(off < 2e-3, "{p:?} is off by {off}: {region:?} by {by}: {grown:?}");
        }
    }

    #[test]
    fn sharper_joins_contain_round_ones(a in region(), by in 0.1..3.0f64) {
        let a = a.normalized();
        let round = a.offset(by, Join::Round);
        let chamfer = a.offset(by, Join::Chamfer);
        let sharp = a.offset(by, Join::SHARP);
        assert_closed(&sharp);
        for p in samples().filter(|p| a.signed_distance(*p) - by < -2e-3) {
            prop_assert!(chamfer.contains(p) && sharp.contains(p));
        }
        prop_assert!(round.area() <= chamfer.area() + 1e-3 && chamfer.area() <= sharp.area() + 1e-3);
    }
}

fn arcs(region: &Region) -> usize {
    region.edges().filter(|edge| matches!(edge, Edge::Arc { .. })).count()
}

#[test]
fn discs_and_stadiums_stay_what_they_are() {
    assert_eq!(Region::circle(2.0).offset(1.0, Join::Round), Region::circle(3.0));
    assert_eq!(Region::circle(2.0).offset(-0.5, Join::SHARP), Region::circle(1.5));
    assert!(Region::circle(2.0).offset(-2.0, Join::Round).is_empty());
    assert!(Region::circle(2.0).offset(-3.0, Join::Round).is_empty());
    for by in [1.0, -0.5] {
        let moved = stadium(1.0, 5.0).offset(by, Join::Round);
        assert_eq!((moved.edges().count(), arcs(&moved)), (4, 2), "{moved:?}");
        let r = 1.0 + by;
        assert!((moved.area() - (10.0 * r + PI * r * r)).abs() < 1e-9);
    }
}

#[test]
fn corners_join_as_asked() {
    let square = Region::rectangle([0.0, 0.0], [10.0, 10.0]);
    let round = square.offset(1.0, Join::Round);
    assert_eq!((round.edges().count(), arcs(&round)), (8, 4));
    assert!((round.area() - (140.0 + PI)).abs() < 1e-9);
    assert!((square.offset(1.0, Join::SHARP).area() - 144.0).abs() < 1e-9);
    let chamfer = square.offset(1.0, Join::Chamfer);
    assert_eq!(chamfer.edges().count(), 8);
    // OpenSCAD cuts the corner at (11, 10.4142).
    let corner = chamfer.edges().map(Edge::start).find(|p| (p[0] - 11.0).abs() < 1e-9 && p[1] > 10.0).unwrap();
    assert!((corner[1] - (9.0 + 2f64.sqrt())).abs() < 1e-9);

    // OpenSCAD moves the tip of this needle from 1000 to 3000.
    let needle = Region::polygon(&[[0.0, 0.0], [1000.0, 0.5], [0.0, 1.0]], None);
    let (_, max) = needle.offset(1.0, Join::SHARP).bounds().unwrap();
    assert!((max[0] - 3000.0).abs() < 0.01, "{max:?}");
    let (_, max) = needle.offset(1.0, Join::Miter { limit: 2.0 }).bounds().unwrap();
    assert!((max[0] - 1001.0).abs() < 0.01, "{max:?}");
}

#[test]
fn holes_shrink_and_close() {
    let frame = Region::rectangle([0.0, 0.0], [10.0, 10.0]).difference(&[Region::rectangle([4.0, 4.0], [6.0, 6.0])]);
    assert!((frame.offset(-1.0, Join::SHARP).area() - (64.0 - 16.0)).abs() < 1e-9);
    assert!((frame.offset(-1.0, Join::Round).area() - (64.0 - 4.0 - 8.0 - PI)).abs() < 1e-9);
    assert_eq!(frame.offset(1.0, Join::Round).contours.len(), 1);
    assert!(frame.offset(-2.0, Join::SHARP).is_empty());
    assert_eq!(frame.offset(-2.0, Join::Round).contours.len(), 4, "only the corners are further from the outline");
    assert!(frame.offset(-3.0, Join::Round).is_empty());
    // Opening and closing round the corners but not the sides.
    let opened = frame.offset(-1.5, Join::Round).offset(1.5, Join::Round);
    assert!(opened.area() < frame.area() && opened.area() > 0.9 * frame.area());
}

#[test]
fn distances_beyond_reason_give_nothing() {
    let square = Region::rectangle([0.0, 0.0], [1.0, 1.0]);
    for by in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e300] {
        assert!(square.offset(by, Join::Round).is_empty(), "{by}");
    }
    assert!(Region::default().offset(1.0, Join::Round).is_empty());
    assert!(!square.offset(1e9, Join::Round).is_empty());
    assert!(!square.offset(1e-9, Join::Round).is_empty());
    assert!((square.offset(0.0, Join::SHARP).area() - 1.0).abs() < 1e-12);
}
