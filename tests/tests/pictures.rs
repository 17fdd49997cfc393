//! Small pictures: of a few scenes, against the ones kept in `pictures/`; of every example, whether there is anything
//! to see.

mod kept;

use std::path::Path;
use std::sync::OnceLock;

use chiaro_compiler::{Options, Scene, compile, shader};
use chiaro_render::{Gpu, Model, Picture, Preference, View};
use chiaro_tests::corpus::examples;
use chiaro_tests::likeness::SAMPLED;
use chiaro_tests::workspace;
use chiaro_tests::world::DiskWorld;
use image::RgbaImage;
use kept::changed;

/// The size of the pictures that are kept, in pixels.
const SIZE: [u32; 2] = [96, 72];

/// Samples of each pixel of the pictures that are kept.
const SAMPLES: u32 = 24;

/// The examples that are kept as pictures.
const KEPT: [&str; 13] = [
    "badge",
    "bolt",
    "bracket",
    "die",
    "gyroid_ball",
    "hello_fillet",
    "joints",
    "molecule",
    "mug",
    "pawn",
    "shell_box",
    "snowman",
    "twisted_vase",
];

#[test]
fn examples_look_as_they_did() {
    let changed: Vec<String> = KEPT
        .iter()
        .filter_map(|name| {
            let scene = compiled(&workspace().join(format!("examples_csg/{name}.csg")));
            let drawn = drawn(&scene, SIZE, SAMPLES).resolve().unwrap();
            changed(name, &RgbaImage::from_raw(SIZE[0], SIZE[1], drawn).unwrap(), &SAMPLED)
        })
        .collect();
    assert!(changed.is_empty(), "{}", changed.join("\n"));
}

#[test]
fn pictures_are_the_same_every_time() {
    let scene = compiled(&workspace().join("examples_csg/hello_fillet.csg"));
    let pictures = [0; 2].map(|_| drawn(&scene, SIZE, 2).hdr().unwrap());
    assert!(pictures[0] == pictures[1], "two pictures of one scene differ");
}

#[test]
fn every_example_has_a_shader_and_something_to_see() {
    for path in examples() {
        let scene = compiled(&path);
        if let Err(diagnostic) = shader::wgsl(&scene.picture()) {
            panic!("{}: {}", path.display(), diagnostic.message);
        }
        let picture = drawn(&scene, [48, 36], 1);
        let radiance = picture.hdr().unwrap();
        let is_sound = |pixel: &[f32; 4]| pixel.iter().all(|channel| channel.is_finite() && *channel >= 0.0);
        assert!(radiance.iter().all(is_sound), "{}: a pixel is no colour", path.display());
        // A scene is framed to fill the picture: what it shows has many brightnesses, and the studio alone has few.
        let empty = drawn_empty([48, 36]);
        let differs = |(a, b): &(&[f32; 4], &[f32; 4])| (0..3).any(|i| (a[i] - b[i]).abs() > 0.02);
        let seen = radiance.iter().zip(empty).filter(differs).count();
        assert!(seen > radiance.len() / 20, "{}: only {seen} pixels show something", path.display());
    }
}

fn compiled(path: &Path) -> Scene {
    let compilation = compile(&DiskWorld, &path.to_string_lossy(), &Options::default());
    let messages: Vec<&str> = compilation.diagnostics.iter().map(|diagnostic| diagnostic.message.as_str()).collect();
    compilation.scene.unwrap_or_else(|| panic!("{}: {messages:?}", path.display()))
}

fn gpu() -> &'static Gpu {
    static GPU: OnceLock<Gpu> = OnceLock::new();
    GPU.get_or_init(|| {
        let software = Gpu::new(&Preference::Software).or_else(|_| Gpu::new(&Preference::Any));
        software.unwrap_or_else(|error| panic!("{error}: tools/setup.sh installs a software adapter"))
    })
}

fn drawn(scene: &Scene, [width, height]: [u32; 2], samples: u32) -> Picture {
    let (graph, values) = (scene.picture(), scene.defaults());
    let model = Model::new(gpu(), &graph, &values).unwrap();
    let view = View::framing_model(gpu(), &model, &scene.camera, f64::from(width) / f64::from(height)).unwrap();
    let mut picture = Picture::new(gpu(), &model, view, [width, height]).unwrap();
    for _ in 0..samples {
        picture.sample().unwrap();
    }
    picture
}

/// The radiance of a picture without any scene.
fn drawn_empty(size: [u32; 2]) -> &'static [[f32; 4]] {
    static EMPTY: OnceLock<Vec<[f32; 4]>> = OnceLock::new();
    EMPTY.get_or_init(|| {
        let world = chiaro_tests::MemoryWorld::of("empty.csg", "");
        let scene = compile(&world, "empty.csg", &Options::default()).scene.unwrap();
        drawn(&scene, size, 1).hdr().unwrap()
    })
}
