//! Small pictures on whatever adapter the machine has. Without any, these tests fail: `tools/setup.sh` installs one.

mod support;

use std::sync::OnceLock;

use chiaro_field::{Graph, Node};
use chiaro_render::{Direct, Error, Gpu, Model, Picture, Preference, View, distances};
use chiaro_solid::{Camera, ParameterId, Scalar};
use chiaro_vocabulary::{Bounds, Interval};

use support::Builder;

const RED: [f64; 4] = [0.9, 0.1, 0.1, 1.0];
/// From below, where there is no floor.
const FROM_BELOW: [f64; 3] = [120.0, 0.0, 0.0];

fn gpu() -> &'static Gpu {
    static GPU: OnceLock<Gpu> = OnceLock::new();
    GPU.get_or_init(|| Gpu::new(&Preference::Any).unwrap_or_else(|error| panic!("{error}")))
}

fn view(rotation: [f64; 3], target: [f64; 3], distance: f64) -> View {
    View { target, rotation, distance, field_of_view: 22.5 }
}

fn picture(graph: &Graph, view: View, size: [u32; 2]) -> Picture {
    let model = Model::new(gpu(), graph, &[]).unwrap();
    Picture::new(gpu(), &model, view, size).unwrap()
}

fn red_ball() -> Graph {
    let mut scene = Builder::new();
    let ball = scene.constant("sphere", &[10.0], [0.0; 3]);
    scene.painted(RED, 0.5, 0.0, ball);
    scene.done()
}

/// How many pixels show something red.
fn red_pixels(picture: &Picture) -> f64 {
    picture.hdr().unwrap().iter().filter(|pixel| pixel[0] > 2.0 * pixel[2]).count() as f64
}

fn expected_pixels_of_ball(radius: f64, distance: f64, height: u32) -> f64 {
    let apparent = radius / (distance * distance - radius * radius).sqrt();
    let in_pixels = 0.5 * f64::from(height) * apparent / 11.25f64.to_radians().tan();
    std::f64::consts::PI * in_pixels * in_pixels
}

#[test]
fn a_ball_covers_as_many_pixels_as_it_should() {
    let mut picture = picture(&red_ball(), view(FROM_BELOW, [0.0; 3], 100.0), [160, 120]);
    for _ in 0..8 {
        picture.sample().unwrap();
    }
    let (seen, expected) = (red_pixels(&picture), expected_pixels_of_ball(10.0, 100.0, 120));
    assert!((seen / expected - 1.0).abs() < 0.03, "{seen} pixels instead of {expected}");
}

#[test]
fn light_comes_from_the_upper_left() {
    let mut scene = Builder::new();
    let ball = scene.constant("sphere", &[10.0], [0.0; 3]);
    scene.painted([0.8, 0.8, 0.8, 1.0], 0.9, 0.0, ball);
    let mut picture = picture(&scene.done(), view([90.0, 0.0, 0.0], [0.0; 3], 100.0), [96, 96]);
    for _ in 0..16 {
        picture.sample().unwrap();
    }
    let hdr = picture.hdr().unwrap();
    assert!(hdr.iter().flatten().all(|component| component.is_finite() && *component >= 0.0));
    // The mean around a point given in radii of the ball.
    let around = |x: f64, y: f64| -> f32 {
        let radius = 0.5 * 96.0 * 0.1 / 11.25f64.to_radians().tan();
        let (column, row) = ((48.0 + x * radius) as usize, (48.0 - y * radius) as usize);
        (0..25).map(|k| hdr[(row + k / 5 - 2) * 96 + column + k % 5 - 2][1]).sum::<f32>() / 25.0
    };
    let (lit, centre, shaded) = (around(-0.5, 0.5), around(0.0, 0.0), around(0.5, -0.5));
    assert!(lit > 1.3 * centre && centre > 1.3 * shaded, "{lit}, {centre}, {shaded}");
}

#[test]
fn the_prepass_changes_the_cost_and_not_the_picture() {
    let mut scene = Builder::new();
    let walls: Vec<_> =
        (0..9).map(|i| scene.constant("box", &[0.5, 20.0, 8.0], [f64::from(i) * 7.0, 0.0, 8.0])).collect();
    scene.union(None, walls);
    let mut picture = picture(&scene.done(), view([55.0, 0.0, 25.0], [28.0, 0.0, 8.0], 150.0), [320, 240]);
    let mut sampled = |prepass: bool| {
        picture.set_prepass(prepass).unwrap();
        for _ in 0..4 {
            picture.sample().unwrap();
        }
        (picture.hdr().unwrap(), picture.evaluations().unwrap())
    };
    let (with, cost_with) = sampled(true);
    let (without, cost_without) = sampled(false);

    let differing = with.iter().zip(&without).filter(|(a, b)| (a[1] - b[1]).abs() > 0.1).count();
    assert!(differing < with.len() / 100, "{differing} of {} pixels differ", with.len());
    assert!(cost_with.prepass / 4.0 + cost_with.sample < cost_without.sample, "{cost_with:?}, {cost_without:?}");
}

