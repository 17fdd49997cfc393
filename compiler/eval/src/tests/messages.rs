//! What goes wrong is said at its place, with what would mend it.

use super::{errors, run, run_with};

#[test]
fn unknown_names_are_errors_with_suggestions() {
    assert_eq!(errors("width = 3; cube(widht);"), ["widht: there is no variable `widht` (did you mean `width`?)"]);
    assert_eq!(errors("x = sqr(4);"), ["sqr: there is no function `sqr` (did you mean `sqrt`?)"]);
    assert_eq!(errors("module peg() {} pgs();"), ["pgs: there is no module `pgs`"]);
    assert_eq!(errors("spere(3);"), ["spere: there is no module `spere` (did you mean `sphere`?)"]);
    assert_eq!(
        errors("x = y; y = 3;"),
        ["y: there is no variable `y` (assignments run in the order of the text: move this one up)"]
    );
}

#[test]
fn what_other_languages_call_modules_is_hinted_at() {
    for (text, hint) in [
        ("smooth_union(r = 2) cube(1);", "union(r = …)"),
        ("fillet(2) cube(1);", "union(r = …)"),
        ("roundedcube([1, 2, 3], 1);", "cube(…, r = …)"),
        ("rounded_cube(3, 1);", "cube(…, r = …)"),
    ] {
        let errors = errors(text);
        assert!(errors.len() == 1 && errors[0].contains(hint), "{errors:?}");
    }
}

#[test]
fn one_mistake_is_one_error_and_hides_no_other() {
    assert_eq!(errors("x = nope; y = x + 1; cube(y); for (i = [0 : 9]) cube(y); cube(nope2);").len(), 2);
    assert_eq!(errors("function f(x) = x + z; a = [for (i = [0 : 9]) f(i)];").len(), 1);
}

#[test]
fn assertions_show_their_condition_and_the_calls() {
    let text = "function f(n) = assert(n > 0, \"too small\") n; module m(k) { cube(f(k)); } m(-1);";
    assert_eq!(errors(text), ["n > 0: the assertion `n > 0` fails: too small"]);
    assert!(errors("assert(true) cube(1); assert([0]);").is_empty());
}

#[test]
fn odd_operands_and_arguments_are_warned_of() {
    let warnings = |text: &str| run(text).warnings;
    assert_eq!(warnings("x = 1 + \"a\";"), ["`+` is not defined for a number and a string"]);
    assert_eq!(warnings("for (i = [0 : 9]) { x = i + undef; }").len(), 1);
    assert_eq!(warnings("module m(size) {} m(sise = 1);"), ["`m` has no parameter `sise`"]);
    assert_eq!(warnings("x = 1;\nx = 2;"), ["`x` was assigned on line 1 already; the value there is never used"]);
    assert_eq!(warnings("echo($nothing);"), ["nothing sets `$nothing`, so this is undef"]);
    assert!(warnings("x = is_undef($nothing) || is_undef(nothing);").is_empty());
}

#[test]
fn missing_and_circular_includes_are_found() {
    let files = [("a.scad", "include <b.scad>\n"), ("b.scad", "include <a.scad>\nx = 1;")];
    let run = |text| run_with(text, &files, Default::default());
    let circular = run("include <a.scad>\necho(x);");
    assert_eq!(circular.echoes, ["1"]);
    assert_eq!(circular.warnings, ["`a.scad` includes itself: it is left out here"]);
    let font = run("use <fonts/Gothic.TTF>\necho(1);");
    assert_eq!((&*font.echoes, font.errors.len()), (&["1".to_owned()][..], 0));
    assert_eq!(font.warnings, ["fonts are not read, because `text` is not supported yet"]);
    let main = [("main.scad", "")];
    let itself = run_with("include <main.scad>\ncube(1);", &main, Default::default());
    assert_eq!((itself.errors.len(), itself.solid.is_some()), (0, true), "{itself:?}");
    let unused = run("use <c.scad>\ncube(1);");
    assert_eq!((&*unused.warnings, unused.solid.is_some()), (&["can't find `c.scad`".to_owned()][..], true));
    let missing = run("include <c.scad>\ncube(what);");
    assert!(matches!(&missing.errors[..], [error] if error.contains("can't find `c.scad`")), "{missing:?}");
}

#[test]
fn echoes_come_in_the_order_of_execution() {
    assert_eq!(run("module m() echo(2); echo(1); m(); echo(a = 3, \"b\");").echoes, ["1", "2", "a = 3, \"b\""]);
}

/// The names that are said to be misspelt in a text with syntax errors.
fn misspelt(text: &str) -> Vec<String> {
    let outcome = run(text);
    let (syntax, names): (Vec<_>, Vec<_>) = outcome
        .errors
        .into_iter()
        .chain(outcome.warnings)
        .partition(|said| !said.contains("there is no") && !said.contains("has no parameter"));
    assert!(!syntax.is_empty(), "{text} has no syntax error");
    names
}

#[test]
fn syntax_errors_hide_no_misspelt_names() {
    let names = misspelt(
        "x = ;\nsphree(8);\ncolr(\"red\") cube(1);\nlinear_extrude(hieght = 3) square(1);\nwidth = 2;\ncube(widht);\ny = sqr(4);",
    );
    assert_eq!(names.len(), 5, "{names:?}");
    // The text may still be written.
    assert_eq!(misspelt("sphree(8);\ntranslate([1, 2, 3]").len(), 1);
}

#[test]
fn what_a_syntax_error_may_have_defined_is_not_misspelt() {
    for text in [
        // The definition can't be read.
        "modul sphree(r) sphere(r);\nsphree(8);",
        "module sphree(r { sphere(r); }\nsphree(8);",
        "module sphree\n(r sphere(r);\nsphree(8);",
        "width = 1;\nwidht 2;\ncube(widht);",
        "width = 1;\nmodul peg(a,\n    widht)\n{ cube(widht); }",
        "function sqr(x) x * x;\ny = sqr(4);",
        // It can be read, but stands in a block that was not meant so.
        "width = 1;\nmodule peg() {\n  widht = 2;\n}\n}\ncube(widht);",
        // On the same line it could be a part of something else.
        "echo(sphree(8) hello);",
        // What is not evaluated is not told of a text without errors either.
        "x = ;\nmodule never() { sphree(8); }",
        "x = ;\nif (is_undef(widht)) cube(1);\nwidth = 3;",
    ] {
        assert_eq!(misspelt(text), [""; 0], "{text}");
    }
    let missing = run("include <gone.scad>\nx = ;\nsphree(8);");
    assert_eq!(missing.errors.len(), 2, "{missing:?}");
}

#[test]
fn nothing_but_names_is_told_of_a_text_with_syntax_errors() {
    let outcome = run("x = ;\necho(1);\nassert(false);\ncube(undef + 1);\nsize = 2;\nsize = 3;");
    assert_eq!((outcome.echoes.len(), outcome.errors.len(), outcome.warnings.len()), (0, 1, 0), "{outcome:?}");
}
