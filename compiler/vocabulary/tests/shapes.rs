//! Every solid and plane shape of the table against what its row promises.

mod common;

use std::cell::RefCell;
use std::collections::BTreeMap;

use chiaro_vocabulary::cpu::Dual;
use chiaro_vocabulary::rows::{self, rows};
use chiaro_vocabulary::{Class, Interval, Kind, Row};
use common::{Random, ask, dot, length};

/// How far from the origin the tests look; the shapes are of that order.
const REACH: f64 = 25.0;

fn shapes() -> impl Iterator<Item = &'static Row> {
    rows().iter().copied().filter(|row| matches!(row.kind, Kind::Solid | Kind::Plane))
}

/// Random arguments that a shape can be made with.
fn arguments(row: &Row, random: &mut Random) -> Vec<f64> {
    let mut size = || random.within(0.5, 15.0);
    let sizes: Vec<f64> = (0..row.arity()).map(|_| size()).collect();
    match row.name {
        "cone" => vec![sizes[0] * random.of(&[0.0, 1.0]), sizes[1] * random.of(&[0.0, 1.0]), sizes[2]],
        "half_space" => {
            let normal = random.point::<3>(1.0);
            vec![normal[0] / length(normal), normal[1] / length(normal), normal[2] / length(normal), sizes[3] - 8.0]
        }
        "box_frame" => {
            let least = sizes[0].min(sizes[1]).min(sizes[2]);
            vec![sizes[0], sizes[1], sizes[2], least * random.within(0.1, 0.9)]
        }
        "ngon" => vec![sizes[0], random.of(&[3.0, 4.0, 5.0, 6.0, 12.0])],
        "ring" => vec![sizes[0], sizes[0] * random.of(&[0.0, 0.3, 0.9])],
        "star" => vec![sizes[0], sizes[0] * random.within(0.1, 1.0), random.of(&[2.0, 3.0, 5.0, 8.0])],
        "dome" => vec![sizes[0], sizes[0] * random.within(-0.9, 0.9)],
        "arc" => vec![sizes[0], 0.3 * sizes[1], random.within(-7.0, 7.0), random.within(0.1, 6.2)],
        "pie" => vec![sizes[0], random.within(-7.0, 7.0), random.within(0.1, 6.2)],
        "wedge" => vec![random.within(-7.0, 7.0), random.within(0.1, 6.2)],
        _ => sizes,
    }
}

/// A point for the shape to be asked at: three coordinates, of which plane shapes take two.
fn point_for(row: &Row, random: &mut Random) -> Vec<f64> {
    random.point::<3>(REACH)[..dimension(row)].to_vec()
}

fn dimension(row: &Row) -> usize {
    if row.kind == Kind::Plane { 2 } else { 3 }
}

fn dual(row: &Row, point: &[f64], arguments: &[f64]) -> Dual {
    let at: Vec<Dual> = point.iter().enumerate().map(|(axis, c)| Dual::coordinate(*c, axis)).collect();
    ask(row, &at, arguments)
}

/// Calls `check` with random shapes of each row and random points.
fn sample(check: impl Fn(&Row, &[f64], &[f64])) {
    for row in shapes() {
        let mut random = Random(7);
        for _ in 0..60 {
            let arguments = arguments(row, &mut random);
            for _ in 0..50 {
                check(row, &point_for(row, &mut random), &arguments);
            }
        }
    }
}

#[test]
fn slopes_are_at_most_one_and_exactly_one_where_promised() {
    sample(|row, point, arguments| {
        let d = dual(row, point, arguments);
        let shown = || format!("{} {arguments:?} at {point:?}: {} with slope {}", row.name, d.value, d.slope());
        assert!(d.slope() <= 1.0 + 2e-6, "{}", shown());
        let exact = row.class == Class::Exact || row.class == Class::ExactOutside && d.value > 0.0;
        assert!(!exact || (d.slope() - 1.0).abs() < 2e-6, "{}", shown());
    });
}

