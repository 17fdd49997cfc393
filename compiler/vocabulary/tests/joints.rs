//! Joints: one equation, any number of operands, in any order.

mod common;

use chiaro_vocabulary::cpu::{Dual, Number};
use chiaro_vocabulary::rows::joint_steps;
use common::{Random, call};

/// The joint by Newton's method, as good as it gets.
fn joint<N: Number>(operands: &[N], r: f64, exponent: f64) -> N {
    joint_after(12, operands, r, exponent)
}

fn joint_after<N: Number>(steps: u32, operands: &[N], r: f64, exponent: f64) -> N {
    let (r, exponent) = (N::of(r), N::of(exponent));
    let mut x = operands.iter().copied().reduce(N::min).unwrap();
    for _ in 0..steps {
        let mut state = [N::of(0.0); 2];
        for operand in operands {
            let [sum, slope, _] = call("joint_term", &[&state, &[*operand, x, r, exponent]]);
            state = [sum, slope];
        }
        x = call("joint_step", &[&state, &[x, r]])[0];
    }
    x
}

const CLOSED: [(f64, &str); 3] = [(1.0, "joint_chamfer"), (2.0, "joint_fillet"), (3.0, "joint_smooth")];

#[test]
fn closed_forms_solve_the_equation() {
    let mut random = Random(1);
    for _ in 0..1000 {
        let [a, b] = random.point(4.0);
        let r = random.within(0.1, 5.0);
        for (exponent, function) in CLOSED {
            let x = call(function, &[&[a, b, r]])[0];
            let term = |d: f64| (1.0 - (d - x) / r).max(0.0).powf(exponent);
            assert!((term(a) + term(b) - 1.0).abs() < 1e-6, "{function}({a}, {b}, {r}) = {x}");
            assert!((x - joint(&[a, b], r, exponent)).abs() < 1e-6, "{function}({a}, {b}, {r})");
        }
    }
}

#[test]
fn operands_may_come_in_any_order_and_far_ones_do_not_count() {
    let mut random = Random(2);
    for _ in 0..300 {
        let operands: [f64; 5] = random.point(3.0);
        for (exponent, _) in CLOSED {
            let x = joint(&operands, 2.0, exponent);
            let mut turned = operands;
            turned.rotate_left(2);
            assert!((x - joint(&turned, 2.0, exponent)).abs() < 1e-9);
            let least = operands.iter().copied().fold(f64::INFINITY, f64::min);
            let far = [operands.as_slice(), &[least + 2.0]].concat();
            assert!((x - joint(&far, 2.0, exponent)).abs() < 1e-9);
        }
    }
}

#[test]
fn the_advised_number_of_steps_is_enough() {
    let mut random = Random(4);
    for count in 2..=16 {
        for _ in 0..100 {
            let spread = random.of(&[0.0, 0.1, 1.0]);
            let operands: Vec<f64> = (0..count).map(|_| spread * random.within(0.0, 1.0)).collect();
            for (exponent, _) in CLOSED {
                let early = joint_after(joint_steps(count), &operands, 1.0, exponent);
                let error = early - joint(&operands, 1.0, exponent);
                assert!((-1e-9..1e-5).contains(&error), "{operands:?} {exponent}: {error}");
            }
        }
    }
}

/// The gradient by the operands is their normalised weights, so that no slope grows.
#[test]
fn gradients_are_convex_combinations_by_weight() {
    let mut random = Random(3);
    for _ in 0..300 {
        let operands = random.point::<3>(1.5);
        for (exponent, _) in CLOSED {
            let x = joint(&Dual::point(operands), 2.0, exponent);
            let weights = operands.map(|d| call("joint_weight", &[&[d, x.value, 2.0, exponent]])[0]);
            let sum: f64 = weights.iter().sum();
            for (weight, by_operand) in weights.iter().zip(x.gradient) {
                assert!((weight / sum - by_operand).abs() < 1e-6, "{operands:?} {exponent}");
            }
        }
    }
}

#[test]
fn a_fillet_between_walls_is_the_circle_and_in_a_corner_the_sphere() {
    // The walls x = 0 and y = 0 with the material at negative x or y: a fillet of radius 3 has its centre at (3, 3).
    for angle in [0.1, 0.7, 1.5_f64] {
        let (x, y) = (3.0 - 3.0 * angle.cos(), 3.0 - 3.0 * angle.sin());
        assert!(call("joint_fillet", &[&[x, y, 3.0]])[0].abs() < 1e-9);
    }
    let along = 3.0 - 3.0 / 3.0_f64.sqrt();
    assert!(joint(&[along; 3], 3.0, 2.0).abs() < 1e-9);
}

#[test]
fn without_a_radius_it_is_the_minimum() {
    for (_, function) in CLOSED {
        assert_eq!(call(function, &[&[2.0, -1.0, 0.0]])[0], -1.0);
        assert_eq!(call(function, &[&[2.0_f32, 2.0, 0.0]])[0], 2.0);
    }
}
