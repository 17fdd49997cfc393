//! The modules that are OpenSCAD's, and our operators.

use super::{Described, Parameter, described, named, parameter};

/// The radius of a joint and its kind.
const JOINT: &[Parameter] = &[
    named("r", "mm", "", "radius with which the operands meet; without, edges are sharp"),
    named("joint", "", "\"fillet\"", "how they meet: \"fillet\", \"chamfer\" or \"smooth\""),
    named("every", "", "false", "whether what loops, conditions and children() below it make counts one by one"),
];

/// The bindings of loops and `let`, whose names are the scene's.
const BINDINGS: &[Parameter] = &[];

pub(super) const MODULES: &[Described] = &[
    // Solids
    described(
        "cube",
        &[
            parameter("size", "mm", "1", "edge lengths [x, y, z], or one number for all"),
            parameter("center", "", "false", "whether the origin is its centre instead of a corner"),
            named("r", "mm", "", "radius of rounded edges; the outer size stays"),
        ],
        "A box with its edges along the axes.",
        "cube([30, 20, 10], center = true);",
    ),
    described(
        "sphere",
        &[parameter("r", "mm", "1", "radius"), named("d", "mm", "", "diameter, instead of r")],
        "The ball around the origin.",
        "sphere(r = 10);",
    ),
    described(
        "cylinder",
        &[
            parameter("h", "mm", "1", "height"),
            parameter("r1", "mm", "", "radius at the bottom"),
            parameter("r2", "mm", "", "radius at the top"),
            parameter("center", "", "false", "whether the origin is in its middle instead of its bottom"),
            named("r", "mm", "1", "radius at both ends"),
            named("d", "mm", "", "diameter at both ends"),
            named("d1", "mm", "", "diameter at the bottom"),
            named("d2", "mm", "", "diameter at the top"),
            named("edge", "mm", "", "radius of rounded edges; the outer size stays"),
        ],
        "A cylinder, cone or frustum about z.",
        "cylinder(h = 20, r = 5);",
    ),
    described(
        "polyhedron",
        &[
            parameter("points", "mm", "!", "the corners, a list of [x, y, z]"),
            parameter("faces", "", "!", "the faces, lists of the corners' numbers, clockwise seen from outside"),
            named("triangles", "", "", "the old name of faces"),
        ],
        "A convex solid with flat faces.",
        "polyhedron([[0, 0, 0], [9, 0, 0], [0, 9, 0], [0, 0, 9]], [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]);",
    ),
    // Plane shapes
    described(
        "square",
        &[
            parameter("size", "mm", "1", "edge lengths [x, y], or one number for both"),
            parameter("center", "", "false", "whether the origin is its centre instead of a corner"),
            named("r", "mm", "", "radius of rounded corners; the outer size stays"),
        ],
        "A rectangle with its edges along x and y.",
        "linear_extrude(5) square([20, 10]);",
    ),
    described(
        "circle",
        &[parameter("r", "mm", "1", "radius"), named("d", "mm", "", "diameter, instead of r")],
        "The disc around the origin.",
        "linear_extrude(5) circle(r = 10);",
    ),
    described(
        "polygon",
        &[
            parameter("points", "mm", "!", "the corners, a list of [x, y]"),
            parameter("paths", "", "", "the outlines, lists of the corners' numbers; without, all in order"),
            named("r", "mm", "", "radius of rounded corners; the outer size stays"),
        ],
        "The area within outlines of straight lines, filled by the even-odd rule.",
        "linear_extrude(5) polygon([[0, 0], [20, 0], [10, 15]]);",
    ),
    // Transforms
    described(
        "translate",
        &[parameter("v", "mm", "[0, 0, 0]", "how far, as [x, y, z]")],
        "Moves its children.",
        "translate([10, 0, 0]) sphere(5);",
    )
    .with_children(),
    described(
        "rotate",
        &[
            parameter("a", "°", "0", "angles [x, y, z], turned about x first; or one angle about v"),
            parameter("v", "", "[0, 0, 1]", "the axis to turn about, if a is one angle"),
        ],
        "Turns its children about the axes, or about one axis, anticlockwise.",
        "rotate([0, 90, 0]) cylinder(h = 20, r = 2);",
    )
    .with_children(),
    described(
        "scale",
        &[parameter("v", "", "1", "factors [x, y, z], or one number for all")],
        "Makes its children larger or smaller.",
        "scale([1, 1, 0.5]) sphere(10);",
    )
    .with_children(),
    described(
        "mirror",
        &[parameter("v", "", "[1, 0, 0]", "the direction across the mirror, as [x, y, z]")],
        "Mirrors its children in a plane through the origin.",
        "mirror([1, 0, 0]) translate([5, 0, 0]) cube(5);",
    )
    .with_children(),
    described(
        "multmatrix",
        &[parameter("m", "", "", "the matrix: 3 or 4 rows of 4 numbers; what is missing is as in the identity")],
        "Transforms its children by an affine matrix.",
        "multmatrix([[1, 0.5, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]) cube(10);",
    )
    .with_children(),
    described(
        "resize",
        &[
            parameter("newsize", "mm", "[0, 0, 0]", "the size [x, y, z]; 0 leaves it as it is"),
            parameter("auto", "", "false", "whether what is 0 grows in proportion"),
        ],
        "Scales its children to a given size.",
        "resize([30, 0, 0], auto = true) sphere(10);",
    )
    .with_children(),
    described(
        "color",
        &[
            parameter("c", "", "", "a name, \"#rrggbb\" or [r, g, b, a] with numbers from 0 to 1"),
            parameter("alpha", "", "1", "opacity from 0 to 1"),
            named("roughness", "", "", "from 0, a mirror, to 1, chalk"),
            named("metallic", "", "", "0 for plastics, 1 for metals"),
            named("emission", "", "", "light given off, as a multiple of the colour"),
        ],
        "Gives its children a colour and what else makes a material.",
        "color(\"tomato\", roughness = 0.3) sphere(10);",
    )
    .with_children(),
    // Booleans
    described("union", JOINT, "Joins its children.", "union(r = 3) { cube(20); cylinder(h = 40, r = 5); }")
        .with_children(),
    described(
        "difference",
        JOINT,
        "The first child without all others.",
        "difference() { cube(20, center = true); sphere(12); }",
    )
    .with_children(),
    described(
        "intersection",
        JOINT,
        "What all children have in common.",
        "intersection() { cube(20, center = true); sphere(12); }",
    )
    .with_children(),
    described("group", &[], "Takes its children as one.", "group() { cube(5); sphere(5); }").with_children(),
    described("render", &[], "Takes its children as one, as `group` does.", "render() sphere(5);").with_children(),
    // Between plane and space
    described(
        "linear_extrude",
        &[
            parameter("height", "mm", "100", "how far up"),
            parameter("v", "mm", "", "the direction and, without a height, how far; if it is not given, straight up"),
            parameter("scale", "", "1", "how the top is scaled, one number or [x, y]"),
            parameter("center", "", "false", "whether the plane z = 0 is its middle instead of its bottom"),
            parameter("twist", "°", "0", "how far the top is turned, clockwise seen from above"),
            parameter(
                "slices",
                "",
                "",
                "number of flat-sided stages of a twist, up to 12; without or above, a true curve",
            ),
            parameter("segments", "", "", "of no effect: curves are true curves"),
            named("h", "mm", "", "height"),
            named("r", "mm", "", "radius of rounded edges, without twist and scale; the outer size stays"),
        ],
        "Draws a plane shape out along z.",
        "linear_extrude(height = 10, twist = 90) square(10, center = true);",
    )
    .with_children(),
    described(
        "rotate_extrude",
        &[
            parameter("angle", "°", "360", "how far to turn, anticlockwise"),
            parameter(
                "start",
                "°",
                "",
                "where to start, from the x axis: with an angle 0, if it is not given, else 180",
            ),
            named("a", "°", "", "angle"),
            named("r", "mm", "", "radius of rounded edges; the outer size stays"),
        ],
        "Turns a plane shape about z: its x is the distance from the axis, its y the height.",
        "rotate_extrude() translate([10, 0]) circle(3);",
    )
    .with_children(),
    described(
        "projection",
        &[parameter("cut", "", "false", "whether to cut at z = 0 instead of taking the shadow")],
        "The plane shape that a solid casts, or its cut.",
        "projection(cut = true) sphere(10);",
    )
    .with_children(),
    described(
        "twist",
        &[parameter("rate", "° / mm", "!", "how far it turns for each millimetre, anticlockwise seen from above")],
        "Turns its children about z in proportion to the height.",
        "twist(rate = 3) translate([0, 0, 20]) cube([10, 10, 40], center = true);",
    )
    .with_children(),
    // Others
    described(
        "hull",
        &[],
        "The convex hull of its children.",
        "hull() { sphere(5); translate([20, 0, 0]) sphere(2); }",
    )
    .with_children(),
    described(
        "minkowski",
        &[],
        "The Minkowski sum of its children: each one drawn along all others.",
        "minkowski() { cube(10); sphere(2); }",
    )
    .with_children(),
    described(
        "offset",
        &[
            parameter("r", "mm", "1", "by how much, with round corners; negative shrinks"),
            parameter("delta", "mm", "", "by how much, with sharp corners, instead of r"),
            parameter("chamfer", "", "false", "whether corners made by delta are cut off"),
        ],
        "Grows or shrinks a plane shape.",
        "linear_extrude(5) offset(r = 2) square(10);",
    )
    .with_children(),
    described(
        "fill",
        &[],
        "Fills the holes of a plane shape.",
        "linear_extrude(5) fill() ring(outer = 10, inner = 8);",
    )
    .with_children(),
    described(
        "round",
        &[parameter("r", "mm", "!", "by how much")],
        "Grows its children, so that convex edges become round with that radius.",
        "round(r = 2) cube(10);",
    )
    .with_children(),
    described(
        "shell",
        &[parameter("thickness", "mm", "1", "thickness of the wall")],
        "The wall that lies half to each side of its children's surface.",
        "difference() { shell(thickness = 1) sphere(10); translate([0, 0, 10]) cube(20, center = true); }",
    )
    .with_children(),
    // Control
    described(
        "for",
        BINDINGS,
        "Repeats its children for every value of a range or list; several names make all combinations.",
        "for (i = [0 : 5]) translate([10 * i, 0, 0]) sphere(4);",
    )
    .with_children(),
    described(
        "intersection_for",
        BINDINGS,
        "What its children have in common over every value of a range or list.",
        "intersection_for (a = [0 : 60 : 120]) rotate(a) cube([30, 10, 10], center = true);",
    )
    .with_children(),
    described(
        "if",
        &[parameter("condition", "", "!", "what decides")],
        "Its children if a condition is true; those of `else`, if it is not.",
        "width = 12; if (width > 10) cube(width); else sphere(width);",
    )
    .with_children(),
    described(
        "let",
        BINDINGS,
        "Gives names to values, for its children.",
        "let (r = 5) translate([r, 0, 0]) sphere(r);",
    )
    .with_children(),
    described("assign", BINDINGS, "OpenSCAD's old way to write `let`.", "assign (r = 5) sphere(r);").with_children(),
    described(
        "echo",
        &[parameter("value", "", "", "what to write; any number of values, also with names")],
        "Writes values into the messages.",
        "echo(\"a third is\", 1 / 3);",
    )
    .with_children(),
    described(
        "assert",
        &[
            parameter("condition", "", "!", "what must be true"),
            parameter("message", "", "", "what to say if it is not"),
        ],
        "Stops with an error if a condition is not true.",
        "width = 12; assert(width > 0, \"the width has to be positive\");",
    )
    .with_children(),
    described(
        "children",
        &[parameter("index", "", "", "which ones: a number, a list or a range, from 0; without, all")],
        "Inside a module: what stands behind the place where the module is used.",
        "module twice() { children(); translate([20, 0, 0]) children(); }",
    ),
    // What there is not
    described(
        "child",
        &[parameter("index", "", "0", "which one, from 0")],
        "OpenSCAD's old way to write `children(0)`.",
        "",
    ),
    described(
        "text",
        &[
            parameter("text", "", "!", "what to write"),
            parameter("size", "mm", "10", "height of capital letters"),
            parameter("font", "", "", "name of the font"),
            parameter("direction", "", "\"ltr\"", "direction of writing"),
            parameter("language", "", "\"en\"", "language"),
            parameter("script", "", "\"latin\"", "script"),
            parameter("halign", "", "\"left\"", "where the origin is across"),
            parameter("valign", "", "\"baseline\"", "where the origin is along"),
            parameter("spacing", "", "1", "distance of letters, as a factor"),
        ],
        "Letters as a plane shape; not supported yet.",
        "",
    )
    .unsupported(),
    described(
        "import",
        &[
            parameter("file", "", "!", "the file"),
            parameter("layer", "", "", "which layer of it"),
            parameter("convexity", "", "", "of no effect"),
            parameter("origin", "mm", "", "what becomes the origin"),
            parameter("scale", "", "", "how it is scaled"),
            parameter("width", "mm", "", "width"),
            parameter("height", "mm", "", "height"),
            parameter("center", "", "false", "whether to centre it"),
        ],
        "The geometry of a file; not supported yet.",
        "",
    )
    .unsupported(),
    described(
        "surface",
        &[
            parameter("file", "", "!", "the file"),
            parameter("center", "", "false", "whether to centre it"),
            parameter("convexity", "", "", "of no effect"),
            parameter("invert", "", "false", "whether dark is high"),
        ],
        "A landscape from a table or picture of heights; not supported yet.",
        "",
    )
    .unsupported(),
    described(
        "roof",
        &[parameter("method", "", "\"voronoi\"", "how it is made"), parameter("convexity", "", "", "of no effect")],
        "A roof over a plane shape; not supported yet.",
        "",
    )
    .unsupported()
    .with_children(),
    replaced("import_stl", "OpenSCAD's old name of `import`, which is not supported yet."),
    replaced("import_off", "OpenSCAD's old name of `import`, which is not supported yet."),
    replaced("import_dxf", "OpenSCAD's old name of `import`, which is not supported yet."),
    replaced("dxf_linear_extrude", "OpenSCAD's old way to extrude an imported drawing, which is not supported yet."),
    replaced("dxf_rotate_extrude", "OpenSCAD's old way to revolve an imported drawing, which is not supported yet."),
];

const fn replaced(name: &'static str, manual: &'static str) -> Described {
    const PARAMETERS: &[Parameter] = &[
        parameter("file", "", "!", "the file"),
        parameter("layer", "", "", "which layer of it"),
        parameter("convexity", "", "", "of no effect"),
        parameter("origin", "mm", "", "what becomes the origin"),
    ];
    described(name, PARAMETERS, manual, "").unsupported()
}
