//! Who painted what.

use chiaro_solid::{Material, Scalar};
use rustc_hash::FxHashMap;

use crate::graph::{Graph, Node, NodeId, Operation};

/// The number of a material, equal ones counted once.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PaintId(pub usize);

impl PaintId {
    /// What nobody painted.
    pub const UNPAINTED: PaintId = PaintId(0);
}

/// Who painted a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Painted {
    /// Nobody: it looks as its surroundings say.
    Nobody,
    /// All of it has one material.
    Once(PaintId),
    /// Several materials.
    Variously,
}

/// The materials of a scene.
#[derive(Clone, Debug)]
pub struct Paints {
    materials: Vec<Material>,
    /// Who painted each node.
    painted: Vec<Painted>,
}

impl Paints {
    /// The materials of a graph.
    pub fn new(graph: &Graph) -> Self {
        let mut materials = vec![Material::default()];
        let mut known = FxHashMap::default();
        let paints: Vec<PaintId> = (graph.materials.iter())
            .map(|material| {
                *known.entry(numbers(material)).or_insert_with(|| {
                    materials.push(material.clone());
                    PaintId(materials.len() - 1)
                })
            })
            .collect();
        let mut painted: Vec<Painted> = Vec::with_capacity(graph.nodes.len());
        for node in &graph.nodes {
            let of_node = match node {
                Node::Paint(material, _) => Painted::Once(paints[material.0 as usize]),
                Node::Boolean(operation, _, children) => painted_together(graph, &painted, *operation, children),
                _ => node.children().first().map_or(Painted::Nobody, |child| painted[child.0 as usize]),
            };
            painted.push(of_node);
        }
        Self { materials, painted }
    }

    /// The material of a paint.
    pub fn material(&self, paint: PaintId) -> &Material {
        &self.materials[paint.0]
    }

    /// All materials, by the numbers of their paints.
    pub fn materials(&self) -> &[Material] {
        &self.materials
    }

    /// Who painted the node.
    pub fn painted(&self, id: NodeId) -> Painted {
        self.painted[id.0 as usize]
    }
}

/// Everything a material consists of, to compare it by.
fn numbers(material: &Material) -> [Scalar; 7] {
    let Material { color: [red, green, blue, opacity], roughness, metallic, emission } = material.clone();
    [red, green, blue, opacity, roughness, metallic, emission]
}

/// Who painted a Boolean. What is cut away counts as painted like what it is cut from, unless it is painted itself.
fn painted_together(graph: &Graph, painted: &[Painted], operation: Operation, children: &[NodeId]) -> Painted {
    let mut cut = Painted::Nobody;
    let mut together = None;
    for child in children {
        let mut own = painted[child.0 as usize];
        if is_cut(graph, operation, *child) {
            own = if own == Painted::Nobody { cut } else { own };
        } else {
            cut = own;
        }
        together = match together {
            None => Some(own),
            Some(same) if same == own => together,
            Some(_) => Some(Painted::Variously),
        };
    }
    together.unwrap_or(Painted::Nobody)
}

/// Whether the child of such a Boolean takes something away.
pub fn is_cut(graph: &Graph, operation: Operation, child: NodeId) -> bool {
    operation == Operation::Intersection && matches!(graph.nodes[child.0 as usize], Node::Negate(_))
}
