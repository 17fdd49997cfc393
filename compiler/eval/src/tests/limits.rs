//! No program exhausts time, memory or the stack.

use super::{echo, errors};

#[test]
fn deep_recursion_works() {
    assert_eq!(echo("function f(n) = n == 0 ? 0 : 1 + f(n - 1); echo(f(8000));"), "8000");
    assert_eq!(echo("function f(n, s = 0) = n == 0 ? s : f(n - 1, s + 1); echo(f(900000));"), "900000");
    assert_eq!(echo("module m(n) { if (n > 0) m(n - 1); else echo(\"end\"); } m(2000);"), "\"end\"");
}

#[test]
fn endless_programs_end_with_an_error() {
    let cases = [
        ("function f(n) = 1 + f(n + 1); x = f(0);", "the recursion of `f` goes too deep"),
        ("function f(n) = f(n + 1); x = f(0);", "`f` calls itself more than 1000000 times"),
        ("f = function() [f()]; x = f();", "the recursion of `f` goes too deep"),
        ("module m() { m(); } m();", "the recursion of `m` goes too deep"),
        ("module m() { translate([1, 0, 0]) { cube(1); m(); } } m();", "the recursion of `m` goes too deep"),
        ("module m(n) { if (n > 0) { cube(1); translate([1, 0, 0]) m(n - 1); } } m(900);", "nested more than"),
        ("x = [for (i = 0; true; i = i + 1) i];", "runs more than 1000000 times"),
        ("for (i = [0 : 1e9]) cube(i);", "more than 1000000 numbers"),
        ("x = [for (l = [1], i = 0; i < 99; l = [l, l], i = i + 1) l];", "more than 10000000 values"),
        ("x = [for (l = [1], i = 0; i < 99999; l = [l], i = i + 1) l];", "levels of lists"),
        ("x = [for (s = \"ab\", i = 0; i < 99; s = str(s, s), i = i + 1) s];", "longer than 10000000 bytes"),
        ("x = rands(0, 1, 1e12);", "random numbers"),
    ];
    for (text, expected) in cases {
        let errors = errors(text);
        assert!(errors.iter().any(|error| error.contains(expected)), "{text}: {errors:?}");
    }
}

#[test]
fn work_is_limited() {
    let limits = crate::Limits { steps: 1_000_000, ..Default::default() };
    let options = super::Options { limits, ..Default::default() };
    let outcome = super::run_with("a = [0 : 999]; for (i = a, j = a, k = a) {}", &[], options);
    assert_eq!(outcome.errors.len(), 1);
    assert!(outcome.errors[0].contains("takes too long"));
}

#[test]
fn chains_of_function_literals_are_dropped_in_turn() {
    let text =
        "x = [for (f = function() 0, i = 0; i < 200000; f = let (g = f) function() g(), i = i + 1) if (i < 1) i];";
    assert_eq!(echo(&format!("{text} echo(x);")), "[0]");
}
