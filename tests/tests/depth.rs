//! What rays from the eye meet is the surface of the mesh that OpenSCAD makes of the same scene. This sees what signs and
//! bounds can't: skins, and surfaces that are missed or added.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use chiaro_compiler::{Options, compile};
use chiaro_render::{Gpu, Inspector, Model, Preference, View};
use chiaro_tests::world::DiskWorld;
use chiaro_tests::{OPENSCAD_EXAMPLES, scad_files, workspace};

type Vec3 = [f64; 3];

/// The edge of the views, in pixels.
const SIZE: u32 = 64;
/// How many sides OpenSCAD gives what is round.
const SIDES: u32 = 48;
/// How far depths may differ, as a part of half the scene's diagonal: more than chords of 48 sides do, at a slant.
const TOLERANCE: f64 = 0.012;
/// Where neighbouring depths differ by more than this part there is a silhouette, which is left out.
const SILHOUETTE: f64 = 0.25;

/// OpenSCAD's examples that it makes a mesh of in seconds, and that have no facets of their own.
const EXAMPLES: [&str; 4] =
    ["Old/example001.scad", "Old/example002.scad", "Old/example003.scad", "Old/example004.scad"];

#[test]
fn rays_meet_the_surface_of_openscads_mesh() {
    let mut seen = 0;
    let mut wrong = Vec::new();
    let examples = EXAMPLES.iter().map(|name| Path::new(OPENSCAD_EXAMPLES).join(name));
    for path in flush_scenes().into_iter().chain(examples) {
        let (looked_at, differing) = compare(&path);
        seen += looked_at;
        // A ray that passes a chord and meets its arc, or the other way, is none.
        if 1000 * differing > looked_at {
            wrong.push(format!("{}: {differing} of {looked_at}", path.display()));
        }
    }
    assert!(wrong.is_empty(), "pixels that are wrong:\n{}", wrong.join("\n"));
    assert!(seen > 15_000, "only {seen} pixels were looked at");
}

/// The scenes with coincident faces that OpenSCAD means the same by: those without joints.
fn flush_scenes() -> Vec<PathBuf> {
    let all = scad_files(&workspace().join("tests/scenes/coincident"));
    // OpenSCAD has no joints, round edges and pyramids, and makes no mesh of nothing.
    let ours = ["union(r", "difference(r", "pyramid(", "], r ="];
    let is_ours = |text: &str| ours.iter().any(|word| text.contains(word));
    let is_plain =
        |path: &PathBuf| !path.ends_with("touching.csg") && !is_ours(&std::fs::read_to_string(path).unwrap());
    let plain: Vec<PathBuf> = all.into_iter().filter(is_plain).collect();
    assert!(plain.len() >= 10, "{plain:?}");
    plain
}

/// How many pixels of two views see the scene, clear of silhouettes, and how many of them see something else.
fn compare(path: &Path) -> (usize, usize) {
    let compilation = compile(&DiskWorld, &path.to_string_lossy(), &Options::default());
    let scene = compilation.scene.unwrap_or_else(|| panic!("{path:?}: {:?}", compilation.diagnostics));
    let triangles = openscad_mesh(path);
    let corners = || triangles.iter().flatten();
    let bound = |f: fn(f64, f64) -> f64, start: f64| -> Vec3 {
        std::array::from_fn(|i| corners().map(|corner| corner[i]).fold(start, f))
    };
    let (low, high) = (bound(f64::min, f64::INFINITY), bound(f64::max, f64::NEG_INFINITY));
    let target: Vec3 = std::array::from_fn(|i| 0.5 * (low[i] + high[i]));
    let size = 0.5 * length(sub(high, low));
    let model = Model::new(gpu(), &scene.picture(), &scene.defaults()).unwrap();
    let mut inspector = Inspector::new(gpu(), &model).unwrap();
    let (mut looked_at, mut wrong) = (0, 0);
    for rotation in [[62.0, 0.0, 43.0], [54.0, 0.0, 222.0]] {
        let view = View { target, rotation, distance: 3.4 * size, field_of_view: 36.0 };
        inspector.look(view, [SIZE, SIZE], None).unwrap();
        let drawn: Vec<f64> = inspector.positions().unwrap().iter().map(|seen| f64::from(seen[3])).collect();
        let expected = mesh_depths(&triangles, &view);
        for pixel in 0..(SIZE * SIZE) as usize {
            if is_at_silhouette(&expected, pixel, SILHOUETTE * size) {
                continue;
            }
            let (drawn, expected) = (drawn[pixel], expected[pixel]);
            let is_right = if expected.is_finite() {
                looked_at += 1;
                drawn >= 0.0 && (drawn - expected).abs() <= TOLERANCE * size
            } else {
                drawn < 0.0
            };
            wrong += usize::from(!is_right);
        }
    }
    (looked_at, wrong)
}

