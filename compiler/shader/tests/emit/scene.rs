//! Graphs made by hand, and what is checked of each: that it is valid, and the same printed and parsed back.

use std::collections::HashMap;

use chiaro_field::{Evaluator, Facts, Graph, MaterialId, Node, NodeId, Operation, Point, PointId};
use chiaro_shader::{Template, splice, wgsl};
use chiaro_solid::{Affine, Material, Scalar};
use chiaro_vocabulary::{Bounds, Class, row};
use naga::valid::{Capabilities, ValidationFlags, Validator};

use crate::interpreter::Machine;

/// Exact, but who knows where.
pub(crate) const EXACT: Facts =
    Facts { bounds: Bounds::ALL, growth: f64::INFINITY, class: Class::Exact, lipschitz: 1.0 };

/// Builds graphs by hand.
pub(crate) struct Scene(pub(crate) Graph);

impl Scene {
    pub(crate) fn new() -> Self {
        Self(Graph {
            points: vec![Point::World],
            nodes: Vec::new(),
            facts: Vec::new(),
            spans: Vec::new(),
            root: NodeId(0),
            materials: Vec::new(),
            slots: Vec::new(),
        })
    }

    pub(crate) fn add(&mut self, node: Node) -> NodeId {
        self.0.nodes.push(node);
        self.0.facts.push(EXACT);
        NodeId(self.0.nodes.len() as u32 - 1)
    }

    /// Says that an exact shape is in this box.
    pub(crate) fn within(&mut self, id: NodeId, min: [f64; 3], max: [f64; 3]) {
        self.0.facts[id.0 as usize] = Facts { bounds: Bounds { min, max }, growth: 1.0, ..EXACT };
    }

    pub(crate) fn at(&mut self, point: Point) -> PointId {
        self.0.points.push(point);
        PointId(self.0.points.len() as u32 - 1)
    }

    pub(crate) fn moved(&mut self, by: [f64; 3]) -> PointId {
        let map = Affine::translation(by.map(|component| Scalar::from(-component)));
        self.at(Point::Affine(map, PointId(0)))
    }

    /// A point under a map of constants.
    pub(crate) fn mapped(&mut self, rows: [[f64; 4]; 3], from: PointId) -> PointId {
        self.at(Point::Affine(Affine::constant(rows), from))
    }

    pub(crate) fn shape(&mut self, name: &str, arguments: &[f64], at: PointId) -> NodeId {
        let row = row(name).unwrap_or_else(|| panic!("no row {name}"));
        assert_eq!(row.arity(), arguments.len(), "{name}");
        self.add(Node::Shape(row, arguments.iter().copied().map(Scalar::from).collect(), at))
    }

    pub(crate) fn painted(&mut self, color: [f64; 4], child: NodeId) -> NodeId {
        self.0.materials.push(Material::of_color(color.map(Scalar::from)));
        self.add(Node::Paint(MaterialId(self.0.materials.len() as u32 - 1), child))
    }

    pub(crate) fn union(&mut self, children: Vec<NodeId>) -> NodeId {
        self.add(Node::Boolean(Operation::Union, None, children))
    }

    pub(crate) fn difference(&mut self, from: NodeId, what: NodeId) -> NodeId {
        let complement = self.add(Node::Negate(what));
        self.add(Node::Boolean(Operation::Intersection, None, vec![from, complement]))
    }

    pub(crate) fn done(mut self) -> Graph {
        self.0.root = NodeId(self.0.nodes.len() as u32 - 1);
        self.0
    }
}

/// A scene's functions, checked in every way there is without a GPU.
pub(crate) struct Checked {
    pub(crate) module: naga::Module,
    pub(crate) parsed: naga::Module,
    pub(crate) bound: HashMap<&'static str, Vec<[f32; 4]>>,
    pub(crate) text: String,
    pub(crate) evaluator: Evaluator,
}

/// Splices into every template and validates the modules; prints, parses and validates the text.
pub(crate) fn checked(graph: &Graph, live: &[f32]) -> Checked {
    for template in Template::all() {
        let shader = splice(graph, template).unwrap_or_else(|error| panic!("{}", error.message));
        validate(&shader.module, "");
    }
    let shader = splice(graph, Template::Library).expect("it was spliced before");
    assert_eq!(shader.live_numbers, live.len());
    let text = wgsl(graph).unwrap_or_else(|error| panic!("{}", error.message));
    let parsed = naga::front::wgsl::parse_str(&text).unwrap_or_else(|error| panic!("{}", error.emit_to_string(&text)));
    validate(&parsed, &text);
    let quads = live.chunks(4).map(|quad| std::array::from_fn(|i| quad.get(i).copied().unwrap_or(0.0)));
    let bound = HashMap::from([("live", quads.collect()), ("tables", shader.tables.rows)]);
    let parameters: Vec<f64> = live.iter().copied().map(f64::from).collect();
    Checked { module: shader.module, parsed, bound, text, evaluator: Evaluator::new(graph, &parameters) }
}

pub(crate) fn validate(module: &naga::Module, text: &str) {
    let validated = Validator::new(ValidationFlags::all(), Capabilities::default()).validate(module);
    if let Err(error) = validated {
        panic!("{}\n{text}", error.emit_to_string(text));
    }
}

impl Checked {
    /// A function's value at a point, which the module and the text agree about.
    pub(crate) fn run(&self, function: &str, p: [f64; 3]) -> Vec<f64> {
        let run = |module| Machine { module, bound: self.bound.clone() }.run(function, vec![p.to_vec()]);
        let (emitted, printed) = (run(&self.module), run(&self.parsed));
        assert_eq!(emitted, printed, "{}", self.text);
        emitted
    }

    /// The distance, which the field's evaluator agrees about.
    pub(crate) fn distance(&self, p: [f64; 3]) -> f64 {
        let distance = self.run("scene_distance", p)[0];
        assert_close(distance, self.evaluator.distance(p));
        distance
    }

    /// Linear red, green and blue.
    pub(crate) fn color(&self, p: [f64; 3]) -> [f64; 3] {
        let surface = self.run("scene_surface", p);
        assert_eq!(surface.len(), 8);
        [surface[0], surface[1], surface[2]]
    }
}

/// Points of a cube about the origin that has an edge of 60.
pub(crate) fn random_points(count: u64) -> impl Iterator<Item = [f64; 3]> {
    let fraction = |i: u64, ratio: f64| (i as f64 * ratio).fract() * 60.0 - 30.0;
    (1..=count).map(move |i| [fraction(i, 0.8191725), fraction(i, 0.6710436), fraction(i, 0.5497005)])
}

#[track_caller]
pub(crate) fn assert_close(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-4 * expected.abs().max(1.0), "{found} is not {expected}");
}

pub(crate) const RED: [f64; 4] = [1.0, 0.0, 0.0, 1.0];
pub(crate) const GREEN: [f64; 4] = [0.0, 1.0, 0.0, 1.0];
