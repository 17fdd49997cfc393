//! Lights and the methods that draw their shadows: closed forms, limits, and what all of them have to agree on.

use std::sync::OnceLock;

use chiaro_compiler::shader::Shadows;
use chiaro_compiler::solid::SHADOW_METHODS;
use chiaro_compiler::{Scene, compile};
use chiaro_render::{Direct, Gpu, LightRow, Lighting, Model, Outcome, Picture, Preference, Receiver, Study, View};
use chiaro_tests::world::MemoryWorld;

fn gpu() -> &'static Gpu {
    static GPU: OnceLock<Gpu> = OnceLock::new();
    GPU.get_or_init(|| Gpu::new(&Preference::Any).unwrap_or_else(|error| panic!("{error}")))
}

/// A scene of the test's, ready to be lit.
struct Subject {
    scene: Scene,
    model: Model,
    view: View,
}

impl Subject {
    fn new(text: &str) -> Self {
        let compilation = compile(&MemoryWorld::of("test.csg", text), "test.csg", &Default::default());
        let messages: Vec<_> = compilation.diagnostics.iter().map(|diagnostic| &diagnostic.message).collect();
        let scene = compilation.scene.unwrap_or_else(|| panic!("{messages:?}"));
        let model = Model::new(gpu(), &scene.picture(), &[]).unwrap();
        let view = View::framing(&scene.camera, &[], &model.extent(gpu()).unwrap(), 1.0);
        Self { scene, model, view }
    }

    fn lighting(&self) -> Lighting {
        Lighting::of(&self.scene.lights, &[], &self.view)
    }

    fn light(&self) -> LightRow {
        self.lighting().lights[0].row
    }

    fn study(&self, edge: u32) -> Study {
        Study::new(gpu(), &self.model, self.view, [edge; 2]).unwrap()
    }
}

const FLOOR: &str = "translate([-500, -500, -10]) cube([1000, 1000, 10]);";

fn seen(receivers: &[Receiver]) -> impl Iterator<Item = usize> + '_ {
    receivers.iter().enumerate().filter(|(_, receiver)| receiver.offset >= 0.0).map(|(pixel, _)| pixel)
}

#[test]
fn every_method_that_a_scene_may_name_is_there() {
    for name in SHADOW_METHODS {
        assert!(*name == "reference" || Shadows::named(name).is_some(), "{name}");
    }
    for method in Shadows::ALL {
        assert!(SHADOW_METHODS.contains(&method.name()), "{}", method.name());
    }
}

/// The light of 1000 lumens, where it faces a surface a metre away.
#[test]
fn lumens_become_lux() {
    let pi = std::f64::consts::PI;
    let lights = [
        ("sphere_light(r = 20)", 1000.0 / (4.0 * pi)),
        ("rotate([180, 0, 0]) disk_light(r = 20)", 1000.0 / pi),
        ("rotate([180, 0, 0]) disk_light(r = 20, two_sided = true)", 500.0 / pi),
        ("rotate([180, 0, 0]) rect_light([30, 20])", 1000.0 / pi),
        ("rotate([180, 0, 0]) polygon_light([[-10, -10], [10, -10], [10, 10], [0, 2], [-10, 10]])", 1000.0 / pi),
        ("tube_light(r = 2, length = 30)", 1000.0 / (pi * pi)),
    ];
    for (light, expected) in lights {
        let camera = "camera(eye = [0, -30, 100], target = [0, 0, 0], fov = 4);";
        let subject = Subject::new(&format!("{camera} {FLOOR} translate([0, 0, 1000]) {light};"));
        let mut study = subject.study(9);
        let middle = 9 * 4 + 4;
        let lux: f64 = subject
            .lighting()
            .lights
            .iter()
            .map(|light| {
                let outcome = study.run(Shadows::Verified, 1, &light.row).unwrap();
                f64::from(outcome.irradiance[middle]) * light.row.radiance()[1]
            })
            .sum();
        assert!((lux / expected - 1.0).abs() < 0.01, "{light}: {lux} lx and not {expected}");
    }
}

