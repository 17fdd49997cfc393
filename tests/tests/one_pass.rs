//! Pictures in one pass, as exported shaders draw them, and the text of such shaders.

use std::path::Path;

use chiaro_compiler::{Options, Scene, compile, shader};
use chiaro_render::{Gpu, Model, Picture, Preference, View};
use chiaro_tests::workspace;
use chiaro_tests::world::DiskWorld;

/// The size of the pictures that are kept, in pixels.
const SIZE: [u32; 2] = [96, 72];

/// How far a picture in one pass may be from the one that is kept of 12 samples, as the square root of the mean square
/// over all channels, in steps of 8 bits: its edges are another filter's, and the kept one has noise.
const TOLERANCE: f64 = 10.0;

#[test]
fn pictures_in_one_pass_look_as_those_of_samples() {
    for name in ["mug", "snowman"] {
        let mut picture = picture(&scene(name));
        picture.draw_in_one_pass().unwrap();
        let drawn = picture.resolve().unwrap();
        let kept = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("pictures/{name}.png"));
        let kept = image::open(kept).unwrap().into_rgba8();
        let squares = kept.as_raw().iter().zip(&drawn).map(|(a, b)| f64::from(a.abs_diff(*b)).powi(2));
        let deviation = (squares.sum::<f64>() / f64::from(3 * SIZE[0] * SIZE[1])).sqrt();
        assert!(deviation < TOLERANCE, "{name} deviates by {deviation:.1} of 255");
    }
}

#[test]
fn the_pass_asks_the_scene_in_one_place() {
    let pass = shader::one_pass(&picture(&scene("mug")).setting());
    assert_eq!(pass.matches("scene_distance(").count(), 1);
    assert_eq!(pass.matches("scene_surface(").count(), 1);
}

fn scene(name: &str) -> Scene {
    let path = workspace().join(format!("examples_csg/{name}.csg"));
    compile(&DiskWorld, &path.to_string_lossy(), &Options::default()).scene.unwrap()
}

fn picture(scene: &Scene) -> Picture {
    let gpu = Gpu::new(&Preference::Software).or_else(|_| Gpu::new(&Preference::Any)).unwrap();
    let model = Model::new(&gpu, &scene.picture(), &scene.defaults()).unwrap();
    let view = View::framing_model(&gpu, &model, &scene.camera, f64::from(SIZE[0]) / f64::from(SIZE[1])).unwrap();
    Picture::new(&gpu, &model, view, SIZE).unwrap()
}
