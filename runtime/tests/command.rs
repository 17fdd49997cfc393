//! The command as a user meets it: what it writes, what it says, how it ends.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;
use tempfile::TempDir;

/// A folder with scenes in it, in which the command is run.
struct Folder(TempDir);

impl Folder {
    fn new() -> Self {
        Folder(tempfile::tempdir().expect("a temporary folder can be made"))
    }

    fn with(self, name: &str, text: impl AsRef<[u8]>) -> Self {
        fs::write(self.path(name), text).expect("a scene can be written");
        self
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn run(&self, arguments: &[&str]) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_chiaro"));
        command.current_dir(self.0.path()).args(arguments).output().expect("the command can be started")
    }
}

fn stdout(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn succeeded(output: Output) -> Output {
    assert!(output.status.success(), "{}", stderr(&output));
    output
}

#[test]
fn render_writes_a_picture_of_the_size_asked_for() {
    let folder = Folder::new().with("ball.csg", "color(\"tomato\") sphere(10);");
    succeeded(folder.run(&["render", "ball.csg", "-o", "ball.png", "--size", "64x48", "--samples", "4"]));
    let picture = image::open(folder.path("ball.png")).expect("a picture").to_rgb8();
    assert_eq!(picture.dimensions(), (64, 48));
    let [r, g, b] = picture.get_pixel(32, 24).0;
    assert!(r > 120 && r > g + 40 && r > b + 40, "the middle of a red ball is {r}, {g}, {b}");
}

#[test]
fn render_writes_linear_radiance_as_exr() {
    let folder = Folder::new().with("ball.csg", "sphere(10);");
    succeeded(folder.run(&["render", "ball.csg", "-o", "ball.exr", "--size", "40x30", "--samples", "2"]));
    let image = exr::prelude::read_first_rgba_layer_from_file(
        folder.path("ball.exr"),
        |size, _| vec![[0.0f32; 4]; size.area()],
        |pixels: &mut Vec<[f32; 4]>, at, (r, g, b, a): (f32, f32, f32, f32)| {
            pixels[at.y() * 40 + at.x()] = [r, g, b, a]
        },
    )
    .expect("a picture");
    let pixels = image.layer_data.channel_data.pixels;
    assert!(pixels.len() == 1200 && pixels.iter().flatten().all(|value| value.is_finite() && *value >= 0.0));
}

#[test]
fn frames_are_numbered_and_differ() {
    let folder = Folder::new().with("turn.csg", "rotate(90 * $t) cube([20, 5, 5]);");
    let arguments = ["render", "turn.csg", "-o", "f.png", "--size", "48x36", "--samples", "2", "--frames", "3"];
    succeeded(folder.run(&arguments));
    let frames: Vec<_> =
        ["f_0.png", "f_1.png", "f_2.png"].map(|name| fs::read(folder.path(name)).expect("a frame")).into();
    assert!(frames[0] != frames[1] && frames[1] != frames[2]);
}

/// Where the clock decides the structure, each frame is compiled for its own time.
#[test]
fn frames_differ_also_where_the_clock_decides_the_structure() {
    let folder = Folder::new().with("grow.csg", "for (i = [0 : 3 * $t]) translate([12 * i, 0, 0]) sphere(5);");
    let arguments = ["render", "grow.csg", "-o", "f.png", "--size", "48x36", "--samples", "2", "--frames", "2"];
    succeeded(folder.run(&arguments));
    let frames = ["f_0.png", "f_1.png"].map(|name| fs::read(folder.path(name)).expect("a frame"));
    assert!(frames[0] != frames[1]);
}

/// So is the camera, if the clock moves it.
#[test]
fn the_camera_moves_also_where_the_clock_decides_the_structure() {
    let folder =
        Folder::new().with("turn.csg", "$vpr = [60, 0, 180 * $t]; for (i = [0 : floor($t)]) cube([20, 5, 5]);");
    let arguments = ["render", "turn.csg", "-o", "f.png", "--size", "48x36", "--samples", "2", "--frames", "2"];
    succeeded(folder.run(&arguments));
    let frames = ["f_0.png", "f_1.png"].map(|name| fs::read(folder.path(name)).expect("a frame"));
    assert!(frames[0] != frames[1]);
}

#[test]
fn a_picture_that_fails_leaves_no_file_and_keeps_the_old_one() {
    let folder = Folder::new().with("bad.csg", "cube(;").with("old.png", "precious");
    let output = folder.run(&["render", "bad.csg", "-o", "old.png"]);
    assert!(!output.status.success());
    assert_eq!(fs::read(folder.path("old.png")).unwrap(), b"precious");
    let names: Vec<_> = fs::read_dir(folder.0.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(names.len(), 2, "{names:?}");
}

#[test]
fn distances_of_cpu_and_gpu_agree() {
    let scene =
        "difference(r = 1) { cube(10, center = true); rotate([20, 30, 0]) cylinder(h = 20, r = 3, center = true); }";
    let points: String =
        (0..200).map(|i| format!("{{\"p\":[{}, {}, {}]}}\n", i % 7 - 3, i % 11 - 5, i % 13 - 6)).collect();
    let folder = Folder::new().with("a.csg", scene).with("points.jsonl", points);
    let answers = |extra: &[&str]| -> Vec<Value> {
        let arguments = [&["distance", "a.csg", "--points", "points.jsonl"], extra].concat();
        stdout(&succeeded(folder.run(&arguments))).lines().map(|line| serde_json::from_str(line).unwrap()).collect()
    };
    let (cpu, gpu) = (answers(&[]), answers(&["--gpu"]));
    assert_eq!(cpu.len(), 200);
    for (a, b) in cpu.iter().zip(&gpu) {
        assert_eq!(a["p"], b["p"]);
        assert_eq!(a["lipschitz"], 1.0);
        let (a, b) = (a["f"].as_f64().unwrap(), b["f"].as_f64().unwrap());
        assert!((a - b).abs() < 1e-4, "{a} on the CPU, {b} on the GPU");
    }
}

#[test]
fn plane_scenes_take_points_with_two_coordinates() {
    let folder =
        Folder::new().with("disc.csg", "circle(5);").with("points.jsonl", "{\"header\": true}\n{\"p\": [8, 0]}\n");
    let output = succeeded(folder.run(&["distance", "disc.csg", "--points", "points.jsonl"]));
    assert_eq!(stdout(&output), "{\"f\":3.0,\"lipschitz\":1.0,\"p\":[8.0,0.0]}\n");
}

#[test]
fn every_stage_can_be_printed() {
    let folder = Folder::new().with("a.csg", "r = 3;\nunion(r = 1) { sphere(r); translate([4, 0, 0]) cube(2); }\n");
    for (stage, part) in
        [("syntax", "union(r = 1)"), ("solid", "sphere"), ("field", "sphere"), ("wgsl", "fn scene_distance")]
    {
        let output = succeeded(folder.run(&["dump", "a.csg", "--stage", stage]));
        assert!(stdout(&output).contains(part), "{stage}: {}", stdout(&output));
    }
}

#[test]
fn errors_say_where_and_how_to_mend_them() {
    let folder = Folder::new().with("a.csg", "cube(3);\nsphree(2);\n");
    let output = folder.run(&["check", "a.csg"]);
    assert_eq!(output.status.code(), Some(1));
    let text = stderr(&output);
    assert!(text.contains("a.csg:2:1") && text.contains("sphere") && text.contains("sphree(2)"), "{text}");

    let output = folder.run(&["check", "a.csg", "--message-format", "json"]);
    let object: Value = serde_json::from_str(stderr(&output).lines().next().unwrap()).unwrap();
    assert_eq!((&object["severity"], &object["place"]["line"]), (&Value::from("error"), &Value::from(2)));
    let suggestion = &object["suggestion"];
    assert_eq!((&suggestion["text"], &suggestion["place"]["column"]), (&Value::from("sphere"), &Value::from(1)));
}

/// What only the shader has no room for is said as the compiler says things, whichever command asks for it.
#[test]
fn scenes_too_large_to_draw_are_errors_with_a_place() {
    let text = "for (i = [1 : 25000]) translate([3 * i, 0, 0]) sphere(i);";
    let folder = Folder::new().with("many.csg", text).with("p.jsonl", "{\"p\":[5,0,0]}\n");
    let (picture, points) = (["-o", "a.png"], ["--points", "p.jsonl", "--gpu"]);
    for (command, arguments) in [("check", &[][..]), ("render", &picture[..]), ("distance", &points[..])] {
        let output = folder.run(&[&[command, "many.csg"], arguments].concat());
        assert_eq!(output.status.code(), Some(1), "{command}");
        assert!(stderr(&output).contains("many.csg:1:1"), "{command}: {}", stderr(&output));
        let says_why = stderr(&output).contains("25000 parts lie in each other");
        assert!(says_why || command == "check", "{command}: {}", stderr(&output));
    }
}

#[test]
fn definitions_set_parameters() {
    let folder = Folder::new().with("a.csg", "r = 1; // [1:10]\nsphere(r);\n").with("p.jsonl", "{\"p\":[20,0,0]}\n");
    let output = succeeded(folder.run(&["distance", "a.csg", "-D", "r=12", "--points", "p.jsonl"]));
    assert!(stdout(&output).contains("\"f\":8.0"), "{}", stdout(&output));
    let output = folder.run(&["check", "a.csg", "-D", "radius=2"]);
    assert!(!output.status.success() && stderr(&output).contains("radius"), "{}", stderr(&output));
}

/// Whatever the input, the command ends soon, with status 1 and an error; it neither panics nor dies.
#[test]
fn hostile_input_is_an_error() {
    let deep = |open: &str, close: &str| format!("{}1{}", open.repeat(100_000), close.repeat(100_000));
    let scenes: Vec<(&str, Vec<u8>)> = vec![
        ("brackets", format!("x = {};", deep("[", "]")).into()),
        ("parentheses", format!("x = {};", deep("(", ")")).into()),
        ("unclosed", "(".repeat(100_000).into()),
        ("minus", format!("x = {}1;", "-".repeat(100_000)).into()),
        ("moves", format!("{}cube(1);", "translate([1, 0, 0]) ".repeat(100_000)).into()),
        ("blocks", format!("{}{}", "union() {".repeat(100_000), "}".repeat(100_000)).into()),
        ("rubbish", (0..100_000u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 24) as u8).collect()),
        ("recursion", "function f(x) = f(x + 1) + 1; echo(f(0)); cube(1);".into()),
        ("modules", "module m(x) { translate([x, 0, 0]) m(x + 1); } m(0);".into()),
        ("loop", "for (i = [0 : 1e12]) cube(i);".into()),
        ("endless", "x = [for (i = 0; true; i = i + 1) i]; cube(1);".into()),
        ("doubling", "function f(s, n) = n == 0 ? s : f(str(s, s), n - 1); echo(len(f(\"abc\", 60))); cube(1);".into()),
        ("lists", "function f(s, n) = n == 0 ? s : f(concat(s, s), n - 1); echo(len(f([1], 60))); cube(1);".into()),
        ("missing", "include <nowhere.scad>\ncube(1);".into()),
        ("names", "cube(size);\nspere(1);".into()),
        ("assertion", "assert(1 > 2, \"no\"); cube(1);".into()),
        ("empty_name", "= 3;".into()),
    ];
    for (name, text) in scenes {
        let file = format!("{name}.csg");
        let folder = Folder::new().with(&file, text);
        let output = folder.run(&["check", &file]);
        let text = stderr(&output);
        assert_eq!(output.status.code(), Some(1), "{name}: {}", text.chars().take(2000).collect::<String>());
        assert!(text.contains("error") && !text.contains("panicked"), "{name}: {text}");
        assert!(text.len() < 200_000, "{name}: {} bytes of errors", text.len());
    }
}

/// What `check` refuses for its numbers is refused by whatever asks for distances.
#[test]
fn bad_numbers_are_refused_whatever_is_made_of_the_scene() {
    let scenes = [
        ("cylinder(h = 6, r1 = 8, r2 = 0 / 0);", "`r2` has to be finite"),
        ("union(r = 1 / 0) { cube(5); sphere(4); }", "`r` has to be finite"),
        ("translate([1e16, 0, 0]) cube(1);", "reaches farther than 1e15 mm"),
    ];
    for (text, message) in scenes {
        let folder = Folder::new().with("bad.csg", text).with("p.jsonl", "{\"p\":[50,3,4]}\n");
        for arguments in [
            &["check", "bad.csg"][..],
            &["distance", "bad.csg", "--points", "p.jsonl"],
            &["render", "bad.csg", "-o", "bad.png", "--size", "16x12", "--samples", "1"],
            &["export", "bad.csg", "-o", "bad.stl"],
            &["export", "bad.csg", "-o", "bad.glsl"],
        ] {
            let output = folder.run(arguments);
            assert_eq!(output.status.code(), Some(1), "{arguments:?} of {text}");
            assert!(stderr(&output).contains(message), "{arguments:?} of {text}: {}", stderr(&output));
            assert!(stdout(&output).is_empty(), "{arguments:?} of {text}: {}", stdout(&output));
        }
        assert!(!folder.path("bad.png").exists() && !folder.path("bad.stl").exists(), "{text}");
    }
}

/// With live numbers that may go bad, a mesh is that of the present values.
#[test]
fn numbers_that_may_go_bad_make_the_mesh_of_their_present_values() {
    let text = "a = 0.5; // [0:5]\nrotate([0, asin(a), 0]) cube(5);\n";
    let folder = Folder::new().with("p.csg", text);
    let output = succeeded(folder.run(&["export", "p.csg", "-o", "p.stl"]));
    assert!(stderr(&output).contains("changing `a` recompiles"), "{}", stderr(&output));
    // Nothing is left where the angle is none, and that is said.
    let output = folder.run(&["export", "p.csg", "-D", "a=2", "-o", "q.stl"]);
    assert_eq!(output.status.code(), Some(1));
    let text = stderr(&output);
    assert!(text.contains("is not finite here") && text.contains("the scene is empty"), "{text}");
}

/// Numbers that make no solid leave it out with a warning, as OpenSCAD does; they are no reason to fail.
#[test]
fn odd_numbers_make_empty_solids() {
    let text = "cube([0/0, 1, 1]); sphere(-1); scale([0, 1, 1]) sphere(1); cylinder(h = 1/0, r = 1); sphere(3);";
    let folder = Folder::new().with("odd.csg", text).with("p.jsonl", "{\"p\":[5,0,0]}\n");
    let output = succeeded(folder.run(&["distance", "odd.csg", "--points", "p.jsonl"]));
    assert!(stdout(&output).contains("\"f\":2.0"), "{}", stdout(&output));
    assert!(stderr(&output).contains("warning"), "{}", stderr(&output));
}

#[test]
fn what_can_not_be_read_or_written_is_said() {
    let folder = Folder::new().with("a.csg", "cube(1);");
    for (arguments, part) in [
        (vec!["check", "nowhere.csg"], "nowhere.csg"),
        (vec!["check", "."], "folder"),
        (vec!["render", "a.csg", "-o", "a.gif"], ".png or .exr"),
        (vec!["render", "a.csg", "-o", "no/such/folder/a.png", "--size", "8x8", "--samples", "1"], "no/such/folder"),
        (vec!["distance", "a.csg", "--points", "nowhere.jsonl"], "nowhere.jsonl"),
    ] {
        let output = folder.run(&arguments);
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        assert!(stderr(&output).contains(part), "{arguments:?}: {}", stderr(&output));
    }
    assert!(!Path::new("no").exists());
}

#[test]
fn compare_writes_a_report_and_nothing_over_other_things() {
    let scene = "camera(eye = [0, -40, 30]); translate([-20, -20, -1]) cube([40, 40, 1]); sphere(4);
                 translate([10, -10, 20]) sphere_light(r = 3);";
    let folder = Folder::new().with("ball.csg", scene).with("mine.txt", "mine");
    let arguments = [
        "compare",
        "ball.csg",
        "-o",
        "report",
        "--size",
        "24x24",
        "--methods",
        "hard,verified:4",
        "--truth-samples",
        "64",
    ];
    let table = stdout(&succeeded(folder.run(&arguments)));
    assert!(table.contains("verified 4"), "{table}");
    let results: Value = serde_json::from_slice(&fs::read(folder.path("report/results.json")).unwrap()).unwrap();
    let ssim = |at: usize| results["means"][at]["score"]["ssim"].as_f64().unwrap();
    assert!(ssim(1) > ssim(0) && ssim(1) <= 1.0, "{results}");
    for file in ["index.html", "0_truth_v.exr", "0_verified_4_ssim.png", "ball_points.exr"] {
        assert!(folder.path("report").join(file).is_file(), "{file}");
    }
    // An earlier report is replaced, anything else is not.
    succeeded(folder.run(&arguments));
    let refused = folder.run(&["compare", "ball.csg", "-o", "."]);
    assert!(!refused.status.success() && stderr(&refused).contains("in use"), "{}", stderr(&refused));
    assert!(!folder.run(&["compare", "-o", "empty"]).status.success());
}

#[test]
fn fmt_formats_in_place_and_keeps_comments() {
    let folder = Folder::new().with("a.csg", "// A ball.\nsphere( 2 );//small\n").with("b.csg", "cube(1);\n");
    let output = succeeded(folder.run(&["fmt", "a.csg", "b.csg"]));
    assert_eq!(stderr(&output), "a.csg formatted\n");
    let text = |name: &str| fs::read_to_string(folder.path(name)).expect("a scene");
    assert_eq!((&*text("a.csg"), &*text("b.csg")), ("// A ball.\nsphere(2); //small\n", "cube(1);\n"));
}

#[test]
fn fmt_checks_without_changing_anything() {
    let folder = Folder::new().with("a.csg", "cube(1);\n\nsphere( 2 );\n").with("b.csg", "cube(1);\n");
    let output = folder.run(&["fmt", "--check", "a.csg", "b.csg"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(stderr(&output).contains("a.csg:3:1") && !stderr(&output).contains("b.csg"), "{}", stderr(&output));
    assert_eq!(fs::read_to_string(folder.path("a.csg")).expect("a scene"), "cube(1);\n\nsphere( 2 );\n");
    succeeded(folder.run(&["fmt", "--check", "b.csg"]));
}

#[test]
fn fmt_leaves_scenes_with_errors_alone() {
    let folder = Folder::new().with("a.csg", "cube( 1\n").with("b.csg", "cube( 1 );\n");
    let output = folder.run(&["fmt", "a.csg", "b.csg"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(stderr(&output).contains("missing `)`"), "{}", stderr(&output));
    let text = |name: &str| fs::read_to_string(folder.path(name)).expect("a scene");
    assert_eq!((&*text("a.csg"), &*text("b.csg")), ("cube( 1\n", "cube(1);\n"));
}

#[cfg(unix)]
#[test]
fn fmt_keeps_links_and_permissions() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::new().with("a.csg", "cube( 1 );\n");
    fs::set_permissions(folder.path("a.csg"), fs::Permissions::from_mode(0o600)).expect("permissions");
    std::os::unix::fs::symlink("a.csg", folder.path("link.csg")).expect("a link");
    succeeded(folder.run(&["fmt", "link.csg"]));
    assert_eq!(fs::read_to_string(folder.path("a.csg")).expect("a scene"), "cube(1);\n");
    assert!(fs::symlink_metadata(folder.path("link.csg")).expect("a link").is_symlink());
    let mode = fs::metadata(folder.path("a.csg")).expect("a scene").permissions().mode();
    assert_eq!(mode & 0o777, 0o600);
}

#[test]
fn the_light_suite_comes_with_the_command() {
    let folder = Folder::new();
    let compared = |arguments: &[&str]| -> Value {
        let common = ["compare", "-o", "report", "--size", "16x16", "--truth-samples", "64"];
        let output = succeeded(folder.run(&[&common, arguments].concat()));
        let table = stdout(&output);
        assert!(table.contains("under rectangles (2)"), "{table}");
        serde_json::from_slice(&fs::read(folder.path("report/results.json")).unwrap()).unwrap()
    };
    let results = compared(&["--suite", "--only", "primitives,bounds", "--methods", "aaltonen,verified:8"]);
    let names: Vec<&str> = results["cases"].as_array().unwrap().iter().map(|c| c["case"].as_str().unwrap()).collect();
    let radii = ["0.15", "0.4", "0.9"];
    let balls = |scene: &str| radii.map(|radius| format!("{scene}, radius {radius}"));
    let rectangles = ["1.00", "2.67"].map(|scale| format!("primitives, rectangle × {scale}"));
    assert_eq!(names, [&balls("primitives")[..], &rectangles, &balls("bounds")].concat());
    // Means over each group and scene, besides those over all.
    let mean = |of: &[Value]| of.iter().map(|case| case["methods"][1]["score"]["ssim"].as_f64().unwrap()).sum::<f64>();
    let cases = results["cases"].as_array().unwrap();
    let parts = results["parts"].as_array().unwrap();
    let first = &parts[0]["means"][1]["score"]["ssim"];
    assert!((first.as_f64().unwrap() - mean(&cases[..3]) / 3.0).abs() < 1e-9, "{parts:?}");

    let refused = folder.run(&["compare", "--suite", "--only", "nowhere"]);
    assert!(stderr(&refused).contains("no scene nowhere"), "{}", stderr(&refused));
}

const TWO_COLOURS: &str = "color([1, 0, 0], metallic = 1) cube(10); color(\"blue\") translate([20, 0, 0]) sphere(5);";

#[test]
fn export_writes_every_mesh_format() {
    let folder = Folder::new().with("a.csg", TWO_COLOURS);
    for name in ["a.stl", "a.obj", "a.ply", "a.3mf", "a.gltf", "a.glb"] {
        let output = succeeded(folder.run(&["export", "a.csg", "-o", name, "--resolution", "40"]));
        assert!(stderr(&output).contains("triangles"), "{}", stderr(&output));
    }
    let bytes = |name: &str| fs::read(folder.path(name)).expect(name);
    let text = |name: &str| String::from_utf8(bytes(name)).expect(name);

    let stl = bytes("a.stl");
    let triangles = u32::from_le_bytes([stl[80], stl[81], stl[82], stl[83]]) as usize;
    assert!(triangles > 100 && stl.len() == 84 + 50 * triangles);

    assert!(text("a.obj").contains("mtllib a.mtl\n"));
    assert_eq!(text("a.obj").lines().filter(|line| line.starts_with("f ")).count(), triangles);
    let materials = text("a.mtl");
    assert!(materials.contains("Kd 1.0000 0.0000 0.0000") && materials.contains("Kd 0.0000 0.0000 1.0000"));

    assert!(bytes("a.ply").starts_with(b"ply\nformat binary_little_endian 1.0\n"));
    assert!(bytes("a.3mf").starts_with(b"PK"));

    let gltf: Value = serde_json::from_str(&text("a.gltf")).expect("JSON");
    assert_eq!(gltf["buffers"][0]["uri"], "a.bin");
    assert_eq!(gltf["buffers"][0]["byteLength"], bytes("a.bin").len());
    let red = &gltf["materials"][0]["pbrMetallicRoughness"];
    assert_eq!((&red["baseColorFactor"][0], &red["metallicFactor"]), (&1.0.into(), &1.0.into()));
    // In metres, y upwards: the box reaches from z = -0.01 to 0.
    let least = &gltf["accessors"][0]["min"];
    assert!((least[2].as_f64().unwrap() + 0.01).abs() < 1e-6, "{least}");

    let glb = bytes("a.glb");
    assert!(glb.starts_with(b"glTF\x02\0\0\0"));
    assert_eq!(u32::from_le_bytes([glb[8], glb[9], glb[10], glb[11]]) as usize, glb.len());
}

#[test]
fn export_writes_over_files_only_when_forced() {
    let folder = Folder::new().with("a.csg", "sphere(5);").with("a.mtl", "precious");
    let export =
        |extra: &[&str]| folder.run(&[&["export", "a.csg", "-o", "a.obj", "--resolution", "16"], extra].concat());
    let output = export(&[]);
    assert!(!output.status.success() && stderr(&output).contains("--force"), "{}", stderr(&output));
    assert!(!folder.path("a.obj").exists());
    assert_eq!(fs::read(folder.path("a.mtl")).unwrap(), b"precious");
    succeeded(export(&["--force"]));
    assert!(fs::read(folder.path("a.mtl")).unwrap() != b"precious");
}

#[test]
fn export_writes_shader_code_for_the_ending_or_the_target() {
    let folder = Folder::new().with("a.csg", "r = 5; // [1:0.5:10]\nsphere(r);");
    for (extra, expected) in [
        (&["-o", "a.glsl"][..], "float scene_distance(vec3 p) {"),
        (&["-o", "a.hlsl"], "float scene_distance(float3 p) {"),
        (&["-o", "a.metal"], "float scene_distance(constant Parameters& parameters, float3 p) {"),
        (&["-o", "a.wgsl", "--program"], "fn pixel(@builtin(position)"),
        (&["-o", "a.frag", "--to", "shadertoy"], "void mainImage("),
        (&["-o", "a.html"], "getContext(\"webgl2\""),
    ] {
        succeeded(folder.run(&[&["export", "a.csg"], extra].concat()));
        let text = fs::read_to_string(folder.path(extra[1])).unwrap();
        assert!(text.contains(expected) && text.contains("from 1 to 10, 5 by default"), "{extra:?}: {text}");
    }
    let output = folder.run(&["export", "a.csg", "-o", "a.stl", "--program"]);
    assert!(!output.status.success() && stderr(&output).contains("shading languages"), "{}", stderr(&output));
}

#[test]
fn exports_of_text_need_no_graphics_driver() {
    let scene = "h = 20; // [5:40]\nsphere_light(r = 2); difference() { cube([30, 20, h]); sphere(9); }";
    let folder = Folder::new().with("block.csg", scene);
    let without_driver = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_chiaro"));
        let nowhere = [("VK_DRIVER_FILES", "/nonexistent"), ("VK_ICD_FILENAMES", "/nonexistent")];
        command.current_dir(folder.0.path()).args(arguments).envs(nowhere).output().expect("the command can be started")
    };
    if !stderr(&without_driver(&["adapters"])).contains("no graphics driver") {
        return; // The machine has another one than Vulkan's.
    }
    let said = succeeded(without_driver(&["export", "block.csg", "--program", "-o", "block.glsl"]));
    assert!(stderr(&said).contains("note: without a graphics driver"), "{}", stderr(&said));
    let text = fs::read_to_string(folder.path("block.glsl")).unwrap();
    assert!(
        text.contains("uniform float h_value") && text.contains("vec3 setting_box_max() {\n    return vec3(30.0"),
        "{text}"
    );
    succeeded(without_driver(&["export", "block.csg", "--to", "godot", "-o", "godot"]));
    let refused = without_driver(&["export", "block.csg", "-o", "named.glsl", "--adapter", "llvmpipe"]);
    assert!(!refused.status.success() && !folder.path("named.glsl").exists());
}

#[test]
fn what_cannot_be_exported_says_why_and_writes_nothing() {
    let folder = Folder::new();
    for (scene, extra, reason) in [
        ("group();", &[][..], "empty"),
        ("circle(5);", &[], "linear_extrude"),
        ("half_space(normal = [0, 0, 1]);", &[], "no end along x, y, z"),
        ("gyroid(period = 5, thickness = 1);", &[], "no end"),
        ("sphere(10);", &["--resolution", "900000"], "too many"),
        ("cube([100, 100, 0.01]);", &["--resolution", "10"], "as thick as a cell"),
        ("cube(;", &[], "missing `)`"),
    ] {
        fs::write(folder.path("a.csg"), scene).unwrap();
        let output = folder.run(&[&["export", "a.csg", "-o", "a.stl"], extra].concat());
        assert!(!output.status.success(), "{scene}");
        assert!(stderr(&output).contains(reason), "{scene}: {}", stderr(&output));
        assert!(!folder.path("a.stl").exists(), "{scene}");
    }
    let output = folder.run(&["export", "a.csg", "-o", "a.xyz"]);
    assert!(!output.status.success() && stderr(&output).contains(".stl"), "{}", stderr(&output));
}

#[test]
fn check_notes_what_is_highlighted() {
    let folder = Folder::new()
        .with("a.csg", "difference() {\n    sphere(10);\n    #cylinder(r = 4, h = 30, center = true);\n}\n")
        .with("b.csg", "color(\"#ff0000\") cube(1);\n");
    let said = stderr(&succeeded(folder.run(&["check", "a.csg"])));
    assert!(said.contains("`#` highlights this in the editor") && said.contains("a.csg:3:5"), "{said}");
    assert!(!stderr(&succeeded(folder.run(&["check", "b.csg"]))).contains("highlights"));
}
