//! What no field may have: numbers that are none, and places too far away. Whoever asks the field, be it a shader, a mesh
//! or a single distance, relies on this.

use chiaro_solid::Scalar;
use chiaro_syntax::Diagnostic;

use crate::graph::{Graph, Node, NodeId};
use crate::walk::material_scalars;

/// How far from the origin a scene may reach, in millimetres: to nothing it is as far, and the square of that is still
/// a number in a shader's precision.
const FARTHEST: f64 = 1e15;

/// Why nothing can be made of the graph, if so.
pub(crate) fn unfit(graph: &Graph) -> Option<Diagnostic> {
    odd_number(graph).or_else(|| remote(graph))
}

/// Says which node depends on a number that is not finite, or may not be.
fn odd_number(graph: &Graph) -> Option<Diagnostic> {
    // The odd number of each point or of those it is computed from: points stand behind those.
    let mut of_points: Vec<Option<&Scalar>> = Vec::with_capacity(graph.points.len());
    for point in &graph.points {
        let mut odd = point.parent().and_then(|parent| of_points[parent.0 as usize]);
        point.visit_scalars(|number| note(&mut odd, number));
        of_points.push(odd);
    }
    graph.nodes.iter().enumerate().find_map(|(index, node)| {
        let mut odd = node.point().and_then(|point| of_points[point.0 as usize]);
        node.visit_scalars(|number| note(&mut odd, number));
        if let Node::Paint(material, _) = node {
            material_scalars(&graph.materials[material.0 as usize]).for_each(|number| note(&mut odd, number));
        }
        odd.map(|number| not_finite(graph, NodeId(index as u32), number))
    })
}

fn note<'g>(odd: &mut Option<&'g Scalar>, number: &'g Scalar) {
    if odd.is_none() && !number.is_finite() {
        *odd = Some(number);
    }
}

fn not_finite(graph: &Graph, node: NodeId, number: &Scalar) -> Diagnostic {
    let span = graph.spans.get(node.0 as usize).copied();
    match number.constant() {
        Some(value) => {
            let is = if value.is_nan() { "is not a number" } else { "is infinite" };
            Diagnostic::error(span, format!("a measure of this {is}"))
                .with_hint("sizes, places and matrices have to be finite; no number comes of 0 / 0, and none of 1 / 0")
        }
        None => Diagnostic::error(span, "a measure of this may not be finite for all values of the parameters")
            .with_hint("keep the parameters within smaller ranges"),
    }
}

/// Says which node may be farther away than numbers have room for.
fn remote(graph: &Graph) -> Option<Diagnostic> {
    let is_remote = |c: &f64| c.is_finite() && c.abs() > FARTHEST;
    let remote = graph.facts.iter().position(|facts| facts.bounds.min.iter().chain(&facts.bounds.max).any(is_remote));
    remote.map(|remote| {
        let message = format!("this reaches farther than {FARTHEST:e} mm, for which numbers have no room");
        Diagnostic::error(graph.spans.get(remote).copied(), message).with_hint("scale the scene down")
    })
}
