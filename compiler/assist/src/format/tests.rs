use proptest::prelude::*;

use super::*;
use crate::testing::{WORDS, scenes};

#[track_caller]
fn check(text: &str, expected: &str) {
    assert_eq!(format(text), expected, "{text}");
    assert_eq!(format(expected), expected, "once more");
}

#[test]
fn words_are_spaced() {
    check("a=1;b=-2;", "a = 1; b = -2;\n");
    check("cube( [ 1,2 , 3 ] ,center=true ) ;", "cube([1, 2, 3], center = true);\n");
    check("x = a*b+c %2 - -d^-2;", "x = a * b + c % 2 - -d^-2;\n");
    check("x = a?b:c[ 0 ].y( 1 );", "x = a ? b : c[0].y(1);\n");
    check("r = [0:2:9]; s = [0 : 9]; t = [a?1:2:9];", "r = [0:2:9]; s = [0 : 9]; t = [a ? 1 : 2:9];\n");
    check("f=function(x)x+1;g = f (1) (2);", "f = function (x) x + 1; g = f(1)(2);\n");
    check("x=[for(i=[0:3])if(i>1)(i)];", "x = [for (i = [0:3]) if (i > 1) (i)];\n");
    check("x=let(a=1)-a;y=[each[1],2];", "x = let (a = 1) -a; y = [each [1], 2];\n");
    check("x=!a&&!(b||c);y=a!=b;", "x = !a && !(b || c); y = a != b;\n");
    check("# translate([1,0,0]) % cube(1);", "#translate([1, 0, 0]) %cube(1);\n");
    check("module m ( a ,b=2 ){}", "module m(a, b = 2) {}\n");
    check("union(){cube(1);sphere(2);}", "union() { cube(1); sphere(2); }\n");
    check("if(a)b();else{c();}", "if (a) b(); else { c(); }\n");
    check("assert (a) echo (b) c();", "assert(a) echo(b) c();\n");
    check("a = 1 .x; b = 1. .x; c = v. 2d;", "a = 1 .x; b = 1..x; c = v. 2d;\n");
}

#[test]
fn lines_are_indented() {
    check(
        "module m()\n{\ntranslate([1,0,0])\n rotate(3)\n  cube([\n1,\n2\n]);\n}\n",
        "module m()\n{\n    translate([1, 0, 0])\n        rotate(3)\n            cube([\n                1,\n                2\n            ]);\n}\n",
    );
    check(
        "if (a)\n  if (b)\n  c();\n  else\n  d();\nelse if (e) {\nf();\n} else\ng();\nh();",
        "if (a)\n    if (b)\n        c();\n    else\n        d();\nelse if (e) {\n    f();\n} else\n    g();\nh();\n",
    );
    check("color(\"red\")\ndifference() {\na();\n}", "color(\"red\")\ndifference() {\n    a();\n}\n");
    check("a = 1 +\n2 +\n3;\nb = 2;", "a = 1 +\n    2 +\n    3;\nb = 2;\n");
    check("a = [\nfor (i = b)\ni,\n2\n];", "a = [\n    for (i = b)\n        i,\n    2\n];\n");
    check("polygon([[1,2],\n[3,4]]);", "polygon([[1, 2],\n    [3, 4]]);\n");
    check(
        "f(a = [[1,2],\n       [3,4]],\n  b = 5,\n  c = (1 +\n       2));",
        "f(a = [[1, 2],\n       [3, 4]],\n  b = 5,\n  c = (1 +\n       2));\n",
    );
    check("a();\n{\nb();\n}\nc();", "a();\n{\n    b();\n}\nc();\n");
}

#[test]
fn comments_and_blank_lines_stay() {
    check("\n\n// a\n\n\n\nb = 1;// c\n/* d\n   e */  f();\n", "// a\n\nb = 1; // c\n/* d\n   e */ f();\n");
    check("union() {\n\n// a\ncube(1); // b\n\n}", "union() {\n    // a\n    cube(1); // b\n}\n");
    check("f(/* a */ 1 /* b */, // c\n2);", "f(/* a */ 1 /* b */, // c\n    2);\n");
}

#[test]
fn comments_that_stand_in_one_column_stay_in_one() {
    check("a=1;   // a\nbcd=2; // b\n", "a = 1;   // a\nbcd = 2; // b\n");
    check("a = 1;// a\nbcd = 2; // b\n", "a = 1; // a\nbcd = 2; // b\n");
    check("a=1;      // [1:2]\n", "a = 1;      // [1:2]\n");
}

#[test]
fn line_breaks_are_those_of_the_text() {
    check("a=1;\r\n\r\n// b\r\nc=2;", "a = 1;\r\n\r\n// b\r\nc = 2;\r\n");
}

#[test]
fn broken_texts_stay_what_they_are() {
    check("a = \"b\nc=1;", "a = \"b\n    c = 1;\n");
    check("union() { a = @ 2;", "union() { a = @ 2;\n");
    check("", "");
    check("a=1;\x03 b=2;", "a = 1;\n\x03 b=2;");
}

/// Whether formatting keeps a promise for any text: the same words, and nothing to do the second time.
fn keeps_promises(text: &str) {
    let formatted = format(text);
    assert!(is_same(text, &formatted), "{text:?} became {formatted:?}");
    assert_eq!(format(&formatted), formatted, "the second time, for {text:?}");
}

#[test]
fn scenes_keep_their_words() {
    for (name, text) in scenes() {
        let formatted = lines::formatted(&text);
        assert!(is_same(&text, &formatted), "{name}");
        assert_eq!(lines::formatted(&formatted), formatted, "{name}");
    }
}

#[test]
fn our_examples_are_formatted() {
    for (name, text) in scenes().into_iter().filter(|(name, _)| name.contains("examples_csg")) {
        assert_eq!(format(&text), text, "{name}");
    }
}

proptest! {
    #[test]
    fn any_text_keeps_its_words(text in any::<String>()) {
        keeps_promises(&text);
    }

    #[test]
    fn any_words_stay(words in prop::collection::vec(prop::sample::select(WORDS), 0..60), blank: bool) {
        keeps_promises(&words.join(if blank { " " } else { "" }));
    }
}
