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
        ("function nest(n, l = []) = n == 0 ? l : nest(n - 1, [l]); x = nest(99999);", "levels of lists"),
        ("x = [for (s = \"ab\", i = 0; i < 99; s = str(s, s), i = i + 1) s];", "longer than 2000000 bytes"),
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

/// A program that its limits end, with limits a hundredth or less of the usual ones, and what it is told.
fn limited(text: &str, files: &[(&'static str, &'static str)]) -> Vec<String> {
    let limits = crate::Limits {
        steps: 3_000_000,
        list_length: 10_000,
        list_values: 12_000,
        held_values: 30_000,
        string_bytes: 100_000,
        text_bytes: 4_000_000,
        solids: 10_000,
        statements: 10_000,
        echoes: 100,
        echo_bytes: 10_000,
        ..Default::default()
    };
    super::run_with(text, files, super::Options { limits, ..Default::default() }).errors
}

#[test]
fn what_doubles_ends_where_it_is_written() {
    let cases = [
        ("function d(n) = n == 0 ? [1] : concat(d(n - 1), d(n - 1)); x = d(40);", "more than 10000 elements"),
        ("function d(n) = n == 0 ? [1] : [each d(n - 1), each d(n - 1)]; x = d(40);", "more than 10000 elements"),
        ("function d(n) = n == 0 ? 1 : d(n - 1) + d(n - 1); x = d(40);", "takes too long"),
        ("function d(n) = n == 0 ? \"ab\" : str(d(n - 1), d(n - 1)); x = d(40);", "100000 bytes"),
        ("s = chr([for (i = [1 : 9]) [33 : 90000]]);", "100000 bytes"),
        ("x = [for (i = [0 : 999]) [for (j = [0 : 999]) [for (k = [0 : 999]) k]]];", "more than 12000 values"),
        ("x = [for (i = [0 : 99]) rands(0, 1, 9999)];", "more than 12000 values"),
        ("x = concat([for (i = [1 : 6000]) i], [for (i = [1 : 6000]) i]);", "more than 10000 elements"),
        (
            "function f(n) = let (l = [for (i = [1 : 9000]) i]) n == 0 ? 0 : 1 + f(n - 1) + l[0]; x = f(9);",
            "hold more than",
        ),
        ("s = chr([65 : 9000]); for (i = [1 : 999]) { t = str(s, i); }", "bytes of text"),
        ("for (i = [1 : 99999]) cube(1);", "more than 10000 solids"),
        ("for (i = [1 : 200], j = [1 : 200]) translate([i, j]) { cube(1); sphere(1); }", "more than 10000 solids"),
        ("include <a.scad>\ninclude <a.scad>", "too many statements"),
    ];
    let files = [
        ("a.scad", "include <b.scad>\ninclude <b.scad>\ninclude <b.scad>\ninclude <b.scad>"),
        ("b.scad", "include <c.scad>\ninclude <c.scad>\ninclude <c.scad>\ninclude <c.scad>\ninclude <c.scad>"),
        ("c.scad", "include <d.scad>\ninclude <d.scad>\ninclude <d.scad>\ninclude <d.scad>\ninclude <d.scad>"),
        ("d.scad", "include <e.scad>\ninclude <e.scad>\ninclude <e.scad>\ninclude <e.scad>\ninclude <e.scad>"),
        ("e.scad", "x = 1; x = 2; cube(1); cube(1); cube(1); cube(1); cube(1); cube(1); cube(1); cube(1); cube(1);"),
    ];
    for (text, expected) in cases {
        let errors = limited(text, &files);
        let is_placed = |error: &String| error.contains(expected) && !error.starts_with(": ");
        assert!(errors.iter().any(is_placed), "{text}: {errors:?}");
    }
}

#[test]
fn messages_are_limited() {
    let told = |text: &str| super::run(text);
    let outcome = told("for (i = [0 : 9999]) children_of(i); module children_of(i) { children(i); }");
    assert!(outcome.warnings.len() <= 101, "{}", outcome.warnings.len());
    let outcome = told("s = chr([for (i = [1 : 9000]) 65]); assert(false, s);");
    assert!(outcome.errors[0].len() < 1_200, "{}", outcome.errors[0].len());
    let limits = crate::Limits { echo_bytes: 100, ..Default::default() };
    let options = super::Options { limits, ..Default::default() };
    let outcome = super::run_with("for (i = [1 : 9]) echo(\"a line of thirty characters ...\");", &[], options);
    assert_eq!(outcome.echoes.len(), 3);
    assert!(outcome.notes.iter().all(|note| note.contains("echoes more than 100 bytes")), "{outcome:?}");
}

#[test]
fn chains_of_function_literals_are_dropped_in_turn() {
    let text =
        "x = [for (f = function() 0, i = 0; i < 200000; f = let (g = f) function() g(), i = i + 1) if (i < 1) i];";
    assert_eq!(echo(&format!("{text} echo(x);")), "[0]");
}
