//! The command with hostile scenes, odd files and signals: what it reads, what it shows, and what it leaves behind.
#![cfg(unix)]

use std::ffi::{OsStr, OsString};
use std::fs;
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::symlink;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;
use tempfile::TempDir;

struct Folder(TempDir);

impl Folder {
    fn new() -> Self {
        Folder(tempfile::tempdir().expect("a temporary folder can be made"))
    }

    fn with(self, name: impl AsRef<OsStr>, text: impl AsRef<[u8]>) -> Self {
        fs::write(self.path(name), text).expect("a file can be written");
        self
    }

    fn path(&self, name: impl AsRef<OsStr>) -> PathBuf {
        self.0.path().join(name.as_ref())
    }

    fn command(&self) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_chiaro"));
        command.current_dir(self.0.path());
        command
    }

    fn run<S: AsRef<OsStr>>(&self, arguments: impl IntoIterator<Item = S>) -> Output {
        self.command().args(arguments).output().expect("the command can be started")
    }

    fn names(&self) -> Vec<OsString> {
        let mut names: Vec<_> = fs::read_dir(self.0.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        names.sort();
        names
    }
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn succeeded(output: Output) -> Output {
    assert!(output.status.success(), "{}", stderr(&output));
    output
}

#[test]
fn control_characters_of_a_scene_are_shown_and_not_obeyed() {
    let folder =
        Folder::new().with("said.csg", r#"echo("\x1b]0;title\x07", "\u202e"); assert(false, "\x1b[2J");"#).with(
            "quoted\u{1b}[2J.csg",
            "// \u{1b}[2J\u{9b}31m\u{202e}\nx = \"\u{1b}]52;c;\u{7}\" + ;\r\ncube(\u{7f}\u{2066}unknown);",
        );
    for file in ["said.csg", "quoted\u{1b}[2J.csg"] {
        for command in [&["check"][..], &["fmt", "--check"]] {
            let text = stderr(&folder.run([command, &[file]].concat()));
            let is_obeyed = |c: char| c.is_control() && !"\n\r\t".contains(c) || "\u{202e}\u{2066}".contains(c);
            assert!(!text.contains(is_obeyed), "{text:?}");
        }
        let json = stderr(&folder.run(["check", "--message-format", "json", file]));
        assert!(!json.contains(|c: char| c.is_control() && c != '\n'), "{json:?}");
        for line in json.lines() {
            serde_json::from_str::<Value>(line).unwrap();
        }
    }
    let said = stderr(&folder.run(["check", "said.csg"]));
    assert!(said.contains("␛]0;title␇") && said.contains("\\u{202e}") && said.contains("␛[2J"), "{said}");
    let json = stderr(&folder.run(["check", "--message-format", "json", "said.csg"]));
    assert!(json.contains("\\u001b[2J"), "{json}");
}

#[test]
fn messages_show_the_text_of_scenes_only() {
    let secret = "HOME=/root\u{0}TOKEN=hunter2 secret\n";
    let folder = Folder::new().with("environ", secret).with("named.scad", "x = hunter3;").with("notes.txt", "y = z;");
    symlink("environ", folder.path("linked.scad")).unwrap();
    for include in ["environ", "linked.scad"] {
        fs::write(folder.path("a.csg"), format!("include <{include}>\ncube(1);")).unwrap();
        for format in ["human", "json"] {
            let text = stderr(&folder.run(["check", "--message-format", format, "a.csg"]));
            assert!(text.contains("environ` is not a scene: line 1 can't be understood"), "{text}");
            assert!(!text.contains("hunter2") && !text.contains("TOKEN"), "{text}");
        }
    }
    fs::write(folder.path("a.csg"), "include <named.scad>\ninclude <notes.txt>\ncube(1);").unwrap();
    let text = stderr(&folder.run(["check", "a.csg"]));
    assert!(text.contains("x = hunter3;") && text.contains("notes.txt:1:5") && !text.contains("y = z"), "{text}");
    // The same where the scene itself is a link to something else.
    symlink("environ", folder.path("main.csg")).unwrap();
    let text = stderr(&folder.run(["check", "main.csg"]));
    assert!(text.contains("main.csg:1:") && !text.contains("hunter2"), "{text}");
}

#[test]
fn a_jail_confines_what_is_read() {
    let folder = Folder::new().with("outside.scad", "module part() cube(1);");
    fs::create_dir(folder.path("jail")).unwrap();
    fs::create_dir(folder.path("library")).unwrap();
    fs::write(folder.path("library/part.scad"), "module part() cube(1);").unwrap();
    symlink("../outside.scad", folder.path("jail/link.scad")).unwrap();
    let check = |text: &str, extra: &[&str]| {
        fs::write(folder.path("jail/a.csg"), text).unwrap();
        folder.run([&["check", "jail/a.csg"], extra].concat())
    };
    for path in ["../outside.scad", "link.scad", "../library/part.scad", "/etc/passwd"] {
        let text = format!("use <{path}>\ncube(1);");
        // Without a jail it is read, though not everything is a scene.
        assert!(!stderr(&check(&text, &[])).contains("can't find"), "{path}");
        let output = check(&text, &["--jail", "jail"]);
        assert!(stderr(&output).contains("can't find"), "{path}: {}", stderr(&output));
        // What is used may be missing, what is included may not.
        let included = check(&text.replace("use", "include"), &["--jail", "jail"]);
        assert_eq!(included.status.code(), Some(1), "{path}");
        assert!(stderr(&included).contains("can't find"), "{path}: {}", stderr(&included));
    }
    succeeded(check("use <../library/part.scad>\npart();", &["--jail", "jail", "--jail", "library"]));
    for command in [&["check"][..], &["fmt", "--check"], &["dump", "--stage", "field"]] {
        let output = folder.run([command, &["outside.scad", "--jail", "jail"]].concat());
        assert!(!output.status.success(), "{command:?}");
        assert!(stderr(&output).contains("outside of the folders"), "{command:?}: {}", stderr(&output));
    }
    let output = check("cube(1);", &["--jail", "nowhere"]);
    assert!(stderr(&output).contains("cannot find nowhere"), "{}", stderr(&output));
}

#[test]
fn special_files_are_no_scenes() {
    let folder = Folder::new();
    assert!(Command::new("mkfifo").arg(folder.path("pipe.csg")).status().unwrap().success());
    for (file, reason) in [("pipe.csg", "it is a pipe"), ("/dev/zero", "it is a device"), (".", "it is a folder")] {
        for command in [&["check"][..], &["fmt", "--check"]] {
            let output = folder.run([command, &[file]].concat());
            assert_eq!(output.status.code(), Some(1));
            assert!(stderr(&output).contains(reason), "{file}: {}", stderr(&output));
        }
    }
}

#[test]
fn names_that_are_not_unicode_are_read_and_written() {
    let scene = OsStr::from_bytes(b"a\xff.csg");
    let folder = Folder::new().with(scene, "cube( 1);\n");
    let argument = |text: &str| OsString::from(text);
    succeeded(folder.run([&argument("check"), scene]));
    let mesh = OsStr::from_bytes(b"a\xff.obj");
    succeeded(folder.run([&argument("export"), scene, &argument("-o"), mesh]));
    assert!(folder.path(mesh).is_file());
    let picture = OsStr::from_bytes(b"b\xff.png");
    let small = ["--size", "8x8", "--samples", "1", "--frames", "2", "-o"].map(OsString::from);
    let arguments = [argument("render"), scene.to_owned()].into_iter().chain(small).chain([picture.to_owned()]);
    succeeded(folder.run(arguments));
    assert!(folder.path(OsStr::from_bytes(b"b\xff_1.png")).is_file(), "{:?}", folder.names());
    succeeded(folder.run([&argument("fmt"), scene]));
    assert_eq!(fs::read(folder.path(scene)).unwrap(), b"cube(1);\n");
}

#[test]
fn standard_output_takes_what_is_one_file() {
    let folder = Folder::new().with("a.csg", "cube(1);");
    let small = ["render", "a.csg", "--size", "8x8", "--samples", "1", "-o"];
    for output in ["-", "/dev/stdout"] {
        let picture = succeeded(folder.run([&small[..], &[output]].concat())).stdout;
        assert_eq!(image::load_from_memory(&picture).unwrap().width(), 8);
        let mesh = succeeded(folder.run(["export", "a.csg", "--to", "stl", "-o", output])).stdout;
        assert_eq!((mesh.len() - 84) % 50, 0);
    }
    let text = succeeded(folder.run(["export", "a.csg", "--to", "wgsl", "-o", "-"])).stdout;
    assert!(String::from_utf8(text).unwrap().contains("fn scene_distance("));
    for (arguments, reason) in [
        (&["export", "a.csg", "--to", "gltf", "-o", "-"][..], "2 files"),
        (&["export", "a.csg", "--to", "blender", "-o", "-"], "files"),
        (&["export", "a.csg", "-o", "-"], "say --to"),
        (&["render", "a.csg", "-o", "-", "--frames", "2"], "several files"),
    ] {
        let output = folder.run(arguments);
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        assert!(stderr(&output).contains(reason), "{arguments:?}: {}", stderr(&output));
    }
    assert_eq!(folder.names(), ["a.csg"]);
}

#[test]
fn outputs_that_are_links_pipes_or_read_only_stay_what_they_are() {
    let folder = Folder::new().with("a.csg", "cube(1);").with("locked.png", "old");
    symlink("there.stl", folder.path("link.stl")).unwrap();
    succeeded(folder.run(["export", "a.csg", "-o", "link.stl"]));
    assert!(folder.path("link.stl").is_symlink() && folder.path("there.stl").is_file());

    let mut permissions = fs::metadata(folder.path("locked.png")).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(folder.path("locked.png"), permissions).unwrap();
    let output = folder.run(["render", "a.csg", "--size", "8x8", "--samples", "1", "-o", "locked.png"]);
    assert!(stderr(&output).contains("cannot write locked.png: it is there already, and may not be written to"));
    assert_eq!(fs::read(folder.path("locked.png")).unwrap(), b"old");

    // Nothing is there that could be written over.
    assert!(Command::new("mkfifo").arg(folder.path("pipe.stl")).status().unwrap().success());
    let pipe = folder.path("pipe.stl");
    let reader = std::thread::spawn(move || fs::read(pipe).unwrap());
    succeeded(folder.run(["export", "a.csg", "-o", "pipe.stl"]));
    assert!(reader.join().unwrap().len() > 84);
    succeeded(folder.run(["export", "a.csg", "--to", "stl", "-o", "/dev/null"]));
}

#[test]
fn names_in_meshes_are_names_for_those_who_read_them() {
    let folder = Folder::new().with("a.csg", "cube(1);");
    succeeded(folder.run(["export", "a.csg", "-o", "part #1 é.gltf"]));
    let document: Value = serde_json::from_slice(&fs::read(folder.path("part #1 é.gltf")).unwrap()).unwrap();
    assert_eq!(document["buffers"][0]["uri"], "part%20%231%20%C3%A9.bin");
    assert!(folder.path("part #1 é.bin").is_file());
    succeeded(folder.run(["export", "a.csg", "-o", "part\nusemtl x.obj"]));
    let text = fs::read_to_string(folder.path("part\nusemtl x.obj")).unwrap();
    assert_eq!(text.lines().nth(1), Some("mtllib part_usemtl x.mtl"));
    assert!(folder.path("part_usemtl x.mtl").is_file());
}

/// Comparing takes long, and needs a folder of its own for the suite's scenes meanwhile.
#[test]
fn a_signal_leaves_nothing_behind() {
    for signal in ["INT", "TERM", "HUP"] {
        let folder = Folder::new();
        fs::create_dir(folder.path("tmp")).unwrap();
        let mut command = folder.command();
        command.args(["compare", "--suite", "--truth-samples", "262144", "--size", "1024x1024", "-o", "report/here"]);
        let mut child = command.env("TMPDIR", folder.path("tmp")).stderr(Stdio::null()).spawn().unwrap();
        let is_started = || fs::read_dir(folder.path("tmp")).unwrap().count() > 0;
        let begin = Instant::now();
        while !is_started() && begin.elapsed() < Duration::from_secs(120) {
            std::thread::sleep(Duration::from_millis(20));
        }
        assert!(is_started());
        let id = child.id().to_string();
        assert!(Command::new("kill").args(["-s", signal, &id]).status().unwrap().success());
        let status = child.wait().unwrap();
        assert!(std::os::unix::process::ExitStatusExt::signal(&status).is_some(), "{signal}: {status}");
        assert!(!is_started(), "{signal}");
        assert_eq!(folder.names(), ["tmp"], "{signal}");
    }
}

#[test]
fn nobody_complains_that_there_is_no_display() {
    let folder = Folder::new().with("a.csg", "cube(1);");
    let mut command = folder.command();
    command.args(["render", "a.csg", "--size", "8x8", "--samples", "1", "-o", "a.png"]);
    let output = command.env_remove("XDG_RUNTIME_DIR").env_remove("WAYLAND_DISPLAY").output().unwrap();
    assert_eq!(stderr(&succeeded(output)), "");
}
