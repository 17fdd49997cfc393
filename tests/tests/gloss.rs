//! Glossy surfaces: what pictures show of lights, against integrals over the lights on the CPU; and that surfaces send
//! back no more light than they get.

use std::f64::consts::{PI, TAU};
use std::sync::OnceLock;

use chiaro_compiler::shader::Shadows;
use chiaro_compiler::{Scene, compile};
use chiaro_render::{Direct, Floor, Gpu, Lighting, Model, Picture, Preference, Study, View};
use chiaro_tests::world::MemoryWorld;

type Vector = [f64; 3];

/// The edge of the pictures, and of every how many pixels one is looked at in both directions.
const EDGE: u32 = 64;
const STRIDE: usize = 3;

fn gpu() -> &'static Gpu {
    static GPU: OnceLock<Gpu> = OnceLock::new();
    GPU.get_or_init(|| Gpu::new(&Preference::Any).unwrap_or_else(|error| panic!("{error}")))
}

fn compiled(text: &str) -> (Scene, Model, View) {
    let compilation = compile(&MemoryWorld::of("test.csg", text), "test.csg", &Default::default());
    let messages: Vec<_> = compilation.diagnostics.iter().map(|diagnostic| &diagnostic.message).collect();
    let scene = compilation.scene.unwrap_or_else(|| panic!("{messages:?}"));
    let values: Vec<f64> = scene.parameters.iter().map(|parameter| parameter.default).collect();
    let model = Model::new(gpu(), &scene.picture(), &values).unwrap();
    let view = View::framing(&scene.camera, &values, &model.extent(gpu()).unwrap(), 1.0);
    (scene, model, view)
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn difference(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] - b[i])
}

fn normalized(v: Vector) -> Vector {
    v.map(|x| x / dot(v, v).sqrt())
}

/// A light of radiance 1 as the test sees it: a point of it with the normal there for a point of the unit square, each
/// standing for the same area.
struct Source {
    text: &'static str,
    point: fn([f64; 2]) -> (Vector, Vector),
    area: f64,
}

const SOURCES: [Source; 5] = [
    Source {
        text: "translate([0, 20, 10]) rotate([90, 0, 0]) rect_light([24, 14], luminance = 1, visible = false);",
        point: |[u, v]| ([24.0 * u - 12.0, 20.0, 14.0 * v + 3.0], [0.0, -1.0, 0.0]),
        area: 24.0 * 14.0,
    },
    Source {
        text: "translate([0, 20, 10]) rotate([90, 0, 0]) disk_light(r = 8, luminance = 1, visible = false);",
        point: |[u, v]| {
            let r = 8.0 * u.sqrt();
            ([r * (TAU * v).cos(), 20.0, 10.0 + r * (TAU * v).sin()], [0.0, -1.0, 0.0])
        },
        area: PI * 64.0,
    },
    Source {
        text: "translate([2, 22, 10]) sphere_light(r = 6, luminance = 1, visible = false);",
        point: |[u, v]| {
            let (z, angle) = (1.0 - 2.0 * u, TAU * v);
            let r = (1.0 - z * z).sqrt();
            let n = [r * angle.cos(), r * angle.sin(), z];
            ([2.0 + 6.0 * n[0], 22.0 + 6.0 * n[1], 10.0 + 6.0 * n[2]], n)
        },
        area: 4.0 * PI * 36.0,
    },
    Source {
        text: "translate([0, 20, 8]) tube_light(r = 2, length = 24, luminance = 1, visible = false);",
        point: |[u, v]| {
            let n = [0.0, (TAU * v).cos(), (TAU * v).sin()];
            ([24.0 * u - 12.0, 20.0 + 2.0 * n[1], 8.0 + 2.0 * n[2]], n)
        },
        area: TAU * 2.0 * 24.0,
    },
    Source {
        text: "sun(angle = 20, aim = [0.1, -2, -1], luminance = 1, visible = false);",
        // A disk far away.
        point: |[u, v]| {
            let far = 1e7;
            let w = normalized([-0.1, 2.0, 1.0]);
            let x = normalized([2.0, 0.1, 0.0]);
            let y = normalized([w[1] * x[2] - w[2] * x[1], w[2] * x[0] - w[0] * x[2], w[0] * x[1] - w[1] * x[0]]);
            let r = 10_f64.to_radians().tan() * u.sqrt();
            let (sin, cos) = (TAU * v).sin_cos();
            ([0, 1, 2].map(|i| far * (w[i] + r * (cos * x[i] + sin * y[i]))), w.map(|c| -c))
        },
        area: 1e14 * PI * 0.031_091,
    },
];