/// Irradiances in closed form against sums over the light, among them of lights that the horizon cuts.
#[test]
fn irradiances_are_those_of_numerical_integration() {
    type Point = ([f64; 3], [f64; 3], f64);
    let grid = |count: usize| {
        (0..count * count).map(move |i| [(i % count) as f64 + 0.5, (i / count) as f64 + 0.5].map(|x| x / count as f64))
    };
    let (tau, up) = (std::f64::consts::TAU, [0.0, 0.0, 1.0]);
    // A point of the light, its normal, and its share of the area.
    let rect: Vec<Point> =
        grid(200).map(|[u, v]| ([40.0 * u - 20.0, 20.0, 30.0 * v - 5.0], [0.0, -1.0, 0.0], 1200.0 / 4e4)).collect();
    let disk: Vec<Point> = grid(200)
        .map(|[u, v]| {
            let r = 12.0 * u.sqrt();
            ([r * (tau * v).cos(), 25.0, r * (tau * v).sin() + 4.0], [0.0, -1.0, 0.0], 452.39 / 4e4)
        })
        .collect();
    let sphere: Vec<Point> = grid(400)
        .map(|[u, v]| {
            let (z, angle) = (1.0 - 2.0 * u, tau * v);
            let r = (1.0 - z * z).sqrt();
            let n = [r * angle.cos(), r * angle.sin(), z];
            ([10.0 * n[0], 45.0 + 10.0 * n[1], 5.0 + 10.0 * n[2]], n, 1256.64 / 16e4)
        })
        .collect();
    let tube: Vec<Point> = grid(300)
        .map(|[u, v]| {
            let n = [0.0, (tau * v).cos(), (tau * v).sin()];
            ([40.0 * u - 20.0, 45.0 + 3.0 * n[1], 16.0 + 3.0 * n[2]], n, 753.98 / 9e4)
        })
        .collect();
    let lights = [
        ("translate([0, 20, 10]) rotate([90, 0, 0]) rect_light([40, 30])", rect, 2e-3),
        ("translate([0, 25, 4]) rotate([90, 0, 0]) disk_light(r = 12)", disk, 5e-3),
        ("translate([0, 45, 5]) sphere_light(r = 10)", sphere, 5e-3),
        ("translate([0, 45, 16]) tube_light(r = 3, length = 40)", tube, 5e-3),
    ];
    for (text, points, allowed) in lights {
        let camera = "camera(eye = [0, -40, 60], target = [0, -5, 0], fov = 40);";
        let subject = Subject::new(&format!("{camera} {FLOOR} {text};"));
        let mut study = subject.study(8);
        let receivers = study.receivers().unwrap();
        let outcome = study.run(Shadows::Hard, 1, &subject.light()).unwrap();
        for pixel in seen(&receivers) {
            let p = receivers[pixel].position.map(f64::from);
            let shadow_point = [0, 1, 2].map(|i| p[i] + f64::from(receivers[pixel].offset) * up[i]);
            let of_point = |(q, n, area): &Point| {
                let d = [0, 1, 2].map(|i| q[i] - shadow_point[i]);
                let d2: f64 = d.iter().map(|x| x * x).sum();
                let facing = -(0..3).map(|i| n[i] * d[i]).sum::<f64>();
                d[2].max(0.0) * facing.max(0.0) / (d2 * d2) * area
            };
            let expected: f64 = points.iter().map(of_point).sum();
            let found = f64::from(outcome.irradiance[pixel]);
            assert!(
                (found - expected).abs() <= allowed * expected + 1e-5,
                "{text} at {p:?}: {found} and not {expected}"
            );
        }
    }
}

