//! What a scene looks like other than lit, which pixels show which expression, and which expression a pixel shows.

mod kept;

use std::sync::OnceLock;

use chiaro_compiler::field::Evaluator;
use chiaro_compiler::solid::SolidKind;
use chiaro_compiler::syntax::FileId;
use chiaro_compiler::{Compilation, Options, Origin, Provenance, compile};
use chiaro_render::{Gpu, Inspection, Inspector, Masker, Model, Plane, Preference, View};
use chiaro_tests::MemoryWorld;
use chiaro_tests::corpus::examples;
use chiaro_tests::likeness::EXACT;
use chiaro_tests::world::DiskWorld;
use image::RgbaImage;
use kept::changed;

/// Straight from the front: x to the right, z upwards.
const FRONT: [f64; 3] = [90.0, 0.0, 0.0];

const PLATE: &str = "
module hole(x) { translate([x, 0, 0]) rotate([90, 0, 0]) cylinder(r = 3, h = 20, center = true); }
difference() {
    cube([30, 4, 16], center = true);
    hole(-8);
    hole(8);
}
translate([0, -4, 0]) sphere(3.1);
";

struct Looked {
    text: &'static str,
    compilation: Compilation,
    provenance: Provenance,
    inspector: Inspector,
    values: Vec<f64>,
}

fn gpu() -> &'static Gpu {
    static GPU: OnceLock<Gpu> = OnceLock::new();
    GPU.get_or_init(|| {
        let software = Gpu::new(&Preference::Software).or_else(|_| Gpu::new(&Preference::Any));
        software.unwrap_or_else(|error| panic!("{error}: tools/setup.sh installs a software adapter"))
    })
}

fn looked(text: &'static str) -> Looked {
    let compilation = compile(&MemoryWorld::of("main.scad", text), "main.scad", &Options::default());
    let scene = compilation.scene.as_ref().unwrap_or_else(|| panic!("{:?}", compilation.diagnostics));
    let values = scene.defaults();
    let model = Model::new(gpu(), &scene.picture(), &values).unwrap();
    let inspector = Inspector::new(gpu(), &model).unwrap();
    let provenance = scene.provenance(&compilation.sources).unwrap();
    Looked { text, provenance, inspector, values, compilation }
}

fn view(rotation: [f64; 3], distance: f64) -> View {
    View { target: [0.0; 3], rotation, distance, field_of_view: 22.5 }
}

