use proptest::prelude::*;

use super::*;
use crate::testing::{tree, without_places};

/// Checks that what is printed reads as the same tree.
fn check_round_trip(text: &str) {
    let tree_read = tree(text);
    let printed = print(&tree_read);
    let again = tree(&printed);
    assert_eq!(without_places(&tree_read).0, without_places(&again).0, "\n{text}\nis printed as\n{printed}");
    assert_eq!(print(&again), printed, "printing is stable");
}

#[test]
fn programs_are_well_formatted() {
    let text = "use<a.scad>module m(a,b=[1,2]){translate([a,0,0])#cube(b,center=true);x=a*(b+1);}
        function f(x)=x>1?f(x-1):-x^2;
        if(a){b();c();}else if(d)e();else{f=1;}
        for(i=[0:2:10])m();";
    let expected = "\
use <a.scad>

module m(a, b = [1, 2]) {
    translate([a, 0, 0]) #cube(b, center = true);
    x = a * (b + 1);
}

function f(x) = x > 1 ? f(x - 1) : -x^2;
if (a) {
    b();
    c();
} else if (d) e();
else {
    f = 1;
}
for (i = [0:2:10]) m();
";
    assert_eq!(print(&tree(text)), expected);
    check_round_trip(text);
}

#[test]
fn long_lists_are_broken() {
    let point = "[1.25, -2.5, 3.125]";
    let printed = print(&tree(&format!("p = [{}];", [point; 6].join(","))));
    assert_eq!(printed, format!("p = [\n    {}\n];\n", [point; 6].join(",\n    ")));
}

#[test]
fn parameters_keep_their_comments() {
    let text = "\
module first()
    cube(1);

/* [Hidden] */
hidden = 1;

/* [Size] */
// Its width
width = 10; // [0:0.5:20]
name = \"a\"; // [\"a,b\":Two, c:See, 5]
five = 5; // [\"5\":Five]
";
    assert_eq!(print(&tree(text)), text);
    check_round_trip(&format!("{text}module m() {{ }} later = 1;"));
}

#[test]
fn small_programs_survive() {
    for text in [
        "x = a. 3d + b.y;",
        "if (a) { if (b) c(); } else d();",
        "if (a) translate() { if (b) c(); } else d();",
        "x = [if (a) (if (b) 1) else 2, if (a) for (i = b) (if (i) 1) else 2];",
        "x = [for (i = 0, j = 1; i < 2; i = i + 1) each [i]];",
        "x = (1).y + (-1)[0] + (a ? b : c) - (let (d = 1) d) * (function (x) x)(1);",
        "x = (a ^ b) ^ -c ^ d - (e - f) - ((g));",
        "x = [(a) + 1, (let (b = 1) b), [a ? b : c:1:2], assert(a), echo(b) c];",
        r#"x = "\"\\\n\t\r\x01é\u00e9"; y = 1e300 + 0x10 + .5 + 1e-7 + 1e999;"#,
        "module a() module b() c(); module d() { e = 1; } module f(); { } { g(); { } }",
        "translate() { a = 1; } union() { include <x> } *!#%cube(); a();",
    ] {
        check_round_trip(text);
    }
}

/// Texts of expressions.
fn expressions() -> impl Strategy<Value = String> {
    let leaf = prop::sample::select(vec!["a", "$b", "1", "2.5", "1e300", "true", "undef", "\"s\\n\"", "[]", "f()"]);
    leaf.prop_map(str::to_owned).prop_recursive(5, 40, 3, |inner| {
        let operators =
            vec!["||", "&&", "==", "!=", "<", "<=", ">", ">=", "|", "&", "<<", ">>", "+", "-", "*", "/", "%", "^"];
        let operand = prop_oneof![4 => inner.clone(), 1 => inner.clone().prop_map(|inner| format!("({inner})"))]
            .prop_filter("an operand", |text| !["let", "function", "assert"].iter().any(|word| text.starts_with(word)));
        let (one, two, three) = (operand.clone(), operand.clone(), operand);
        prop_oneof![
            (one.clone(), prop::sample::select(operators), two.clone())
                .prop_map(|(left, operator, right)| format!("({left}) {operator} ({right})")),
            (prop::sample::select(vec!["-", "+", "!", "~"]), one.clone()).prop_map(|(sign, a)| format!("{sign}({a})")),
            (one.clone(), two.clone(), three).prop_map(|(a, b, c)| format!("({a}) ? {b} : {c}")),
            (one.clone(), two.clone()).prop_map(|(a, b)| format!("({a})[{b}]")),
            (one.clone(), two.clone()).prop_map(|(a, b)| format!("({a}).x(n = {b}, 1)")),
            (one.clone(), two.clone()).prop_map(|(a, b)| format!("[{a} : {b}]")),
            (elements(inner.clone()), elements(inner.clone())).prop_map(|(a, b)| format!("[{a}, {b}]")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("let (v = {a}) {b}")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("function (p = {a}) {b}")),
            (inner.clone(), inner).prop_map(|(a, b)| format!("assert({a}) {b}")),
        ]
    })
}

/// Texts of list elements.
fn elements(values: impl Strategy<Value = String> + Clone + 'static) -> impl Strategy<Value = String> {
    let value = values.clone();
    value.prop_recursive(3, 8, 2, move |inner| {
        prop_oneof![
            inner.clone().prop_map(|a| format!("each {a}")),
            (values.clone(), inner.clone()).prop_map(|(a, b)| format!("for (i = {a}) {b}")),
            (values.clone(), inner.clone()).prop_map(|(a, b)| format!("if ({a}) {b}")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("if (c) {a} else {b}")),
            (values.clone(), inner.clone()).prop_map(|(a, b)| format!("let (w = {a}) {b}")),
            (values.clone(), inner.clone()).prop_map(|(a, b)| format!("for (i = {a}; i < 1; i = 2) {b}")),
        ]
    })
}

/// Texts of statements.
fn statements() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        expressions().prop_map(|value| format!("a = {value}; // [1:2]\n")),
        expressions().prop_map(|value| format!("*#cube({value}, r = 1);")),
        expressions().prop_map(|value| format!("function f(x = {value}) = x;")),
        Just("b = -1; // [x:y, \"z,\"]\n".to_owned()),
        Just("// About c\nc = [1, \"d\"];\n".to_owned()),
        Just("/* [Hidden] */".to_owned()),
        Just("/* [Group] */".to_owned()),
        Just("use <u>".to_owned()),
        Just(";".to_owned()),
    ];
    leaf.prop_recursive(4, 24, 3, |inner| {
        let child =
            prop::sample::select(vec![";", "c();", "if (a) c();", "!if (a) b(); else c();", "{ }", "{ d = 1; }"]);
        let child = prop_oneof![
            child.prop_map(str::to_owned),
            inner
                .clone()
                .prop_filter("no use in braces", |text| !text.contains("use"))
                .prop_map(|a| format!("{{ {a} }}")),
        ];
        prop_oneof![
            (inner.clone(), inner).prop_map(|(a, b)| format!("{a}\n{b}")),
            child.clone().prop_map(|a| format!("module m(x) {a}")),
            child.clone().prop_map(|a| format!("translate([1, 0]) {a}")),
            (child.clone(), child).prop_map(|(a, b)| format!("if (x) {a} else {b}")),
        ]
    })
}

proptest! {
    #[test]
    fn any_program_survives(text in statements()) {
        check_round_trip(&text);
    }
}
