//! Graphs of every kind of node, emitted, validated, printed and parsed back.

use std::sync::Arc;

use chiaro_field::{Facts, Graph, MaterialId, Node, NodeId, Point, PointId, graph::Operation};
use chiaro_plane::Region;
use chiaro_shader::{Shader, Template, splice};
use chiaro_solid::{Affine, Joint, Material, ParameterId, Profile, Scalar};
use chiaro_syntax::Span;
use chiaro_vocabulary::{Bounds, Class, Interval, row};
use naga::valid::{Capabilities, ValidationFlags, Validator};

/// Builds graphs by hand.
struct Scene(Graph);

impl Scene {
    fn new() -> Self {
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

    fn add(&mut self, node: Node) -> NodeId {
        self.0.nodes.push(node);
        self.0.facts.push(Facts { bounds: Bounds::ALL, class: Class::Exact, lipschitz: 1.0 });
        NodeId(self.0.nodes.len() as u32 - 1)
    }

    fn at(&mut self, point: Point) -> PointId {
        self.0.points.push(point);
        PointId(self.0.points.len() as u32 - 1)
    }

    fn moved(&mut self, by: [f64; 3]) -> PointId {
        let map = Affine::translation(by.map(|component| Scalar::from(-component)));
        self.at(Point::Affine(map, PointId(0)))
    }

    fn shape(&mut self, name: &str, arguments: &[f64], at: PointId) -> NodeId {
        let row = row(name).unwrap_or_else(|| panic!("no row {name}"));
        assert_eq!(row.arity(), arguments.len(), "{name}");
        self.add(Node::Shape(row, arguments.iter().copied().map(Scalar::from).collect(), at))
    }

    fn painted(&mut self, color: [f64; 4], child: NodeId) -> NodeId {
        self.0.materials.push(Material::of_color(color.map(Scalar::from)));
        self.add(Node::Paint(MaterialId(self.0.materials.len() as u32 - 1), child))
    }

    fn union(&mut self, children: Vec<NodeId>) -> NodeId {
        self.add(Node::Boolean(Operation::Union, None, children))
    }

    fn done(mut self) -> Graph {
        self.0.root = NodeId(self.0.nodes.len() as u32 - 1);
        self.0
    }
}

/// Splices into every template and validates the modules; answers the library.
fn checked(graph: &Graph) -> Shader {
    for template in Template::ALL {
        let shader = splice(graph, template).unwrap_or_else(|error| panic!("{}", error.message));
        let validated = Validator::new(ValidationFlags::all(), Capabilities::default()).validate(&shader.module);
        if let Err(error) = validated {
            panic!("{template:?}: {}", error.emit_to_string(""));
        }
    }
    splice(graph, Template::Library).expect("it was spliced before")
}

#[test]
fn a_small_scene_validates() {
    let mut scene = Scene::new();
    let at = scene.moved([10.0, 0.0, 0.0]);
    let ball = scene.shape("sphere", &[5.0], at);
    let cube = scene.shape("box", &[5.0, 5.0, 5.0], PointId(0));
    let red = scene.painted([1.0, 0.0, 0.0, 1.0], ball);
    scene.union(vec![cube, red]);
    checked(&scene.done());
}

#[test]
fn text() {
    let mut scene = Scene::new();
    let at = scene.moved([10.0, 0.0, 0.0]);
    let ball = scene.shape("sphere", &[5.0], at);
    let cube = scene.shape("box", &[5.0, 5.0, 5.0], PointId(0));
    let red = scene.painted([1.0, 0.0, 0.0, 1.0], ball);
    scene.union(vec![cube, red]);
    println!("{}", chiaro_shader::wgsl(&scene.done()).unwrap());
}
