//! The variables that the language sets, and its keywords.

use super::{Described, described};

pub(super) const VARIABLES: &[Described] = &[
    described(
        "$fn",
        &[],
        "Number of sides of curves: from 3 to 12 it makes polygons, above a true curve. It follows the calls.",
        "cylinder(h = 5, r = 8, $fn = 6);",
    ),
    described("$fa", &[], "Least angle of a facet, in degrees; of no effect, since curves are true curves.", ""),
    described("$fs", &[], "Least size of a facet, in mm; of no effect, since curves are true curves.", ""),
    described("$t", &[], "The time, from 0 to 1.", "rotate(360 * $t) cube(10);"),
    described("$preview", &[], "Whether a picture is made quickly; always true.", ""),
    described(
        "$vpr",
        &[],
        "The angles that the scene is seen from, in degrees, if it sets them.",
        "$vpr = [60, 0, 30];",
    ),
    described("$vpt", &[], "The point that is looked at, in mm, if the scene sets it.", "$vpt = [0, 0, 10];"),
    described("$vpd", &[], "The distance of the camera, in mm, if the scene sets it.", "$vpd = 200;"),
    described("$vpf", &[], "The vertical field of view, in degrees.", "$vpf = 30;"),
    described(
        "$children",
        &[],
        "Inside a module: how many children it was given.",
        "module all() { for (i = [0 : $children - 1]) children(i); }",
    ),
    described("$parent_modules", &[], "How many modules are under way.", ""),
    described(
        "PI",
        &[],
        "The number π, 3.14159…; angles are in degrees, so it is rarely needed.",
        "r = 5; around = 2 * PI * r;",
    ),
];

pub(super) const KEYWORDS: &[Described] = &[
    described("module", &[], "Defines a module.", "module wall(length, height = 20) cube([length, 2, height]);"),
    described("function", &[], "Defines a function, or is one.", "function half(x) = x / 2;"),
    described(
        "if",
        &[],
        "Chooses what is there, or what is in a list.",
        "width = 12; if (width > 10) cube(width); else sphere(width);",
    ),
    described(
        "else",
        &[],
        "What is there if the condition of `if` is not true.",
        "open = true; if (open) sphere(5); else cube(5);",
    ),
    described("let", &[], "Gives names to values, for what follows.", "x = let (a = 2) a * a;"),
    described(
        "assert",
        &[],
        "Stops with an error if a condition is not true.",
        "width = 12; assert(width > 0, \"too thin\");",
    ),
    described("echo", &[], "Writes values into the messages.", "echo(\"a third is\", 1 / 3);"),
    described(
        "for",
        &[],
        "Repeats for every value of a range or list.",
        "for (i = [0 : 5]) translate([10 * i, 0, 0]) sphere(4);",
    ),
    described("each", &[], "In a list: all elements of another list.", "all = [each [1, 2], 3];"),
    described("true", &[], "The truth value of what holds.", ""),
    described("false", &[], "The truth value of what does not hold.", ""),
    described("undef", &[], "The value of what has none.", ""),
    described("use", &[], "Takes the modules and functions of another file.", "use <parts.scad>"),
    described("include", &[], "Stands for the text of another file.", "include <sizes.scad>"),
];
