//! From points of a surface to the expressions that made it, and back.

use std::collections::BTreeMap;

use chiaro_compiler::field::Evaluator;
use chiaro_compiler::syntax::FileId;
use chiaro_compiler::{Compilation, Options, Provenance, Scene, Tree, World, compile};

struct Files(BTreeMap<&'static str, String>);

impl World for Files {
    fn find(&self, _from: &str, path: &str) -> Option<String> {
        self.0.contains_key(path).then(|| path.to_owned())
    }

    fn read(&self, name: &str) -> Result<Vec<u8>, String> {
        self.0.get(name).map(|text| text.clone().into_bytes()).ok_or_else(|| "missing".to_owned())
    }
}

struct Compiled {
    compilation: Compilation,
    provenance: Provenance,
    text: String,
}

fn compiled(text: &str) -> Compiled {
    let files = Files([("main.scad", text.to_owned()), ("library.scad", LIBRARY.to_owned())].into());
    let compilation = compile(&files, "main.scad", &Options::default());
    let scene = compilation.scene.as_ref().unwrap_or_else(|| panic!("{:?}", compilation.diagnostics));
    let provenance = scene.provenance(&compilation.sources).unwrap();
    Compiled { provenance, text: text.to_owned(), compilation }
}

const LIBRARY: &str = "module knob(r) { translate([0, 0, 1]) sphere(r); }";

impl Compiled {
    fn scene(&self) -> &Scene {
        self.compilation.scene.as_ref().unwrap()
    }

    /// The heads of the expressions that made the surface at a point, the innermost first.
    fn origin(&self, point: [f64; 3]) -> Vec<&str> {
        self.origin_with(point, &self.scene().defaults())
    }

    fn origin_with(&self, point: [f64; 3], parameters: &[f64]) -> Vec<&str> {
        let origin = self.provenance.origin(point, parameters);
        origin.iter().map(|origin| self.compilation.sources.text(origin.span)).collect()
    }

    /// Where the caret is in the text: before this.
    fn offset(&self, before: &str) -> u32 {
        self.text.find(before).unwrap() as u32
    }

    /// The values at points of each solid that the expression at the caret made.
    fn parts(&self, before: &str, points: &[[f64; 3]]) -> Vec<Vec<f64>> {
        let solids = self.provenance.nodes_at(FileId(0), self.offset(before));
        let part = |solid| Evaluator::new(&self.provenance.part(solid).unwrap(), &[]);
        let rounded = |value: f64| (value * 1e6).round() / 1e6;
        let values = |field: Evaluator| points.iter().map(|point| rounded(field.distance(*point))).collect();
        solids.into_iter().map(|solid| values(part(solid))).collect()
    }
}

#[test]
fn a_surface_knows_the_operand_that_made_it() {
    let scene = compiled(
        "translate([10, 0, 0]) difference() { cube(4, center = true); sphere(2.5); cylinder(r = 0.5, h = 20, center = true); }",
    );
    let above = ["difference()", "translate([10, 0, 0])"];
    let cube = |point| assert_eq!(scene.origin(point), [&["cube(4, center = true)"], &above[..]].concat());
    cube([12.0, 1.9, 1.9]);
    cube([10.0 - 1.9, 2.0, 1.9]);
    assert_eq!(scene.origin([11.5, 1.5, 1.75_f64.sqrt()]), [&["sphere(2.5)"], &above[..]].concat());
    assert_eq!(scene.origin([10.0, 40.0, 1.5]), [""; 0], "nothing is near");
}

#[test]
fn a_module_that_is_called_twice_knows_which_call_it_was() {
    let text = "module ball() { sphere(1); }
module pair(x) { translate([x, 0, 0]) { ball(); cube(1); } }
pair(0); pair(10); for (i = [0 : 1]) translate([0, 10 * (i + 1), 0]) ball();";
    let scene = compiled(text);
    let call = |x: &'static str| vec!["sphere(1)", "ball()", "translate([x, 0, 0])", x];
    assert_eq!(scene.origin([-1.0, 0.0, 0.0]), call("pair(0)"));
    assert_eq!(scene.origin([9.0, 0.0, 0.0]), call("pair(10)"));
    let looped = ["sphere(1)", "ball()", "translate([0, 10 * (i + 1), 0])", "for (i = [0 : 1])"];
    assert_eq!(scene.origin([0.0, 21.0, 0.0]), looped);
}

#[test]
fn libraries_and_children_are_in_the_chain() {
    let text = "use <library.scad>
module placed() { translate([0, 0, 5]) children(); }
placed() knob(2);";
    let chain = ["sphere(r)", "translate([0, 0, 1])", "knob(2)", "children()", "translate([0, 0, 5])", "placed()"];
    assert_eq!(compiled(text).origin([0.0, 0.0, 8.0]), chain);
}

#[test]
fn walls_and_flat_ends_of_extrusions_come_from_their_outline() {
    let text = "linear_extrude(height = 3) difference() { square(10); translate([5, 5]) circle(2); }";
    let scene = compiled(text);
    let extrusion = ["difference()", "linear_extrude(height = 3)"];
    let of = |inner: &[&'static str]| [inner, &extrusion[..]].concat();
    assert_eq!(scene.origin([7.0, 5.0, 1.0]), of(&["circle(2)", "translate([5, 5])"]));
    assert_eq!(scene.origin([10.0, 5.0, 1.0]), of(&["square(10)"]));
    assert_eq!(scene.origin([7.1, 5.0, 3.0]), of(&["square(10)"]), "on the flat end, beside the hole");
}

#[test]
fn a_joint_and_what_is_grown_come_from_the_nearest_operand() {
    let scene = compiled("union(r = 2) { cube(4, center = true); translate([0, 0, 4]) sphere(3); }");
    assert_eq!(scene.origin([2.0, 0.0, -1.0])[0], "cube(4, center = true)");
    assert_eq!(scene.origin([0.0, 0.0, 7.0])[0], "sphere(3)");
    let scene = compiled("minkowski() { union() { cube(2); translate([9, 0, 0]) cube(2); } sphere(1); }");
    assert_eq!(scene.origin([12.0, 1.0, 1.0])[..3], ["cube(2)", "translate([9, 0, 0])", "union()"]);
}

#[test]
fn live_numbers_move_what_made_a_point() {
    let scene =
        compiled("x = 0; // [0:10]\ntranslate([x, 0, 0]) sphere(1); translate([6, 0, 0]) cube(2, center = true);");
    assert_eq!(scene.origin_with([7.0, 0.0, 0.0], &[0.0])[0], "cube(2, center = true)");
    assert_eq!(scene.origin_with([8.0, 0.0, 0.0], &[7.0])[0], "sphere(1)");
}

#[test]
fn a_caret_finds_all_that_its_expression_made() {
    let text = "module ball(r) { sphere(r); }
for (i = [0 : 2]) translate([10 * i, 0, 0]) ball(1);
difference() { cube(30); cylinder(r = 1, h = 50); }";
    let scene = compiled(text);
    let points = [[0.0; 3], [10.0, 0.0, 0.0]];
    let balls = [[-1.0, 9.0], [9.0, -1.0], [19.0, 9.0]];
    assert_eq!(scene.parts("sphere(r)", &points), balls);
    assert_eq!(scene.parts("(1);", &points), balls, "the caret in the call's arguments");
    assert_eq!(scene.parts("for", &points), [[-1.0, -1.0]], "the loop as one");
    assert_eq!(scene.parts(" cylinder", &points).len(), 1, "between the operands, all of the difference");
    assert_eq!(scene.parts("cylinder", &[[0.0, 3.0, 9.0]]), [[2.0]], "what is taken away, by itself");
    assert_eq!(scene.parts("module", &points), balls, "all that the module made");
    let solids = scene.provenance.nodes_at(FileId(0), scene.offset("sphere(r)"));
    let together = Evaluator::new(&scene.provenance.parts(&solids).unwrap(), &[]);
    assert_eq!(points.map(|point| together.distance(point)), [-1.0, -1.0]);
    assert!(compiled("x = 3; cube(x);").parts("3;", &points).is_empty());
}

#[test]
fn a_part_has_what_moves_and_grows_it() {
    let text = "difference() { cube(20); minkowski() { translate([5, 0, 0]) sphere(4); sphere(1); } }";
    assert_eq!(compiled(text).parts("sphere(4)", &[[5.0, 0.0, 0.0]]), [[-5.0]]);
    let text = "linear_extrude(height = 4) { translate([20, 0]) circle(2); square(5); }";
    assert_eq!(compiled(text).parts("circle(2)", &[[20.0, 0.0, 3.0], [20.0, 5.0, 2.0]]), [[-1.0, 3.0]]);
}

#[test]
fn placements_turn_drags_into_local_units() {
    let text =
        "rotate([0, 0, 90]) scale(2) translate([1, 0, 0]) cube(3); rotate_extrude() translate([9, 0]) circle(1);";
    let scene = compiled(text);
    let place = |before| {
        let solid = scene.provenance.nodes_at(FileId(0), scene.offset(before))[0];
        scene.provenance.placement(solid, &[])
    };
    let rounded = place("translate([1").unwrap().map(|row| row.map(|x| (x * 1e9).round() / 1e9));
    assert_eq!(rounded, [[0.0, -2.0, 0.0, 0.0], [2.0, 0.0, 0.0, 0.0], [0.0, 0.0, 2.0, 0.0]]);
    assert_eq!(place("cube").unwrap().map(|row| row[3].round()), [0.0, 2.0, 0.0]);
    assert_eq!(place("circle").unwrap_err().what, "rotate_extrude");
}

#[test]
fn local_bounds_are_in_the_coordinates_of_the_text() {
    let scene =
        compiled("w = 3; rotate([0, 0, 90]) translate([5, 0, 0]) cube([2 * w, 1, w]); cylinder(r = w, h = w + 1);");
    let bounds = |before| {
        let solid = scene.provenance.nodes_at(FileId(0), scene.offset(before))[0];
        let bounds = scene.provenance.local_bounds(solid, &[]);
        [bounds.min, bounds.max]
    };
    assert_eq!(bounds("cube"), [[0.0; 3], [6.0, 1.0, 3.0]]);
    assert_eq!(bounds("cylinder"), [[-3.0, -3.0, 0.0], [3.0, 3.0, 4.0]]);
}

#[test]
fn rays_hit_where_the_surface_is() {
    let scene = compiled("translate([0, 0, 1]) sphere(2);");
    let point = scene.provenance.hit([0.0, 0.0, 50.0], [0.0, 0.0, -3.0], &[]).unwrap();
    assert!((point[2] - 3.0).abs() < 1e-3, "{point:?}");
    assert_eq!(scene.provenance.hit([5.0, 0.0, 50.0], [0.0, 0.0, -3.0], &[]), None);
}

#[test]
fn the_tree_shows_the_text_with_facts() {
    fn outline(tree: &Tree, depth: usize, lines: &mut Vec<String>) {
        let size = tree.bounds.size().map(|edge| format!("{edge:.0}")).join("×");
        let class = tree.class.map_or("nothing".to_owned(), |class| format!("{class:?}"));
        lines.push(format!("{}{} {size} {class}", "  ".repeat(depth), tree.what));
        tree.children.iter().for_each(|child| outline(child, depth + 1, lines));
    }
    let scene = compiled("module leg() { cylinder(r = 1, h = 9); } leg(); difference() { cube(4); cube([1, 2, 20]); }");
    let mut lines = Vec::new();
    outline(&scene.provenance.tree(&[]), 0, &mut lines);
    let expected = [
        " 5×5×9 Bound",
        "  leg 2×2×9 Exact",
        "    cylinder 2×2×9 Exact",
        "  difference 4×4×4 Bound",
        "    cube 4×4×4 Exact",
        "    cube 1×2×20 Exact",
    ];
    assert_eq!(lines, expected);
}

#[test]
fn a_plane_scene_is_a_slab() {
    let scene = compiled("circle(10); translate([20, 0]) square(5);");
    assert_eq!(scene.origin([-10.0, 0.0, 0.1]), ["circle(10)"]);
    assert_eq!(scene.origin([25.0, 2.0, 0.1]), ["square(5)", "translate([20, 0])"]);
}

#[test]
fn what_is_highlighted_is_found_be_it_cut_away() {
    let highlighted = |text: &str| {
        let scene = compiled(text);
        let name = |solid: &chiaro_compiler::SolidId| scene.provenance.chain(*solid)[0].what.clone();
        let signs = scene.provenance.highlights().map(|sign| scene.compilation.sources.text(sign).to_owned());
        (scene.provenance.highlighted().iter().map(name).collect::<Vec<_>>(), signs.collect::<Vec<_>>().concat())
    };
    let found = |names: &[&str], signs: &str| (names.iter().map(|name| (*name).to_owned()).collect(), signs.to_owned());
    assert_eq!(highlighted("difference() { sphere(10); # cylinder(r = 4, h = 30); }"), found(&["cylinder"], "#"));
    // What is far from all that it is taken from is there to be found, too.
    let far = "difference() { sphere(10); translate([90, 0, 0]) #cube(1); }";
    assert_eq!(highlighted(far), found(&["cube"], "#"));
    assert_eq!(highlighted("module peg() #cube(1); peg(); translate([3, 0, 0]) peg();"), found(&["cube", "cube"], "#"));
    assert_eq!(highlighted("#for (x = [0 : 1]) translate([x, 0, 0]) sphere(0.2);"), found(&["for"], "#"));
    assert_eq!(highlighted("cube(1); *#cube(2); %#cube(3); module never() #cube(4);"), found(&[], ""));
    assert_eq!(highlighted("#!cube(1); sphere(3);"), found(&["cube"], "#!"));
}
