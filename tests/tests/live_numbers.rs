//! Random programs whose live numbers pass through functions that are not defined everywhere. Whatever the parameters
//! are, what the compiler claims of the field holds, and nothing is computed that is no number.
//!
//! `CHIARO_LIVE_PROGRAMS` says how many programs there are.

use chiaro_compiler::field::{Evaluator, Painter};
use chiaro_compiler::shader::{Template, single, splice};
use chiaro_compiler::{Options, Scene, compile};
use chiaro_tests::MemoryWorld;
use chiaro_tests::sampling::{Random, distance, sample_box};

/// How many programs are tried, unless somebody wants more.
const PROGRAMS: u64 = 120;
/// Rounding of f64, relative to the coordinates.
const ROUNDING: f64 = 1e-6;

/// A program under construction.
struct Program {
    random: Random,
}

impl Program {
    fn text(seed: u64) -> String {
        let mut program = Program { random: Random::new(seed) };
        let mut text = String::new();
        for name in ["a", "b", "c"] {
            let [least, most] =
                program.of(&[[-1.0, 1.0], [0.0, 1.0], [0.0, 10.0], [-5.0, 5.0], [0.5, 3.0], [1.0, 1000.0]]);
            let default = least + program.random.unit() * (most - least);
            text += &format!("{name} = {default:.3}; // [{least}:{most}]\n");
        }
        for _ in 0..1 + program.below(2) {
            let depth = 1 + program.below(3);
            text += &program.solid(depth);
            text += "\n";
        }
        text
    }

    fn below(&mut self, count: usize) -> usize {
        (self.random.unit() * count as f64) as usize
    }

    fn of<T: Copy>(&mut self, items: &[T]) -> T {
        items[self.below(items.len())]
    }

    fn constant(&mut self, least: f64, most: f64) -> String {
        format!("{:.3}", least + self.random.unit() * (most - least))
    }

    /// Any number, often live.
    fn number(&mut self, depth: usize) -> String {
        if depth == 0 || self.below(4) == 0 {
            return match self.below(8) {
                0 => self.constant(-4.0, 4.0),
                1 => self.of(&["0", "1", "2", "-1"]).to_owned(),
                2 => "$t".to_owned(),
                _ => self.of(&["a", "b", "c"]).to_owned(),
            };
        }
        let x = self.number(depth - 1);
        match self.below(20) {
            0 => format!("asin({x})"),
            1 => format!("acos({x})"),
            2 => format!("sqrt({x})"),
            3 => format!("ln({x})"),
            4 => format!("log({x})"),
            5 => format!("tan({x} * 30)"),
            6 => format!("sin({x} * 90)"),
            7 => format!("pow({x}, {})", self.number(depth - 1)),
            8 => format!("({x} / {})", self.number(depth - 1)),
            9 => format!("({x} % {})", self.number(depth - 1)),
            10 => format!("exp({x})"),
            11 => format!("sqrt(4 - {x} * {x})"),
            12 => format!("norm([{x}, {}])", self.number(depth - 1)),
            13 => format!("({x} > 0 ? ln({x}) : {})", self.number(depth - 1)),
            14 => format!("max({x}, 0.1)"),
            15 => format!("min(max({x}, -1), 1)"),
            16 => format!("({x} * {})", self.number(depth - 1)),
            17 => format!("({x} - {})", self.number(depth - 1)),
            18 => format!("atan2({x}, {})", self.number(depth - 1)),
            _ => format!("abs({x})"),
        }
    }

    /// A number of ordinary size, which may be none.
    fn some(&mut self) -> String {
        let depth = self.below(3);
        self.number(depth)
    }

    /// A size, mostly positive.
    fn size(&mut self) -> String {
        match self.below(4) {
            0 => self.constant(0.5, 6.0),
            1 => format!("1 + abs({})", self.some()),
            2 => format!("0.5 + {}", self.of(&["a", "b", "c", "$t"])),
            _ => self.some(),
        }
    }

    fn vector(&mut self) -> String {
        format!("[{}, {}, {}]", self.some(), self.some(), self.some())
    }

    fn shape(&mut self) -> String {
        match self.below(6) {
            0 => format!("sphere({});", self.size()),
            1 => format!("cube([{}, {}, {}], center = true);", self.size(), self.size(), self.size()),
            2 => format!("cylinder(h = {}, r1 = {}, r2 = {});", self.size(), self.size(), self.size()),
            3 => format!("torus({}, {});", self.size(), self.size()),
            4 => format!(
                "linear_extrude({}, twist = {}, scale = {}) square([{}, 3]);",
                self.size(),
                self.some(),
                self.size(),
                self.size()
            ),
            _ => format!("rotate_extrude(angle = {}) translate([4, 0]) circle({});", self.some(), self.size()),
        }
    }

    fn solid(&mut self, depth: usize) -> String {
        if depth == 0 {
            return self.shape();
        }
        let inner = self.solid(depth - 1);
        match self.below(12) {
            0 => format!("translate({}) {inner}", self.vector()),
            1 => format!("rotate({}) {inner}", self.vector()),
            2 => format!("rotate({}, {}) {inner}", self.some(), self.vector()),
            3 => format!("scale([{}, {}, {}]) {inner}", self.size(), self.size(), self.size()),
            4 => format!("mirror({}) {inner}", self.vector()),
            5 | 6 => {
                let mut row = |axis: usize| {
                    let mut entry = |column: usize| match self.below(3) {
                        0 => self.some(),
                        _ => if column == axis { "1" } else { "0" }.to_owned(),
                    };
                    format!("[{}, {}, {}, {}]", entry(0), entry(1), entry(2), entry(3))
                };
                format!("multmatrix([{}, {}, {}]) {inner}", row(0), row(1), row(2))
            }
            7 => format!("color([{}, {}, 0.5]) {inner}", self.some(), self.some()),
            8 => format!("union(r = {}) {{ {inner} {} }}", self.size(), self.shape()),
            9 => format!("difference() {{ {inner} {} }}", self.shape()),
            10 => format!("round(r = {}) {inner}", self.size()),
            _ => format!("twist(rate = {}) {inner}", self.some()),
        }
    }
}

