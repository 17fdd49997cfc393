//! What programs mean.

use super::{echo, errors, run, run_with, value};

#[test]
fn operators_follow_openscad() {
    let cases = [
        ("[1, 2, 3] + [10, 20]", "[11, 22]"),
        ("2 * [1, [2, 3]]", "[2, [4, 6]]"),
        ("[1, 2, 3] * [4, 5, 6]", "32"),
        ("[[1, 2], [3, 4]] * [1, 1]", "[3, 7]"),
        ("[1, 1] * [[1, 2], [3, 4]]", "[4, 6]"),
        ("[[1, 2], [3, 4]] * [[0, 1], [1, 0]]", "[[2, 1], [4, 3]]"),
        ("-2 ^ 2", "-4"),
        ("2 ^ 3 ^ 2", "512"),
        ("-7 % 3", "-1"),
        ("5 & 3 | 8, 1 << 4, ~0", "9, 16, -1"),
        ("[1, 2] < [1, 3], \"a\" < \"b\", 1 == true, undef == undef", "true, true, false, true"),
        ("[1, [2]] == [1, [2]], [0 : 1] == [0 : 1 : 1]", "true, true"),
        ("1 / 0, -1 / 0, 0 / 0", "inf, -inf, nan"),
        ("[10, 20, 30][1.9], [1, 2].y, \"äö\"[1], [0 : 2 : 9].step, [1][7]", "20, 2, \"ö\", 2, undef"),
        ("!\"\" && [0] && !undef || false", "true"),
    ];
    for (expression, expected) in cases {
        assert_eq!(value(expression), expected, "{expression}");
    }
}

#[test]
fn lists_are_built_by_comprehensions() {
    let cases = [
        ("[for (i = [0 : 3]) i * i]", "[0, 1, 4, 9]"),
        ("[for (i = [3 : 1]) i]", "[]"),
        ("[for (i = [5 : -2 : 0]) i]", "[5, 3, 1]"),
        ("[for (i = [0 : 1], j = \"ab\") str(i, j)]", "[\"0a\", \"0b\", \"1a\", \"1b\"]"),
        ("[for (i = 0, s = 1; i < 4; i = i + 1, s = s * 2) s]", "[1, 2, 4, 8]"),
        ("[for (i = [1 : 5]) if (i % 2 == 0) i else -i]", "[-1, 2, -3, 4, -5]"),
        ("[each [1, 2], each [3 : 4], each \"x\", each 5, let (a = 6) a]", "[1, 2, 3, 4, \"x\", 5, 6]"),
        ("[each for (i = [1 : 2]) [i, i]]", "[1, 1, 2, 2]"),
        ("len([for (i = [0 : 0.1 : 1]) i])", "11"),
    ];
    for (expression, expected) in cases {
        assert_eq!(value(expression), expected, "{expression}");
    }
}

#[test]
fn built_in_functions_have_their_values() {
    let cases = [
        ("sin(30), cos(60), tan(45), asin(0.5), atan2(1, -1)", "0.5, 0.5, 1, 30, 135"),
        ("round(-2.5), floor(-0.5), ceil(0.2), sign(-3), abs(-3)", "-3, -1, 1, -1, 3"),
        ("min(3, 1, 2), max([3, 9, 2]), norm([3, 4]), log(8), ln(1)", "1, 9, 5, 0.90309, 0"),
        ("cross([1, 0, 0], [0, 1, 0]), cross([1, 2], [3, 4])", "[0, 0, 1], -2"),
        ("concat([1], 2, [[3]]), len(\"äöü\"), len([1, 2])", "[1, 2, [3]], 3, 2"),
        ("lookup(1.5, [[2, 20], [0, 0], [1, 10]]), lookup(9, [[0, 0], [1, 10]])", "15, 10"),
        (
            "chr(65, [66, 67], [68 : 69]), ord(\"ä\"), str(1.5, \"a\", [\"b\", true])",
            "\"ABCDE\", 228, \"1.5a[\"b\", true]\"",
        ),
        ("search(\"b\", \"abab\"), search(\"ab\", \"abab\", 0)", "[1], [[0, 2], [1, 3]]"),
        ("search(3, [[\"a\", 3], [\"b\", 4]], 1, 1), search([4, 9], [1, 4])", "[0], [1, []]"),
        ("is_undef(nothing), is_num(0 / 0), is_function(function() 1), is_list([1])", "true, false, true, true"),
        ("rands(0, 1, 2, 42)", "[0.796543, 0.183435]"),
        ("function(x, y = 2) x + y", "function(x, y = 2) (x + y)"),
    ];
    for (expression, expected) in cases {
        assert_eq!(value(expression), expected, "{expression}");
    }
}

