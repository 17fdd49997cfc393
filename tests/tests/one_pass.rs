//! Pictures in one pass, as exported shaders draw them, and the text of such shaders.

use chiaro_compiler::{Options, Scene, compile, shader};
use chiaro_render::{Gpu, Lighting, Model, Picture, Preference, View};
use chiaro_tests::workspace;
use chiaro_tests::world::DiskWorld;

/// The size of the pictures, in pixels.
const SIZE: [u32; 2] = [96, 72];

/// The samples of the pictures that those in one pass are compared with.
const SAMPLES: usize = 24;

/// How far a picture in one pass may be from one of samples, as the square root of the mean square over all channels, in steps of
/// 8 bits: its edges are another filter's, and the other has noise. Among lights of several shapes it has most.
const TOLERANCES: [(&str, f64); 4] = [("mug", 10.0), ("snowman", 10.0), ("bracket", 10.0), ("still_life", 14.0)];

/// A studio with a polished and with a matt scene, rough metal, and lights of several shapes of which one is seen.
#[test]
fn pictures_in_one_pass_look_as_those_of_samples() {
    for (name, tolerance) in TOLERANCES {
        let mut picture = picture(&scene(name));
        picture.draw_in_one_pass().unwrap();
        let drawn = picture.resolve().unwrap();
        picture.restart().unwrap();
        for _ in 0..SAMPLES {
            picture.sample().unwrap();
        }
        let sampled = picture.resolve().unwrap();
        let squares = sampled.iter().zip(&drawn).map(|(a, b)| f64::from(a.abs_diff(*b)).powi(2));
        // The fourth channel is always full.
        let deviation = (squares.sum::<f64>() / f64::from(3 * SIZE[0] * SIZE[1])).sqrt();
        assert!(deviation < tolerance, "{name} deviates by {deviation:.1} of 255");
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
    let mut picture = Picture::new(&gpu, &model, view, SIZE).unwrap();
    if !scene.lights.is_empty() {
        picture.set_lighting(Lighting::of(&scene.lights, &scene.defaults(), &view)).unwrap();
    }
    picture
}