/// A straight edge cuts a disc of light: V is the segment that it leaves, in the truth within its own confidence
/// interval, and in ours.
#[test]
fn a_half_plane_leaves_a_segment_of_the_disc() {
    let subject = Subject::new(&format!(
        "camera(eye = [0, -8, 3.5], target = [0, 0, 0], fov = 40); {FLOOR}
         translate([0, -500, 5]) cube([1000, 1000, 8]);
         translate([0, 0, 20]) sphere_light(r = 2);"
    ));
    let mut study = subject.study(48);
    let receivers = study.receivers().unwrap();
    let truth = study.truth(&subject.light(), 0.01, 2048).unwrap();
    let ours = study.run(Shadows::Verified, 19, &subject.light()).unwrap();
    assert!(truth.half_width < 0.02, "{}", truth.half_width);
    // Lit and dark places far from the penumbra need few rays.
    assert!(truth.mean_samples < 0.7 * f64::from(truth.samples), "{} of {}", truth.mean_samples, truth.samples);
    let (mut checked, mut outside) = (0, 0);
    for pixel in seen(&receivers) {
        let [x, y, z] = receivers[pixel].position.map(f64::from);
        if z.abs() > 1e-3 || x.abs() > 1.2 || y.abs() > 1.2 {
            continue;
        }
        // Where the plane through p and the edge that counts, the upper or the lower one, meets the light's height.
        let edge = if x < 0.0 { 13.0 } else { 5.0 };
        let expected = segment(x * (1.0 - 20.0 / edge) / 2.0);
        checked += 1;
        outside += usize::from((f64::from(truth.visible[pixel]) - expected).abs() > 0.01 + truth.half_width);
        let error = (f64::from(ours.visible[pixel]) - expected).abs();
        assert!(error < 0.06, "V = {} and not {expected} at {x} {y}", ours.visible[pixel]);
    }
    assert!(checked > 50 && outside * 20 <= checked, "{outside} of {checked}");
}

/// The truth of the whole integral is the closed form where nothing is in the way, and V of it where something is.
#[test]
fn what_receivers_get_is_the_irradiance_of_what_they_see() {
    for light in
        ["translate([0, 30, 12]) sphere_light(r = 6)", "translate([0, 25, 10]) rotate([90, 0, 0]) rect_light([20, 10])"]
    {
        let camera = "camera(eye = [0, -40, 40], target = [0, 0, 0], fov = 30);";
        let subject = Subject::new(&format!("{camera} {FLOOR} translate([2, 10, 0]) cube([30, 1, 12]); {light};"));
        let mut study = subject.study(24);
        let receivers = study.receivers().unwrap();
        let truth = study.truth(&subject.light(), 0.01, 1024).unwrap();
        let (mut open, mut part) = (0, 0);
        for pixel in seen(&receivers).filter(|pixel| receivers[*pixel].normal[2] > 0.99) {
            let (received, irradiance, seen) = (truth.received[pixel], truth.irradiance[pixel], truth.visible[pixel]);
            let allowed = 0.03 * irradiance + 2.0 * truth.received_half_width as f32;
            let expected = seen * irradiance;
            assert!((received - expected).abs() <= allowed, "{light}: E {received} and not {expected} at {seen}");
            open += usize::from(seen >= 1.0);
            part += usize::from(seen > 0.0 && seen < 1.0);
        }
        assert!(open > 50 && part > 20 && truth.received_half_width < 0.02, "{open}, {part}");
    }
}