#[test]
fn a_lipschitz_constant_that_is_too_large_costs_steps_and_no_holes() {
    let mut scene = Builder::new();
    let plate = scene.constant("box", &[20.0, 20.0, 2.0], [0.0; 3]);
    let drill = scene.constant("cylinder", &[12.0, 2.3], [0.0; 3]);
    scene.difference(None, plate, vec![drill]);
    let mut graph = scene.done();
    let view = view([35.0, 0.0, 25.0], [0.0; 3], 150.0);
    let mut sampled = |lipschitz: f64| {
        graph.facts[graph.root.0 as usize].lipschitz = lipschitz;
        let mut picture = picture(&graph, view, [96, 72]);
        // Shadow methods take distances over L for distances: their penumbrae would be wider.
        picture.set_direct(Direct::Sampled).unwrap();
        for _ in 0..4 {
            picture.sample().unwrap();
        }
        picture.hdr().unwrap()
    };
    let (fitting, large) = (sampled(1.0), sampled(12.0));
    let differing = fitting.iter().zip(&large).filter(|(a, b)| (a[1] - b[1]).abs() > 0.15).count();
    assert!(differing < fitting.len() / 50, "{differing} of {} pixels differ", fitting.len());
}

#[test]
fn live_numbers_move_the_picture_without_a_new_pipeline() {
    let radius = Scalar::parameter(ParameterId(0), Interval::new(1.0, 20.0));
    let mut scene = Builder::new();
    let ball = scene.shape("sphere", &[radius], [0.0; 3]);
    scene.painted(RED, 0.5, 0.0, ball);
    let graph = scene.done();

    let gpu = Gpu::new(&Preference::Any).unwrap();
    let model = Model::new(&gpu, &graph, &[5.0]).unwrap();
    let mut picture = Picture::new(&gpu, &model, view(FROM_BELOW, [0.0; 3], 100.0), [120, 120]).unwrap();
    // The shadow method is compiled when it is first asked for.
    picture.sample().unwrap();
    let pipelines = gpu.pipelines_compiled();
    for radius in [5.0, 12.0, 3.0] {
        picture.set_parameters(&[radius]).unwrap();
        for _ in 0..4 {
            picture.sample().unwrap();
        }
        let (seen, expected) = (red_pixels(&picture), expected_pixels_of_ball(radius, 100.0, 120));
        assert!((seen / expected - 1.0).abs() < 0.1, "radius {radius}: {seen} pixels instead of {expected}");
    }
    assert_eq!(gpu.pipelines_compiled(), pipelines);
    assert_eq!(picture.set_parameters(&[]).unwrap_err(), Error::Parameters { needed: 1, given: 0 });
}

#[test]
fn parts_of_any_size_make_the_same_picture() {
    // The first sample is cut small, later ones as the time they take allows.
    let mut picture = picture(&red_ball(), view([55.0, 0.0, 25.0], [0.0; 3], 90.0), [203, 131]);
    picture.sample().unwrap();
    let cut_small = picture.hdr().unwrap();
    for _ in 0..3 {
        picture.sample().unwrap();
    }
    picture.set_prepass(true).unwrap();
    picture.sample().unwrap();
    assert!(cut_small == picture.hdr().unwrap());
}

#[test]
fn bytes_are_srgb_and_opaque() {
    let mut picture = picture(&red_ball(), view([55.0, 0.0, 25.0], [0.0; 3], 90.0), [65, 33]);
    picture.sample().unwrap();
    let bytes = picture.resolve().unwrap();
    assert_eq!(bytes.len(), 65 * 33 * 4);
    assert!(bytes.chunks(4).all(|pixel| pixel[3] == 255));
    let middle = &bytes[4 * (16 * 65 + 32)..][..3];
    assert!(middle[0] > 150 && middle[1] < 140 && middle[2] < 140, "{middle:?}");
    let corner = &bytes[..3];
    assert!(corner.iter().all(|&component| component > 180), "{corner:?}");
}

#[test]
fn distances_are_the_fields() {
    let points = [[0.0; 3], [10.0, 0.0, 0.0], [0.0, 25.0, 0.0], [3.0, 4.0, 0.0]];
    let answers = distances(gpu(), &red_ball(), &[], &points).unwrap();
    let expected = [-10.0, 0.0, 15.0, -5.0];
    assert!(answers.iter().zip(expected).all(|(answer, expected): (&f32, f32)| (answer - expected).abs() < 1e-4));
    assert_eq!(distances(gpu(), &red_ball(), &[], &[]).unwrap(), Vec::<f32>::new());
    // More than one dispatch of rows along x.
    let many = vec![[20.0, 0.0, 0.0]; 70_000];
    assert!(distances(gpu(), &red_ball(), &[], &many).unwrap().iter().all(|distance| (distance - 10.0).abs() < 1e-4));
}

