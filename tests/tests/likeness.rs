//! The comparison of pictures tells apart what it has to: every kept picture from every other, and from itself with one
//! thing wrong. No graphics adapter is needed.

mod kept;

use chiaro_tests::likeness::{Difference, EXACT, SAMPLED};
use image::{Rgba, RgbaImage, imageops};
use kept::{folder, kept, pixels};

/// All pictures that are kept, with what they may differ by.
fn all() -> Vec<(String, RgbaImage, Difference)> {
    let mut names: Vec<String> = std::fs::read_dir(folder())
        .unwrap()
        .map(|entry| entry.unwrap().path().file_stem().unwrap().to_string_lossy().into_owned())
        .collect();
    names.sort();
    assert!(names.len() >= 20, "only {} pictures are kept", names.len());
    let with_picture = |name: String| {
        let most = if name.starts_with("inspect_") { EXACT } else { SAMPLED };
        let picture = kept(&name).unwrap_or_else(|| panic!("{name} is no picture"));
        (name, picture, most)
    };
    names.into_iter().map(with_picture).collect()
}

fn of_pixels(image: &RgbaImage, change: impl Fn([f64; 3]) -> [f64; 3]) -> RgbaImage {
    let mut changed = image.clone();
    for Rgba([red, green, blue, _]) in changed.pixels_mut() {
        let channels = change([*red, *green, *blue].map(f64::from));
        [*red, *green, *blue] = channels.map(|channel| channel.round().clamp(0.0, 255.0) as u8);
    }
    changed
}

fn grey(image: &RgbaImage) -> RgbaImage {
    of_pixels(image, |[red, green, blue]| [0.2126 * red + 0.7152 * green + 0.0722 * blue; 3])
}

fn shifted(image: &RgbaImage, x: u32, y: u32) -> RgbaImage {
    let from = |at: u32, by: u32| at.saturating_sub(by);
    RgbaImage::from_fn(image.width(), image.height(), |to_x, to_y| *image.get_pixel(from(to_x, x), from(to_y, y)))
}

/// A picture with each thing wrong that has to be seen.
fn spoiled(image: &RgbaImage) -> Vec<(&'static str, RgbaImage)> {
    let scaled = |factor: f64| of_pixels(image, |channels| channels.map(|channel| factor * channel));
    vec![
        ("blurred by 0.7 pixels", imageops::blur(image, 0.7)),
        ("2 % darker", scaled(0.98)),
        ("2 % brighter", scaled(1.02)),
        ("one pixel to the right", shifted(image, 1, 0)),
        ("one pixel down", shifted(image, 0, 1)),
        ("upside down", imageops::flip_vertical(image)),
        ("a mirror's", imageops::flip_horizontal(image)),
    ]
}

#[test]
fn a_picture_looks_like_itself() {
    for (name, picture, _) in all() {
        let difference = Difference::between(pixels(&picture), pixels(&picture));
        assert_eq!(difference, Difference::default(), "{name}");
    }
}

#[test]
fn no_picture_looks_like_another() {
    let mut pairs = 0;
    for (name, picture, most) in all() {
        for (other_name, other, _) in all() {
            if other_name != name && other.dimensions() == picture.dimensions() {
                let difference = Difference::between(pixels(&picture), pixels(&other));
                assert!(!difference.is_within(&most), "{other_name} passes for {name}: {difference}");
                pairs += 1;
            }
        }
    }
    assert!(pairs >= 20 * 19, "only {pairs} pairs");
}

#[test]
fn no_picture_looks_like_itself_spoiled() {
    for (name, picture, most) in all() {
        for (how, spoiled) in spoiled(&picture) {
            let difference = Difference::between(pixels(&picture), pixels(&spoiled));
            assert!(!difference.is_within(&most), "{name}, {how}, passes: {difference}");
        }
    }
}

#[test]
fn no_picture_looks_like_itself_without_colour() {
    for (name, picture, most) in all() {
        let difference = Difference::between(pixels(&picture), pixels(&grey(&picture)));
        // Depths are drawn in grey.
        assert_eq!(difference.is_within(&most), name == "inspect_depth", "{name}: {difference}");
    }
}

/// A patch as large as a tile that is wrong by a tenth, wherever it is, is seen.
#[test]
fn no_picture_hides_a_wrong_patch() {
    for (name, picture, most) in all() {
        for (left, top) in [(0, 0), (44, 32), (83, 60), (21, 43)] {
            let mut wrong = picture.clone();
            let patch = || (0..12).flat_map(|x| (0..12).map(move |y| (left + x, top + y)));
            let sum: u32 = patch().map(|(x, y)| u32::from(picture.get_pixel(x, y)[0])).sum();
            for (x, y) in patch() {
                let Rgba([red, ..]) = wrong.get_pixel_mut(x, y);
                *red = if sum > 12 * 12 * 127 { red.saturating_sub(26) } else { red.saturating_add(26) };
            }
            let difference = Difference::between(pixels(&picture), pixels(&wrong));
            assert!(!difference.is_within(&most), "{name}, wrong at {left}, {top}, passes: {difference}");
        }
    }
}
