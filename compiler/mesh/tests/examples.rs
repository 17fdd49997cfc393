//! Meshes of example scenes, as files that other programs read.

mod support;

use std::collections::HashMap;
use std::path::Path;

use chiaro_mesh::{Field, GraphField, Mesh, write};
use support::{at, is_watertight, mesh_of, scene};

/// Those whose meshes are made soon: sharp and round edges, colours, holes, studs, parts of their own.
const EXAMPLES: [&str; 6] = ["bracket", "brick", "die", "hello_fillet", "mug", "ring"];

#[test]
fn examples_are_watertight_and_have_their_volume() {
    for name in EXAMPLES {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../examples_csg/{name}.csg"));
        let text = std::fs::read_to_string(path).unwrap();
        let model = mesh_of(&text, &at(48));
        let read = read_stl(&write::stl(&model.mesh));
        assert!(is_watertight(&read) && read.triangles.len() == model.mesh.triangles.len(), "{name}");

        let scene = scene(&text);
        let values = scene.defaults();
        let (expected, error) = volume(&GraphField::new(&scene.graph, &values));
        let volume = model.mesh.volume();
        // The walls of some are no more than a few cells.
        assert!((volume - expected).abs() < 4.0 * error + 0.01 * expected, "{name}: {volume} of {expected} ± {error}");
    }
}

/// The surface in a binary STL file, with corners that are in the same place joined, as programs do that read such files.
fn read_stl(bytes: &[u8]) -> Mesh {
    let mut numbers: HashMap<[u32; 3], u32> = HashMap::new();
    let mut mesh = Mesh::default();
    for triangle in bytes[84..].chunks_exact(50) {
        let corners = triangle[12..48].chunks_exact(12).map(|corner| {
            let at: Vec<f32> = corner.chunks_exact(4).map(|x| f32::from_le_bytes([x[0], x[1], x[2], x[3]])).collect();
            *numbers.entry([0, 1, 2].map(|axis| at[axis].to_bits())).or_insert_with(|| {
                mesh.vertices.push([0, 1, 2].map(|axis| f64::from(at[axis])));
                mesh.vertices.len() as u32 - 1
            })
        });
        let corners: Vec<u32> = corners.collect();
        mesh.triangles.push([corners[0], corners[1], corners[2]]);
    }
    mesh
}

/// The volume of a solid by points in its box, evenly spread along no axis, and the standard error of as many random ones.
fn volume(field: &dyn Field) -> (f64, f64) {
    const COUNT: u32 = 12_000;
    /// Powers of 1 / x, where x⁴ = x + 1 (Roberts' sequence).
    const STEPS: [f64; 3] = [0.819_172_513_396_164, 0.671_043_606_703_789, 0.549_700_477_901_970];
    let bounds = field.bounds();
    let size = bounds.size();
    let point = |n: u32| [0, 1, 2].map(|axis| bounds.min[axis] + size[axis] * (f64::from(n) * STEPS[axis]).fract());
    let points: Vec<[f64; 3]> = (0..COUNT).map(point).collect();
    let inside = field.distances(&points).into_iter().filter(|distance| *distance < 0.0).count();
    let (part, all) = (inside as f64 / f64::from(COUNT), size[0] * size[1] * size[2]);
    (part * all, (part * (1.0 - part) / f64::from(COUNT)).sqrt() * all)
}
