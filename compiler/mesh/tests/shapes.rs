//! Meshes of solids whose form is known.

mod support;

use std::f64::consts::PI;
use std::ops::ControlFlow;

use chiaro_compiler::field::Look;
use chiaro_compiler::vocabulary::Bounds;
use chiaro_compiler::vocabulary::cpu::Dual;
use chiaro_mesh::{Detail, Error, Field, GraphField, Model, model};
use support::{at, attempt, mesh_of, scene};

#[track_caller]
fn assert_volume(model: &Model, expected: f64, tolerance: f64) {
    let volume = model.mesh.volume();
    assert!((volume - expected).abs() < tolerance * expected, "{volume} instead of {expected}");
}

/// Whether some vertex is at the point.
fn has_vertex(model: &Model, point: [f64; 3], tolerance: f64) -> bool {
    model.mesh.vertices.iter().any(|vertex| (0..3).all(|axis| (vertex[axis] - point[axis]).abs() < tolerance))
}

#[test]
fn a_box_has_its_eight_corners_and_twelve_triangles() {
    let model = mesh_of("translate([1, 2, 3]) cube([10, 7, 4]);", &at(40));
    assert_volume(&model, 280.0, 1e-5);
    for number in 0..8 {
        let at = |axis: usize, from: f64, size: f64| if number >> axis & 1 == 1 { from + size } else { from };
        let corner = [at(0, 1.0, 10.0), at(1, 2.0, 7.0), at(2, 3.0, 4.0)];
        assert!(has_vertex(&model, corner, 1e-4), "{corner:?}");
    }
    assert_eq!((model.mesh.vertices.len(), model.mesh.triangles.len()), (8, 12));
}

#[test]
fn a_turned_box_is_as_sharp() {
    let model = mesh_of("rotate([20, 30, 40]) cube(10, center = true);", &at(48));
    assert_volume(&model, 1000.0, 1e-3);
    let half = 5.0 * 3.0f64.sqrt();
    let farthest = model.mesh.vertices.iter().map(|v| v.iter().map(|c| c * c).sum::<f64>().sqrt());
    let corners = farthest.filter(|distance| (distance - half).abs() < 1e-3).count();
    assert_eq!(corners, 8);
}

#[test]
fn a_sphere_is_as_round_as_the_tolerance_says() {
    for tolerance in [0.1, 0.02] {
        let model = mesh_of("sphere(10);", &Detail { tolerance: Some(tolerance), resolution: None });
        let radius = |point: [f64; 3]| point.iter().map(|c| c * c).sum::<f64>().sqrt();
        assert!(model.mesh.vertices.iter().all(|vertex| (radius(*vertex) - 10.0).abs() < tolerance));
        let middles = (0..model.mesh.triangles.len()).map(|triangle| {
            let [a, b, c] = model.mesh.corners(triangle);
            radius([0, 1, 2].map(|axis| (a[axis] + b[axis] + c[axis]) / 3.0))
        });
        let worst = middles.map(|radius| (radius - 10.0).abs()).fold(0.0, f64::max);
        assert!(worst < tolerance, "{worst} at a tolerance of {tolerance}");
        assert_volume(&model, 4.0 / 3.0 * PI * 1000.0, 0.3 * tolerance);
    }
}

#[test]
fn a_hole_has_sharp_rims() {
    let text = "difference() { cube([20, 20, 10]); translate([10, 10, -1]) cylinder(h = 12, r = 5); }";
    let model = mesh_of(text, &at(80));
    assert_volume(&model, 4000.0 - PI * 250.0, 2e-4);
    let on_rim = model
        .mesh
        .vertices
        .iter()
        .filter(|[x, y, z]| (z - 10.0).abs() < 1e-3 && ((x - 10.0).hypot(y - 10.0) - 5.0).abs() < 1e-3);
    assert!(on_rim.count() > 20);
}

#[test]
fn normals_face_outwards_and_keep_creases() {
    let model = mesh_of("cylinder(h = 10, r = 5);", &at(48));
    for (triangle, corners) in model.mesh.triangles.iter().zip(&model.corners) {
        for (vertex, corner) in triangle.iter().zip(corners) {
            let [x, y, _] = model.mesh.vertices[*vertex as usize];
            let [nx, ny, nz] = corner.normal;
            let is_flat = nz.abs() > 0.999;
            let is_round = nz.abs() < 1e-3 && (nx * x + ny * y) / x.hypot(y) > 0.99;
            assert!(is_flat || is_round, "{:?} at {x}, {y}", corner.normal);
        }
    }
}

/// Configurations that defeat dual contouring with one vertex a cell: parts that touch at corners and edges, walls about
/// as thick as cells, and fine structure everywhere.
#[test]
fn awkward_solids_are_manifold() {
    for text in [
        "cube(10); translate([10, 10, 0]) cube(10);",
        "cube(10); translate([10, 10, 10]) cube(10);",
        "for (x = [0 : 3], y = [0 : 3], z = [0 : 3]) if ((x + y + z) % 2 == 0) translate([x, y, z]) cube(1);",
        "intersection() { gyroid(period = 3, thickness = 0.5); sphere(6); }",
        "difference() { sphere(10); sphere(9.7); translate([0, 0, 5]) cube(20); }",
        "cylinder(h = 10, r1 = 5, r2 = 0); mirror([0, 0, 1]) cylinder(h = 10, r1 = 5, r2 = 0);",
        "rotate([10, 20, 30]) difference() { cube(10, center = true); cube([3, 3, 20], center = true); \
         rotate([90, 0, 0]) cube([3, 3, 20], center = true); rotate([0, 90, 0]) cube([3, 3, 20], center = true); }",
    ] {
        for resolution in [7, 16, 33] {
            let model = mesh_of(text, &at(resolution));
            assert!(model.mesh.volume() > 0.0, "{text}");
        }
    }
}

