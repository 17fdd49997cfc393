//! Scenes in, printed solids out.

use super::Facets;
use super::testing::{evaluate, solid, warning};

#[test]
fn openscad_defaults_and_argument_orders() {
    assert_eq!(solid("cube();"), "move 0.5 0.5 0.5\n  box 0.5 0.5 0.5\n");
    assert_eq!(solid("cube([1, 2, 3], true);"), "box 0.5 1 1.5\n");
    assert_eq!(solid("sphere(d = 3);"), "sphere 1.5\n");
    assert_eq!(solid("cylinder(4, 1, 2, true);"), "cone 1 2 2\n");
    assert_eq!(solid("cylinder(r = 3, h = 4);"), "move 0 0 2\n  cylinder 3 2\n");
    assert_eq!(solid("cylinder(d1 = 3, d2 = 0, h = 4, center = true);"), "cone 1.5 0 2\n");
    assert_eq!(solid("square([4, 2]);"), "move 2 1 0\n  rectangle 2 1\n");
    assert_eq!(solid("circle(d = 3);"), "circle 1.5\n");
}

#[test]
fn wrong_arguments_are_reported_and_defaults_used() {
    let (cube, warnings) = evaluate("cube(\"big\", centre = true, convexity = 3, $fn = 8);", Facets::Auto);
    assert_eq!(cube, "move 0.5 0.5 0.5\n  box 0.5 0.5 0.5\n");
    assert_eq!(
        warnings,
        [
            "`cube` has no parameter `centre`; the argument is ignored",
            "`size` of `cube` has to be a number or a list of 3 numbers, not a string; the default is used",
        ]
    );
    assert_eq!(warning("sphere(1, 2, 3);"), "`sphere` has no parameter for this argument, which is ignored");
    assert_eq!(warning("sphere(r = 1, r = 2);"), "`r` of `sphere` is given twice; the last one counts");
    assert_eq!(warning("color(\"gren\") cube();"), "there is no colour \"gren\", so that nothing is painted");
}

#[test]
fn sizes_that_are_not_positive_give_nothing() {
    assert_eq!(solid("cube(0);"), "empty\n");
    assert_eq!(solid("cylinder(r1 = 0, r2 = 0);"), "empty\n");
    assert_eq!(warning("sphere(-1);"), "this size is negative, so that there is nothing");
    assert_eq!(warning("cube([1, inf, 1]);"), "this size is not finite, so that there is nothing");
    assert_eq!(solid("linear_extrude(0) square();"), "empty\n");
    assert_eq!(solid("rotate_extrude(angle = 0) square();"), "empty\n");
}

#[test]
fn empty_operands_count() {
    assert_eq!(solid("difference() { group(); cube(2); }"), "empty\n");
    assert_eq!(solid("difference() { sphere(); group(); }"), "sphere 1\n");
    assert_eq!(solid("intersection() { sphere(); cube(0); }"), "empty\n");
    assert_eq!(solid("union() { cube(0); sphere(); }"), "sphere 1\n");
    assert_eq!(solid("translate([1, 2, 3]) color(\"red\") hull() minkowski() group();"), "empty\n");
}

#[test]
fn the_first_child_decides_the_dimension() {
    let (mixed, warnings) = evaluate("square(center = true); cube();", Facets::Auto);
    assert_eq!(mixed, "rectangle 0.5 0.5\n");
    assert_eq!(warnings, ["plane shapes and solids do not mix: what is unlike the first child is left out"]);
    assert_eq!(evaluate("intersection() { sphere(); circle(); }", Facets::Auto).0, "empty\n");
    let text = "linear_extrude(1) { cube(); circle(); }";
    assert_eq!(evaluate(text, Facets::Auto).0, "extrude 1\n  circle 1\n");
    assert_eq!(warning(text), "`linear_extrude` takes plane shapes: this is a solid and is left out");
}

#[test]
fn facets_follow_the_policy() {
    let text = "circle(2, $fn = 6); circle(3, $fn = 40);";
    assert_eq!(evaluate(text, Facets::Auto).0, "union\n  ngon 2 6\n  circle 3\n");
    assert_eq!(evaluate(text, Facets::Exact).0, "union\n  ngon 2 6\n  ngon 3 40\n");
    assert_eq!(evaluate(text, Facets::Smooth).0, "union\n  circle 2\n  circle 3\n");
    assert_eq!(solid("cylinder(h = 2, r = 1, center = true, $fn = 2);"), "move 0 0 -1\n  extrude 2\n    ngon 1 3\n");
    let sphere =
        "scale 2 2 2\n  revolve facets 8\n    region 1 contour, 6 lines, 0 arcs, (0 -0.92388) to (0.92388 0.92388)\n";
    assert_eq!(solid("sphere(2, $fn = 8);"), sphere);
    assert_eq!(solid("sphere(2, $fn = size);"), "demote: `$fn`, the number of sides of a curve\n");
}

