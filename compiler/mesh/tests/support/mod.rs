//! Scenes of a text as meshes.

#![allow(dead_code, reason = "each test program uses a part of it")]

use std::collections::HashMap;
use std::ops::ControlFlow;

use chiaro_compiler::{Options, Scene, World, compile};
use chiaro_mesh::{Detail, Error, GraphField, Mesh, Model, model};

struct Text<'a>(&'a str);

impl World for Text<'_> {
    fn find(&self, _: &str, _: &str) -> Option<String> {
        None
    }

    fn read(&self, _: &str) -> Result<Vec<u8>, String> {
        Ok(self.0.as_bytes().to_vec())
    }
}

pub(crate) fn scene(text: &str) -> Scene {
    let compilation = compile(&Text(text), "scene.scad", &Options::default());
    compilation.scene.unwrap_or_else(|| panic!("{text}: {:?}", compilation.diagnostics))
}

pub(crate) fn attempt(text: &str, detail: &Detail) -> Result<Model, Error> {
    let scene = scene(text);
    let values = scene.defaults();
    model(&GraphField::new(&scene.graph, &values), detail, &mut |_| ControlFlow::Continue(()))
}

pub(crate) const fn at(resolution: u32) -> Detail {
    Detail { resolution: Some(resolution), tolerance: None }
}

pub(crate) fn mesh_of(text: &str, detail: &Detail) -> Model {
    let model = attempt(text, detail).unwrap_or_else(|error| panic!("{text}: {error}"));
    assert!(model.mesh.is_manifold(), "{text}");
    let welded = welded(&model.mesh, 1e-6 * diagonal(&model.mesh));
    assert!(is_watertight(&welded) && welded.triangles.len() == model.mesh.triangles.len(), "{text}: {detail:?}");
    model
}

/// What programs make of a mesh that take vertices for one which are nearer to each other than this.
pub(crate) fn welded(mesh: &Mesh, distance: f64) -> Mesh {
    let site = |point: [f64; 3]| point.map(|x| (x / distance).floor() as i64);
    let mut sites: HashMap<[i64; 3], Vec<u32>> = HashMap::new();
    let mut joined: Vec<u32> = Vec::new();
    for (number, point) in mesh.vertices.iter().enumerate() {
        let [x, y, z] = site(*point);
        let around = (0..27).map(|n| [x + n % 3 - 1, y + n / 3 % 3 - 1, z + n / 9 - 1]);
        let near = around.filter_map(|site| sites.get(&site)).flatten().find(|other| {
            let other = mesh.vertices[**other as usize];
            (0..3).map(|axis| (other[axis] - point[axis]).powi(2)).sum::<f64>().sqrt() < distance
        });
        joined.push(near.map_or(number as u32, |other| joined[*other as usize]));
        sites.entry(site(*point)).or_default().push(number as u32);
    }
    let triangles = mesh.triangles.iter().map(|triangle| triangle.map(|corner| joined[corner as usize]));
    let has_area = |[a, b, c]: &[u32; 3]| a != b && b != c && c != a;
    Mesh { vertices: mesh.vertices.clone(), triangles: triangles.filter(has_area).collect() }
}

/// Whether each edge has two triangles, which pass it in opposite directions.
pub(crate) fn is_watertight(mesh: &Mesh) -> bool {
    let mut passes: HashMap<(u32, u32), i32> = HashMap::new();
    for [a, b, c] in &mesh.triangles {
        for (from, to) in [(*a, *b), (*b, *c), (*c, *a)] {
            *passes.entry((from, to)).or_default() += 1;
        }
    }
    passes.iter().all(|((from, to), count)| *count == 1 && passes.get(&(*to, *from)) == Some(&1))
}

/// The diagonal of the box around a mesh.
pub(crate) fn diagonal(mesh: &Mesh) -> f64 {
    let side = |axis: usize| {
        let along = || mesh.vertices.iter().map(|vertex| vertex[axis]);
        along().fold(f64::MIN, f64::max) - along().fold(f64::MAX, f64::min)
    };
    (0..3).map(|axis| side(axis).powi(2)).sum::<f64>().sqrt()
}
