//! The real windows, on an X server without a screen: that they open, show the scene, and draw it anew when its file is saved.
#![cfg(all(target_os = "linux", feature = "editor"))]

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use tempfile::TempDir;
use x11rb::connection::Connection;
use x11rb::protocol::xproto::{ConnectionExt, ImageFormat};
use x11rb::rust_connection::RustConnection;

/// The screen, in pixels.
const SCREEN: [u16; 2] = [1280, 800];
/// Nothing takes so long, on any machine.
const PATIENCE: Duration = Duration::from_secs(300);

/// A process that ends with the test.
struct Process(Child);

impl Drop for Process {
    fn drop(&mut self) {
        // It may be gone already.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// An X server of one's own, and a connection to look at its screen.
struct Screen {
    _server: Process,
    name: String,
    connection: RustConnection,
    root: u32,
}

impl Screen {
    fn new() -> Self {
        let [width, height] = SCREEN;
        let server = Command::new("Xvfb")
            .args(["-displayfd", "1", "-nolisten", "tcp", "-screen", "0", &format!("{width}x{height}x24")])
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn();
        let mut server = Process(server.expect("an X server: tools/setup.sh --tests installs Xvfb"));
        let mut number = String::new();
        BufReader::new(server.0.stdout.take().unwrap()).read_line(&mut number).unwrap();
        let name = format!(":{}", number.trim());
        let (connection, screen) = x11rb::connect(Some(&name)).unwrap();
        let root = connection.setup().roots[screen].root;
        Self { _server: server, name, connection, root }
    }

    /// How many pixels of the screen have a colour.
    fn count(&self, is_it: fn([u8; 3]) -> bool) -> usize {
        let [width, height] = SCREEN;
        let image = self.connection.get_image(ImageFormat::Z_PIXMAP, self.root, 0, 0, width, height, !0);
        let image = image.unwrap().reply().unwrap();
        // Blue, green, red, and a byte of nothing.
        image.data.chunks_exact(4).filter(|pixel| is_it([pixel[2], pixel[1], pixel[0]])).count()
    }

    /// Waits for a patch of a colour.
    #[track_caller]
    fn wait_for(&self, window: &mut Process, what: &str, is_it: fn([u8; 3]) -> bool) {
        let begun = Instant::now();
        while self.count(is_it) < 5_000 {
            if let Some(status) = window.0.try_wait().unwrap() {
                panic!("the window was closed: {status}");
            }
            assert!(begun.elapsed() < PATIENCE, "there is nothing {what}");
            std::thread::sleep(Duration::from_millis(100));
        }
    }
}

/// The command with a window on a screen, which keeps its settings in a folder of its own.
fn opened(screen: &Screen, home: &TempDir, arguments: &[&str]) -> Process {
    let window = Command::new(env!("CARGO_BIN_EXE_chiaro"))
        .args(arguments)
        .env("DISPLAY", &screen.name)
        .env("HOME", home.path())
        .env("XDG_DATA_HOME", home.path())
        .env("XDG_RUNTIME_DIR", home.path())
        .env_remove("WAYLAND_DISPLAY")
        .spawn();
    Process(window.unwrap())
}

fn is_red([red, green, blue]: [u8; 3]) -> bool {
    red > 90 && green < red / 3 && blue < red / 3
}

fn is_blue([red, green, blue]: [u8; 3]) -> bool {
    blue > 90 && red < blue / 2 && green < blue / 2
}

/// Saves as careful editors do: beside the file, and then in its place.
fn save(file: &Path, text: &str) {
    let beside = file.with_extension("new");
    fs::write(&beside, text).unwrap();
    fs::rename(&beside, file).unwrap();
}

fn shows_and_reloads(command: &str) {
    let (screen, home) = (Screen::new(), tempfile::tempdir().unwrap());
    let file = home.path().join("scene.csg");
    fs::write(&file, "color([0.8, 0, 0]) cube(10);\n").unwrap();
    let mut window = opened(&screen, &home, &[command, file.to_str().unwrap()]);
    screen.wait_for(&mut window, "red", is_red);
    save(&file, "color([0, 0, 0.8]) cube(10);\n");
    screen.wait_for(&mut window, "blue", is_blue);
    save(&file, "color([0, 0, 0.8]) cube(10)");
    std::thread::sleep(Duration::from_millis(500));
    screen.wait_for(&mut window, "blue any more", is_blue);
}

#[test]
fn the_editor_shows_a_scene_and_reloads_it() {
    shows_and_reloads("edit");
}

#[test]
fn watching_shows_a_scene_and_reloads_it() {
    shows_and_reloads("watch");
}

#[test]
fn without_a_screen_there_is_an_error_and_no_panic() {
    let output = Command::new(env!("CARGO_BIN_EXE_chiaro"))
        .arg("edit")
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .env_remove("WAYLAND_SOCKET")
        .output()
        .unwrap();
    assert!(!output.status.success());
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("cannot open a window") && !said.contains("panicked"), "{said}");
}

#[test]
fn watching_what_is_not_there_is_an_error() {
    let output = Command::new(env!("CARGO_BIN_EXE_chiaro")).args(["watch", "nothing.csg"]).output().unwrap();
    assert!(!output.status.success());
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("cannot read nothing.csg"), "{said}");
}