/// An edge cuts flat lights: the part of the irradiance that is left, in the truth and in ours, against sums over the
/// light.
#[test]
fn an_edge_leaves_a_part_of_the_irradiance_of_flat_lights() {
    type Inside = fn(f64, f64) -> bool;
    let lights: [(&str, Inside); 3] = [
        ("disk_light(r = 3)", |x, y| x * x + y * y <= 9.0),
        ("rect_light([5, 3])", |x, y| x.abs() <= 2.5 && y.abs() <= 1.5),
        ("polygon_light([[-3, -2], [3, -2], [0, 3]])", |x, y| y >= -2.0 && x.abs() <= 3.0 * (3.0 - y) / 5.0),
    ];
    for (light, inside) in lights {
        let subject = Subject::new(&format!(
            "camera(eye = [0, -8, 3.5], target = [0, 0, 0], fov = 40); {FLOOR}
             translate([0, -500, 5]) cube([1000, 1000, 8]);
             translate([0, 0, 20]) rotate([180, 0, 0]) {light};"
        ));
        let mut study = subject.study(40);
        let receivers = study.receivers().unwrap();
        let truth = study.truth(&subject.light(), 0.01, 2048).unwrap();
        let ours = study.run(Shadows::Verified, 18, &subject.light()).unwrap();
        let (mut checked, mut outside) = (0, 0);
        for pixel in seen(&receivers) {
            let [x, y, z] = receivers[pixel].position.map(f64::from);
            if z.abs() > 1e-3 || x.abs() > 1.5 || y.abs() > 1.5 {
                continue;
            }
            // The light lies face down: its y is the world's −y.
            let expected = part_beside_the_edge([x, y], |u, v| inside(u, -v));
            checked += 1;
            outside += usize::from((f64::from(truth.visible[pixel]) - expected).abs() > 0.01 + truth.half_width);
            let error = (f64::from(ours.visible[pixel]) - expected).abs();
            assert!(error < 0.06, "{light}: V = {} and not {expected} at {x} {y}", ours.visible[pixel]);
        }
        assert!(checked > 50 && outside * 20 <= checked, "{light}: {outside} of {checked}");
    }
}

/// The part of the irradiance at the floor that a light at height 20 sends past the block from height 5 to 13 on the
/// side of positive x.
fn part_beside_the_edge([x, y]: [f64; 2], inside: impl Fn(f64, f64) -> bool) -> f64 {
    const GRID: i32 = 160;
    let (mut all, mut passed) = (0.0, 0.0);
    for i in 0..GRID * GRID {
        let [u, v] = [i % GRID, i / GRID].map(|k| 3.2 * (2.0 * (f64::from(k) + 0.5) / f64::from(GRID) - 1.0));
        if !inside(u, v) {
            continue;
        }
        let share = ((u - x).powi(2) + (v - y).powi(2) + 400.0).powi(-2);
        let at = |height: f64| x + (u - x) * height / 20.0;
        all += share;
        passed += if at(5.0) < 0.0 && at(13.0) < 0.0 { share } else { 0.0 };
    }
    passed / all
}

/// The part of a unit disc on the near side of a chord at the signed distance x from its centre.
fn segment(x: f64) -> f64 {
    let m = x.clamp(-1.0, 1.0);
    (m * (1.0 - m * m).sqrt() + m.asin()) / std::f64::consts::PI + 0.5
}

/// Lights in every awkward place: whatever the method, V is a number from 0 to 1, and what is plainly lit or hidden is
/// that. (The minimal cone as it was printed lets light through.)
#[test]
fn no_light_is_too_awkward_for_any_method() {
    let solids = "cube(10); translate([20, 0, 6]) sphere(6);";
    let places = [
        ("in the open", "translate([0, -10, 40])"),
        ("inside geometry", "translate([5, 5, 5])"),
        ("below the horizon", "translate([0, 0, -60])"),
        ("on the floor", "translate([-15, -15, 0])"),
        ("grazing", "translate([300, 0, 2])"),
        ("far too large", "scale(1e300)"),
        ("far too far away", "translate([1e300, 0, 1e300])"),
    ];
    let lights = [
        "sphere_light(r = 4)",
        "sphere_light(r = 0)",
        "sphere_light(r = 60)",
        "rotate([180, 0, 0]) rect_light([8, 4])",
        "rotate([180, 0, 0]) disk_light(r = 4, two_sided = true)",
        "tube_light(r = 1, length = 20)",
        "sun(angle = 10)",
        "rotate([180, 0, 0]) rect_light([0.001, 0.001])",
        "rotate([180, 0, 0]) disk_light(r = 0.001)",
        "rotate([100, 0, 0]) rect_light([200, 100], two_sided = true)",
        "rotate([180, 0, 0]) polygon_light([[-4, -3], [4, -3], [0, 5]])",
    ];
    let mut text = format!("camera(eye = [-30, -60, 50], target = [5, 0, 0], fov = 40); {FLOOR} {solids}");
    for (_, place) in places {
        for light in lights {
            text += &format!("{place} {light};");
        }
    }
    let subject = Subject::new(&text);
    let mut study = subject.study(24);
    let receivers = study.receivers().unwrap();
    let mut bounded = 0;
    for (index, light) in subject.lighting().lights.iter().enumerate() {
        let (place, name) = (places[index / lights.len()].0, lights[index % lights.len()]);
        for method in Shadows::ALL {
            let outcome = study.run(method, 4, &light.row).unwrap();
            check(&receivers, &outcome, &format!("{} of {name}, {place}", method.name()));
            let seen: Vec<f32> = seen(&receivers).map(|pixel| outcome.visible[pixel]).collect();
            assert_eq!(seen.len(), 24 * 24, "every pixel shows a surface");
            let mean = seen.iter().sum::<f32>() / seen.len() as f32;
            let (least, most) = visible_part(place, name);
            let leaks = method == Shadows::MinimalConePrinted && most == 0.0;
            assert!(leaks || (least..=most).contains(&mean), "{} of {name}, {place}: V {mean}", method.name());
            bounded += usize::from(!leaks && (least, most) != (0.0, 1.0));
        }
    }
    assert!(bounded >= 200, "{bounded}");
}

