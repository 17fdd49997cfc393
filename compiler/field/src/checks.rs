//! What no field may have: numbers that are none, and places too far away. Shaders, meshes and single distances
//! rely on this.

use chiaro_solid::Scalar;
use chiaro_syntax::Diagnostic;

use crate::graph::{Graph, Node, NodeId};
use crate::walk::material_scalars;

/// How far from the origin a scene may reach, in millimetres: to nothing it is as far, and the square of that is still
/// a number in a shader's precision.
const FARTHEST: f64 = 1e15;

/// More than this part of a scene's size may not be lost where numbers are rounded to single precision.
const FINEST: f64 = 1.0 / 2000.0;

/// Why nothing can be made of the graph, as an error; or why that will look crude, as a warning.
pub(crate) fn remark(graph: &Graph) -> Option<Diagnostic> {
    odd_number(graph).or_else(|| remote(graph)).or_else(|| blurred(graph))
}

/// Says which node depends on a number that is not finite, or may not be.
fn odd_number(graph: &Graph) -> Option<Diagnostic> {
    // The odd number of each point or of those it is computed from: points come after those.
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

/// Says that a scene is so far from the origin that pictures of it are rough.
fn blurred(graph: &Graph) -> Option<Diagnostic> {
    let root = graph.root.0 as usize;
    let bounds = graph.facts.get(root)?.bounds;
    let extents = (0..3).map(|axis| bounds.axis(axis)).filter(|extent| extent.is_finite());
    let (size, far) = extents
        .fold((0f64, 0f64), |(size, far), extent| (size.max(extent.max - extent.min), far.max(extent.magnitude())));
    let rounding = far * f64::from(f32::EPSILON);
    if bounds.is_empty() || rounding <= FINEST * size {
        return None;
    }
    let message =
        format!("this is {size:.3e} mm large, but {far:.3e} mm from the origin: pictures of it will be rough");
    let warning = Diagnostic::warning(graph.spans.get(root).copied(), message)
        .with_label(format!("there, numbers of single precision are {rounding:.1e} mm apart"));
    Some(warning.with_hint("move the scene nearer to the origin"))
}
