//! Field graphs built by hand.

use chiaro_field::{Facts, Graph, MaterialId, Node, NodeId, Operation, Point, PointId};
use chiaro_solid::{Affine, Joint, Material, Profile, Scalar};
use chiaro_syntax::{FileId, Span};
use chiaro_vocabulary::{Bounds, Class, row};

/// A graph in the making.
pub(crate) struct Builder(Graph);

impl Builder {
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

    pub(crate) fn add(&mut self, node: Node, bounds: Bounds) -> NodeId {
        self.0.nodes.push(node);
        self.0.facts.push(Facts { bounds, growth: f64::INFINITY, class: Class::Exact, lipschitz: 1.0 });
        self.0.spans.push(Span::new(FileId(0), 0..0));
        NodeId(self.0.nodes.len() as u32 - 1)
    }

    /// A shape of the vocabulary's table, moved by a vector.
    pub(crate) fn shape(&mut self, name: &str, arguments: &[Scalar], by: [f64; 3]) -> NodeId {
        let row = row(name).unwrap_or_else(|| panic!("no row {name}"));
        assert_eq!(row.arity(), arguments.len(), "{name}");
        for argument in arguments {
            if argument.constant().is_none() && !self.0.slots.contains(argument) {
                self.0.slots.push(argument.clone());
            }
        }
        let ranges: Vec<_> = arguments.iter().map(Scalar::range).collect();
        let mut bounds = (row.bounds)(&ranges);
        bounds.min = [0, 1, 2].map(|axis| bounds.min[axis] + by[axis]);
        bounds.max = [0, 1, 2].map(|axis| bounds.max[axis] + by[axis]);
        self.0.points.push(Point::Affine(Affine::translation(by.map(|x| Scalar::from(-x))), PointId(0)));
        let at = PointId(self.0.points.len() as u32 - 1);
        self.add(Node::Shape(row, arguments.to_vec(), at), bounds)
    }

    /// A shape with constant arguments.
    pub(crate) fn constant(&mut self, name: &str, arguments: &[f64], by: [f64; 3]) -> NodeId {
        let arguments: Vec<Scalar> = arguments.iter().copied().map(Scalar::from).collect();
        self.shape(name, &arguments, by)
    }

    pub(crate) fn painted(&mut self, color: [f64; 4], roughness: f64, metallic: f64, child: NodeId) -> NodeId {
        self.0.materials.push(Material {
            color: color.map(Scalar::from),
            roughness: Scalar::from(roughness),
            metallic: Scalar::from(metallic),
            emission: Scalar::ZERO,
        });
        let bounds = self.bounds(child);
        self.add(Node::Paint(MaterialId(self.0.materials.len() as u32 - 1), child), bounds)
    }

    pub(crate) fn union(&mut self, fillet: Option<f64>, children: Vec<NodeId>) -> NodeId {
        let sharp = children.iter().fold(Bounds::EMPTY, |all, &child| all.union(&self.bounds(child)));
        let bounds = sharp.inflate(0.3 * fillet.unwrap_or(0.0));
        let joint = fillet.map(|radius| Joint { profile: Profile::Fillet, radius: Scalar::from(radius) });
        self.add(Node::Boolean(Operation::Union, joint, children), bounds)
    }

    pub(crate) fn difference(&mut self, fillet: Option<f64>, from: NodeId, taken: Vec<NodeId>) -> NodeId {
        let bounds = self.bounds(from);
        let mut children = vec![from];
        children.extend(taken.into_iter().map(|child| self.add(Node::Negate(child), Bounds::ALL)));
        let joint = fillet.map(|radius| Joint { profile: Profile::Fillet, radius: Scalar::from(radius) });
        self.add(Node::Boolean(Operation::Intersection, joint, children), bounds)
    }

    /// The graph, its last node the root.
    pub(crate) fn done(mut self) -> Graph {
        self.0.root = NodeId(self.0.nodes.len() as u32 - 1);
        self.0
    }

    fn bounds(&self, node: NodeId) -> Bounds {
        self.0.facts[node.0 as usize].bounds
    }
}
