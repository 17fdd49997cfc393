//! Outlines of lines and arcs, and polytopes, against brute force.

mod common;

use std::f64::consts::{PI, TAU};

use chiaro_vocabulary::cpu::Dual;
use common::{Random, call, length};

type Point = [f64; 2];

#[derive(Clone, Copy, Debug)]
enum Edge {
    Line(Point, Point),
    Arc { a: Point, b: Point, center: Point, sweep: f64 },
}

fn distance(edges: &[Edge], p: Point) -> f64 {
    let [squared, sign, _] = call::<f64>("outline_start", &[]);
    let mut state = [squared, sign];
    for edge in edges {
        let [squared, sign, _] = match edge {
            Edge::Line(a, b) => call("outline_line", &[&state, &p, a, b]),
            Edge::Arc { a, b, center, sweep } => call("outline_arc", &[&state, &p, a, b, center, &[*sweep]]),
        };
        state = [squared, sign];
    }
    call("outline_end", &[&state])[0]
}

fn polygon(corners: &[Point]) -> Vec<Edge> {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(a, b)| Edge::Line(*a, *b)).collect()
}

/// The arc from a to b over sweep.
fn arc(a: Point, b: Point, sweep: f64) -> Edge {
    let t = 0.5 / (0.5 * sweep).tan();
    let center = [0.5 * (a[0] + b[0]) - t * (b[1] - a[1]), 0.5 * (a[1] + b[1]) + t * (b[0] - a[0])];
    Edge::Arc { a, b, center, sweep }
}

/// The edge as a fine polygon line, without its end.
fn flattened(edge: &Edge) -> Vec<Point> {
    const STEPS: usize = 400;
    (0..STEPS)
        .map(|step| {
            let t = step as f64 / STEPS as f64;
            match *edge {
                Edge::Line(a, b) => [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])],
                Edge::Arc { a, center, sweep, .. } => {
                    let (s, c) = (sweep * t).sin_cos();
                    let from = [a[0] - center[0], a[1] - center[1]];
                    [center[0] + c * from[0] - s * from[1], center[1] + s * from[0] + c * from[1]]
                }
            }
        })
        .collect()
}

/// How often a closed line of points winds around p.
fn winding(points: &[Point], p: Point) -> i64 {
    let angle = |q: &Point| (q[1] - p[1]).atan2(q[0] - p[0]);
    let turns = points.iter().zip(points.iter().cycle().skip(1)).map(|(a, b)| {
        let turn = angle(b) - angle(a);
        turn - TAU * (turn / TAU).round()
    });
    (turns.sum::<f64>() / TAU).round() as i64
}

#[test]
fn a_square_with_a_hole() {
    let corners = |r: f64| polygon(&[[-r, -r], [r, -r], [r, r], [-r, r]]);
    let edges = [corners(3.0), corners(1.0)].concat();
    for (p, expected) in
        [([0.0, 0.0], 1.0), ([2.0, 0.5], -1.0), ([2.5, 1.0], -0.5), ([6.0, 7.0], 5.0), ([4.0, 3.0], 1.0)]
    {
        assert!((distance(&edges, p) - expected).abs() < 1e-9, "{p:?}");
    }
}

#[test]
fn a_bow_tie_is_even_odd() {
    let edges = polygon(&[[-2.0, -1.0], [2.0, 1.0], [2.0, -1.0], [-2.0, 1.0]]);
    for (p, inside) in [([1.5, 0.0], true), ([-1.5, 0.0], true), ([0.0, 0.5], false), ([0.0, -0.5], false)] {
        assert_eq!(distance(&edges, p) < 0.0, inside, "{p:?}");
    }
}

