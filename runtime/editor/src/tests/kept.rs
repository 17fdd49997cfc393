//! The pictures of the window that are kept, and what is no longer taken for one of them.

use std::path::{Path, PathBuf};

use image::{RgbaImage, imageops};

use super::likeness::difference;

/// How far a window may be from the picture that is kept of it.
///
/// What has to be seen begins above it: greyed, blurred by 0.7 pixels or 2 % darker, every kept
/// picture is farther from itself, and four times as far from every other.
pub(super) const TOLERANCE: f64 = 1.5;

/// The status line is not compared, in pixels: it tells how long things took, and on what.
const STATUS: u32 = 32;

/// Where the picture of that name is kept.
pub(super) fn path(name: &str) -> PathBuf {
    folder().join(format!("{name}.png"))
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/pictures")
}

/// A window without what is not compared.
pub(super) fn compared(window: &RgbaImage) -> RgbaImage {
    imageops::crop_imm(window, 0, 0, window.width(), window.height() - STATUS).to_image()
}

/// All of them, with their names.
fn all() -> Vec<(String, RgbaImage)> {
    let mut paths: Vec<PathBuf> = std::fs::read_dir(folder()).unwrap().flatten().map(|entry| entry.path()).collect();
    paths.sort();
    let named = |path: PathBuf| {
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        (name, compared(&image::open(&path).unwrap().to_rgba8()))
    };
    paths.into_iter().map(named).collect()
}

#[test]
fn no_kept_picture_passes_for_another() {
    let all = all();
    assert!(all.len() >= 18, "{} pictures", all.len());
    for (at, (name, picture)) in all.iter().enumerate() {
        for (other, others) in &all[..at] {
            let apart = difference(picture, others);
            assert!(apart > 4.0 * TOLERANCE, "{name} and {other} are only {apart:.2} apart");
        }
    }
}

#[test]
fn no_kept_picture_passes_for_itself_altered() {
    let altered = |picture: &RgbaImage, change: fn([u8; 3]) -> [u8; 3]| {
        let mut picture = picture.clone();
        for pixel in picture.pixels_mut() {
            let [red, green, blue, _] = pixel.0;
            pixel.0[..3].copy_from_slice(&change([red, green, blue]));
        }
        picture
    };
    let grey = |[red, green, blue]: [u8; 3]| {
        let luma = 0.2126 * f64::from(red) + 0.7152 * f64::from(green) + 0.0722 * f64::from(blue);
        [luma.round() as u8; 3]
    };
    let darker = |color: [u8; 3]| color.map(|channel| (0.98 * f64::from(channel)).round() as u8);
    for (name, picture) in all() {
        for (what, now) in [
            ("grey", altered(&picture, grey)),
            ("blurred", imageops::blur(&picture, 0.7)),
            ("2 % darker", altered(&picture, darker)),
        ] {
            let apart = difference(&picture, &now);
            assert!(apart > TOLERANCE, "{name} passes when it is {what}: {apart:.2}");
        }
    }
}