#[test]
fn the_extent_is_what_is_there_and_not_what_was_cut_off() {
    let mut scene = Builder::new();
    let ball = scene.constant("sphere", &[10.0], [0.0; 3]);
    let cutter = scene.constant("box", &[20.0, 20.0, 20.0], [0.0, 0.0, -20.0]);
    scene.difference(None, ball, vec![cutter]);
    let model = Model::new(gpu(), &scene.done(), &[]).unwrap();
    let extent = model.extent(gpu()).unwrap();
    let expected = Bounds { min: [-10.0, -10.0, 0.0], max: [10.0; 3] };
    for axis in 0..3 {
        assert!((extent.min[axis] - expected.min[axis]).abs() < 0.1, "{extent:?}");
        assert!((extent.max[axis] - expected.max[axis]).abs() < 0.1, "{extent:?}");
    }
}

#[test]
fn a_model_fills_its_picture_wherever_it_is() {
    for centre in [[0.0; 3], [40.0, -70.0, 12.0]] {
        let mut scene = Builder::new();
        scene.constant("sphere", &[10.0], centre);
        let model = Model::new(gpu(), &scene.done(), &[]).unwrap();
        let view = View::framing_model(gpu(), &model, &Camera::default(), 1.5).unwrap();
        // The sphere's silhouette as a part of the picture's height, where its centre is in the picture's.
        let eye = view.eye();
        let distance = (0..3).map(|axis| (eye[axis] - centre[axis]).powi(2)).sum::<f64>().sqrt();
        let part = 10.0 / (distance * distance - 100.0).sqrt() / (0.5 * view.field_of_view).to_radians().tan();
        assert!((0.78..0.84).contains(&part), "{view:?}: {part}");
        let off_target = (0..3).map(|axis| (view.target[axis] - centre[axis]).powi(2)).sum::<f64>().sqrt();
        assert!(off_target < 0.2, "{view:?}");
    }
}

#[test]
fn what_live_numbers_could_be_does_not_make_the_scene_a_speck() {
    let radius = Scalar::parameter(ParameterId(0), Interval::new(1.0, 1e6));
    let mut scene = Builder::new();
    scene.shape("sphere", &[radius], [0.0; 3]);
    let model = Model::new(gpu(), &scene.done(), &[10.0]).unwrap();
    for radius in [10.0, 300.0] {
        model.set_parameters(gpu(), &[radius]).unwrap();
        let extent = model.extent(gpu()).unwrap();
        let off = |end: f64| (end.abs() / radius - 1.0).abs();
        assert!(extent.min.into_iter().chain(extent.max).all(|end| off(end) < 0.01), "{radius}: {extent:?}");
    }
}

#[test]
fn nothing_and_endless_solids_are_drawn_too() {
    let mut nothing = Builder::new();
    nothing.add(Node::Nothing, Bounds::EMPTY);
    let mut ground = Builder::new();
    ground.constant("half_space", &[0.0, 0.0, 1.0, 0.0], [0.0; 3]);
    for graph in [nothing.done(), ground.done()] {
        let model = Model::new(gpu(), &graph, &[]).unwrap();
        let view = View::framing_model(gpu(), &model, &Camera::default(), 1.5).unwrap();
        let mut picture = Picture::new(gpu(), &model, view, [48, 32]).unwrap();
        picture.sample().unwrap();
        assert!(picture.hdr().unwrap().iter().flatten().all(|component| component.is_finite()));
    }
}

#[test]
fn sizes_scale_from_hundredths_of_millimetres_to_metres() {
    let mut reference = None;
    for scale in [0.001, 1.0, 1000.0] {
        let mut scene = Builder::new();
        let ball = scene.constant("sphere", &[10.0 * scale], [0.0, 0.0, 10.0 * scale]);
        let block = scene.constant("box", &[8.0 * scale; 3], [15.0 * scale, 0.0, 8.0 * scale]);
        scene.union(None, vec![ball, block]);
        let view = view([55.0, 0.0, 25.0], [5.0 * scale, 0.0, 8.0 * scale], 130.0 * scale);
        let mut picture = picture(&scene.done(), view, [96, 64]);
        for _ in 0..4 {
            picture.sample().unwrap();
        }
        let hdr = picture.hdr().unwrap();
        let reference = reference.get_or_insert_with(|| hdr.clone());
        let differing = hdr.iter().zip(reference).filter(|(a, b)| (a[1] - b[1]).abs() > 0.1).count();
        assert!(differing < hdr.len() / 50, "at scale {scale} {differing} of {} pixels differ", hdr.len());
    }
}

#[test]
fn what_cannot_be_drawn_is_an_error() {
    let model = Model::new(gpu(), &red_ball(), &[]).unwrap();
    let view = view(FROM_BELOW, [0.0; 3], 100.0);
    for size in [[0, 10], [10, 0], [1_000_000, 1], [u32::MAX, u32::MAX]] {
        let error = Picture::new(gpu(), &model, view, size).unwrap_err();
        assert!(matches!(error, Error::PictureSize { .. }), "{error}");
    }
    let nobody = Gpu::new(&Preference::Named("no such adapter".to_string())).unwrap_err();
    assert!(nobody.to_string().contains("no such adapter"), "{nobody}");
}
