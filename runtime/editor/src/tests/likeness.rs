//! How far two pictures are apart.
//!
//! Practice: a mean over a whole window lets a panel pass for another one, since most of a window
//! is empty. What differs is somewhere, so the tile that differs most counts; and it counts by
//! channel, so that a change of colour is as large as one of brightness.

use image::RgbaImage;

/// The edge of a tile, in pixels.
const TILE: u32 = 16;

/// The mean absolute difference of the tile and the channel in which two pictures differ most, in
/// steps of 8 bits. Pictures of different sizes are infinitely far apart.
pub(super) fn difference(a: &RgbaImage, b: &RgbaImage) -> f64 {
    if a.dimensions() != b.dimensions() {
        return f64::INFINITY;
    }
    let (width, height) = a.dimensions();
    let corners =
        (0..height).step_by(TILE as usize).flat_map(|y| (0..width).step_by(TILE as usize).map(move |x| [x, y]));
    corners.map(|corner| tile_difference(a, b, corner)).fold(0.0, f64::max)
}

/// The mean absolute difference of the channel in which a tile differs most.
fn tile_difference(a: &RgbaImage, b: &RgbaImage, [left, top]: [u32; 2]) -> f64 {
    let (right, bottom) = ((left + TILE).min(a.width()), (top + TILE).min(a.height()));
    let pixels = (top..bottom).flat_map(|y| (left..right).map(move |x| (x, y)));
    let mut sums = [0_u64; 3];
    for (x, y) in pixels {
        let (a, b) = (a.get_pixel(x, y), b.get_pixel(x, y));
        for (channel, sum) in sums.iter_mut().enumerate() {
            *sum += u64::from(a[channel].abs_diff(b[channel]));
        }
    }
    let count = f64::from((right - left) * (bottom - top));
    sums.into_iter().map(|sum| sum as f64 / count).fold(0.0, f64::max)
}