#[test]
fn scopes_nest_and_assignments_run_first() {
    assert_eq!(echo("x = 1; echo(x); x = 2;"), "2");
    assert_eq!(echo("a = 1; { a2 = a; } echo(a2);"), "1");
    assert_eq!(echo("a = 1; module m() { b = a; a = 2; echo(a, b); } m();"), "2, 1");
    assert_eq!(echo("a = 1; module m(a, b = a) { echo(a, b); } m(5);"), "5, 1");
    assert_eq!(echo("module m(a, b, c) { echo(a, b, c); } m(b = 1, 2, 3);"), "2, 1, 3");
    assert_eq!(echo("function f(x) = let (y = x, z = y + 1) z; echo(f(1));"), "2");
    assert_eq!(echo("function sin(x) = \"mine\"; echo(sin(0));"), "\"mine\"");
    assert_eq!(echo("f = function(n) n == 0 ? 1 : n * f(n - 1); echo(f(5));"), "120");
    assert_eq!(echo("make = function(n) function(x) x + n; echo(make(3)(4));"), "7");
}

#[test]
fn special_variables_follow_the_calls() {
    assert_eq!(echo("echo($fn, $fa, $fs, $preview);"), "0, 12, 2, true");
    assert_eq!(echo("$a = 1; module m() { echo($a); } m(); m($a = 2); let ($a = 3) m();"), "1; 2; 3");
    assert_eq!(echo("function f() = $b; function g($b) = f(); echo(g(4), let ($b = 5) f());"), "4, 5");
    assert_eq!(echo("module m() { echo($children, $parent_modules); } m() { m(); *m(); m(); }"), "2, 1");
    assert_eq!(echo("module p() { children(); } p($c = 6) echo($c);"), "6");
}

#[test]
fn children_are_those_of_the_module_around() {
    let text = "module a() { b() children(1); } module b() { children([0 : 0]); } a() { echo(0); echo(1); }";
    assert_eq!(echo(text), "1");
    assert_eq!(echo("x = 1; module m() { x = 2; children(); } m() { y = x; echo(y, parent_module(0)); }"), "1, \"m\"");
    assert_eq!(echo("module m() for (i = [0 : $children - 1]) children(i); m() { echo(1); echo(2); }"), "1; 2");
}

#[test]
fn files_are_included_and_used() {
    let files = [
        ("in.scad", "a = 1; b = a + 1; module m() { echo(\"m\", a, b); } echo(\"in\");"),
        ("lib.scad", "include <in.scad>\n$k = 7; c = 30; function f() = c; module g() { echo(c, $k); }"),
        ("other.scad", "function f() = 4; module g() { echo(\"other\"); }"),
    ];
    let run = |text| run_with(text, &files, Default::default());
    assert_eq!(run("include <in.scad>\na = 5; m();").echoes, ["\"in\"", "\"m\", 5, 6"]);
    assert_eq!(run("use <lib.scad>\nc = 1; echo(f()); g();").echoes, ["30", "30, 7"]);
    assert_eq!(run("use <lib.scad>\nuse <other.scad>\necho(f());").echoes, ["4"]);
    assert_eq!(run("use <lib.scad>\necho(c);").errors.len(), 1);
    assert_eq!(run("include <in.scad>\ninclude <in.scad>\n").echoes.len(), 2);
}

#[test]
fn callers_come_before_the_top_level_of_used_files() {
    let files = [
        ("cell.scad", "$cell = undef; $fn = 6; function cell() = $cell; module with(c) { $cell = c; children(); }"),
        ("size.scad", "use <cell.scad>\n$fn = 8; function sides() = $fn; function both() = [cell(), sides()];"),
    ];
    let run = |text: &str| {
        let outcome = run_with(&format!("use <cell.scad>\nuse <size.scad>\n{text}"), &files, Default::default());
        assert!(outcome.errors.is_empty(), "{text}: {:?}", outcome.errors);
        outcome.echoes.join("; ")
    };
    // Where no caller says anything, a file's own top level does.
    assert_eq!(run("echo(cell(), sides());"), "undef, 8");
    assert_eq!(run("with(5) { s = cell(); echo(s); }"), "5");
    assert_eq!(run("with(5) echo(both());"), "[5, 8]");
    assert_eq!(run("with(5) echo($fn, sides());"), "0, 8");
    assert_eq!(run("$fn = 48; echo(sides()); module m() { $fn = 9; echo(sides()); } m();"), "48; 9");
    assert_eq!(run("echo(sides($fn = 0), let ($cell = 1) cell());"), "0, 1");
}