/// What was seen of all programs.
#[derive(Debug, Default)]
struct Seen {
    compiled: u64,
    live: u64,
    recompiled: u64,
    values: u64,
    points: u64,
}

fn compiled(text: &str) -> (Option<Scene>, bool) {
    let compilation = compile(&MemoryWorld::of("live.csg", text.to_owned()), "live.csg", &Options::default());
    let recompiles = compilation.diagnostics.iter().any(|said| said.message.contains("recompiles"));
    (compilation.scene, recompiles)
}

/// The first thing that is wrong with a scene at some values of its parameters.
fn wrong(scene: &Scene, parameters: &[f64], random: &mut Random, seen: &mut Seen) -> Option<String> {
    let graph = &scene.graph;
    for slot in &graph.slots {
        let (value, range) = (slot.value(parameters), slot.range());
        let slack = 1e-9 * (1.0 + value.abs());
        if !(range.min - slack <= value && value <= range.max + slack && single(value).is_finite()) {
            return Some(format!("a live number is {value}, not in {range:?}"));
        }
    }
    let facts = &graph.facts[graph.root.0 as usize];
    let evaluator = Evaluator::new(graph, parameters);
    let painter = Painter::new(graph, parameters);
    let now = evaluator.bounds();
    let bounds = sample_box(&now);
    let slack = ROUNDING * (1.0 + bounds.diagonal());
    let mut points: Vec<([f64; 3], f64)> = Vec::new();
    for _ in 0..40 {
        let point = random.point(&bounds);
        let dual = evaluator.gradient(point);
        let (value, slope) = (evaluator.distance(point), dual.slope());
        let look = painter.look(&evaluator, point);
        let claims = [
            ("is finite", value.is_finite() && dual.value.is_finite() && slope.is_finite()),
            ("has a look", look.color.iter().all(|channel| channel.is_finite())),
            ("has a slope within L", slope <= facts.lipschitz * (1.0 + ROUNDING) + ROUNDING),
            ("lies within the bounds", value > -slack || facts.bounds.distance(point) <= slack),
            ("lies within the present bounds", value > -slack || now.distance(point) <= slack),
        ];
        if let Some((claim, _)) = claims.iter().find(|(_, holds)| !holds) {
            return Some(format!("{value} at {point:?} {claim}: not so; slope {slope}, {facts:?}, {now:?}"));
        }
        for (other, known) in &points {
            let most = facts.lipschitz * distance(point, *other);
            if (value - known).abs() > most * (1.0 + ROUNDING) + slack {
                return Some(format!(
                    "{value} at {point:?} and {known} at {other:?}: steeper than {}",
                    facts.lipschitz
                ));
            }
        }
        points.push((point, value));
        seen.points += 1;
    }
    seen.values += 1;
    None
}

/// The defaults, all at one end or the other, anywhere between, and beyond: these count as the nearest within.
fn values(scene: &Scene, random: &mut Random) -> Vec<Vec<f64>> {
    let ranges: Vec<_> = scene.parameters.iter().map(|parameter| parameter.range).collect();
    let anywhere = |random: &mut Random| {
        ranges.iter().map(|range| range.min + random.unit() * (range.max - range.min)).collect::<Vec<f64>>()
    };
    let ends = |random: &mut Random| {
        ranges.iter().map(|range| if random.unit() < 0.5 { range.min } else { range.max }).collect::<Vec<f64>>()
    };
    vec![
        scene.defaults(),
        ranges.iter().map(|range| range.min).collect(),
        ranges.iter().map(|range| range.max).collect(),
        ends(random),
        anywhere(random),
        anywhere(random),
        ranges.iter().map(|range| range.max + 1e3).collect(),
        vec![f64::NAN; ranges.len()],
    ]
}

#[test]
fn no_value_of_a_live_number_breaks_the_field() {
    let wanted = std::env::var("CHIARO_LIVE_PROGRAMS").ok().and_then(|count| count.parse().ok());
    let programs = wanted.unwrap_or(PROGRAMS);
    let mut seen = Seen::default();
    let mut failures = Vec::new();
    for seed in 0..programs {
        let text = Program::text(seed);
        let (scene, recompiles) = compiled(&text);
        let Some(scene) = scene else { continue };
        seen.compiled += 1;
        seen.recompiled += u64::from(recompiles);
        seen.live += u64::from(!scene.graph.slots.is_empty());
        let mut random = Random::new(!seed);
        for parameters in values(&scene, &mut random) {
            if let Some(what) = wrong(&scene, &parameters, &mut random, &mut seen) {
                failures.push(format!("seed {seed} at {parameters:?}: {what}\n{text}"));
                break;
            }
        }
        if seed % 16 == 0
            && let Err(error) = splice(&scene.picture(), Template::Library)
        {
            failures.push(format!("seed {seed}: {}\n{text}", error.message));
        }
    }
    assert!(failures.is_empty(), "{} failures of {seen:?}:\n{}", failures.len(), failures.join("\n"));
    // The test is worth something only if many of the programs are scenes, with live numbers and without.
    assert!(4 * seen.compiled > programs, "{seen:?}");
    assert!(8 * seen.live > programs && 16 * seen.recompiled > programs, "{seen:?}");
    assert!(seen.values > 6 * seen.compiled, "{seen:?}");
}
