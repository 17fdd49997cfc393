//! Solids and plane shapes.
//!
//! The tree's laws:
//! * Lengths are in millimetres and angles in radians, except where a field says degrees.
//! * Every number is a [`Scalar`]: a constant, or live. What decides the tree's structure is constant.
//! * OpenSCAD's rules of empty operands have been applied: [`SolidKind::Empty`] occurs only as the root.
//! * Children of one operator have one dimension; plane shapes are below an extrusion, a revolution or the root.
//! * Of nested [`SolidKind::Paint`]s the outermost counts, as in OpenSCAD.
//! * Its depth is limited by the evaluator, so that it can be walked by recursion.

use std::sync::Arc;

use chiaro_plane::{Loft, Region};
use chiaro_syntax::Span;
use chiaro_vocabulary::Row;

use crate::affine::Affine;
use crate::scalar::Scalar;
use crate::scene::Material;

/// Whether something lies in the plane z = 0 or fills space.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Dimension {
    /// A plane shape.
    Plane,
    /// A solid.
    Space,
}

/// One node of the tree.
#[derive(Clone, Debug)]
pub struct Solid {
    /// What it is.
    pub kind: SolidKind,
    /// The text it came from: the head of a module's instance.
    pub span: Span,
    /// The heads of the instances that came to this very solid, the innermost first: a module or a loop with one solid
    /// in it, a move by nothing.
    pub via: Vec<Span>,
}

/// The kinds of solid.
#[derive(Clone, Debug)]
pub enum SolidKind {
    /// No point at all.
    Empty,
    /// A shape of the vocabulary's table ([`Kind::Solid`](chiaro_vocabulary::Kind::Solid) or `Plane`) with its
    /// flattened arguments, in the units of WGSL.
    Shape(&'static Row, Vec<Scalar>),
    /// A plane shape bounded by lines and arcs.
    Region(Arc<Region>),
    /// The convex hull of spheres (two or more): centres and radii.
    SphereHull(Vec<([Scalar; 3], Scalar)>),
    /// Several of them as one.
    Boolean {
        /// Which operation.
        operation: Boolean,
        /// How the operands' surfaces meet; sharp if there is none.
        joint: Option<Joint>,
        /// The operands, two or more; of a difference, the first is what the others are taken from.
        children: Vec<Arc<Solid>>,
    },
    /// Moved, turned, mirrored, scaled or sheared. The matrix is regular. Below it may be a plane shape; then the
    /// matrix keeps the plane.
    Transform(Affine, Arc<Solid>),
    /// Painted.
    Paint(Material, Arc<Solid>),
    /// Grown by a distance in every direction (shrunk, if negative).
    Offset(Scalar, Arc<Solid>),
    /// The wall of this thickness that lies half to each side of the surface.
    Shell(Scalar, Arc<Solid>),
    /// Turned about z in proportion to the height: radians per millimetre, anticlockwise seen from above.
    Twist(Scalar, Arc<Solid>),
    /// A plane shape drawn out along z.
    Extrude {
        /// From z = 0 to this height; positive.
        height: Scalar,
        /// How far the top is turned against the bottom, in radians, anticlockwise seen from above. (OpenSCAD's
        /// twist counts clockwise.)
        twist: Scalar,
        /// How the top is scaled against the bottom, along the fixed x and y after it has been turned; not negative.
        scale: [Scalar; 2],
        /// The plane shape.
        child: Arc<Solid>,
    },
    /// Stages between plane outlines at successive heights, with flat sides.
    Loft(Arc<Loft>),
    /// A plane shape turned about z: its x is the distance from the axis, its y the height. Only what lies at x ≥ 0
    /// is used; the evaluator has mirrored what lay at the other side.
    Revolve {
        /// Where the sweep starts and how far it goes, anticlockwise in radians; none for a full turn.
        sweep: Option<[Scalar; 2]>,
        /// The number of flat sides of a full turn that replace the circle, the first corner at angle 0; none for
        /// a true circle.
        facets: Option<u32>,
        /// The plane shape.
        child: Arc<Solid>,
    },
    /// The plane shape in which the plane z = 0 cuts a solid.
    Slice(Arc<Solid>),
}

/// The set operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Boolean {
    /// What is in any operand.
    Union,
    /// What is in the first and in no other.
    Difference,
    /// What is in all of them.
    Intersection,
}

/// How the surfaces of a Boolean's operands meet.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// The profile.
    pub profile: Profile,
    /// Its radius, in millimetres; positive.
    pub radius: Scalar,
}

/// The profile of a joint: the exponent p of the formula Σ max(0, 1 − (dᵢ − x)/r)ᵖ = 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Profile {
    /// p = 1: a straight edge at 45° between perpendicular faces.
    Chamfer,
    /// p = 2: the circle of the joint's radius between perpendicular faces.
    Fillet,
    /// p = 3: continuous in curvature.
    Smooth,
}

impl Solid {
    /// A node of that kind, written at `span`.
    pub fn new(kind: SolidKind, span: Span) -> Arc<Self> {
        Arc::new(Self { kind, span, via: Vec::new() })
    }

    /// The same, as what the instance with this head came to.
    pub fn seen_from(mut self: Arc<Self>, head: Span) -> Arc<Self> {
        if self.span != head && self.via.last() != Some(&head) {
            Arc::make_mut(&mut self).via.push(head);
        }
        self
    }

    /// Whether it is a plane shape or a solid; an empty one is neither.
    pub fn dimension(&self) -> Option<Dimension> {
        match &self.kind {
            SolidKind::Empty => None,
            SolidKind::Shape(row, _) if row.kind == chiaro_vocabulary::Kind::Plane => Some(Dimension::Plane),
            SolidKind::Region(_) | SolidKind::Slice(_) => Some(Dimension::Plane),
            SolidKind::Shape(..)
            | SolidKind::SphereHull(_)
            | SolidKind::Twist(..)
            | SolidKind::Extrude { .. }
            | SolidKind::Loft(_)
            | SolidKind::Revolve { .. } => Some(Dimension::Space),
            SolidKind::Boolean { children, .. } => children.first().and_then(|child| child.dimension()),
            SolidKind::Transform(_, child)
            | SolidKind::Paint(_, child)
            | SolidKind::Offset(_, child)
            | SolidKind::Shell(_, child) => child.dimension(),
        }
    }
}