#[test]
fn components_are_read_by_their_letters() {
    let cases = [
        ("[1, 2, 3].xy, [1, 2, 3].zyx, [1, 2, 3, 4].wx", "[1, 2], [3, 2, 1], [4, 1]"),
        ("[1, 2, 3].r, [1, 2, 3, 4].a, [1, 2, 3].gb, [1, 2].xxyy", "1, 4, [2, 3], [1, 1, 2, 2]"),
        ("[1, 2].z, [1, 2].xz, [].xy", "undef, [1, undef], [undef, undef]"),
    ];
    for (expression, expected) in cases {
        assert_eq!(value(expression), expected, "{expression}");
    }
    for odd in ["xg", "xyzwx", "length", "s"] {
        let outcome = run(&format!("echo([1, 2].{odd});"));
        let warning = format!("a list has no `{odd}`, so that this is undef");
        assert_eq!((&*outcome.echoes, &*outcome.warnings), (&["undef".to_owned()][..], &[warning][..]));
    }
}

#[test]
fn zeros_have_signs() {
    assert_eq!(value("1 / sin(-180), 1 / sin(360), 1 / cos(270), 1 / tan(180)"), "-inf, inf, -inf, -inf");
    assert_eq!(value("atan2(sin(-180), cos(-180)), atan2(-0, -1), sin(180)"), "-180, -180, 0");
}

#[test]
fn what_is_no_function_or_never_ends_is_warned_of() {
    let warned = |text: &str| {
        let outcome = run(text);
        assert!(outcome.errors.is_empty() && outcome.warnings.len() == 1, "{text}: {outcome:?}");
        (outcome.echoes.join("; "), outcome.warnings[0].clone())
    };
    let no_function = "this is a number, which can't be called".to_owned();
    assert_eq!(warned("x = 3; echo(x(4));"), ("undef".into(), no_function.clone()));
    assert_eq!(warned("echo([(1 + 2)(4)]);"), ("[undef]".into(), no_function));
    let endless = |text: &str| warned(text).1.contains("never ends");
    for text in ["for (i = [0 : 0 : 5]) cube(i);", "x = [for (i = [0 : 1 / 0]) i];", "x = chr([1 : 0 : 9]);"] {
        assert!(endless(text), "{text}");
    }
    assert_eq!(warned("echo([each [0 : 0 : 5], 1]);").0, "[1]");
}

#[test]
fn every_takes_what_groups_make_one_by_one() {
    let solid = |text: &str| {
        let outcome = run(text);
        assert!(outcome.errors.is_empty() && outcome.warnings.is_empty(), "{text}: {outcome:?}");
        outcome.solid.expect(text)
    };
    let three = "cube(1); translate([2, 0, 0]) cube(1); translate([4, 0, 0]) cube(1);";
    let at = |x: &str| format!("translate([{x}, 0, 0]) cube(1);");
    for operation in ["union", "difference", "intersection"] {
        let joined = solid(&format!("{operation}(r = 1) {{ {three} }}"));
        for body in [
            format!("for (x = [0, 2, 4]) {}", at("x")),
            format!("for (x = [0]) {{ {} for (y = [2, 4]) if (true) {} }}", at("x"), at("y")),
            format!("let (a = 1) {{ {} if (a > 2) sphere(9); else for (y = [2, 4]) {} }}", at("0"), at("y")),
            format!("echo() for (x = [0 : 2]) assert(true) {}", at("2 * x")),
        ] {
            assert_eq!(solid(&format!("{operation}(r = 1, every = true) {body}")), joined, "{body}");
        }
        let module = format!("module all() {operation}(r = 1, every = true) children();");
        assert_eq!(solid(&format!("{module} all() {{ {three} }}")), joined);
        assert_eq!(solid(&format!("{module} all() for (x = [0, 2, 4]) {}", at("x"))), joined);
    }
    // What is moved or painted as one, or made by a module, is one.
    let apart = solid("union(r = 1) { union() { cube(1); sphere(1); } cube(3); }");
    for one in ["group()", "union()", "render()", "m()"] {
        let text =
            format!("module m() children(); union(r = 1, every = true) {{ {one} {{ cube(1); sphere(1); }} cube(3); }}");
        assert_eq!(solid(&text), apart, "{one}");
    }
    // Without a radius there is nothing to it but for a difference, which is of the first.
    assert_eq!(
        solid("difference(every = true) for (i = [0 : 1]) cube(2 - i);"),
        solid("difference() { cube(2); cube(1); }")
    );
    assert_eq!(solid("union(every = true) for (i = [0 : 1]) cube(2 - i);"), solid("union() { cube(2); cube(1); }"));
}

