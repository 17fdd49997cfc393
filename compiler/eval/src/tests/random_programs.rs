//! Programs put together at random: whatever they say, the evaluator answers.

use proptest::prelude::*;

use super::run;

fn expression() -> impl Strategy<Value = String> {
    let leaf = prop::sample::select(vec![
        "1",
        "-2.5",
        "1e300",
        "0",
        "p",
        "q",
        "q[0]",
        "$t",
        "true",
        "undef",
        "\"aß\"",
        "[]",
        "[1, 2, 3]",
        "[0 : 3]",
        "x",
        "PI",
        "1 / 0",
        "0 / 0",
        "function(x) x + 1",
        "$fn",
        "$children",
        "[[1, 2], [3, 4]]",
    ]);
    leaf.prop_map(String::from).prop_recursive(4, 24, 3, |inner| {
        let binary =
            prop::sample::select(vec!["+", "-", "*", "/", "%", "^", "<", "<=", "==", "!=", "&&", "||", "&", "<<"]);
        let unary = prop::sample::select(vec!["-", "!", "~", "+"]);
        let function = prop::sample::select(vec![
            "sin", "abs", "floor", "len", "str", "min", "max", "norm", "chr", "ord", "is_num", "is_undef", "f",
            "concat",
        ]);
        let binary_function =
            prop::sample::select(vec!["lookup", "search", "cross", "atan2", "pow", "max", "concat", "g", "log"]);
        prop_oneof![
            (inner.clone(), binary, inner.clone()).prop_map(|(a, op, b)| format!("({a} {op} {b})")),
            (unary, inner.clone()).prop_map(|(op, a)| format!("({op}{a})")),
            (function, inner.clone()).prop_map(|(f, a)| format!("{f}({a})")),
            (binary_function, inner.clone(), inner.clone()).prop_map(|(f, a, b)| format!("{f}({a}, {b})")),
            (inner.clone(), inner.clone(), inner.clone()).prop_map(|(a, b, c)| format!("({a} ? {b} : {c})")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("({a})[{b}]")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("[for (x = {a}) if ({b}) x, each {b}]")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("let (x = {a}) {b}")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("({a})({b})")),
            (inner.clone(), inner).prop_map(|(a, b)| format!("[{a}, {b}]")),
        ]
    })
}

fn statement() -> impl Strategy<Value = String> {
    let module =
        prop::sample::select(vec!["translate", "rotate", "scale", "color", "m", "group", "union", "difference"]);
    let leaf = prop::sample::select(vec!["cube", "sphere", "cylinder", "children", "echo", "m", "square", "nothing"]);
    let leaf = (leaf, expression()).prop_map(|(name, a)| format!("{name}({a});"));
    let assignment = expression().prop_map(|a| format!("x = {a};"));
    prop_oneof![leaf, assignment].prop_recursive(3, 12, 3, move |inner| {
        let block = prop::collection::vec(inner, 0..3).prop_map(|statements| statements.join(" "));
        prop_oneof![
            (module.clone(), expression(), block.clone()).prop_map(|(m, a, b)| format!("{m}({a}) {{ {b} }}")),
            (expression(), block.clone()).prop_map(|(a, b)| format!("for (x = {a}) {{ {b} }}")),
            (expression(), block.clone(), block.clone())
                .prop_map(|(a, b, c)| format!("if ({a}) {{ {b} }} else {{ {c} }}")),
            (expression(), block).prop_map(|(a, b)| format!("let (x = {a}) {{ {b} }}")),
        ]
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_program_panics(statements in prop::collection::vec(statement(), 1..6)) {
        let head = "p = 2; // [1:0.5:9]\nq = [1, 2, 3]; // [0:9]\nx = 1;\n\
            function f(x) = x == 0 ? 0 : f(x - 1) + 1; function g(a, b) = a > b ? a : b;\n\
            module m(x = 1) { translate([x, 0, 0]) children(); children(0); }\n";
        let outcome = run(&format!("{head}{}", statements.join("\n")));
        prop_assert_eq!(outcome.solid.is_some(), outcome.errors.is_empty());
    }
}
