//! Binary PLY with vertex colours.

use super::{Distinct, srgb_with_opacity};
use crate::model::Model;

/// A binary PLY file, in millimetres, with colours in sRGB. A vertex where colours meet is there once for each of them.
pub fn ply(model: &Model) -> Vec<u8> {
    let mut vertices: Distinct<(u32, [u8; 4])> = Distinct::new();
    let triangles: Vec<[u32; 3]> = (model.mesh.triangles.iter().zip(&model.corners))
        .map(|(triangle, corners)| {
            [0, 1, 2].map(|place| vertices.number((triangle[place], srgb_with_opacity(corners[place].color))))
        })
        .collect();
    let header = format!(
        "ply\nformat binary_little_endian 1.0\ncomment millimetres, z upwards; by Chiaro\nelement vertex {}\n\
         property float x\nproperty float y\nproperty float z\n\
         property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        vertices.items.len(),
        triangles.len()
    );
    let mut bytes = header.into_bytes();
    for (vertex, color) in &vertices.items {
        for coordinate in model.mesh.vertices[*vertex as usize] {
            bytes.extend((coordinate as f32).to_le_bytes());
        }
        bytes.extend(color);
    }
    for triangle in triangles {
        bytes.push(3);
        bytes.extend(triangle.into_iter().flat_map(u32::to_le_bytes));
    }
    bytes
}
