//! Whether a picture looks as one that is kept.
//!
//! The mean over all pixels hides what matters: another part in a corner, a little less light. So pictures are compared
//! tile by tile and channel by channel, and by how sharp they are.

use std::fmt;

/// The edge of a tile, in pixels.
const TILE: u32 = 8;

/// A picture of 8 bits a channel: rows from the top, of red, green, blue and opacity.
#[derive(Clone, Copy, Debug)]
pub struct Pixels<'a> {
    /// Width and height.
    pub size: [u32; 2],
    /// The channels of all pixels.
    pub rgba: &'a [u8],
}

/// How much two pictures differ. Levels are steps of 8 bits.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Difference {
    /// The levels by which the mean of a channel differs, of the channel where that is most.
    pub mean: f64,
    /// The same for the mean over a tile, of the tile where that is most.
    pub tile: f64,
    /// The part by which the sharpness differs: the root mean square of the steps from pixel to pixel.
    pub sharpness: f64,
}

/// How much pictures of 24 random samples, 96 × 72 pixels large, may differ from the kept ones.
///
/// On one adapter sampling is deterministic, and pictures are equal. On another, rays near edges go elsewhere; were all
/// rays to do so, the noise of both pictures would be independent. That much was measured, of each kept picture with the
/// next 24 samples: at most 0.40 levels, 6.8 in a tile, and 3.3 % in sharpness. What must not pass is far beyond: 2 %
/// darker are 3.6 levels, a shift by one pixel 10 in a tile, and a blur by 0.7 pixels 24 % in sharpness.
pub const SAMPLED: Difference = Difference { mean: 0.5, tile: 7.5, sharpness: 0.05 };

/// How much views without noise, 96 × 72 pixels large, may differ from the kept ones. On one adapter they are equal. On
/// another, pixels at edges may show what is beside: here two in a tile and eight in all, of the greatest contrast.
pub const EXACT: Difference =
    Difference { mean: 8.0 * 255.0 / (96.0 * 72.0), tile: 2.0 * 255.0 / 64.0, sharpness: 0.05 };

impl Difference {
    /// What differs between two pictures of the same size.
    pub fn between(a: Pixels, b: Pixels) -> Self {
        assert_eq!(a.size, b.size);
        let most = |a: &[[f64; 3]], b: &[[f64; 3]]| {
            let levels = a.iter().flatten().zip(b.iter().flatten()).map(|(a, b)| (a - b).abs());
            levels.fold(0.0, f64::max)
        };
        let (tiles, others) = (a.tile_means(TILE), b.tile_means(TILE));
        let whole = a.size[0].max(a.size[1]);
        let (sharpness, other) = (a.sharpness(), b.sharpness());
        Self {
            mean: most(&a.tile_means(whole), &b.tile_means(whole)),
            tile: most(&tiles, &others),
            sharpness: if sharpness == other { 0.0 } else { (sharpness - other).abs() / sharpness.max(other) },
        }
    }

    /// Whether nothing differs by more than these.
    pub fn is_within(&self, most: &Self) -> bool {
        self.mean <= most.mean && self.tile <= most.tile && self.sharpness <= most.sharpness
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let percent = 100.0 * self.sharpness;
        write!(f, "{:.2} levels, {:.2} in a tile, {percent:.1} % in sharpness", self.mean, self.tile)
    }
}

impl Pixels<'_> {
    fn pixel(&self, x: u32, y: u32) -> [f64; 3] {
        let start = 4 * (y * self.size[0] + x) as usize;
        std::array::from_fn(|channel| f64::from(self.rgba[start + channel]))
    }

    /// The means over tiles of this edge; those at the right and the lower side may be smaller.
    fn tile_means(&self, edge: u32) -> Vec<[f64; 3]> {
        let [width, height] = self.size;
        let mean = |left: u32, top: u32| {
            let (right, bottom) = ((left + edge).min(width), (top + edge).min(height));
            let count = f64::from((right - left) * (bottom - top));
            let pixels = (top..bottom).flat_map(|y| (left..right).map(move |x| self.pixel(x, y)));
            pixels.fold([0.0; 3], |sum, pixel| std::array::from_fn(|channel| sum[channel] + pixel[channel] / count))
        };
        let corners = (0..height).step_by(edge as usize);
        corners.flat_map(|top| (0..width).step_by(edge as usize).map(move |left| mean(left, top))).collect()
    }

    /// The root mean square of what channels change from a pixel to the next, to the right and downwards.
    fn sharpness(&self) -> f64 {
        let [width, height] = self.size;
        let square = |a: [f64; 3], b: [f64; 3]| (0..3).map(|channel| (a[channel] - b[channel]).powi(2)).sum::<f64>();
        let inner = (0..height - 1).flat_map(|y| (0..width - 1).map(move |x| [x, y]));
        let steps = inner.map(|[x, y]| {
            let here = self.pixel(x, y);
            square(here, self.pixel(x + 1, y)) + square(here, self.pixel(x, y + 1))
        });
        (steps.sum::<f64>() / f64::from(6 * (width - 1) * (height - 1))).sqrt()
    }
}
