//! Binary STL: triangles, and nothing else.

use crate::mesh::Mesh;
use crate::vector::{cross, sub, unit};

/// A binary STL file, in millimetres. STL has neither materials nor shared vertices.
pub fn stl(mesh: &Mesh) -> Vec<u8> {
    const HEADER: [u8; 80] = {
        // It must not begin with "solid", which is how textual STL begins.
        let text = b"binary STL, millimetres, z upwards; by Chiaro";
        let mut header = [b' '; 80];
        let mut index = 0;
        while index < text.len() {
            header[index] = text[index];
            index += 1;
        }
        header
    };
    let mut bytes = Vec::with_capacity(84 + 50 * mesh.triangles.len());
    bytes.extend(HEADER);
    bytes.extend((mesh.triangles.len() as u32).to_le_bytes());
    for triangle in 0..mesh.triangles.len() {
        let [a, b, c] = mesh.corners(triangle);
        let normal = unit(cross(sub(b, a), sub(c, a))).unwrap_or([0.0; 3]);
        for number in [normal, a, b, c].into_iter().flatten() {
            bytes.extend((number as f32).to_le_bytes());
        }
        bytes.extend([0; 2]);
    }
    bytes
}