#[test]
fn transforms() {
    assert_eq!(solid("translate([1, 2]) sphere();"), "move 1 2 0\n  sphere 1\n");
    assert_eq!(solid("scale([2, 3]) sphere();"), "scale 2 3 1\n  sphere 1\n");
    assert_eq!(solid("mirror() sphere();"), "scale -1 1 1\n  sphere 1\n");
    assert_eq!(solid("rotate([90, 0, 90]) sphere();"), "matrix [0 0 1 0; 1 0 0 0; 0 1 0 0]\n  sphere 1\n");
    assert_eq!(solid("rotate(a = 90, v = [0, 0, 2]) sphere();"), "matrix [0 -1 0 0; 1 0 0 0; 0 0 1 0]\n  sphere 1\n");
    assert_eq!(
        solid("multmatrix([[2, 0, 0, 4], [0, 2, 0, 0], [0, 0, 2, 0], [0, 0, 0, 2]]) sphere();"),
        "move 2 0 0\n  sphere 1\n"
    );
    let (turned, warnings) = evaluate("rotate([0, 0, 90, 45]) sphere();", Facets::Auto);
    assert_eq!(turned, "matrix [0 -1 0 0; 1 0 0 0; 0 0 1 0]\n  sphere 1\n");
    assert_eq!(warnings, ["there are angles about x, y and z: what follows the third does not count"]);
    let (gone, warnings) = evaluate("rotate([0, 0, inf]) sphere();", Facets::Auto);
    assert_eq!(gone, "empty\n");
    assert_eq!(warnings, ["`rotate` is not finite here, so that there is nothing"]);
    assert_eq!(warning("scale([1, 0, 1]) sphere();"), "`scale` flattens this to nothing");
}

#[test]
fn transforms_of_plane_shapes_keep_the_plane() {
    assert_eq!(solid("translate([1, 2, 3]) circle();"), "move 1 2 0\n  circle 1\n");
    assert_eq!(solid("rotate([60, 0, 0]) square(2, true);"), "scale 1 0.5 1\n  rectangle 1 1\n");
    assert_eq!(solid("scale([2, 2]) circle();"), "scale 2 2 2\n  circle 1\n");
    assert_eq!(solid("scale([3, 2, 0]) circle();"), "scale 3 2 3\n  circle 1\n");
}

#[test]
fn live_numbers_stay_live_unless_they_decide() {
    assert_eq!(solid("translate([signed, 0, 0]) sphere(size);"), "move p1 0 0\n  sphere p0\n");
    assert_eq!(solid("rotate(signed) circle(size);").lines().last(), Some("  circle p0"));
    assert_eq!(solid("cube(signed);"), "demote: whether a size is positive\n");
    assert_eq!(solid("scale(signed) cube();"), "demote: whether a matrix flattens what it is applied to\n");
    assert_eq!(solid("polygon([[0, 0], [size, 0], [0, 1]]);"), "demote: a point of a polygon\n");
    let painted = evaluate("color([signed, 0, 1]) sphere();", Facets::Auto).0;
    assert_eq!(painted, "paint min(max(p1, 0), 1) 0 1 1\n  sphere 1\n");
}

#[test]
fn joints() {
    let joined = "difference smooth 2\n  sphere 1\n  sphere 2\n";
    assert_eq!(solid("difference(r = 2, joint = \"smooth\") { sphere(); sphere(2); }"), joined);
    assert_eq!(solid("union(r = size) { sphere(); sphere(2); }"), "union fillet p0\n  sphere 1\n  sphere 2\n");
    assert_eq!(solid("union(r = 1, joint = \"stairs\") sphere();"), "error: there is no joint \"stairs\"\n");
    assert_eq!(solid("union(r = -1) sphere();"), "error: the radius of a joint cannot be negative\n");
}

