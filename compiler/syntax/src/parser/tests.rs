use proptest::prelude::*;

use super::*;
use crate::testing::{FILE, messages, tree, without_places};
use crate::tree::{Element, Expression, ExpressionKind, Instance, Statement};

/// The value of the first assignment of a text.
fn value(text: &str) -> Expression {
    match tree(text).statements.into_iter().next() {
        Some(Statement::Assignment(assignment)) => assignment.value,
        other => panic!("no assignment: {other:?}"),
    }
}

/// An expression with a parenthesis around every operation.
fn grouped(expression: &Expression) -> String {
    match &*expression.kind {
        ExpressionKind::Name(name) => name.to_string(),
        ExpressionKind::Number(number) => number.to_string(),
        ExpressionKind::Unary(operator, operand) => format!("({}{})", operator.sign(), grouped(operand)),
        ExpressionKind::Binary(operator, left, right) => {
            format!("({}{}{})", grouped(left), operator.sign(), grouped(right))
        }
        ExpressionKind::Conditional { condition, yes, no } => {
            format!("({}?{}:{})", grouped(condition), grouped(yes), grouped(no))
        }
        ExpressionKind::Member(list, name) => format!("({}.{})", grouped(list), name.node),
        ExpressionKind::Index(list, index) => format!("({}[{}])", grouped(list), grouped(index)),
        ExpressionKind::Call(function, arguments) => {
            let arguments: Vec<_> = arguments.iter().map(|argument| grouped(&argument.value)).collect();
            format!("({}({}))", grouped(function), arguments.join(","))
        }
        other => format!("{other:?}"),
    }
}

fn instance(text: &str) -> Instance {
    match tree(text).statements.into_iter().next() {
        Some(Statement::Instance(instance)) => instance,
        other => panic!("no instance: {other:?}"),
    }
}

#[test]
fn operators_bind_as_in_openscad() {
    for (text, expected) in [
        ("-2^2", "(-(2^2))"),
        ("2^3^2", "(2^(3^2))"),
        ("2^-1", "(2^(-1))"),
        ("a-b-c*d%e", "((a-b)-((c*d)%e))"),
        ("a||b&&c==d<e|f&g<<h+i", "(a||(b&&(c==(d<(e|(f&(g<<(h+i))))))))"),
        ("!a==b", "((!a)==b)"),
        ("a?b:c?d:e", "(a?b:(c?d:e))"),
        ("-f(x).y[0]^2", "(-((((f(x)).y)[0])^2))"),
        ("(a+b)*c", "((a+b)*c)"),
    ] {
        assert_eq!(grouped(&value(&format!("x = {text};"))), expected);
    }
}

#[test]
fn parentheses_in_lists_hold_operands_or_comprehensions() {
    let text = "x = [(a) + 1, (for (i = a) i), each (b), (let (c = 1) c) * 2, let (d = 1) each d];";
    let ExpressionKind::List(elements) = *value(text).kind else { panic!("no list") };
    assert!(matches!(
        &elements[..],
        [Element::Value(_), Element::For(..), Element::Each(..), Element::Value(_), Element::Let(..)]
    ));
}

#[test]
fn commas_may_be_repeated() {
    for (text, once) in [
        ("x = [a, , b,,];", "x = [a, b];"),
        ("x = [,,];", "x = [];"),
        ("x = f(a,, b = 1, ,);", "x = f(a, b = 1);"),
        ("m(,a);", "m(a);"),
        ("module m(a,, b,) cube(a);", "module m(a, b) cube(a);"),
    ] {
        assert_eq!(crate::print(&tree(text)), crate::print(&tree(once)));
    }
}

#[test]
fn spans_cover_the_whole_text_of_a_node() {
    let text = "x = (a + b) * [1, 2];";
    assert_eq!(&text[value(text).span.range()], "(a + b) * [1, 2]");
    let text = "#translate([1, 0]) { cube(1); } sphere(2);";
    let instance = instance(text);
    assert_eq!(&text[instance.span.range()], "#translate([1, 0]) { cube(1); }");
    assert_eq!(&text[instance.head.range()], "translate([1, 0])");
}

#[test]
fn else_belongs_to_the_nearest_if() {
    let outer = instance("if (a) if (b) c(); else d(); else e();");
    let [Statement::Instance(inner)] = &outer.children[..] else { panic!("one child") };
    assert_eq!((inner.otherwise.len(), outer.otherwise.len()), (1, 1));
}