/// The least and the greatest part of a light that receivers see on average, where the place leaves no doubt: small
/// lights high above are seen from nearly everywhere, and what the floor or the cube hides is seen from nowhere.
fn visible_part(place: &str, light: &str) -> (f32, f32) {
    let is_small = !light.contains("sun") && !light.contains("60") && !light.contains("200");
    let is_point = light.contains("0.001") || light.contains("r = 0)");
    match place {
        "in the open" if is_small => (0.95, 1.0),
        "below the horizon" if is_small => (0.0, 0.0),
        "inside geometry" if is_point => (0.0, 0.0),
        _ => (0.0, 1.0),
    }
}

fn check(receivers: &[Receiver], outcome: &Outcome, what: &str) {
    for pixel in seen(receivers) {
        let (seen, bare) = (outcome.visible[pixel], outcome.bare[pixel]);
        let p = receivers[pixel].position;
        assert!(
            (-1e-4..=1.0001).contains(&seen) && (0.0..=1.0001).contains(&bare),
            "{what}: V {seen}, V₀ {bare} at {p:?}"
        );
        assert!(outcome.irradiance[pixel] >= 0.0, "{what}: E₀ {} at {p:?}", outcome.irradiance[pixel]);
    }
}

/// A plane without anything on it sees all that is above its horizon.
#[test]
fn an_open_plane_has_no_black_dots() {
    for light in ["translate([0, 0, 30]) sphere_light(r = 8)", "rotate([80, 0, 0]) sun(angle = 30)"] {
        let camera = "camera(eye = [0, -60, 20], target = [0, 0, 0], fov = 50);";
        let subject = Subject::new(&format!("{camera} {FLOOR} {light};"));
        let mut study = subject.study(32);
        let receivers = study.receivers().unwrap();
        for cells in [1, 4, 8, 37] {
            let outcome = study.run(Shadows::Verified, cells, &subject.light()).unwrap();
            for pixel in seen(&receivers) {
                let (seen, bare) = (outcome.visible[pixel], outcome.bare[pixel]);
                assert!((seen - bare).abs() < 0.02, "{light}, {cells} cells: V {seen} but V₀ {bare}");
            }
        }
    }
}