#[test]
fn rounded_edges_keep_the_outer_size() {
    assert_eq!(solid("cube([4, 6, 8], true, r = 1);"), "offset 1\n  box 1 2 3\n");
    assert_eq!(solid("square([4, 6], true, r = 2);"), "offset 2\n  rectangle 0 1\n");
    assert_eq!(solid("cylinder(r = 4, h = 6, center = true, edge = 1);"), "offset 1\n  cylinder 3 2\n");
    assert_eq!(solid("cube(4, r = 3);"), "error: edges of this radius do not fit the shape: at most 2\n");
    let plate = "offset 1\n  move 0 0 1\n    extrude 2\n      region 1 contour, 4 lines, 0 arcs, (-1 -2) to (1 2)\n";
    assert_eq!(solid("linear_extrude(4, r = 1) square([4, 6], true);"), plate);
}

#[test]
fn polygons_are_even_odd_and_forgive_indices() {
    let text = "polygon([[0, 0], [4, 0], [4, 4], [0, 4]], [[0, 1, 2, 9]]);";
    assert_eq!(evaluate(text, Facets::Auto).0, "region 1 contour, 3 lines, 0 arcs, (0 0) to (4 4)\n");
    assert_eq!(warning(text), "indices that are not of one of the 4 points are left out of the paths");
    assert_eq!(solid("polygon([[0, 0], [4, 0]]);"), "empty\n");
    assert_eq!(
        solid("polygon([[0, 0], [4, 0], [4, 4]], undef);"),
        "region 1 contour, 3 lines, 0 arcs, (0 0) to (4 4)\n"
    );
}

#[test]
fn extrusions() {
    let twisted = "move 0 0 -5\n  extrude 10 twist -90° scale 0.5 2\n    circle 1\n";
    assert_eq!(solid("linear_extrude(10, center = true, twist = 90, scale = [0.5, 2]) circle();"), twisted);
    assert_eq!(solid("linear_extrude(v = [0, 0, 3]) circle();"), "extrude 3\n  circle 1\n");
    let (default, warnings) = evaluate("linear_extrude(height = inf) circle();", Facets::Auto);
    assert_eq!(default, "extrude 100\n  circle 1\n");
    assert_eq!(warnings, ["this height is not finite; the default of 100 is used"]);
    let leaning = "matrix [1 0 0.75 0; 0 1 0 0; 0 0 1 0]\n  extrude 8\n    circle 1\n";
    assert_eq!(solid("linear_extrude(height = 10, v = [3, 0, 4]) circle();"), leaning);
    assert_eq!(solid("projection(cut = true) sphere();"), "slice\n  sphere 1\n");
    assert_eq!(solid("projection() translate([1, 2, 3]) sphere();"), "move 1 2 0\n  circle 1\n");
    let shadows = "union\n  rectangle 0.5 0.5\n  circle 2\n";
    assert_eq!(solid("projection() { cube(center = true); cylinder(r = 2, h = 9); }"), shadows);
    assert_eq!(solid("projection() torus();"), "error: the shadow of this solid is not supported yet\n");
}

#[test]
fn revolutions_look_at_the_side_of_the_axis() {
    let ring = "translate([3, 0]) circle();";
    let left = "translate([-3, 0]) circle();";
    let profile = "move 3 0 0\n    circle 1\n";
    assert_eq!(solid(&format!("rotate_extrude() {ring}")), format!("revolve\n  {profile}"));
    assert_eq!(solid(&format!("rotate_extrude(90) {ring}")), format!("revolve 90° from 0°\n  {profile}"));
    assert_eq!(solid(&format!("rotate_extrude(-90) {ring}")), format!("revolve 90° from -90°\n  {profile}"));
    assert_eq!(solid(&format!("rotate_extrude(400) {ring}")), format!("revolve\n  {profile}"));
    let flipped = "scale -1 1 1\n    move -3 0 0\n      circle 1\n";
    assert_eq!(solid(&format!("rotate_extrude(90) {left}")), format!("revolve 90° from 180°\n  {flipped}"));
    let error = "error: the profile of `rotate_extrude` lies on both sides of the axis x = 0\n";
    assert_eq!(solid("rotate_extrude() circle();"), error);
    let hexagonal = "scale -1 -1 1\n  revolve facets 6\n    move 3 0 0\n      circle 1\n";
    assert_eq!(solid(&format!("rotate_extrude($fn = 6) {ring}")), hexagonal);
    // The box of the difference reaches over the axis, but the difference does not.
    let half = solid("rotate_extrude() difference() { circle(2); translate([-4, -4]) square([4, 8]); }");
    assert_eq!(half.lines().next(), Some("revolve"));
}