#[test]
fn materials_go_with_their_parts() {
    let model =
        mesh_of("color([1, 0, 0], metallic = 1) cube(10); color([0, 0, 1]) translate([20, 0, 0]) sphere(5);", &at(60));
    assert!(!model.is_blended());
    for (triangle, material) in model.painted.iter().enumerate() {
        let red = model.mesh.corners(triangle)[0][0] < 12.0;
        let look = &model.materials[*material as usize];
        let expected = if red { [1.0, 0.0, 0.0, 1.0] } else { [0.0, 0.0, 1.0, 1.0] };
        assert_eq!((look.color, look.metallic), (expected, f64::from(red)));
    }
}

#[test]
fn joints_blend_colours() {
    let model = mesh_of(
        "union(r = 4) { color([1, 0, 0]) sphere(6); color([0, 0, 1]) translate([9, 0, 0]) sphere(6); }",
        &at(48),
    );
    assert!(model.is_blended());
    let mixed = model.corners.iter().flatten().filter(|corner| corner.color[0] > 0.2 && corner.color[2] > 0.2);
    assert!(mixed.count() > 10);
}

#[test]
fn what_has_no_mesh_says_why() {
    assert_eq!(attempt("group();", &at(20)).unwrap_err(), Error::Empty);
    assert_eq!(
        attempt("half_space(normal = [0, 0, 1]);", &at(20)).unwrap_err(),
        Error::Unbounded { axes: "x, y, z".to_owned() }
    );
    assert!(matches!(attempt("gyroid(period = 5, thickness = 1);", &at(20)), Err(Error::Unbounded { .. })));
    assert!(matches!(attempt("sphere(10);", &at(100_000)), Err(Error::TooFine { .. })));
    assert!(matches!(attempt("cube([100, 100, 0.1]);", &at(10)), Err(Error::NothingFound { .. })));
}

#[test]
fn parts_too_thin_for_the_cells_are_reported_and_finer_cells_find_them() {
    let text = "cube(10); translate([9, 0, 0]) cube([10, 10, 0.15]);";
    assert!(mesh_of(text, &at(40)).report.misses_parts);
    assert!(!mesh_of("cube(10);", &at(40)).report.misses_parts);
    let model = mesh_of(text, &Detail { tolerance: Some(0.05), resolution: None });
    assert!(!model.report.misses_parts);
    assert!(has_vertex(&model, [19.0, 10.0, 0.15], 1e-3));
}

#[test]
fn whoever_watches_can_stop_it() {
    let scene = scene("sphere(10);");
    let field = GraphField::new(&scene.graph, &[]);
    let mut calls = 0;
    let mut watch = |_| {
        calls += 1;
        if calls < 3 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    assert_eq!(model(&field, &at(60), &mut watch).unwrap_err(), Error::Cancelled);
    assert_eq!(calls, 3);
}

/// A field that is not what it should be.
struct Odd {
    bounds: Bounds,
    value: fn([f64; 3]) -> f64,
}

impl Field for Odd {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn lipschitz(&self) -> f64 {
        1.0
    }

    fn distances(&self, points: &[[f64; 3]]) -> Vec<f64> {
        points.iter().map(|point| (self.value)(*point)).collect()
    }

    fn gradients(&self, points: &[[f64; 3]]) -> Vec<Dual> {
        let dual = |value| Dual { value, gradient: [1.0, 0.0, 0.0] };
        self.distances(points).into_iter().map(dual).collect()
    }

    fn looks(&self, _: &[[f64; 3]]) -> Vec<Look> {
        unreachable!("it has one look")
    }

    fn materials(&self) -> Vec<Look> {
        let scene = scene("sphere(1);");
        GraphField::new(&scene.graph, &[]).materials()
    }

    fn only_look(&self) -> Option<Look> {
        self.materials().first().copied()
    }
}

fn meshed(field: &Odd) -> Result<Model, Error> {
    model(field, &at(20), &mut |_| ControlFlow::Continue(()))
}

#[test]
fn a_field_that_is_not_what_it_says_is_an_error() {
    let bounds = Bounds::centred([5.0; 3]);
    let nowhere = meshed(&Odd { bounds, value: |_| f64::NAN });
    assert!(matches!(nowhere, Err(Error::NotANumber { .. })), "{nowhere:?}");
    let half = meshed(&Odd { bounds, value: |p| if p[1] > 0.3 { f64::NAN } else { p[0] } });
    assert!(matches!(half, Err(Error::NotANumber { .. })), "{half:?}");
    // A half space is said to be in a box.
    let endless = meshed(&Odd { bounds, value: |p| p[0] });
    assert_eq!(endless.unwrap_err(), Error::BeyondBounds);
}

#[test]
fn what_is_small_and_far_away_has_no_mesh() {
    for far in ["1e5", "1e9", "9e14"] {
        let error = attempt(&format!("translate([{far}, 0, 0]) cube(1);"), &Detail::default()).unwrap_err();
        assert!(matches!(error, Error::TooFar { .. }), "{far}: {error}");
    }
    let near = mesh_of("translate([1e3, 0, 0]) cube(1);", &at(20));
    assert_volume(&near, 1.0, 1e-3);
}