impl Looked {
    /// The pixels that show what the expression at the caret made, as text; the caret stands before this.
    fn mask(&mut self, before: &str, outline: bool) -> Vec<String> {
        let offset = self.text.find(before).unwrap() as u32;
        let [width, height] = self.inspector.size();
        let mut rows = vec![vec![b'.'; width as usize]; height as usize];
        let mut masker = Masker::default();
        for (number, solid) in self.provenance.nodes_at(FileId(0), offset).into_iter().enumerate() {
            let part = self.provenance.part(solid).unwrap();
            let mask = masker.mask(&mut self.inspector, &part, &self.values).unwrap();
            let all = (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
            let shown = all.filter(|[x, y]| mask.shows(i64::from(*x), i64::from(*y)));
            let pixels: Vec<[u32; 2]> = if outline { mask.outline().collect() } else { shown.collect() };
            pixels.into_iter().for_each(|[x, y]| rows[y as usize][x as usize] = b'a' + number as u8);
        }
        // Without the margin that shows nothing.
        rows[5..13].iter().map(|row| String::from_utf8(row[8..24].to_vec()).unwrap()).collect()
    }

    /// Draws an inspection and compares it with the one that is kept.
    fn check(&mut self, name: &str, view: View, inspection: Inspection) {
        let size = [96, 72];
        let drawing = self.inspector.draw(view, size, &inspection).unwrap();
        let drawn = RgbaImage::from_raw(size[0], size[1], drawing.pixels).unwrap();
        if let Some(changed) = changed(&format!("inspect_{name}"), &drawn, &EXACT) {
            panic!("{changed}");
        }
    }
}

#[test]
fn masks_show_what_an_expression_made() {
    let mut plate = looked(PLATE);
    plate.inspector.look(view(FRONT, 90.0), [32, 18], None).unwrap();
    let rows = |rows: &[&str]| rows.iter().map(|row| (*row).to_owned()).collect::<Vec<_>>();
    let cube = [
        "aaaaaaaaaaaaaaaa",
        "aaaaaaaaaaaaaaaa",
        "aaaaaaa..aaaaaaa",
        "aa...a....a...aa",
        "aa...a....a...aa",
        "aaaaaaa..aaaaaaa",
        "aaaaaaaaaaaaaaaa",
        "aaaaaaaaaaaaaaaa",
    ];
    assert_eq!(plate.mask("cube", false), rows(&cube));
    let ball = [
        "................",
        "................",
        ".......aa.......",
        "......aaaa......",
        "......aaaa......",
        ".......aa.......",
        "................",
        "................",
    ];
    assert_eq!(plate.mask("sphere", false), rows(&ball));
    let walls_of_holes = [
        "................",
        "................",
        "...aa......bb...",
        "..a..a....b..b..",
        "..a..a....b..b..",
        "...aa......bb...",
        "................",
        "................",
    ];
    assert_eq!(plate.mask("cylinder", false), rows(&walls_of_holes));
    let outline = [
        "aaaaaaaaaaaaaaaa",
        "a......aa......a",
        "a..aa.a..a.aa..a",
        "a.a..a....a..a.a",
        "a.a..a....a..a.a",
        "a..aa.a..a.aa..a",
        "a......aa......a",
        "aaaaaaaaaaaaaaaa",
    ];
    assert_eq!(plate.mask("difference", true), rows(&outline));
}

#[test]
fn a_pixel_shows_the_expression_that_its_ray_meets() {
    let mut plate = looked(PLATE);
    let (view, size) = (view([70.0, 0.0, 20.0], 90.0), [64, 48]);
    plate.inspector.look(view, size, None).unwrap();
    let text =
        |origin: Vec<Origin>| origin.first().map(|origin| plate.compilation.sources.text(origin.span).to_owned());
    let (mut seen, mut same) = (0, 0);
    for pixel in (0..48).step_by(3).flat_map(|y| (0..64).step_by(3).map(move |x| [x, y])) {
        let (eye, direction) = view.ray(pixel.map(|edge| f64::from(edge) + 0.5), size);
        let traced = plate.provenance.hit(eye, direction, &[]);
        let picked = plate.inspector.pick(pixel).unwrap();
        assert_eq!(traced.is_some(), picked.is_some(), "{pixel:?}");
        let (Some(traced), Some(picked)) = (traced, picked) else { continue };
        let apart = (0..3).map(|axis| (traced[axis] - picked[axis]).powi(2)).sum::<f64>().sqrt();
        assert!(apart < 0.05, "{pixel:?}: {traced:?} {picked:?}");
        let ([x, y], _) = view.project(picked, size).unwrap();
        assert!((x - 0.5 - f64::from(pixel[0])).abs() < 0.1 && (y - 0.5 - f64::from(pixel[1])).abs() < 0.1);
        seen += 1;
        same += usize::from(text(plate.provenance.origin(traced, &[])) == text(plate.provenance.origin(picked, &[])));
    }
    assert!(seen > 80, "{seen}");
    assert_eq!(same, seen);
    assert_eq!(plate.inspector.pick([64, 0]).unwrap(), None);
}

#[test]
fn a_section_cuts_the_eyes_side_away() {
    let mut ball = looked("sphere(10);");
    let plane = Plane { normal: [0.0, 2.0, 0.0], offset: 12.0 };
    for (rotation, side) in [(FRONT, 1.0), ([90.0, 0.0, 180.0], -1.0)] {
        let view = view(rotation, 100.0);
        let size = [81, 61];
        let drawing = ball.inspector.draw(view, size, &Inspection::Section(plane)).unwrap();
        let inside = drawing.legend.marks.iter().find(|mark| mark.label == "inside").unwrap().color;
        let cut = drawing.pixels.chunks(4).filter(|pixel| pixel[0] > 150 && pixel[2] < 130).count() as f64;
        // The plane y = 6 cuts a disc of radius 8, at a depth of 106 or of 94.
        let radius = 8.0 / (100.0 + side * 6.0) / view.pixel_angle(size);
        let area = std::f64::consts::PI * (radius - 1.0).powi(2);
        assert!(inside[0] > inside[2] && (cut / area - 1.0).abs() < 0.1, "{side}: {cut} of {area}");
        assert!(drawing.legend.step > 0.0);
        let point = ball.inspector.pick([40, 30]).unwrap().unwrap();
        assert!((point[1] - 6.0).abs() < 1e-3, "{point:?}");
    }
}

#[test]
fn evaluations_and_depths_have_their_numbers() {
    let mut ball = looked("sphere(10);");
    let view = view(FRONT, 100.0);
    let drawing = ball.inspector.draw(view, [41, 31], &Inspection::Depth).unwrap();
    let depths: Vec<f64> = drawing.legend.marks.iter().filter_map(|mark| mark.value).collect();
    assert!((depths[0] - 90.0).abs() < 0.01 && (95.0..100.0).contains(&depths[2]), "{depths:?}");
    let middle = 4 * (15 * 41 + 20);
    assert_eq!(drawing.pixels[middle..middle + 4], [255; 4]);
    assert_eq!(drawing.pixels[..4], [0; 4], "nothing is seen at the corner");
    let drawing = ball.inspector.draw(view, [41, 31], &Inspection::Evaluations).unwrap();
    let most = drawing.legend.marks.last().unwrap().value.unwrap();
    assert!((10.0..=50.0).contains(&most), "{most}");
}

#[test]
fn live_numbers_and_sizes_change_what_is_seen() {
    let mut ball = looked("r = 5; // [1:20]\nsphere(r);");
    let view = view(FRONT, 100.0);
    ball.inspector.look(view, [21, 15], None).unwrap();
    assert_eq!(ball.inspector.pick([0, 7]).unwrap(), None);
    ball.inspector.set_parameters(&[19.0]).unwrap();
    ball.inspector.look(view, [21, 15], None).unwrap();
    assert!(ball.inspector.pick([10, 0]).unwrap().is_some(), "a ball that fills the picture");
    ball.inspector.look(view, [41, 31], None).unwrap();
    assert!(ball.inspector.draw_while(view, [40, 31], &Inspection::Normals, &|| false).unwrap().is_none());
    assert_eq!(ball.inspector.size(), [0; 2], "it was interrupted");
    ball.inspector.look(view, [41, 31], None).unwrap();
    let point = ball.inspector.pick([20, 15]).unwrap().unwrap();
    assert!((point[1] + 19.0).abs() < 0.01, "{point:?}");
    assert!(ball.inspector.draw(view, [0, 7], &Inspection::Normals).is_err());
}

/// Of each class one solid, and one that is steep.
const CLASSES: &str = "
translate([-15, 0, 0]) sphere(5);
translate([-2, 0, 0]) intersection() { sphere(5); cube(7, center = true); }
translate([10, 0, 0]) union(r = 3) { cylinder(r = 3, h = 10, center = true); cube([9, 9, 3], center = true); }
translate([22, 0, -5]) linear_extrude(height = 10, twist = 150) square(6, center = true);
";

#[test]
fn views_look_as_they_did() {
    let mut scene = looked(CLASSES);
    let view = View { target: [3.0, 0.0, 0.0], ..view([65.0, 0.0, 15.0], 95.0) };
    let plane = Plane { normal: [0.0, 1.0, 0.0], offset: 1.0 };
    for (name, inspection) in [
        ("normals", Inspection::Normals),
        ("depth", Inspection::Depth),
        ("evaluations", Inspection::Evaluations),
        ("section", Inspection::Section(plane)),
        ("classes", Inspection::FieldClass),
        ("error", Inspection::DistanceError(None)),
        ("error_section", Inspection::DistanceError(Some(plane))),
    ] {
        scene.check(name, view, inspection);
    }
}

#[test]
fn what_made_a_surface_is_there_in_every_example() {
    for path in examples() {
        let compilation = compile(&DiskWorld, &path.to_string_lossy(), &Options::default());
        let scene = compilation.scene.unwrap();
        let provenance = scene.provenance(&compilation.sources).unwrap();
        let values = scene.defaults();
        let bounds = Evaluator::new(&scene.picture(), &values).bounds();
        let view = View::framing(&scene.camera, &values, &bounds, 4.0 / 3.0);
        let mut seen = 0;
        for pixel in (0..9).flat_map(|y| (0..12).map(move |x| [f64::from(x) + 0.5, f64::from(y) + 0.5])) {
            let (eye, direction) = view.ray(pixel, [12, 9]);
            let Some(point) = provenance.hit(eye, direction, &values) else { continue };
            let chain = provenance.origin(point, &values);
            let innermost = chain.first().unwrap_or_else(|| panic!("{}: nothing made {point:?}", path.display()));
            let span = innermost.span;
            let back = provenance.nodes_at(span.file, span.start);
            assert!(back.contains(&innermost.solid), "{}: {innermost:?} is not at its place", path.display());
            // Where operands are joined, the surface is off all of them.
            let joint = |origin: &Origin| match &provenance.solid(origin.solid).kind {
                SolidKind::Boolean { joint: Some(joint), .. } => joint.radius.value(&values),
                _ => 0.0,
            };
            let off = Evaluator::new(&provenance.part(innermost.solid).unwrap(), &values).distance(point).abs();
            let most = 1e-4 * bounds.diagonal() + chain.iter().map(joint).sum::<f64>();
            assert!(off <= most, "{}: {point:?} is {off} mm off {innermost:?}", path.display());
            seen += 1;
        }
        assert!(seen > 5, "{}: only {seen} rays meet anything", path.display());
    }
}