#[test]
fn offsets_of_plane_shapes() {
    assert_eq!(solid("offset(2) square(2, true);"), "offset 2\n  rectangle 1 1\n");
    assert_eq!(solid("offset(delta = 1) square(2, true);"), "region 1 contour, 4 lines, 0 arcs, (-2 -2) to (2 2)\n");
    assert_eq!(solid("offset(r = -3) circle(2);"), "empty\n");
    let opened = solid("offset(1) offset(-1) square(4, true);");
    assert_eq!(opened, "offset 1\n  region 1 contour, 4 lines, 0 arcs, (-1 -1) to (1 1)\n");
    let cut = solid("offset(1) difference() { square(8, true); square(2, true); }");
    assert_eq!(cut, "region 1 contour, 4 lines, 4 arcs, (-5 -5) to (5 5)\n");
}

#[test]
fn minkowski_sums() {
    assert_eq!(solid("minkowski() { cube(2, true); sphere(1); }"), "offset 1\n  box 1 1 1\n");
    assert_eq!(solid("minkowski() { sphere(1); translate([1, 0, 0]) sphere(2); }"), "move 1 0 0\n  sphere 3\n");
    let plate = "move 0 0 -1\n  extrude 4\n    offset 1\n      rectangle 1 1\n";
    assert_eq!(solid("minkowski() { cube(2, true); cylinder(r = 1, h = 2); }"), plate);
    let boxes = "extrude 6\n  move 2 3 0\n    rectangle 2 3\n";
    assert_eq!(solid("minkowski() { cube(2); cube([2, 4, 4]); }"), boxes);
    assert!(solid("minkowski() { difference() { cube(2); cube(1); } sphere(1); }").starts_with("error: "));
    assert_eq!(solid("minkowski() { group(); cube(2, true); }"), "box 1 1 1\n");
    assert_eq!(solid("minkowski() { circle(); circle(0); }"), "empty\n");
    assert_eq!(solid("minkowski() circle();"), "circle 1\n");
    let plane = solid("minkowski() { square(2, true); rotate(45) square(2, true); }");
    assert_eq!(plane, "region 1 contour, 8 lines, 0 arcs, (-2.41421 -2.41421) to (2.41421 2.41421)\n");
}

#[test]
fn hulls() {
    let cone = "sphere_hull (0 0 0) 1, (0 0 5) 2\n";
    assert_eq!(solid("hull() { sphere(1); translate([0, 0, 5]) sphere(2); }"), cone);
    let slot = "extrude 2\n  region 1 contour, 2 lines, 2 arcs, (-1 -1) to (6 1)\n";
    assert_eq!(solid("hull() { cylinder(r = 1, h = 2); translate([5, 0, 0]) cylinder(r = 1, h = 2); }"), slot);
    let plane = "region 1 contour, 2 lines, 2 arcs, (-1 -1) to (6 1)\n";
    assert_eq!(solid("hull() { circle(); translate([5, 0]) circle(); }"), plane);
    assert_eq!(solid("hull() cylinder(center = true);"), "cylinder 1 0.5\n");
    let torus = "hull() { torus(); sphere(); }";
    assert_eq!(solid(torus), "error: this hull or sum of solids is not supported yet\n");
}

#[test]
fn convex_solids_with_corners() {
    let pyramid = "sphere_hull (0 0 0) 0, (2 0 0) 0, (0 2 0) 0, (0 0 2) 0\n";
    let points = "[[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]]";
    let faces = "[[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]";
    assert_eq!(solid(&format!("polyhedron({points}, {faces});")), pyramid);
    let repeated = "[[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2], [0, 0, 2.00001]]";
    let corners = solid(&format!("polyhedron({repeated}, [[0, 1, 2], [0, 3, 1], [0, 2, 4], [1, 3, 2]]);"));
    assert!(corners.starts_with("sphere_hull"), "{corners}");
    let error = "error: the faces of this polyhedron do not enclose a solid\n";
    assert_eq!(solid(&format!("polyhedron({points}, [[0, 1, 2], [0, 3, 1], [0, 2, 3]]);")), error);
    let notched = "[[0, 0, 0], [9, 0, 0], [0, 9, 0], [0, 0, 9], [1, 1, 1]]";
    let faces = "[[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 4], [3, 2, 4], [2, 1, 4]]";
    let error = "error: a polyhedron that is not convex is not supported yet\n";
    assert_eq!(solid(&format!("polyhedron({notched}, {faces});")), error);
    let boxes = solid("hull() { cube(2, true); translate([5, 0, 1]) cube(1); }");
    assert_eq!((boxes.starts_with("sphere_hull"), boxes.matches('(').count()), (true, 16));
    let sum = solid("minkowski() { rotate([0, 45, 0]) cube(2, true); cube(2, true); }");
    assert_eq!(sum.matches('(').count(), 64);
    let faceted = solid("minkowski() { cube(2, true); sphere(1, $fn = 4); }");
    assert_eq!(faceted.matches('(').count(), 8 * (2 * 4 + 2));
    assert_eq!(solid("hull() { sphere(size); cube(); }"), "demote: the hull of more than two solids\n");
}

