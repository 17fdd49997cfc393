//! OBJ with its materials in an MTL file beside it.

use std::fmt::Write;

use chiaro_field::Look;

use super::{Distinct, srgb};
use crate::model::Model;

/// An OBJ file, in millimetres, which refers to the MTL file of that name.
pub fn obj(model: &Model, materials: &str) -> String {
    let mut text = format!("# millimetres, z upwards; by Chiaro\nmtllib {materials}\n");
    for vertex in &model.mesh.vertices {
        let [x, y, z] = vertex.map(|coordinate| coordinate as f32);
        let _ = writeln!(text, "v {x} {y} {z}");
    }
    let mut normals: Distinct<[u32; 3]> = Distinct::new();
    let corners: Vec<[u32; 3]> = (model.corners.iter())
        .map(|corners| {
            corners.map(|corner| normals.number(corner.normal.map(|component| (component as f32).to_bits())))
        })
        .collect();
    for normal in &normals.items {
        let [x, y, z] = normal.map(f32::from_bits);
        let _ = writeln!(text, "vn {x} {y} {z}");
    }
    for material in used(model) {
        let _ = writeln!(text, "usemtl {}", name(material));
        let painted = model.painted.iter().enumerate().filter(|(_, painted)| **painted == material);
        for (triangle, _) in painted {
            let ([a, b, c], [i, j, k]) = (model.mesh.triangles[triangle], corners[triangle]);
            let _ = writeln!(text, "f {}//{} {}//{} {}//{}", a + 1, i + 1, b + 1, j + 1, c + 1, k + 1);
        }
    }
    text
}

/// The MTL file that goes with it: colours in sRGB, and the parameters of physically based shading that many programs
/// read (Pr, Pm, Ke).
pub fn mtl(model: &Model) -> String {
    let mut text = String::from("# by Chiaro\n");
    for material in used(model) {
        let Look { color, roughness, metallic, emission, .. } = model.materials[material as usize];
        let [red, green, blue] = [0, 1, 2].map(|channel| f64::from(srgb(color[channel])) / 255.0);
        let glow = [red, green, blue].map(|channel| channel * emission);
        let _ = writeln!(text, "newmtl {}", name(material));
        let _ = writeln!(text, "Kd {red:.4} {green:.4} {blue:.4}");
        let _ = writeln!(text, "Ke {:.4} {:.4} {:.4}", glow[0], glow[1], glow[2]);
        let _ = writeln!(text, "d {:.4}\nPr {roughness:.4}\nPm {metallic:.4}\nillum 2\n", color[3]);
    }
    text
}

/// The materials that some triangle has.
fn used(model: &Model) -> Vec<u32> {
    let mut used = model.painted.clone();
    used.sort_unstable();
    used.dedup();
    used
}

fn name(material: u32) -> String {
    format!("material_{material}")
}