#[test]
fn the_whole_language_is_read() {
    tree(
        "use <a.scad>
        include <b/c.scad>;
        ;; { x = 1; { cube(x); } }
        module m(a, b = [1, 2,], $fn = 3,) { module n() cube(); n(); children(0); y = 2; }
        module empty();
        module one() sphere(1);
        function f(x, y = 2) = let (z = x + y, ) assert(z > 0, \"positive\") echo(z) z;
        g = function (x) function (y) x + y;
        h = g(1)(2) ? f(x = 1, 2,) : [0:2:10][1].begin;
        l = [for (i = 0, j = 1; i < 3; i = i + 1, j = 2) if (i > 1) i else each [j, i], [], [1:2],];
        v = assert(true);
        *!#%for (i = [1:3]) let (a = 1) assert(a) echo(a) each(a) intersection_for(n = [1]) { cube(); }
        if (a) ; else if (b) { } else cube();
        2d_shape(0x1F, 1., .5, undef, true, false, -inf);",
    );
}

#[test]
fn many_mistakes_are_reported_at_once_and_each_once() {
    assert_eq!(
        messages("a = 3\nb = [1, 2;\nc = (1 + ) * 2;\ncube(size = );\nd = 4 5;\ne = 6;"),
        [
            "1:6 missing `;` behind this assignment",
            "2:10 missing `]`",
            "3:10 expected an expression, found `)`",
            "4:13 expected an expression, found `)`",
            "5:7 expected `;`, found the number `5`",
        ]
    );
    assert_eq!(
        messages("difference { cube(1) }\nmodule (a) { sphere(1); }\nx += 1;\nfunction f(x) { return x; }\ny = 1;"),
        [
            "1:11 missing `()` behind `difference`",
            "1:21 missing `;` behind `cube(1)`",
            "2:8 expected the name of a module, found `(`",
            "3:3 expected `(` or `=`, found `+`",
            "4:15 expected `=`, found `{`",
        ]
    );
}

#[test]
fn what_other_languages_write_is_one_error_each() {
    assert_eq!(
        messages(
            "if a > b { c(); }\nx = if (a) 3 else 4;\ny = {1, 2};\nz = 1 + let (a = 1) a;\nuse file;\nm.x = [1 2 3];"
        ),
        [
            "1:4 expected `(`, found the name `a`",
            "2:5 expected an expression, found `if`",
            "3:5 expected an expression, found `{`",
            "4:9 expected an expression, found `let`",
            "5:5 expected `(` or `=`, found the name `file`",
            "6:2 expected `(` or `=`, found `.`",
        ]
    );
}

#[test]
fn brackets_left_open_name_their_opener() {
    let text = "module m() {\n  cube([1, 2);\n";
    let (_, diagnostics) = parse(FILE, text, Dialect::Program);
    let related: Vec<_> = diagnostics
        .iter()
        .flat_map(|diagnostic| &diagnostic.related)
        .map(|label| (label.span.start, label.message.as_str()))
        .collect();
    assert_eq!(related, [(20, "`[` is opened here"), (11, "this `{` is never closed")]);
    assert_eq!(messages(text), ["2:13 missing `]`", "2:15 missing `}` at the end of the file"]);
}

#[test]
fn characters_and_strings_that_cannot_be_are_reported_without_further_errors() {
    assert_eq!(
        messages("a = 'b';\nc = \"d;\ne = 1 @ 2;"),
        [
            "1:5 `'` means nothing here",
            "1:7 `'` means nothing here",
            "2:5 this string is never closed",
            "3:7 `@` means nothing here",
        ]
    );
}

#[test]
fn a_string_left_open_is_one_error_whatever_it_swallows() {
    for text in [
        "a = ((1 + \"x);\nb = 1;",
        "a = [[f([\"x)]]];\nb = 1;",
        "for (i = [0:len((\"x))]) cube(i);\nb = 1;",
        "module m() { text(\"abc); }\nm();",
        "color(\"red) {\n  cube(1);\n}\nb = 1;",
        "if ((a == \"b)) {\n  cube(1);\n}",
    ] {
        let messages = messages(text);
        assert!(messages.len() == 1 && messages[0].ends_with("this string is never closed"), "{text}\n{messages:?}");
    }
}

#[test]
fn a_bracket_that_closes_nothing_is_said_to() {
    for text in ["cube(1));", "x = 1);", "cube(1) ];"] {
        let (_, diagnostics) = parse(FILE, text, Dialect::Program);
        let hints: Vec<_> = diagnostics.iter().flat_map(|diagnostic| &diagnostic.hints).collect();
        assert_eq!(hints, ["nothing is open that it could close"], "{text}");
    }
}

#[test]
fn no_more_than_a_hundred_errors_are_shown() {
    let messages = messages(&"a = ;\n".repeat(1000));
    assert_eq!(messages.len(), 101);
    assert_eq!(messages[100], "101:5 further errors are not shown");
}

#[test]
fn files_that_are_too_large_are_refused() {
    assert_eq!(messages(&" ".repeat(MAX_FILE_BYTES + 1)), ["1:1 the file is larger than 128 MB"]);
}

#[test]
fn raw_strings_of_dumps_end_where_their_node_says() {
    let arguments = "size = 10, spacing = 1, font = \"F\"G\", direction = \"ltr\", language = \"en\"";
    let text = format!("group() {{\n\ttext(text = \"a\"b\\n\", {arguments});\n}}\ntext(text = \"a\\\"b\");\n");
    let (file, diagnostics) = parse(FILE, &text, Dialect::Dump);
    assert_eq!(diagnostics, []);
    let debug = without_places(&file).0;
    for value in [r#"String("a\"b\\n")"#, r#"String("F\"G")"#, r#"String("a\"b")"#] {
        assert!(debug.contains(value), "{value} in {debug}");
    }
}

#[test]
fn whatever_is_too_deep_is_one_error_on_a_small_stack() {
    let deep = |open: &str, close: &str| format!("{}1{};", open.repeat(100_000), close.repeat(100_000));
    let mut texts: Vec<_> =
        ["(", "[", "-", "f(", "x[", "[for (i = 1) ", "let (a = 1) ", "function (x) ", "2^", "a?", "a?1:", "[("]
            .iter()
            .map(|open| format!("a = {}", deep(open, "")))
            .collect();
    texts.push(format!("a = {};", vec!["a"; 1_000_000].join(" + ")));
    texts.push(format!("a = f{};", "(1)[2].x".repeat(100_000)));
    texts.extend(["translate([1, 0]) ", "if (a) b(); else ", "{", "module m() ", "m() {"].map(|open| deep(open, "")));
    let thread = std::thread::Builder::new().stack_size(3 << 19).spawn(move || {
        for text in &texts {
            let (file, diagnostics) = parse(FILE, text, Dialect::Program);
            crate::print(&file);
            assert_eq!(diagnostics.len(), 1, "{:.50}", text);
            assert!(diagnostics[0].message.contains("levels deep"), "{:.50}", text);
        }
    });
    thread.expect("a thread starts").join().expect("no text overflows the stack");
}

#[test]
fn what_is_long_but_flat_takes_linear_time() {
    for text in ["!", "]", "}", "\"\\\"\n", "text(text = \"", "text(text = \"a\");", "a=[1 2;", "f({", "/*", "a=x(;"] {
        parse(FILE, &text.repeat(20_000), Dialect::Dump);
    }
}

/// Checks the places in a tree and its diagnostics.
fn check_places(text: &str, dialect: Dialect) {
    let (file, diagnostics) = parse(FILE, text, dialect);
    let places = [without_places(&file).1, without_places(&diagnostics).1].concat();
    for (start, end) in places {
        assert!(text.get(start..end).is_some(), "{start}..{end} of {text:?}");
    }
    crate::print(&file);
}

/// Words that programs are made of, and some that they are not.
const WORDS: &[&str] = &[
    "module",
    "function",
    "if",
    "else",
    "let",
    "assert",
    "echo",
    "for",
    "each",
    "true",
    "undef",
    "a",
    "cube",
    "$fn",
    "1",
    "2.5",
    "0x1F",
    "\"s\"",
    "\"",
    "\\",
    "use <a>",
    "include <b>",
    "use <",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ";",
    ",",
    ".",
    ":",
    "?",
    "=",
    "+",
    "-",
    "*",
    "/",
    "%",
    "^",
    "!",
    "~",
    "#",
    "&",
    "&&",
    "|",
    "||",
    "==",
    "<",
    "<<",
    ">=",
    "\n",
    "// c\n",
    "/* [G] */",
    "/*",
    "é",
    "\u{a0}",
    "\x03",
    "text(text = \"",
    "\", size = 1, spacing = 1, font = \"",
    ");\n",
];

proptest! {
    #[test]
    fn any_text_is_read(text in any::<String>()) {
        check_places(&text, Dialect::Program);
        check_places(&text, Dialect::Dump);
    }

    #[test]
    fn any_words_are_read(words in prop::collection::vec(prop::sample::select(WORDS), 0..60), dump: bool, blank: bool) {
        let text = words.join(if blank { " " } else { "" });
        check_places(&text, if dump { Dialect::Dump } else { Dialect::Program });
    }
}