#[test]
fn a_circle_of_one_or_two_arcs_either_way_round() {
    let mut random = Random(4);
    let full = |sweep| vec![Edge::Arc { a: [5.0, 1.0], b: [5.0, 1.0], center: [2.0, 1.0], sweep }];
    let halves = |sweep: f64| {
        let (a, b, center) = ([5.0, 1.0], [-1.0, 1.0], [2.0, 1.0]);
        vec![Edge::Arc { a, b, center, sweep }, Edge::Arc { a: b, b: a, center, sweep }]
    };
    for edges in [full(TAU), full(-TAU), halves(PI), halves(-PI)] {
        for _ in 0..500 {
            let level = random.bits().is_multiple_of(2);
            let p = [random.within(-8.0, 8.0), if level { 1.0 } else { random.within(-8.0, 8.0) }];
            let expected = length([p[0] - 2.0, p[1] - 1.0]) - 3.0;
            assert!((distance(&edges, p) - expected).abs() < 1e-9, "{edges:?} at {p:?}");
        }
        // Level with the centre and with the arcs' ends.
        assert!((distance(&edges, [2.0, 1.0]) + 3.0).abs() < 1e-9);
        assert!((distance(&edges, [-4.0, 1.0]) - 3.0).abs() < 1e-9);
        assert!((distance(&edges, [1.0, 1.0]) + 2.0).abs() < 1e-9);
    }
}

#[test]
fn random_contours_match_brute_force() {
    let mut random = Random(5);
    for _ in 0..60 {
        // Corners on a coarse grid, so that points are often level with several of them.
        let count = 3 + (random.bits() % 5) as usize;
        let corners: Vec<Point> = (0..count).map(|_| random.point::<2>(4.0).map(f64::round)).collect();
        let next = corners.iter().cycle().skip(1);
        let edges: Vec<Edge> = (corners.iter().zip(next))
            .filter(|(a, b)| a != b)
            .map(|(a, b)| {
                let sweep = random.of(&[0.0, 1.0, -1.0, 2.5, -2.5, 4.0, -4.0]);
                if sweep == 0.0 { Edge::Line(*a, *b) } else { arc(*a, *b, sweep) }
            })
            .collect();
        let points: Vec<Point> = edges.iter().flat_map(flattened).collect();
        for _ in 0..60 {
            let p = random.point::<2>(6.0);
            let p = if random.bits().is_multiple_of(2) { [p[0], p[1].round()] } else { p };
            let nearest = points.iter().map(|q| length([q[0] - p[0], q[1] - p[1]])).fold(f64::INFINITY, f64::min);
            let found = distance(&edges, p);
            assert!((found.abs() - nearest).abs() < 0.1, "{edges:?} at {p:?}: {found} instead of {nearest}");
            if nearest > 0.05 {
                assert_eq!(found < 0.0, winding(&points, p) % 2 != 0, "{edges:?} at {p:?}");
            }
        }
    }
}

/// The corners of a tetrahedron, and its faces anticlockwise seen from outside.
const CORNERS: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [6.0, 0.0, 0.0], [1.0, 5.0, 0.0], [2.0, 1.0, 4.0]];
const FACES: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];

fn tetrahedron(p: [Dual; 3]) -> Dual {
    let [squared, plane, _] = call::<Dual>("polytope_start", &[]);
    let mut state = [squared, plane];
    for face in FACES {
        let [a, b, c] = face.map(|corner| CORNERS[corner].map(|c| Dual { value: c, gradient: [0.0; 3] }));
        let [squared, plane, _] = call("polytope_triangle", &[&state, &p, &a, &b, &c]);
        state = [squared, plane];
    }
    call("polytope_end", &[&state])[0]
}

#[test]
fn a_tetrahedron_has_exact_distances() {
    let mut random = Random(6);
    let mut inside = 0;
    for _ in 0..3000 {
        let p = random.point::<3>(7.0);
        let d = tetrahedron(Dual::point(p));
        assert!((d.slope() - 1.0).abs() < 1e-6, "{p:?}: {d:?}");
        let foot: [f64; 3] = std::array::from_fn(|axis| p[axis] - d.value * d.gradient[axis]);
        assert!(tetrahedron(Dual::point(foot)).value.abs() < 1e-6, "{p:?}: {d:?}");
        let last = 1.0 - p[2] / 4.0;
        let (x, y) = (p[0] - 0.5 * p[2], p[1] - 0.25 * p[2]);
        let within = p[2] > 0.0 && y > 0.0 && x > 0.2 * y && x + y < 6.0 * last;
        assert!(d.value.abs() < 1e-9 || (d.value < 0.0) == within, "{p:?}: {d:?}");
        inside += usize::from(within);
    }
    assert!(inside > 5);
}
