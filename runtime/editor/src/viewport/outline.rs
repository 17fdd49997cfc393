//! The outline of the selected solid.

use chiaro_render::Mask;
use egui::{Color32, ColorImage};

/// The outline's colour, as bright on dark pictures as on light ones.
const INK: Color32 = Color32::from_rgb(255, 140, 0);
/// What is inside is tinted a little.
const TINT: Color32 = Color32::from_rgba_premultiplied(24, 13, 0, 24);

/// The mask as a picture to be laid over the scene's.
pub(super) fn image(mask: &Mask) -> ColorImage {
    let [width, height] = mask.size.map(|edge| edge as usize);
    let mut pixels: Vec<Color32> =
        mask.covered.iter().map(|covered| if *covered { TINT } else { Color32::TRANSPARENT }).collect();
    pixels.resize(width * height, Color32::TRANSPARENT);
    for [x, y] in mask.outline() {
        // Two pixels thick, so that it is seen on fine screens too.
        for (x, y) in [(x, y), (x + 1, y), (x, y + 1)] {
            if let Some(pixel) = pixels.get_mut(y as usize * width + (x as usize).min(width - 1)) {
                *pixel = INK;
            }
        }
    }
    ColorImage::new([width, height], pixels)
}
