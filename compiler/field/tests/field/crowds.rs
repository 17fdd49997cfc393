//! Crowds of random trees: cells list whatever can be the nearest, and patterns with a member's numbers are the member.

use std::sync::Arc;

use chiaro_field::crowd::{Cell, Cells, Crowd};
use chiaro_field::{Bounds, Crowds, Evaluator, lower};
use chiaro_solid::{Boolean, Scalar, Solid};

use crate::trees::{self, Random, Trees};

/// A union of many trees at random places, that differ by nothing but numbers from one of some random trees.
fn many(random: &mut Random, count: u64, depth: u32, reach: f64) -> Arc<Solid> {
    const STRUCTURES: u64 = 8;
    let first = random.bits();
    let members = (0..count)
        .map(|i| {
            let by = random.point(reach);
            let mut structure = Random(first.wrapping_add(i % STRUCTURES));
            let mut number = |structure: &mut Random, least: f64, most: f64| {
                structure.within(least, most);
                Scalar::from(random.within(least, most))
            };
            let tree = Trees { random: &mut structure, number: &mut number }.space(depth);
            trees::moved(by, tree)
        })
        .collect();
    trees::boolean(Boolean::Union, None, members)
}

fn least(evaluator: &Evaluator, crowd: &Crowd, members: impl Iterator<Item = usize>, point: [f64; 3]) -> f64 {
    members.map(|member| evaluator.value(crowd.members[member].node, point)).fold(f64::INFINITY, f64::min)
}

#[test]
fn cells_list_whatever_can_be_the_nearest() {
    let mut random = Random(11);
    let mut found = 0;
    for (depth, reach) in [(0, 60.0), (0, 12.0), (1, 60.0), (1, 15.0), (2, 60.0), (2, 20.0)] {
        let graph = lower(&many(&mut random, 150, depth, reach)).0;
        let crowds = Crowds::of(&graph);
        let evaluator = Evaluator::new(&graph, &[]);
        for crowd in &crowds.crowds {
            let Some(cells) = Cells::of(&graph, crowd, &[], 1 << 18) else { continue };
            found += 1;
            let (grid, mut asked) = (cells.bounds(), 0);
            for _ in 0..600 {
                let point = inside(&grid, &mut random);
                let listed = cells.at(point);
                asked += listed.len();
                let some = least(&evaluator, crowd, listed.iter().map(|member| *member as usize), point);
                let all = least(&evaluator, crowd, 0..crowd.members.len(), point);
                assert_eq!(some, all, "at {point:?} of depth {depth}");
            }
            assert!(reach < 60.0 || asked < 150 * crowd.members.len(), "{asked} of 600 × {}", crowd.members.len());
        }
    }
    assert!(found >= 3, "only {found} of the unions have cells");
}

fn inside(bounds: &Bounds, random: &mut Random) -> [f64; 3] {
    std::array::from_fn(|axis| random.within(bounds.min[axis], bounds.max[axis]))
}

#[test]
fn patterns_with_a_members_numbers_are_the_member() {
    let mut random = Random(12);
    let graph = lower(&many(&mut random, 200, 2, 60.0)).0;
    let crowds = Crowds::of(&graph);
    let evaluator = Evaluator::new(&graph, &[]);
    let mut checked = 0;
    for crowd in &crowds.crowds {
        for member in &crowd.members {
            let pattern = &crowds.patterns[crowd.patterns[member.pattern]];
            let numbers: Vec<f64> = member.numbers.iter().map(|number| number.value(&[])).collect();
            let patterned = Evaluator::new(&pattern.graph, &numbers);
            for _ in 0..10 {
                let point = random.point(70.0);
                let (found, expected) = (patterned.distance(point), evaluator.value(member.node, point));
                assert!((found - expected).abs() <= 1e-9 * (1.0 + expected.abs()), "{found} instead of {expected}");
                checked += 1;
            }
        }
    }
    assert!(checked >= 640, "{checked}");
}

#[test]
fn members_that_differ_by_numbers_follow_one_pattern() {
    let place = |i: u32| [f64::from(i % 10) * 5.0, f64::from(i / 10) * 5.0, 1.0];
    let ball =
        |i: u32| trees::moved(place(i), trees::shape(&chiaro_vocabulary::rows::SPHERE, &[1.0 + f64::from(i % 3)]));
    let balls = trees::boolean(Boolean::Union, None, (0..100).map(ball).collect());
    let graph = lower(&balls).0;
    let crowds = Crowds::of(&graph);
    assert_eq!((crowds.crowds.len(), crowds.patterns.len()), (1, 1));
    assert_eq!(crowds.crowds[0].members.len(), 100);
    // A few are no crowd.
    let few = trees::boolean(Boolean::Union, None, (0..20).map(ball).collect());
    assert!(Crowds::of(&lower(&few).0).is_empty());
}

/// Each list is a part of the members, in rising order; each cube is of the grid or of one block; and each member is
/// listed.
fn assert_well_formed(cells: &Cells, count: usize) {
    const BLOCK: usize = 64;
    let grid: usize = cells.counts.iter().map(|count| *count as usize).product();
    let (mut blocks, mut listed) = (Vec::new(), vec![false; count]);
    for cell in &cells.cells {
        match *cell {
            Cell::Block(first) => blocks.push(first as usize),
            Cell::List(first, last) => {
                let list = &cells.members[first as usize..last as usize];
                assert!(!list.is_empty() && list.is_sorted_by(|a, b| a < b), "{list:?}");
                list.iter().for_each(|member| listed[*member as usize] = true);
            }
        }
    }
    blocks.sort_unstable();
    let expected: Vec<usize> = (0..blocks.len()).map(|block| grid + BLOCK * block).collect();
    assert_eq!(blocks, expected);
    assert_eq!(cells.cells.len(), grid + BLOCK * blocks.len());
    assert!(listed.iter().all(|is_listed| *is_listed));
}

#[test]
fn room_is_kept() {
    let mut random = Random(13);
    let graph = lower(&many(&mut random, 400, 0, 200.0)).0;
    let crowds = Crowds::of(&graph);
    let evaluator = Evaluator::new(&graph, &[]);
    let crowd = &crowds.crowds[0];
    let longest = crowd.members.len();
    assert!(Cells::of(&graph, crowd, &[], 1).is_none());
    for room in [100_000, 200_000] {
        let cells = Cells::of(&graph, crowd, &[], room).unwrap();
        assert!(cells.cells.len() + cells.members.len() <= room + 96 * longest, "{room}");
        for _ in 0..100 {
            let point = inside(&cells.bounds(), &mut random);
            let some = least(&evaluator, crowd, cells.at(point).iter().map(|member| *member as usize), point);
            assert_eq!(some, least(&evaluator, crowd, 0..longest, point));
        }
        assert_well_formed(&cells, longest);
    }
}

#[test]
fn members_that_lie_in_each_other_have_no_cells() {
    let ball = |i: u32, apart: f64| {
        let place = [apart * f64::from(i), apart * f64::from(i * i % 97), 0.0];
        trees::moved(place, trees::shape(&chiaro_vocabulary::rows::SPHERE, &[10.0 + f64::from(i % 7) / 100.0]))
    };
    for (apart, has_cells) in [(0.001, false), (5.0, true)] {
        let balls = trees::boolean(Boolean::Union, None, (0..300).map(|i| ball(i, apart)).collect());
        let graph = lower(&balls).0;
        let crowds = Crowds::of(&graph);
        assert_eq!(Cells::of(&graph, &crowds.crowds[0], &[], 1 << 18).is_some(), has_cells, "{apart} mm apart");
    }
}