/// Shadow methods and random samples draw the same picture, up to noise: energy doesn't depend on the method.
#[test]
fn pictures_have_the_same_energy_by_every_way_to_light_them() {
    for light in [
        "translate([10, -30, 50]) sphere_light(r = 6)",
        "translate([0, -20, 45]) rotate([150, 0, 0]) rect_light([30, 15])",
        "translate([0, 0, 50]) rotate([180, 0, 0]) disk_light(r = 10)",
        "translate([0, -10, 40]) tube_light(r = 1.5, length = 40)",
        "rotate([40, 20, 0]) sun(angle = 5)",
    ] {
        let subject = Subject::new(&format!(
            "camera(eye = [40, -70, 50], target = [0, 0, 5], fov = 35);
             color(\"white\", roughness = 0.8) {{ {FLOOR} translate([-8, -8, 0]) cube(14); }} {light};"
        ));
        let energy = |direct: Direct| energy(&subject, subject.lighting(), direct);
        let (sampled, ours) = (energy(Direct::Sampled), energy(Direct::By(Shadows::Verified)));
        assert!((ours / sampled - 1.0).abs() < 0.03, "{light}: {ours} and not {sampled}");
    }
}

/// The rig that scenes without lights get: the methods differ in the edges of shadows, not in how much light there is.
#[test]
fn the_rig_has_the_same_energy_by_every_method() {
    let subject = Subject::new(&format!(
        "camera(eye = [40, -70, 50], target = [0, 0, 5], fov = 35);
         color(\"white\", roughness = 0.8) {{ {FLOOR} translate([-8, -8, 0]) cube(14); }}"
    ));
    let energy = |direct: Direct| energy(&subject, Lighting::studio(0.6), direct);
    let sampled = energy(Direct::Sampled);
    for (method, allowed) in [
        (Shadows::Verified, 0.02),
        (Shadows::MinimalConePlus, 0.03),
        (Shadows::MinimalConeExact, 0.03),
        (Shadows::Quilez2019, 0.03),
        (Shadows::Aaltonen, 0.05),
        (Shadows::Hard, 0.05),
    ] {
        let by_method = energy(Direct::By(method));
        assert!((by_method / sampled - 1.0).abs() < allowed, "{}: {by_method} and not {sampled}", method.name());
    }
}

/// The studio's floor isn't of the scene, whose distance says nothing of it.
#[test]
fn shadows_on_the_studios_floor_are_those_of_random_samples() {
    let subject = Subject::new(
        "difference() { cylinder(h = 46, r = 20); translate([0, 0, 4]) cylinder(h = 60, r = 17); }
         difference() { translate([21, 0, 24]) rotate([90, 0, 0]) torus(major = 12, minor = 2.8); cylinder(h = 60, r = 18.5); }",
    );
    let green = |direct: Direct| blocks(&drawn(&subject, Lighting::studio(0.6), direct, [64, 48], 96), 64);
    let (sampled, ours) = (green(Direct::Sampled), green(Direct::By(Shadows::Verified)));
    let most = sampled.iter().zip(&ours).map(|(sampled, ours)| (sampled - ours).abs()).fold(0.0, f64::max);
    assert!(most < 0.03, "{most}");
}

/// The means of green over blocks of four by four pixels.
fn blocks(pixels: &[[f32; 4]], width: usize) -> Vec<f64> {
    let rows: Vec<&[[f32; 4]]> = pixels.chunks(width).collect();
    let mean = |rows: &[&[[f32; 4]]], x: usize| {
        rows.iter().flat_map(|row| &row[x..x + 4]).map(|pixel| f64::from(pixel[1])).sum::<f64>() / 16.0
    };
    rows.chunks_exact(4).flat_map(|rows| (0..width).step_by(4).map(|x| mean(rows, x)).collect::<Vec<_>>()).collect()
}

/// The sum of a picture's green.
fn energy(subject: &Subject, lighting: Lighting, direct: Direct) -> f64 {
    drawn(subject, lighting, direct, [48, 48], 32).iter().map(|pixel| f64::from(pixel[1])).sum()
}

/// A picture of so many samples: linear red, green and blue.
fn drawn(subject: &Subject, lighting: Lighting, direct: Direct, size: [u32; 2], samples: u32) -> Vec<[f32; 4]> {
    let mut picture = Picture::new(gpu(), &subject.model, subject.view, size).unwrap();
    picture.set_lighting(lighting).unwrap();
    picture.set_direct(direct).unwrap();
    for _ in 0..samples {
        picture.sample().unwrap();
    }
    picture.hdr().unwrap()
}
