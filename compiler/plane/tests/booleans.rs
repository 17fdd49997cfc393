//! Boolean operations against membership, point by point.

mod common;

use chiaro_plane::{Edge, Region};
use common::{assert_closed, outline, region, samples};
use proptest::prelude::*;

/// How near to an outline a point may be on the wrong side, in millimetres: chords are off by half as much.
const NEAR: f64 = 1e-3;

fn assert_members(result: &Region, operands: &[&Region], expected: impl Fn(&[bool]) -> bool) {
    assert_closed(result);
    for p in samples() {
        if operands.iter().all(|operand| operand.signed_distance(p).abs() > NEAR) {
            let inside: Vec<bool> = operands.iter().map(|operand| operand.contains(p)).collect();
            assert_eq!(result.contains(p), expected(&inside), "{p:?} of {operands:?}: {result:?}");
        }
    }
    for p in outline(result) {
        let off = operands.iter().map(|operand| operand.signed_distance(p).abs()).fold(f64::INFINITY, f64::min);
        assert!(off < 1e-3, "{p:?} is off by {off}: {operands:?} {result:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn booleans_agree_with_membership(a in region(), b in region(), c in region()) {
        let all = [&a, &b, &c];
        let list = all.map(Region::clone);
        assert_members(&Region::union(&list), &all, |inside| inside.iter().any(|x| *x));
        assert_members(&Region::intersection(&list), &all, |inside| inside.iter().all(|x| *x));
        assert_members(&a.difference(&list[1..]), &all, |inside| inside[0] && !inside[1] && !inside[2]);
        assert_members(&a.xor(&b), &all[..2], |inside| inside[0] != inside[1]);
        assert_members(&a.normalized(), &all[..1], |inside| inside[0]);
    }

    #[test]
    fn areas_add_up(a in region(), b in region()) {
        let both = Region::intersection(&[a.clone(), b.clone()]).area();
        let any = Region::union(&[a.clone(), b.clone()]).area();
        let sum = a.area() + b.area();
        prop_assert!((any + both - sum).abs() <= 1e-6 * sum, "{} {}", any + both, sum);
        prop_assert!((any - both - a.xor(&b).area()).abs() <= 1e-6 * sum);
        prop_assert!((a.area() - both - a.difference(&[b]).area()).abs() <= 1e-6 * sum);
    }
}

fn arcs(region: &Region) -> usize {
    region.edges().filter(|edge| matches!(edge, Edge::Arc { .. })).count()
}

#[test]
fn arcs_survive_with_exact_ends() {
    // Two unit discs one apart meet at x = 1/2, y = ±√3/2.
    let lens = Region::intersection(&[Region::circle(1.0), Region::disc([1.0, 0.0], 1.0)]);
    assert_eq!((lens.edges().count(), arcs(&lens)), (2, 2));
    for edge in lens.edges() {
        let [x, y] = edge.start();
        assert!((x - 0.5).abs() < 1e-12 && (y.abs() - 0.75f64.sqrt()).abs() < 1e-12);
    }
    let exact = 2.0 * std::f64::consts::PI / 3.0 - 0.75f64.sqrt();
    assert!((lens.area() - exact).abs() < 1e-12);

    let bitten = Region::rectangle([0.0, 0.0], [4.0, 4.0]).difference(&[Region::disc([4.0, 4.0], 2.0)]);
    assert_eq!((bitten.edges().count(), arcs(&bitten)), (5, 1));
    let holed = Region::rectangle([0.0, 0.0], [4.0, 4.0]).difference(&[Region::disc([2.0, 2.0], 1.0)]);
    assert_eq!((holed.edges().count(), arcs(&holed)), (5, 1));
    assert!(holed.contours[1].signed_area() < 0.0);
}

#[test]
fn tangent_and_coincident_outlines_leave_no_crumbs() {
    // A rounded rectangle out of two rectangles and four discs.
    let disc = |x, y| Region::disc([x, y], 1.0);
    let parts = [
        Region::rectangle([0.0, 1.0], [6.0, 3.0]),
        Region::rectangle([1.0, 0.0], [5.0, 4.0]),
        disc(1.0, 1.0),
        disc(5.0, 1.0),
        disc(1.0, 3.0),
        disc(5.0, 3.0),
    ];
    let rounded = Region::union(&parts);
    assert_eq!((rounded.contours.len(), rounded.edges().count(), arcs(&rounded)), (1, 8, 4), "{rounded:?}");
    assert!((rounded.area() - (20.0 + std::f64::consts::PI)).abs() < 1e-9);

    let disc = Region::circle(3.0);
    assert!(disc.difference(std::slice::from_ref(&disc)).is_empty());
    assert_eq!(Region::union(&[disc.clone(), disc.clone()]), disc);
    let half = disc.difference(&[Region::rectangle([-5.0, -5.0], [5.0, 0.0])]);
    let other = disc.difference(&[Region::rectangle([-5.0, 0.0], [5.0, 5.0])]);
    assert_eq!(Region::union(&[half.clone(), other.clone()]), disc);
    assert!(Region::intersection(&[half, other]).is_empty());

    // Squares side by side become one rectangle of four edges.
    let squares = [0.0, 1.0, 2.0].map(|x| Region::rectangle([x, 0.1], [x + 1.0, 0.7]));
    assert_eq!(Region::union(&squares).edges().count(), 4);
}

#[test]
fn what_is_apart_keeps_its_arcs_and_empties_are_skipped() {
    let far = [Region::circle(1.0), Region::default(), Region::disc([5.0, 5.0], 1.0)];
    let union = Region::union(&far);
    assert_eq!(union.contours, [far[0].contours.clone(), far[2].contours.clone()].concat());
    assert_eq!(far[0].difference(&far[1..]), far[0]);
    assert!(Region::intersection(&far).is_empty());
    assert!(Region::intersection(&[]).is_empty());
    assert!(far[1].difference(&far[..1]).is_empty());
}

#[test]
fn coordinates_beyond_reason_give_nothing() {
    for x in [f64::NAN, f64::INFINITY, 1e300] {
        let edge = |from, to| Edge::Line { from, to };
        let edges = vec![edge([0.0, 0.0], [x, 0.0]), edge([x, 0.0], [1.0, 1.0]), edge([1.0, 1.0], [0.0, 0.0])];
        let wild = Region { contours: vec![chiaro_plane::Contour { edges }] };
        let _ = Region::union(&[wild.clone(), Region::circle(1.0)]);
        let _ = wild.difference(&[Region::circle(1.0)]);
        let _ = wild.xor(&Region::circle(1.0));
        let _ = wild.normalized().area();
    }
}