/// A value whose slope is at most 1 is at most the distance. It is the distance if the way down the gradient, as long
/// as the value, ends on the surface.
#[test]
fn exact_distances_lead_to_the_surface() {
    sample(|row, point, arguments| {
        let d = dual(row, point, arguments);
        if row.class == Class::Exact || row.class == Class::ExactOutside && d.value > 0.0 {
            let foot: Vec<f64> = (0..point.len()).map(|axis| point[axis] - d.value * d.gradient[axis]).collect();
            let there: f64 = ask(row, &foot, arguments);
            assert!(there.abs() < 1e-4, "{} {arguments:?} at {point:?}: {} leads to {there}", row.name, d.value);
        }
    });
}

#[test]
fn values_never_change_faster_than_the_point() {
    for row in shapes() {
        let mut random = Random(11);
        for _ in 0..2000 {
            let arguments = arguments(row, &mut random);
            let (a, b) = (point_for(row, &mut random), point_for(row, &mut random));
            let apart = a.iter().zip(&b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt();
            let change = (ask(row, &a, &arguments) - ask(row, &b, &arguments)).abs();
            assert!(change <= apart * (1.0 + 1e-6) + 1e-5, "{} {arguments:?}: {a:?} {b:?}", row.name);
        }
    }
}

#[test]
fn inside_points_lie_in_the_bounds() {
    sample(|row, point, arguments| {
        let intervals: Vec<_> = arguments.iter().map(|argument| Interval::point(*argument)).collect();
        let bounds = (row.bounds)(&intervals).inflate(1e-6);
        let at = [point[0], point[1], point.get(2).copied().unwrap_or(0.0)];
        let value: f64 = ask(row, point, arguments);
        assert!(value > 0.0 || bounds.distance(at) == 0.0, "{} {arguments:?} at {point:?}", row.name);
    });
}

#[test]
fn both_precisions_agree() {
    sample(|row, point, arguments| {
        let single: Vec<f32> = point.iter().map(|c| *c as f32).collect();
        let (single, double): (f32, f64) = (ask(row, &single, arguments), ask(row, point, arguments));
        let error = (f64::from(single) - double).abs();
        assert!(error < 2e-4, "{} {arguments:?} at {point:?}: {single} {double}", row.name);
    });
}

#[test]
fn values_are_finite_at_special_points() {
    for row in shapes() {
        let mut random = Random(3);
        for _ in 0..10 {
            let arguments = arguments(row, &mut random);
            let mut special = vec![0.0, 1.0, -1.0];
            special.extend(arguments.iter().flat_map(|a| [*a, -a]));
            for _ in 0..300 {
                let point: Vec<f64> = (0..dimension(row)).map(|_| random.of(&special)).collect();
                let d = dual(row, &point, &arguments);
                let single: Vec<f32> = point.iter().map(|c| *c as f32).collect();
                let single: f32 = ask(row, &single, &arguments);
                let finite = d.value.is_finite() && d.slope().is_finite() && single.is_finite();
                assert!(finite, "{} {arguments:?} at {point:?}: {d:?} {single}", row.name);
                assert!(d.slope() <= 2.0, "{} {arguments:?} at {point:?}: {d:?}", row.name);
            }
        }
    }
}

/// Whether a point is inside, said in another way than by a distance; none where it is not.
fn inside(row: &Row, p: &[f64], a: &[f64]) -> Option<bool> {
    let across = p[0].hypot(p[1]);
    let z = p.get(2).copied().unwrap_or(0.0);
    Some(match row.name {
        "sphere" => dot([p[0], p[1], z], [p[0], p[1], z]) < a[0] * a[0],
        "box" => (0..3).all(|axis| p[axis].abs() < a[axis]),
        "cylinder" => across < a[0] && z.abs() < a[1],
        "cone" => {
            let t = (z + a[2]) / (2.0 * a[2]);
            z.abs() < a[2] && across < a[0] + t * (a[1] - a[0])
        }
        "torus" => (0..3600).any(|i| {
            let angle = f64::from(i).to_radians() * 0.1;
            length([p[0] - a[0] * angle.cos(), p[1] - a[0] * angle.sin(), z]) < a[1]
        }),
        "capsule" => (0..=1000).any(|i| length([p[0], p[1], z - a[0] * f64::from(i) * 1e-3]) < a[1]),
        "round_cone" => (0..=1000).any(|i| {
            let t = f64::from(i) * 1e-3;
            length([p[0], p[1], z - a[2] * t]) < a[0] + t * (a[1] - a[0])
        }),
        "ellipsoid" => length([p[0] / a[0], p[1] / a[1], z / a[2]]) < 1.0,
        "half_space" => dot([p[0], p[1], z], [a[0], a[1], a[2]]) < a[3],
        "box_frame" => {
            let near_edge = (0..3).filter(|axis| p[*axis].abs() > a[*axis] - a[3]).count();
            (0..3).all(|axis| p[axis].abs() < a[axis]) && near_edge >= 2
        }
        "octahedron" => p[0].abs() + p[1].abs() + z.abs() < a[0],
        "link" => {
            let bend = length([p[0], (p[1].abs() - a[0]).max(0.0)]);
            length([bend - a[1], z]) < a[2]
        }
        "tetrahedron" => {
            let corners = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
            corners.iter().all(|corner| -dot(*corner, [p[0], p[1], z]) < a[0] / 3.0_f64.sqrt())
        }
        "dodecahedron" => {
            let g = 0.5 * (1.0 + 5.0_f64.sqrt());
            let inner = a[0] * g * g / (3.0 * (1.0 + g * g)).sqrt();
            (0..3).all(|axis| {
                let (x, z) = (p[axis].abs(), p[(axis + 2) % 3].abs());
                x + g * z < inner * (1.0 + g * g).sqrt()
            })
        }
        "icosahedron" => {
            let g = 0.5 * (1.0 + 5.0_f64.sqrt());
            let inner = a[0] * g * g / (3.0 * (1.0 + g * g)).sqrt();
            let sum = p[0].abs() + p[1].abs() + z.abs();
            let oblique = |axis: usize| p[(axis + 1) % 3].abs() / g + g * p[(axis + 2) % 3].abs();
            sum.max(oblique(0)).max(oblique(1)).max(oblique(2)) < inner * 3.0_f64.sqrt()
        }
        "dome" => length([p[0], p[1], z]) < a[0] && z > a[1],
        "arc" => (0..=1000).any(|i| {
            let (s, c) = (a[2] + a[3] * f64::from(i) * 1e-3).sin_cos();
            length([p[0] - a[0] * c, p[1] - a[0] * s]) < 0.5 * a[1]
        }),
        "pie" => across < a[0] && (p[1].atan2(p[0]) - a[1]).rem_euclid(std::f64::consts::TAU) < a[2],
        "egg" => (0..=1000).any(|i| {
            let t = f64::from(i) * 1e-3;
            length([p[0], p[1] - a[2] * t]) < a[0] + t * (a[1] - a[0])
        }),
        "vesica" => [0.5, -0.5].iter().all(|side| length([p[0] - side * a[1].min(2.0 * a[0]), p[1]]) < a[0]),
        "pyramid" => z > 0.0 && p[0].abs().max(p[1].abs()) < 0.5 * a[0] * (1.0 - z / a[1]),
        "circle" => across < a[0],
        "rectangle" => p[0].abs() < a[0] && p[1].abs() < a[1],
        "ngon" => (0..a[1] as usize).all(|i| {
            let middle = (i as f64 + 0.5) * std::f64::consts::TAU / a[1];
            p[0] * middle.cos() + p[1] * middle.sin() < a[0] * (std::f64::consts::PI / a[1]).cos()
        }),
        "ellipse" => (p[0] / a[0]).hypot(p[1] / a[1]) < 1.0,
        "ring" => across < a[0] && across > a[1],
        "star" => {
            // The outline's radius in this direction: a point and a notch joined by a line.
            let half_sector = std::f64::consts::PI / a[2];
            let angle = p[1].atan2(p[0]).rem_euclid(2.0 * half_sector);
            let angle = angle.min(2.0 * half_sector - angle);
            let (s, c) = half_sector.sin_cos();
            let (tip, notch) = ([a[0], 0.0], [a[1] * c, a[1] * s]);
            let q = [across * angle.cos(), across * angle.sin()];
            (notch[0] - tip[0]) * (q[1] - tip[1]) - (notch[1] - tip[1]) * (q[0] - tip[0]) > 0.0
        }
        "gyroid" => {
            let wave_number = std::f64::consts::TAU / a[0];
            let q = [p[0], p[1], z].map(|x| x * wave_number);
            let wave: f64 = (0..3).map(|axis| q[axis].sin() * q[(axis + 1) % 3].cos()).sum();
            wave.abs() < 0.5 * a[1] * wave_number * 3.0_f64.sqrt()
        }
        "wedge" => (p[1].atan2(p[0]) - a[0]).rem_euclid(std::f64::consts::TAU) < a[1],
        _ => return None,
    })
}

#[test]
fn signs_are_right() {
    // For each shape, how many points were found outside and inside.
    let seen = RefCell::new(BTreeMap::<&str, [usize; 2]>::new());
    sample(|row, point, arguments| {
        let value: f64 = ask(row, point, arguments);
        let inside = inside(row, point, arguments).unwrap_or_else(|| panic!("`inside` doesn't know {}", row.name));
        // The other definitions sample circles and segments: near the surface they may err.
        if value.abs() > 0.02 {
            assert_eq!(value < 0.0, inside, "{} {arguments:?} at {point:?}: {value}", row.name);
            seen.borrow_mut().entry(row.name).or_default()[usize::from(inside)] += 1;
        }
    });
    let seen = seen.into_inner();
    assert_eq!(seen.len(), shapes().count());
    assert!(seen.values().flatten().all(|count| *count >= 5), "{seen:?}");
}

#[test]
fn a_round_cone_whose_one_ball_swallows_the_other_is_a_ball() {
    let mut random = Random(5);
    for _ in 0..100 {
        let p = random.point::<3>(REACH);
        let bottom = ask(&rows::ROUND_CONE, &p, &[9.0, 2.0, 5.0]) - ask(&rows::SPHERE, &p, &[9.0]);
        let top = ask(&rows::ROUND_CONE, &p, &[2.0, 9.0, 5.0]) - ask(&rows::SPHERE, &[p[0], p[1], p[2] - 5.0], &[9.0]);
        assert!(bottom.abs() < 1e-9 && top.abs() < 1e-9, "{p:?}");
    }
}

#[test]
fn only_round_shapes_say_so() {
    for row in shapes().filter(|row| row.round) {
        let mut random = Random(9);
        for _ in 0..100 {
            let (p, arguments) = (point_for(row, &mut random), arguments(row, &mut random));
            let turned: Vec<f64> = p[1..].iter().chain(&p[..1]).copied().collect();
            let change: f64 = ask(row, &p, &arguments) - ask(row, &turned, &arguments);
            assert!(change.abs() < 1e-9, "{}", row.name);
        }
    }
}

/// The corners of the regular polyhedra that have them at distance 1 from the origin.
fn corners(name: &str) -> Vec<[f64; 3]> {
    let golden = 0.5 * (1.0 + 5f64.sqrt());
    let signs = (0..8).map(|bits| [0, 1, 2].map(|axis: usize| if bits >> axis & 1 == 0 { 1.0 } else { -1.0 }));
    let cycled = |[x, y, z]: [f64; 3]| [[x, y, z], [y, z, x], [z, x, y]];
    let base = match name {
        "tetrahedron" | "cube" => vec![[1.0, 1.0, 1.0]],
        "octahedron" => cycled([1.0, 0.0, 0.0]).to_vec(),
        "icosahedron" => cycled([1.0, 0.0, golden]).to_vec(),
        "dodecahedron" => [cycled([0.0, 1.0 / golden, golden]).to_vec(), vec![[1.0, 1.0, 1.0]]].concat(),
        _ => unreachable!("{name}"),
    };
    let all = signs.flat_map(|signs| base.iter().map(move |corner| [0, 1, 2].map(|axis| signs[axis] * corner[axis])));
    let kept = all.filter(|corner| name != "tetrahedron" || corner.iter().product::<f64>() > 0.0);
    let unit = |corner: [f64; 3]| {
        let length = corner.iter().map(|x| x * x).sum::<f64>().sqrt();
        corner.map(|x| x / length)
    };
    kept.map(unit).collect()
}

#[test]
fn distances_to_regular_polyhedra_are_exact_to_the_last_digits() {
    let mut asked = 0;
    for name in ["tetrahedron", "octahedron", "icosahedron", "dodecahedron"] {
        let row = shapes().find(|row| row.name == name).expect("the row");
        let distance = |point: [f64; 3], radius: f64| ask(row, &point, &[radius]);
        for corner in corners(name) {
            for radius in [1.0, 10.0, 12345.6] {
                // At the corner, and beyond it as far again.
                for (times, expected) in [(1.0, 0.0), (2.0, radius)] {
                    let found = distance(corner.map(|x| x * times * radius), radius);
                    let off = (found - expected).abs() / radius;
                    assert!(off < 2e-15, "{name} of {radius}: {found} at {times} times {corner:?}: {off:e}");
                    asked += 1;
                }
            }
        }
    }
    assert_eq!(asked, (8 / 2 + 8 * 3 + 8 * 3 + 8 * 4) * 6);
}

#[test]
fn forms_hold_their_shapes_and_bound_them() {
    sample(|row, point, arguments| {
        let value: f64 = ask(row, point, arguments);
        let form = row.form;
        let [x, y, z] = [point[0], point[1], point.get(2).copied().unwrap_or(0.0)];
        let weighted = |weights: &[(usize, f64)]| weights.iter().map(|(i, weight)| weight * arguments[*i]).sum::<f64>();
        let flats = form
            .flats
            .iter()
            .map(|flat| flat.normal[0] * x + flat.normal[1] * y + flat.normal[2] * z - weighted(flat.offset));
        let rounds = form.rounds.iter().map(|round| {
            let beyond = if round.is_sphere { x.hypot(y).hypot(z) } else { x.hypot(y) } - weighted(round.radius);
            if round.is_hollow { -beyond } else { beyond }
        });
        let beyond = flats.chain(rounds).fold(f64::NEG_INFINITY, f64::max);
        if value < -1e-6 {
            assert!(beyond <= 1e-6, "{}: {beyond} beyond a face, where the value is {value}", row.name);
            for [nx, ny, nz] in
                [[1.0, 0.0, 0.0], [-0.6, 0.8, 0.0], [0.48, 0.64, 0.6], [-0.48, 0.64, -0.6], [0.0, 0.0, 1.0]]
            {
                let reaches = form.discs.iter().map(|disc| {
                    let [cx, cy, cz] = disc.center.map(weighted);
                    let across = f64::hypot(nx, ny) * weighted(disc.radius);
                    nx * cx + ny * cy + nz * cz + across + weighted(disc.ball)
                });
                let reach = reaches.fold(f64::NEG_INFINITY, f64::max);
                let is_held = form.discs.is_empty() || nx * x + ny * y + nz * z <= reach + 1e-6;
                assert!(is_held, "{} with {arguments:?} is not held by its discs at {point:?}", row.name);
            }
        } else if value > 1e-6 && form.is_whole {
            assert!(beyond > -1e-6, "{}: within all faces, where the value is {value}", row.name);
        }
    });
}

/// Of an ellipsoid 25 times as long as thin. (Near the ends of needles, a hundred times as long, Newton's steps leave
/// some of the error.)
#[test]
fn long_ellipsoids_are_no_steeper_than_others() {
    let row = shapes().find(|row| row.name == "ellipsoid").expect("the row");
    let mut random = Random(11);
    let radii = [8.0, 9.7, 200.6];
    let reach = radii.map(|radius: f64| 1.1 * radius + 60.0);
    for _ in 0..4000 {
        let point = reach.map(|reach| random.within(-reach, reach));
        let slope = dual(row, &point, &radii).slope();
        assert!(slope <= 1.0 + 1e-6, "{slope} at {point:?} beside {radii:?}");
    }
}
