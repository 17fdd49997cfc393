//! Leaves out what has no volume: where a sharp tip is thinner than a cell, a point of the lattice in it is alone, and the
//! mesh around it folds flat onto the tip.

use crate::merge::Trait;
use crate::mesh::Mesh;
use crate::vector::{cross, dot, length, sub};

/// The mesh without parts that are thinner than this on average, in millimetres, unless there is nothing else.
pub(crate) fn without_flakes(mesh: Mesh, traits: Vec<Trait>, thinnest: f64) -> (Mesh, Vec<Trait>) {
    let parts = parts(&mesh);
    let mut volumes = vec![0.0; mesh.vertices.len()];
    let mut areas = vec![0.0; mesh.vertices.len()];
    for triangle in 0..mesh.triangles.len() {
        let part = parts[mesh.triangles[triangle][0] as usize] as usize;
        let [a, b, c] = mesh.corners(triangle);
        // From a point of the part, so that nothing cancels.
        let origin = mesh.vertices[part];
        volumes[part] += dot(sub(a, origin), cross(sub(b, origin), sub(c, origin))) / 6.0;
        areas[part] += 0.5 * length(cross(sub(b, a), sub(c, a)));
    }
    let stays = |triangle: &[u32; 3]| {
        let part = parts[triangle[0] as usize] as usize;
        volumes[part].abs() > thinnest * areas[part]
    };
    if !mesh.triangles.iter().any(stays) {
        return (mesh, traits);
    }
    let (triangles, traits) = mesh.triangles.iter().zip(traits).filter(|(triangle, _)| stays(triangle)).unzip();
    let mut left = Mesh { vertices: mesh.vertices, triangles };
    left.compact();
    (left, traits)
}

/// One vertex of the part that each vertex is in.
fn parts(mesh: &Mesh) -> Vec<u32> {
    let mut leaders: Vec<u32> = (0..mesh.vertices.len() as u32).collect();
    for [a, b, c] in &mesh.triangles {
        for (one, other) in [(a, b), (b, c)] {
            let (one, other) = (leader(&mut leaders, *one), leader(&mut leaders, *other));
            leaders[one.max(other) as usize] = one.min(other);
        }
    }
    (0..leaders.len() as u32).map(|vertex| leader(&mut leaders, vertex)).collect()
}

fn leader(leaders: &mut [u32], mut vertex: u32) -> u32 {
    while leaders[vertex as usize] != vertex {
        leaders[vertex as usize] = leaders[leaders[vertex as usize] as usize];
        vertex = leaders[vertex as usize];
    }
    vertex
}