/// The interface of our surfaces: D V cos, and Schlick's term.
struct Interface {
    alpha: f64,
    f0: f64,
    v: Vector,
}

impl Interface {
    /// D V F cos, without the gain.
    fn value(&self, l: Vector) -> f64 {
        if l[2] <= 0.0 {
            return 0.0;
        }
        let h = normalized([0, 1, 2].map(|i| l[i] + self.v[i]));
        let a2 = self.alpha * self.alpha;
        let spread = a2 * h[2] * h[2] + h[0] * h[0] + h[1] * h[1];
        let smith = |c: f64| (1.0 + a2 * (1.0 - c * c) / (c * c)).sqrt();
        let fresnel = self.f0 + (1.0 - self.f0) * (1.0 - dot(h, l)).powi(5);
        0.5 * a2 / (PI * spread * spread) / (self.v[2] * (smith(self.v[2]) + smith(l[2]))) * fresnel
    }

    /// The factor that gives back what is lost between microfacets.
    fn gain(&self) -> f64 {
        let once = Interface { f0: 1.0, alpha: self.alpha, v: self.v };
        // Half vectors as dense as D cos: l's density is that over 4 (h·l).
        let count = 200;
        let mut whole = 0.0;
        for i in 0..count * count {
            let [u, v] = [i % count, i / count].map(|k| (k as f64 + 0.5) / count as f64);
            let cos2 = (1.0 - u) / (1.0 + (self.alpha * self.alpha - 1.0) * u);
            let (sine, (sin, cos)) = ((1.0 - cos2).sqrt(), (TAU * v).sin_cos());
            let h = [sine * cos, sine * sin, cos2.sqrt()];
            let facing = dot(self.v, h);
            let l = [0, 1, 2].map(|i| 2.0 * facing * h[i] - self.v[i]);
            if facing > 0.0 && l[2] > 0.0 {
                let spread = self.alpha * self.alpha * cos2 + 1.0 - cos2;
                let density = self.alpha * self.alpha / (PI * spread * spread) * h[2] / (4.0 * facing);
                whole += once.value(l) / density / (count * count) as f64;
            }
        }
        1.0 + self.f0 * (1.0 / whole - 1.0)
    }

    /// What it sends back of a light, seen from p.
    fn of_light(&self, source: &Source, p: Vector) -> f64 {
        let count = if self.alpha < 0.1 { 100 } else { 40 };
        let each = source.area / (count * count) as f64;
        let of_square = |i: i32| {
            let (q, n) = (source.point)([i % count, i / count].map(|k| (f64::from(k) + 0.5) / f64::from(count)));
            let d = difference(q, p);
            let distance2 = dot(d, d);
            let l = d.map(|x| x / distance2.sqrt());
            self.value(l) * (-dot(n, l)).max(0.0) / distance2 * each
        };
        (0..count * count).map(of_square).sum::<f64>() * self.gain()
    }
}