#[test]
fn a_joint_of_one_operand_is_warned_of() {
    let warnings = |text: &str| run(text).warnings;
    let lonely = ["there is one operand only, so that nothing is joined"];
    assert_eq!(warnings("union(r = 6) for (i = [0 : 1]) cube(i + 1);"), lonely);
    assert_eq!(warnings("module m() difference(r = 2) children(); m() { cube(2); cube(1); }"), lonely);
    assert_eq!(warnings("intersection(r = 2) cube(2);"), lonely);
    for fine in ["union(r = 0) cube(1);", "union() cube(1);", "union(r = 2, every = true) for (i = [0]) cube(1);"] {
        assert!(warnings(fine).is_empty(), "{fine}");
    }
    assert!(warnings("union(r = 2) { cube(1); if (false) cube(2); }").is_empty());
}

#[test]
fn control_flow_makes_groups_and_nothing() {
    let solid = |text: &str| run(text).solid.expect(text);
    let cubes = solid("cube(1); translate([5, 0, 0]) cube(1);");
    assert_eq!(solid("for (x = [0, 5]) translate([x, 0, 0]) cube(1);"), cubes);
    assert_eq!(
        solid("module m(n) { if (n > 0) { translate([5, 0, 0]) cube(1); } cube(1); } m(1);").lines().count(),
        cubes.lines().count()
    );
    assert_eq!(solid("difference() { cube(2); if (false) cube(1); }"), solid("cube(2);"));
    assert_eq!(solid("difference() { if (false) cube(1); cube(2); }"), solid("cube(2);"));
    assert_eq!(solid("difference() { for (i = []) cube(1); cube(2); }"), solid(""));
    assert_eq!(solid("cube(1); { translate([3, 0, 0]) !cube(2); } %cube(9);"), solid("cube(2);"));
    assert_eq!(solid("*cube(1); %cube(2); #cube(3);"), solid("cube(3);"));
    assert_eq!(solid("intersection_for (i = [0 : 1]) cube(1 + i);"), solid("intersection() { cube(1); cube(2); }"));
    assert_eq!(solid("module cube(s) { sphere(s); } cube(2);"), solid("sphere(2);"));
}

#[test]
fn definitions_from_outside_replace_values() {
    let run = |name: &str, value: &str| {
        let options = super::Options { definitions: vec![(name.into(), value.into())], ..Default::default() };
        run_with("size = 1; twice = 2 * size; echo(size, twice, $fn);", &[], options)
    };
    assert_eq!(run("size", "1 + 2").echoes, ["3, 6, 0"]);
    assert_eq!(run("$fn", "8").echoes, ["1, 2, 8"]);
    assert_eq!(run("sise", "3").errors, ["sise = 3;: the scene has no variable `sise` to set (did you mean `size`?)"]);
    assert_eq!(run("size", "3; cube(1)").errors.len(), 1);
    assert!(!run("size", "3 +").errors.is_empty());
}

#[test]
fn a_polyhedron_in_a_hull_is_its_corners() {
    let flat = "polyhedron([[0, 0, 0], [2, 0, 0], [0, 2, 0]], [[0, 1, 2]]);";
    let two = format!("module m() {flat} hull() {{ m(); for (i = [1]) translate([0, 0, i]) m(); }}");
    let prism = "sphere_hull (0 0 0) 0, (2 0 0) 0, (0 2 0) 0, (0 0 1) 0, (2 0 1) 0, (0 2 1) 0\n";
    assert_eq!(run(&two).solid.as_deref(), Some(prism));
    assert_eq!(run(&format!("hull() {flat}")).solid.as_deref(), Some("empty\n"));
    let open = "polyhedron([[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]], [[0, 1, 2], [0, 3, 1]]);";
    for text in [format!("hull() difference() {{ {open} sphere(1); }}"), format!("hull() {{ sphere(1); !{open} }}")] {
        assert_eq!(errors(&text).len(), 1, "{text}");
    }
}
