//! Rays meet what is there: tiny steps along them find no surface but the one that sphere tracing finds, on the CPU in
//! every scene, and on the graphics adapter in a few.

use chiaro_compiler::field::Evaluator;
use chiaro_render::{Gpu, Inspector, Model, Preference, View};
use chiaro_tests::corpus::{compiled, every_scene};
use chiaro_tests::sampling::{Random, distance, sample_box};
use chiaro_tests::workspace;

type Vector = [f64; 3];

/// How many tiny steps a ray's length has.
const STEPS: usize = 1000;

/// A straight way through a scene.
struct Ray {
    from: Vector,
    /// Of length 1.
    direction: Vector,
    length: f64,
}

impl Ray {
    fn between(from: Vector, to: Vector) -> Self {
        let length = distance(from, to);
        Self { from, direction: std::array::from_fn(|axis| (to[axis] - from[axis]) / length), length }
    }

    fn at(&self, t: f64) -> Vector {
        std::array::from_fn(|axis| self.from[axis] + t * self.direction[axis])
    }

    fn step(&self) -> f64 {
        self.length / STEPS as f64
    }

    /// Where tiny steps first find the inside, and where the surface is before that.
    fn surface(&self, evaluator: &Evaluator) -> Option<f64> {
        let inside =
            (1..=STEPS).map(|step| step as f64 * self.step()).find(|t| evaluator.distance(self.at(*t)) < 0.0)?;
        let (mut outside, mut inside) = (inside - self.step(), inside);
        for _ in 0..40 {
            let middle = (outside + inside) / 2.0;
            *(if evaluator.distance(self.at(middle)) < 0.0 { &mut inside } else { &mut outside }) = middle;
        }
        Some(inside)
    }
}

/// What rays met, by what tiny steps say and by what sphere tracing says.
#[derive(Debug, Default)]
struct Tally {
    same: usize,
    missed: usize,
    /// Sphere tracing stopped at a surface that tiny steps went past: along it, or through a corner of it.
    grazed: usize,
}

impl Tally {
    /// Adds a ray that met the surface where tiny steps say and where sphere tracing says. Errors are told of `what`.
    fn add(&mut self, ray: &Ray, evaluator: &Evaluator, traced: Option<Vector>, slack: f64, what: &str) {
        let surface = ray.surface(evaluator);
        let traced = traced.map(|point| {
            let left = evaluator.distance(point);
            assert!(left.abs() <= slack, "{what}: {point:?} is {left} off the surface");
            distance(ray.from, point)
        });
        match (surface, traced) {
            (None, None) => self.missed += 1,
            (Some(surface), traced) => {
                let traced =
                    traced.unwrap_or_else(|| panic!("{what}: nothing is met from {:?}, but at {surface}", ray.from));
                assert!(traced <= surface + slack, "{what}: met at {traced} from {:?}, not at {surface}", ray.from);
                // A surface at a slant is reached before it is met.
                let is_same = surface - traced <= ray.step();
                *(if is_same { &mut self.same } else { &mut self.grazed }) += 1;
            }
            (None, Some(traced)) if traced > ray.length => self.missed += 1,
            (None, Some(_)) => self.grazed += 1,
        }
    }
}

#[test]
fn sphere_tracing_meets_what_tiny_steps_find() {
    let mut tally = Tally::default();
    for subject in every_scene() {
        let (scene, what) = (&subject.scene, subject.path.display().to_string());
        let values = scene.defaults();
        let graph = scene.picture();
        let evaluator = Evaluator::new(&graph, &values);
        let provenance = scene.provenance(&subject.compilation.sources).unwrap();
        let bounds = sample_box(&evaluator.bounds());
        let slack = 1e-5 * (1.0 + bounds.diagonal());
        let mut random = Random::new(4);
        for _ in 0..20 {
            let ray = Ray::between(random.point(&bounds), random.point(&bounds));
            if evaluator.distance(ray.from) > ray.step() {
                let traced = provenance.hit(ray.from, ray.direction, &values);
                tally.add(&ray, &evaluator, traced, slack, &what);
            }
        }
    }
    assert!(tally.same >= 1_500 && tally.missed >= 2_300, "{tally:?}");
    assert!(tally.grazed * 100 <= tally.same, "{tally:?}");
}

#[test]
fn the_graphics_adapter_meets_what_tiny_steps_find() {
    let software = Gpu::new(&Preference::Software).or_else(|_| Gpu::new(&Preference::Any));
    let gpu = software.unwrap_or_else(|error| panic!("{error}: tools/setup.sh installs a software adapter"));
    let size = [24, 18];
    let mut tally = Tally::default();
    for name in ["bolt", "bracket", "die", "joints", "mug", "twisted_vase"] {
        let scene = compiled(&workspace().join(format!("examples_csg/{name}.csg"))).scene;
        let (graph, values) = (scene.picture(), scene.defaults());
        let evaluator = Evaluator::new(&graph, &values);
        let model = Model::new(&gpu, &graph, &values).unwrap();
        let view = View::framing(&scene.camera, &values, &evaluator.bounds(), 4.0 / 3.0);
        let mut inspector = Inspector::new(&gpu, &model).unwrap();
        inspector.look(view, size, None).unwrap();
        let reach = 2.0 * (view.distance + evaluator.bounds().diagonal());
        for pixel in (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| [x, y])) {
            let (from, direction) = view.ray(pixel.map(|x| f64::from(x) + 0.5), size);
            let ray = Ray { from, direction, length: reach };
            let traced = inspector.pick(pixel).unwrap();
            // Steps go a hundredth of a pixel beyond what is free.
            let pixel = view.distance * view.field_of_view.to_radians() / f64::from(size[1]);
            let slack = 0.02 * pixel;
            tally.add(&ray, &evaluator, traced, slack, &format!("{name} at {pixel:?}"));
        }
    }
    assert!(tally.same >= 560 && tally.missed >= 1_900, "{tally:?}");
    assert!(tally.grazed * 50 <= tally.same, "{tally:?}");
}
