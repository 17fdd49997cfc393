//! A scene painted by what its distances are.

use chiaro_field::{Class, Graph, MaterialId, Node, NodeId, Operation};
use chiaro_solid::{Material, Scalar};

/// The same field, painted: red, green or blue where distances are exact, exact outside, or bounds; the emission is the
/// greatest slope of anything in it. Near an operand of hard unions the field is that operand's, so each is painted as a
/// whole.
pub(super) fn painted(graph: &Graph) -> Graph {
    let mut painter = Painter { graph: graph.clone(), steepest: steepest(graph) };
    painter.graph.materials.clear();
    painter.graph.root = painter.painted(graph.root);
    painter.graph
}

struct Painter {
    graph: Graph,
    /// For each node of the graph as it was, the greatest slope of it and what is in it.
    steepest: Vec<f64>,
}

impl Painter {
    fn painted(&mut self, id: NodeId) -> NodeId {
        match self.graph.nodes[id.0 as usize].clone() {
            Node::Boolean(Operation::Union, None, operands) => {
                let operands = operands.into_iter().map(|operand| self.painted(operand)).collect();
                self.add(Node::Boolean(Operation::Union, None, operands), id)
            }
            Node::Paint(_, child) => self.painted(child),
            _ => {
                let class = self.graph.facts[id.0 as usize].class;
                let is = |of: Class| Scalar::from(f64::from(u8::from(class == of)));
                self.graph.materials.push(Material {
                    color: [is(Class::Exact), is(Class::ExactOutside), is(Class::Bound), Scalar::ONE],
                    emission: Scalar::from(self.steepest[id.0 as usize]),
                    ..Material::default()
                });
                let material = MaterialId(self.graph.materials.len() as u32 - 1);
                self.add(Node::Paint(material, id), id)
            }
        }
    }

    /// A node about which the same is known as about another.
    fn add(&mut self, node: Node, like: NodeId) -> NodeId {
        let Graph { nodes, facts, spans, .. } = &mut self.graph;
        nodes.push(node);
        facts.push(facts[like.0 as usize]);
        spans.push(spans[like.0 as usize]);
        NodeId(nodes.len() as u32 - 1)
    }
}

fn steepest(graph: &Graph) -> Vec<f64> {
    let mut steepest: Vec<f64> = Vec::with_capacity(graph.nodes.len());
    for (node, facts) in graph.nodes.iter().zip(&graph.facts) {
        // Below a taper, slopes are not by the world.
        let below = if matches!(node, Node::Taper(..)) { &[] } else { node.children() };
        let inner = below.iter().map(|child| steepest[child.0 as usize]).fold(facts.lipschitz, f64::max);
        steepest.push(inner);
    }
    steepest
}