/// How far along the rays of pixels a mesh is met.
fn mesh_depths(triangles: &[[Vec3; 3]], view: &View) -> Vec<f64> {
    let eye = view.eye();
    let (right, up) = view.sideways();
    let ahead = unit(sub(view.target, eye));
    let slope = (0.5 * view.field_of_view).to_radians().tan();
    let at = |pixel: u32| slope * (2.0 * (f64::from(pixel) + 0.5) / f64::from(SIZE) - 1.0);
    let pixels = (0..SIZE).flat_map(|y| (0..SIZE).map(move |x| (x, y)));
    let direction =
        |(x, y): (u32, u32)| unit(std::array::from_fn(|i| ahead[i] + at(x) * unit(right)[i] - at(y) * unit(up)[i]));
    pixels
        .map(direction)
        .map(|w| triangles.iter().map(|corners| crossing(eye, w, corners)).fold(f64::INFINITY, f64::min))
        .collect()
}

/// How far along a ray it meets a triangle (Möller and Trumbore 1997).
fn crossing(o: Vec3, w: Vec3, [a, b, c]: &[Vec3; 3]) -> f64 {
    let (u, v) = (sub(*b, *a), sub(*c, *a));
    let p = cross(w, v);
    let determinant = dot(u, p);
    let from = sub(o, *a);
    let q = cross(from, u);
    let (x, y, t) = (dot(from, p) / determinant, dot(w, q) / determinant, dot(v, q) / determinant);
    if x >= 0.0 && y >= 0.0 && x + y <= 1.0 && t > 0.0 { t } else { f64::INFINITY }
}

/// Whether the depths of the pixels around one differ much, or it is at the view's edge.
fn is_at_silhouette(depths: &[f64], pixel: usize, much: f64) -> bool {
    let (x, y) = (pixel % SIZE as usize, pixel / SIZE as usize);
    let last = SIZE as usize - 1;
    if x == 0 || y == 0 || x == last || y == last {
        return true;
    }
    let around = (0..9).map(|k| depths[(y + k / 3 - 1) * SIZE as usize + x + k % 3 - 1]);
    let all: Vec<f64> = around.collect();
    let missed = all.iter().filter(|depth| depth.is_infinite()).count();
    let least = all.iter().copied().fold(f64::INFINITY, f64::min);
    let most = all.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    missed != 9 && (missed != 0 || most - least > much)
}

/// The triangles of the mesh that OpenSCAD makes of a scene.
fn openscad_mesh(path: &Path) -> Vec<[Vec3; 3]> {
    let folder = tempfile::tempdir().unwrap();
    let stl = folder.path().join("mesh.stl");
    let mut command = Command::new("openscad");
    command.arg("-o").arg(&stl).arg("-D").arg(format!("$fn={SIDES}")).arg(path);
    let output = command.output().expect("OpenSCAD is missing: run tools/setup.sh --tests");
    let text = std::fs::read_to_string(&stl).unwrap_or_else(|error| {
        panic!("{path:?}: {error}\n{}", String::from_utf8_lossy(&output.stderr));
    });
    let numbers = text.lines().filter_map(|line| line.trim().strip_prefix("vertex "));
    let corners: Vec<Vec3> = numbers
        .map(|line| {
            let numbers: Vec<f64> = line.split_whitespace().map(|number| number.parse().unwrap()).collect();
            [numbers[0], numbers[1], numbers[2]]
        })
        .collect();
    corners.chunks_exact(3).map(|corners| [corners[0], corners[1], corners[2]]).collect()
}

fn gpu() -> &'static Gpu {
    static GPU: OnceLock<Gpu> = OnceLock::new();
    GPU.get_or_init(|| Gpu::new(&Preference::Software).or_else(|_| Gpu::new(&Preference::Any)).unwrap())
}

fn sub(a: Vec3, b: Vec3) -> Vec3 {
    std::array::from_fn(|i| a[i] - b[i])
}

fn dot(a: Vec3, b: Vec3) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn length(a: Vec3) -> f64 {
    dot(a, a).sqrt()
}

fn unit(a: Vec3) -> Vec3 {
    a.map(|x| x / length(a))
}