/// What lights come to on glossy planes, the body black: pictures against integrals. The mean error is relative to the mean,
/// the greatest to the brightest. A linearly transformed cosine is not the lobe; but all in all no light is lost.
#[test]
fn gloss_is_near_the_integral_over_the_light() {
    for source in &SOURCES {
        let (scene, model, view) = compiled(&format!(
            "finish = 0.5; // [0:0.01:1]
             metal = 0; // [0:0.01:1]
             camera(eye = [0, -40, 22], target = [0, 0, 0], fov = 30);
             color([metal, metal, metal], roughness = finish, metallic = metal)
                 translate([-500, -500, -10]) cube([1000, 1000, 10]);
             {}",
            source.text
        ));
        let receivers = Study::new(gpu(), &model, view, [EDGE; 2]).unwrap().receivers().unwrap();
        let mut picture = Picture::new(gpu(), &model, view, [EDGE; 2]).unwrap();
        let values: Vec<f64> = scene.parameters.iter().map(|parameter| parameter.default).collect();
        let lighting = Lighting { exposure: 1.0, ..Lighting::of(&scene.lights, &values, &view) };
        picture.set_lighting(lighting).unwrap();
        picture.set_direct(Direct::By(Shadows::Hard)).unwrap();
        for (roughness, mean_allowed, most_allowed) in [(0.2, 0.05, 0.25), (0.5, 0.13, 0.2), (0.9, 0.08, 0.12)] {
            for metal in [0.0, 1.0] {
                picture.set_parameters(&[roughness, metal]).unwrap();
                for _ in 0..8 {
                    picture.sample().unwrap();
                }
                let found = picture.hdr().unwrap();
                let truth = |p: [f32; 3]| {
                    let p = p.map(f64::from);
                    let f0 = 0.04 + 0.96 * metal;
                    let interface =
                        Interface { alpha: roughness * roughness, f0, v: normalized(difference(view.eye(), p)) };
                    interface.of_light(source, p)
                };
                let looked_at =
                    || (0..receivers.len()).filter(|i| i % EDGE as usize % STRIDE + i / EDGE as usize % STRIDE == 0);
                let truths: Vec<f64> = looked_at().map(|pixel| truth(receivers[pixel].position)).collect();
                let errors = || truths.iter().zip(looked_at()).map(|(truth, pixel)| f64::from(found[pixel][1]) - truth);
                let brightest = truths.iter().fold(0.0_f64, |most, truth| most.max(*truth));
                let mean = errors().map(f64::abs).sum::<f64>() / truths.iter().sum::<f64>();
                let most = errors().fold(0.0_f64, |most, error| most.max(error.abs())) / brightest;
                let bias = errors().sum::<f64>() / truths.iter().sum::<f64>();
                let what = format!(
                    "{} roughness {roughness}, metal {metal}: mean error {mean:.4}, most {most:.4}, bias {bias:.4}",
                    source.text
                );
                assert!(mean < mean_allowed && most < most_allowed && bias.abs() < 0.09, "{what}");
            }
        }
    }
}

/// A surface that absorbs nothing sends back what it gets of uniform surroundings: it can't be told from them.
#[test]
fn white_surfaces_vanish_in_a_furnace() {
    for roughness in [0.05, 0.3, 0.6, 1.0] {
        for metallic in [0.0, 1.0] {
            let (scene, model, view) = compiled(&format!(
                "camera(eye = [0, -40, 0], target = [0, 0, 0], fov = 30);
                 environment(\"white\", luminance = 1);
                 color(\"white\", roughness = {roughness}, metallic = {metallic}) sphere(8);"
            ));
            let mut picture = Picture::new(gpu(), &model, view, [EDGE; 2]).unwrap();
            picture.set_lighting(Lighting { exposure: 1.0, ..Lighting::of(&scene.lights, &[], &view) }).unwrap();
            picture.set_floor(Floor::Missing).unwrap();
            for _ in 0..32 {
                picture.sample().unwrap();
            }
            let found = picture.hdr().unwrap();
            let mean = found.iter().map(|pixel| f64::from(pixel[1])).sum::<f64>() / found.len() as f64;
            let what = format!("roughness {roughness}, metallic {metallic}: {mean} and not 1");

            assert!((mean - 1.0).abs() < 0.01, "{what}");
        }
    }
}

/// So does it of a light that is all that it sees.
#[test]
fn white_surfaces_send_back_all_of_a_ceiling() {
    let (scene, model, view) = compiled(
        "finish = 0.5; // [0:0.01:1]
         metal = 0; // [0:0.01:1]
         camera(eye = [0, -40, 30], target = [0, 0, 0], fov = 30);
         color(\"white\", roughness = finish, metallic = metal) translate([-50, -50, -10]) cube([100, 100, 10]);
         translate([0, 0, 60]) rotate([180, 0, 0]) rect_light([1e5, 1e5], luminance = 1, visible = false);",
    );
    let mut picture = Picture::new(gpu(), &model, view, [EDGE; 2]).unwrap();
    picture.set_lighting(Lighting { exposure: 1.0, ..Lighting::of(&scene.lights, &[0.5, 0.0], &view) }).unwrap();
    picture.set_direct(Direct::By(Shadows::Hard)).unwrap();
    for roughness in [0.03, 0.1, 0.3, 0.6, 1.0] {
        for metal in [0.0, 1.0] {
            picture.set_parameters(&[roughness, metal]).unwrap();
            for _ in 0..2 {
                picture.sample().unwrap();
            }
            let found = picture.hdr().unwrap();
            let (least, most) = found
                .iter()
                .fold((f32::MAX, 0.0_f32), |(least, most), pixel| (least.min(pixel[1]), most.max(pixel[1])));
            assert!(least > 0.98 && most < 1.01, "roughness {roughness}, metallic {metal}: {least} to {most}");
        }
    }
}