#[test]
fn resizing() {
    assert_eq!(solid("resize([8, 0, 2]) sphere(2);"), "scale 2 1 0.5\n  sphere 2\n");
    assert_eq!(solid("resize([8, 0, 0], auto = [false, true, false]) sphere(2);"), "scale 2 2 1\n  sphere 2\n");
    assert_eq!(solid("resize([8, 0], auto = true) square(2, true);"), "scale 4 4 4\n  rectangle 1 1\n");
    let drilled = "difference() { cube(4, true); cylinder(r = 1, h = 9, center = true); }";
    assert!(solid(&format!("resize([8, 0, 0]) {drilled}")).starts_with("scale 2 1 1\n"));
    assert!(solid("resize([8, 0]) difference() { square(4); square(2); }").starts_with("scale 2 1 2\n"));
    let error = "error: the size of what is resized here is not known exactly\n";
    assert_eq!(solid("resize([8, 0, 0]) intersection() { sphere(2); cube(2); }"), error);
    assert_eq!(solid("resize([8, 0, 0]) sphere(size);"), "demote: the size of what is resized\n");
}

#[test]
fn native_shapes_come_from_the_table() {
    assert_eq!(solid("torus(major = 8, minor = 2);"), "torus 8 2\n");
    assert_eq!(solid("capsule(5, 1);"), "capsule 5 1\n");
    assert_eq!(solid("half_space([0, 0, 2], 3);"), "half_space 0 0 1 3\n");
    assert_eq!(solid("pie(2);"), "pie 2 0 1.5708\n");
    assert_eq!(solid("arc(start = 90, sweep = -90);"), "arc 10 1 0 1.5708\n");
    assert_eq!(solid("half_space();"), "error: `half_space` needs its `normal`\n");
    assert_eq!(solid("torus(minor = 0);"), "empty\n");
    assert_eq!(solid("ring(outer = 2, inner = 3);"), "error: `inner` has to be less than `outer`\n");
    assert_eq!(solid("star(n = 1);"), "error: `n` has to be a whole number from 2 to 1000\n");
}

#[test]
fn operators_on_one_solid() {
    assert_eq!(solid("shell(0.5) sphere(3);"), "shell 0.5\n  sphere 3\n");
    assert_eq!(solid("round(1) cube(2, true);"), "offset 1\n  box 1 1 1\n");
    assert_eq!(solid("twist(3) cube(2, true);"), "twist 3° per mm\n  box 1 1 1\n");
    assert!(solid("shell(1) { sphere(2); cube(2); }").starts_with("error: "));
}

#[test]
fn paint() {
    assert_eq!(solid("color(\"Red\", 0.5) sphere();"), "paint 1 0 0 0.5\n  sphere 1\n");
    assert_eq!(solid("color(\"#08f\") sphere();"), "paint 0 0.533333 1 1\n  sphere 1\n");
    assert_eq!(solid("color([0, 0, 1], metallic = 1) sphere();"), "paint 0 0 1 1 metallic 1\n  sphere 1\n");
    assert_eq!(solid("color([-1, -1, -1, 1]) sphere();"), "sphere 1\n");
    assert_eq!(solid("color(\"red\", roughness = 2) sphere();"), "error: `roughness` goes from 0 to 1\n");
}

#[test]
fn what_is_not_supported_says_so() {
    assert_eq!(solid("text(\"a\");"), "error: `text` is not supported yet\n");
    assert_eq!(solid("import_stl(file = \"a.stl\");"), "error: `import_stl` is not supported yet\n");
}
