//! The functions, which are OpenSCAD's.

use super::{Described, Parameter, described, parameter};

const X: &[Parameter] = &[parameter("x", "", "!", "a number")];
const ANGLE: &[Parameter] = &[parameter("angle", "°", "!", "an angle")];
const VALUE: &[Parameter] = &[parameter("value", "", "!", "any value")];
const EXTREME: &[Parameter] = &[parameter("values", "", "!", "numbers, or one list of them")];

pub(super) const FUNCTIONS: &[Described] = &[
    // Mathematics
    described("abs", X, "The absolute value.", "abs(-3)"),
    described("sign", X, "-1, 0 or 1, as the number is negative, zero or positive.", "sign(-3)"),
    described("sin", ANGLE, "The sine of an angle in degrees.", "sin(30)"),
    described("cos", ANGLE, "The cosine of an angle in degrees.", "cos(60)"),
    described("tan", ANGLE, "The tangent of an angle in degrees.", "tan(45)"),
    described("asin", X, "The angle, in degrees, whose sine this is.", "asin(0.5)"),
    described("acos", X, "The angle, in degrees, whose cosine this is.", "acos(0.5)"),
    described("atan", X, "The angle, in degrees, whose tangent this is.", "atan(1)"),
    described(
        "atan2",
        &[parameter("y", "", "!", "a number"), parameter("x", "", "!", "a number")],
        "The angle, in degrees from -180 to 180, from the x axis to the point [x, y].",
        "atan2(1, -1)",
    ),
    described("floor", X, "The next whole number below.", "floor(2.7)"),
    described("ceil", X, "The next whole number above.", "ceil(2.1)"),
    described("round", X, "The nearest whole number; halves go away from zero.", "round(2.5)"),
    described("sqrt", X, "The square root.", "sqrt(2)"),
    described("exp", X, "The exponential function.", "exp(1)"),
    described("ln", X, "The natural logarithm.", "ln(10)"),
    described(
        "pow",
        &[parameter("base", "", "!", "a number"), parameter("exponent", "", "!", "a number")],
        "The base to the power of the exponent, as `base ^ exponent`.",
        "pow(2, 8)",
    ),
    described(
        "log",
        &[parameter("base", "", "10", "the base, if there are two arguments"), parameter("x", "", "!", "a number")],
        "The logarithm to base 10, or with two arguments to the first.",
        "log(1000)",
    ),
    described("min", EXTREME, "The least of some numbers.", "min(3, 1, 2)"),
    described("max", EXTREME, "The greatest of some numbers.", "max([3, 1, 2])"),
    described("norm", &[parameter("v", "", "!", "a list of numbers")], "The length of a vector.", "norm([3, 4])"),
    described(
        "cross",
        &[parameter("a", "", "!", "a vector of 2 or 3 numbers"), parameter("b", "", "!", "another one")],
        "The cross product.",
        "cross([1, 0, 0], [0, 1, 0])",
    ),
    described(
        "rands",
        &[
            parameter("min", "", "!", "the least"),
            parameter("max", "", "!", "the greatest"),
            parameter("count", "", "!", "how many"),
            parameter("seed", "", "", "a number on which they depend"),
        ],
        "A list of random numbers.",
        "rands(0, 10, 5, seed = 42)",
    ),
    // Lists
    described("len", &[parameter("list", "", "!", "a list or text")], "How many elements there are.", "len([1, 2, 3])"),
    described(
        "concat",
        &[parameter("lists", "", "", "lists and single values, any number of them")],
        "One list of all elements.",
        "concat([1, 2], [3], 4)",
    ),
    described(
        "lookup",
        &[parameter("key", "", "!", "a number"), parameter("table", "", "!", "a list of [key, value]")],
        "The value of a table at a key, with straight lines between its rows.",
        "lookup(5, [[0, 10], [10, 30]])",
    ),
    described(
        "search",
        &[
            parameter("what", "", "!", "a number, a text, or a list of these"),
            parameter("table", "", "!", "the list or text to search"),
            parameter("matches", "", "1", "the most matches for each; 0 for all"),
            parameter("column", "", "0", "the column of the table that counts"),
        ],
        "Where values occur in a table, as indices.",
        "search(\"b\", [[\"a\", 1], [\"b\", 2]])",
    ),
    // Texts
    described(
        "str",
        &[parameter("values", "", "", "any values, any number of them")],
        "One text of all values.",
        "str(\"width \", 12.5)",
    ),
    described(
        "chr",
        &[parameter("codes", "", "", "Unicode code points, or lists of them")],
        "The text of some characters.",
        "chr(65)",
    ),
    described("ord", &[parameter("text", "", "!", "a text")], "The code point of the first character.", "ord(\"A\")"),
    // Types
    described("is_undef", VALUE, "Whether a value is undef; names that stand for nothing are.", "is_undef(x)"),
    described("is_bool", VALUE, "Whether a value is true or false.", "is_bool(x)"),
    described("is_num", VALUE, "Whether a value is a number.", "is_num(x)"),
    described("is_string", VALUE, "Whether a value is a text.", "is_string(x)"),
    described("is_list", VALUE, "Whether a value is a list.", "is_list(x)"),
    described("is_function", VALUE, "Whether a value is a function.", "is_function(x)"),
    described("is_object", VALUE, "Whether a value is an object; there are none.", "is_object(x)"),
    // Surroundings
    described("version", &[], "The version of OpenSCAD whose language this is, as a list.", "version()"),
    described(
        "version_num",
        &[parameter("version", "", "", "a version as a list; without, this one")],
        "A version as one number to compare.",
        "version_num() >= 20210100",
    ),
    described(
        "parent_module",
        &[parameter("number", "", "1", "how many modules further out")],
        "The name of a module that is under way.",
        "parent_module(0)",
    ),
    // What there is not
    missing("dxf_cross", "A point of a drawing; not supported."),
    missing("dxf_dim", "A measure of a drawing; not supported."),
    missing("fontmetrics", "The measures of a font; not supported yet."),
    missing("textmetrics", "The measures of a text; not supported yet."),
    missing("has_key", "Whether an object has a member; not supported yet."),
    missing("import", "The values of a file; not supported yet."),
    missing("object", "An object with members; not supported yet."),
];

const fn missing(name: &'static str, manual: &'static str) -> Described {
    described(name, &[], manual, "").unsupported()
}
