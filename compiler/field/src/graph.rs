//! The field graph: what is to be computed to answer the distance from a point to the scene.
//!
//! The graph's laws:
//! * It is a DAG: nodes and points stand behind those they refer to, and no two are equal (hash-consing).
//! * Points are functions of the point that is asked about; nodes are distances, in millimetres of the world. (Only
//!   what stands directly below an adjustment by `scale` or a [`Node::Taper`] is in other units.)
//! * A point is a plane point if it is a section of a point, or a map or confinement of a plane point. Plane shapes
//!   are asked at plane points, all else at space points.
//! * A node's facts hold for every value of the live parameters within their ranges.
//! * Numbers are [`Scalar`]s. The distinct live ones are the graph's *slots*: whoever evaluates the graph computes
//!   each slot once and then treats it as a constant.
//! * A Boolean has two children or more, in the order of the text. Nested hard unions are one; so are hard
//!   intersections.

use std::sync::Arc;

use chiaro_plane::{Loft, Region};
use chiaro_solid::{Affine, Joint, Material, Scalar};
use chiaro_syntax::Span;
use chiaro_vocabulary::{Kind, Row};

use crate::facts::Facts;

/// The number of a [`Point`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PointId(pub u32);

/// The number of a [`Node`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(pub u32);

/// The number of a [`Material`] of the graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct MaterialId(pub u32);

/// Where a shape is asked.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
#[expect(clippy::large_enum_variant, reason = "nearly all points are maps")]
pub enum Point {
    /// The point that the scene is asked about, with three coordinates. Always point 0.
    World,
    /// A point mapped by a matrix, local from parent. Maps of maps are fused, but for those of several shapes that move together
    /// with live numbers. It never makes lengths longer. At a
    /// plane point, the upper left 2 × 2 entries and the last column's first two count.
    Affine(Affine, PointId),
    /// A point mapped by a warp (to three coordinates) or a section (to two) with its flattened arguments.
    Warp(&'static Row, Vec<Scalar>, PointId),
    /// A space or plane point with its x and y moved into the disc of this radius about the origin.
    Confined(Scalar, PointId),
    /// A space or plane point as the space point with the same x and y and z = 0.
    Flattened(PointId),
}

/// A distance.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// Farther than anything: there is nothing. Only as the root.
    Nothing,
    /// A shape of the table with its flattened arguments.
    Shape(&'static Row, Vec<Scalar>, PointId),
    /// A plane shape bounded by lines and arcs.
    Outline(Arc<Region>, PointId),
    /// The distance, within its level, to the section of stages with flat sides: at a space point.
    Loft(Arc<Loft>, PointId),
    /// A convex polytope, by the triangles of its surface, anticlockwise seen from outside.
    Polytope(Arc<[[[f64; 3]; 3]]>, PointId),
    /// The least (of a union) or greatest (of an intersection) of the children, or their joint.
    Boolean(Operation, Option<Joint>, Vec<NodeId>),
    /// The complement.
    Negate(NodeId),
    /// A distance changed by an adjustment of the table with its flattened arguments.
    Adjust(&'static Row, Vec<Scalar>, NodeId),
    /// A plane shape's distance drawn out from z = 0 to a height, at the point whose z counts.
    Extrude(Scalar, NodeId, PointId),
    /// A distance asked at the [extrude](chiaro_vocabulary::rows::EXTRUDE) section of a point: times the lesser of the
    /// two scales at that point's height, which makes it a distance at that point. The height and scale of the top,
    /// as that section has them, and the point.
    Taper(Scalar, [Scalar; 2], NodeId, PointId),
    /// A distance asked at the confined point, joined with the gap from there to the unconfined one: the radius of
    /// confinement, the Lipschitz constant of the distance within, and the unconfined point.
    Confine(Scalar, f64, NodeId, PointId),
    /// The same distance; its surface has this material.
    Paint(MaterialId, NodeId),
}

/// The operations of [`Node::Boolean`]. A difference is an intersection with complements.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "the names say it")]
pub enum Operation {
    Union,
    Intersection,
}

/// A scene's field.
#[derive(Clone, Debug)]
pub struct Graph {
    /// The points; the first is [`Point::World`].
    pub points: Vec<Point>,
    /// The nodes.
    pub nodes: Vec<Node>,
    /// What is known of each node.
    pub facts: Vec<Facts>,
    /// The text each node came from.
    pub spans: Vec<Span>,
    /// The node that is the whole scene.
    pub root: NodeId,
    /// The materials that [`Node::Paint`] refers to.
    pub materials: Vec<Material>,
    /// The distinct live numbers in points, nodes and materials.
    pub slots: Vec<Scalar>,
}

impl Graph {
    /// How many coordinates a point has: two, if it is a plane point, or else three.
    pub fn dimension(&self, id: PointId) -> usize {
        dimension(&self.points, id)
    }

    /// Whether it is the same field, from whichever places of the text: then the shaders of one serve the other.
    pub fn is_same_field(&self, other: &Graph) -> bool {
        let Self { points, nodes, facts, spans: _, root, materials, slots } = self;
        *root == other.root
            && *points == other.points
            && *nodes == other.nodes
            && *facts == other.facts
            && *materials == other.materials
            && *slots == other.slots
    }
}

/// How many coordinates one of some points has.
pub(crate) fn dimension(points: &[Point], id: PointId) -> usize {
    match &points[id.0 as usize] {
        Point::World | Point::Flattened(_) => 3,
        Point::Affine(_, from) | Point::Confined(_, from) => dimension(points, *from),
        Point::Warp(row, ..) if row.kind == Kind::Section => 2,
        Point::Warp(..) => 3,
    }
}
