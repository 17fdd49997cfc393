//! Numbers that stay live, and those that can't.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use chiaro_vocabulary::Interval;

use super::{Options, Outcome, run, run_with};
use crate::LiveLiteral;

/// The names of a scene's live parameters; a component's number follows its name.
fn names(outcome: &Outcome) -> Vec<String> {
    assert!(outcome.errors.is_empty(), "{:?}", outcome.errors);
    let name = |p: &chiaro_solid::LiveParameter| p.component.map_or(p.name.to_string(), |at| format!("{}{at}", p.name));
    outcome.parameters.iter().map(name).collect()
}

#[test]
fn sliders_and_time_stay_live() {
    let outcome =
        run("r = 10; // [1:0.5:30]\nv = [1, 2]; // [0:5]\ns = 3; // 2\nsphere(r); translate(v) cube(s + $t);");
    assert_eq!(names(&outcome), ["r", "v0", "v1", "$t"]);
    let r = &outcome.parameters[0];
    assert_eq!((r.default, r.range.min, r.range.max, r.step), (10.0, 1.0, 30.0, Some(0.5)));
    assert!(outcome.notes.is_empty());
}

#[test]
fn time_is_a_parameter_only_if_it_is_used() {
    assert!(names(&run("cube(1);")).is_empty());
    assert_eq!(names(&run("rotate(360 * $t) cube(1);")), ["$t"]);
}

#[test]
fn arithmetic_and_choices_of_numbers_stay_live() {
    let head = "r = 10; // [1:30]\n";
    for expression in [
        "sphere(max(r, 3) + sin(r) ^ 2);",
        "translate(r > 5 ? [1, 2, r] : [3, 4, 5]) cube(1);",
        "function f(x) = x < 3 || x > 20 ? 1 : x; sphere(f(f(r)));",
        "translate([for (i = [0 : 2]) i * r]) cube(norm([r, r]));",
        "assert(r > 0) sphere(r);",
    ] {
        assert_eq!(names(&run(&format!("{head}{expression}"))), ["r"], "{expression}");
    }
}

#[test]
fn what_decides_the_structure_is_demoted_with_a_note() {
    let head = "n = 3; // [1:30]\nr = 2; // [1:9]\n";
    for (text, value) in [
        ("for (i = [0 : n]) sphere(r + i);", "[]"),
        ("if (n > 2) sphere(r); echo(n > 2);", "true"),
        ("echo([5, 6, 7, 8][n]); sphere(r);", "8"),
        ("echo(str(n)); sphere(r);", "\"3\""),
        ("function f(k) = k <= 0 ? 0 : 1 + f(k - 1); echo(f(n)); sphere(r);", "3"),
        ("echo(n == 3 ? \"yes\" : 0); sphere(r);", "\"yes\""),
        ("x = n == 3 ? 1 : assert(false) 2; sphere(x + r); echo(x);", "1"),
        ("assert(n < 10); sphere(r);", "[]"),
        ("x = [for (s = n, i = 0; i < 9000; i = i + 1, s = s + n) s]; sphere(x[8999] + r);", "[]"),
    ] {
        let outcome = run(&format!("{head}{text}"));
        assert_eq!(names(&outcome), ["r"], "{text}");
        let expected = "`n` decides the structure of the scene here, so that changing it recompiles";
        assert_eq!(outcome.notes, [expected], "{text}");
        assert_eq!(outcome.echoes.first().map_or("[]", |echo| echo), value, "{text}");
    }
}

#[test]
fn a_number_that_may_not_be_finite_is_demoted_with_its_range() {
    let head = "n = 3; // [0:30]\nr = 2; // [1:9]\n";
    for text in [
        "translate([asin(n / 30 + r / 9), 0, 0]) sphere(1);",
        "rotate(1 / n) sphere(r);",
        "sphere(r); rotate([0, sqrt(n - 20), 0]) cube(1);",
        "scale(r) translate([ln(n), 0, 0]) cube(1);",
        "multmatrix([[1, n % (n - 5), 0, r]]) cube(1);",
        "color([1, 0, log(n)]) sphere(r);",
        "$vpd = 100 / n; sphere(r);",
        "rect_light(1, luminance = exp(n * 100)); sphere(r);",
        "union(r = tan(n * 4)) { sphere(r); cube(1); }",
        "camera([r, 1, pow(n - 10, 0.5)]); sphere(1);",
        "sphere(n < 1 ? r : sqrt(n - 2));",
    ] {
        let outcome = run(&format!("{head}{text}"));
        assert!(outcome.parameters.iter().all(|parameter| &*parameter.name != "n"), "{text}: {outcome:?}");
        let expected = "changing `n` recompiles, because this may not be a finite number for all its values";
        assert!(outcome.notes.iter().any(|note| note == expected), "{text}: {outcome:?}");
    }
}

#[test]
fn limits_and_conditions_keep_what_may_fail_live() {
    let head = "n = 3; // [0:30]\nr = 2; // [-9:9]\n";
    for text in [
        "translate([asin(min(n, 1)), r, 0]) sphere(1);",
        "rotate(n > 0.1 ? 1 / n : r) sphere(1);",
        "rotate(!(n <= 4) ? sqrt(n - 4) : r) sphere(1);",
        "translate([sqrt(81 - r * r), tan(n), 0]) sphere(1);",
        "multmatrix([[1, n % 5, 0, r ^ 3]]) cube(1);",
        "rotate(n, [r, 0, 1]) cube(1);",
    ] {
        let outcome = run(&format!("{head}{text}"));
        assert_eq!(names(&outcome), ["n", "r"], "{text}");
        assert!(outcome.notes.is_empty(), "{text}: {:?}", outcome.notes);
    }
}

#[test]
fn a_value_from_outside_is_a_live_ones_default() {
    let options = Options { definitions: vec![("r".into(), "50".into())], ..Options::default() };
    let outcome = run_with("r = 10; // [1:30]\nsphere(r);", &[], options);
    let r = &outcome.parameters[0];
    assert_eq!((r.default, r.range.min, r.range.max), (50.0, 1.0, 50.0));
}

#[test]
fn a_number_in_the_text_is_live_if_the_caller_wants_it() {
    let text = "for (i = [0 : 2]) translate([10 * i, 0, 0]) sphere(r = 2.5);";
    let literal = |wanted: &str| LiveLiteral { start: text.find(wanted).unwrap(), range: Interval::new(1.0, 4.0) };
    let with = |literal| run_with(text, &[], Options { live_literals: vec![literal], ..Options::default() });

    let outcome = with(literal("2.5"));
    assert_eq!(names(&outcome).len(), 1);
    let radius = &outcome.parameters[0];
    assert_eq!((radius.default, radius.range), (2.5, Interval::new(1.0, 4.0)));
    assert_eq!(radius.span.map(|span| &text[span.range()]), Some("2.5"));

    // What decides the structure stays a constant, and nothing is to be told about it.
    let outcome = with(literal("2])"));
    assert!(names(&outcome).is_empty() && outcome.notes.is_empty());
}

#[test]
fn an_evaluation_can_be_stopped() {
    let cancelled = Some(Arc::new(AtomicBool::new(true)));
    let outcome = run_with("for (i = [0 : 2]) sphere(i);", &[], Options { cancelled, ..Options::default() });
    assert!(
        outcome.errors.len() == 1 && outcome.errors[0].ends_with("evaluating the scene was stopped"),
        "{outcome:?}"
    );
}
