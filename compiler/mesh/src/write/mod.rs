//! The bytes of mesh files.
//!
//! STL, OBJ, PLY and 3MF files are in millimetres with z upwards, as scenes are; glTF files in metres with y upwards, as
//! their specification demands. Numbers are in single precision wherever a format has it.

mod gltf;
mod obj;
mod ply;
mod stl;
mod threemf;

pub use gltf::{glb, gltf};
pub use obj::{mtl, obj};
pub use ply::ply;
pub use stl::stl;
pub use threemf::threemf;

use std::hash::Hash;

use rustc_hash::FxHashMap;

/// A channel of sRGB, from 0 to 255, for one of linear light (IEC 61966-2-1).
fn srgb(linear: f64) -> u8 {
    let linear = linear.clamp(0.0, 1.0);
    let encoded = if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
    (255.0 * encoded).round() as u8
}

/// Red, green and blue in sRGB, and opacity, from 0 to 255.
fn srgb_with_opacity([red, green, blue, opacity]: [f64; 4]) -> [u8; 4] {
    [srgb(red), srgb(green), srgb(blue), (255.0 * opacity.clamp(0.0, 1.0)).round() as u8]
}

/// Items in the order in which they first come, each once.
struct Distinct<T> {
    items: Vec<T>,
    numbers: FxHashMap<T, u32>,
}

impl<T: Clone + Eq + Hash> Distinct<T> {
    fn new() -> Self {
        Self { items: Vec::new(), numbers: FxHashMap::default() }
    }

    /// The number of an item.
    fn number(&mut self, item: T) -> u32 {
        *self.numbers.entry(item.clone()).or_insert_with(|| {
            self.items.push(item);
            self.items.len() as u32 - 1
        })
    }
}
