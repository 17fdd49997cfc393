//! Warps, sections and confinement.

mod common;

use std::f64::consts::PI;

use chiaro_vocabulary::cpu::Dual;
use chiaro_vocabulary::rows;
use common::{Random, ask, call, length};

fn turned([x, y]: [f64; 2], angle: f64) -> [f64; 2] {
    let (s, c) = angle.sin_cos();
    [c * x - s * y, s * x + c * y]
}

#[test]
fn an_extrusion_turns_and_then_scales_its_levels() {
    let mut random = Random(1);
    for _ in 0..200 {
        let q = random.point::<2>(5.0);
        let (height, twist, t) = (random.within(1.0, 9.0), random.within(-5.0, 5.0), random.within(0.0, 1.0));
        let top: [f64; 2] = [random.within(0.1, 2.0), random.within(0.1, 2.0)];
        let level = turned(q, twist * t);
        let [x, y] = [0, 1].map(|axis| level[axis] * (1.0 - t + t * top[axis]));
        let found = call("section_extrude", &[&[x, y, height * t, height, twist], &top]);
        assert!(length([found[0] - q[0], found[1] - q[1]]) < 1e-9);
    }
    let apex = call("section_extrude", &[&[1.0_f32, 1.0, 9.0, 9.0, 0.0, 0.0, 0.0]]);
    assert!(apex.iter().all(|c| c.is_finite()) && apex[0] > 100.0);
}

#[test]
fn a_twisted_solid_turns_anticlockwise_with_the_height() {
    let [x, y] = turned([3.0, 0.0], 0.2 * 4.0);
    let asked = call("warp_twist", &[&[x, y, 4.0, 0.2]]);
    assert!(length([asked[0] - 3.0, asked[1], asked[2] - 4.0]) < 1e-9);
}

#[test]
fn facets_put_their_corners_at_the_radius() {
    let mut random = Random(2);
    for n in [3.0, 4.0, 5.0, 6.0, 8.0] {
        for corner in 0..n as usize {
            let [x, y] = turned([7.0, 0.0], corner as f64 * 2.0 * PI / n);
            let [r, z, _] = call("section_revolve_facets", &[&[x, y, 2.0, n]]);
            assert!((r - 7.0).abs() < 1e-6 && z == 2.0);
        }
        for _ in 0..200 {
            let p = random.point::<3>(9.0);
            let [r, ..] = call("section_revolve_facets", &[&Dual::point(p), &[Dual { value: n, gradient: [0.0; 3] }]]);
            assert!((r.slope() * (PI / n).cos() - 1.0).abs() < 1e-6);
            let polygon: f64 = ask(&rows::NGON, &p[..2], &[7.0, n]);
            assert!(polygon.abs() < 1e-6 || (polygon < 0.0) == (r.value < 7.0));
        }
    }
}

#[test]
fn an_extruded_rectangle_is_a_box() {
    let mut random = Random(3);
    for _ in 0..200 {
        let p = random.point::<3>(9.0);
        let plane: f64 = ask(&rows::RECTANGLE, &p[..2], &[3.0, 2.0]);
        let extruded = call("op_extrude", &[&[plane, p[2], 4.0]])[0];
        let expected: f64 = ask(&rows::BOX, &[p[0], p[1], p[2] - 2.0], &[3.0, 2.0, 2.0]);
        assert!((extruded - expected).abs() < 1e-9);
    }
}

#[test]
fn confinement_keeps_what_is_within_and_bounds_what_is_beyond() {
    assert_eq!(call("confine_disc", &[&[1.0, 1.0, 5.0, 2.0]]), [1.0, 1.0, 5.0]);
    let moved = call("confine_disc", &[&[6.0, 8.0, 5.0, 2.0]]);
    assert!(length([moved[0] - 1.2, moved[1] - 1.6, moved[2] - 5.0]) < 1e-9);
    assert_eq!(call("confine_disc", &[&[0.0_f32, 0.0, 5.0, 2.0]]), [0.0, 0.0, 5.0]);
    assert_eq!(call("confine_join", &[&[-3.0, 0.0, 2.0]])[0], -3.0);
    assert_eq!(call("confine_join", &[&[3.0, 2.0, 2.0]])[0], 5.0);
}
