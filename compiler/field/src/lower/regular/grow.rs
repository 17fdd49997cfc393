//! Nodes with a face moved outwards.

use std::sync::Arc;

use chiaro_solid::{Affine, Scalar};
use chiaro_vocabulary::form::{Flat, Growth, Round};
use chiaro_vocabulary::{Class, Row, rows};

use super::super::Lowering;
use super::face::{Face, MOST_HEIGHT, is_rounding, weighted};
use super::linear::Linear;
use super::outline;
use super::place::{Map, Place, SAME};
use super::polytope;
use crate::graph::{Node, NodeId, Operation, Point, PointId};
use crate::hull::{Vec3, scale};

/// What is left of a face's thickness at the least when it is moved inwards.
const MOST_SHRINKING: f64 = 0.5;

/// A node with a face moved.
pub(super) struct Grown {
    pub(super) node: NodeId,
    /// Nodes that hold what was added (of what is taken away, by moving a face of its complement inwards).
    pub(super) added: Vec<NodeId>,
}

/// A face that is to be moved, in the coordinates of a frame.
#[derive(Clone, Copy)]
pub(super) struct Move<'a> {
    pub(super) face: &'a Face,
    pub(super) frame: PointId,
    /// How far out of the solid; negative for inwards.
    pub(super) by: f64,
    /// How near to the face a node's own has to be to be moved.
    pub(super) tolerance: f64,
}

impl Lowering {
    /// The node with all its faces that lie in a face moved out of the solid; none if none does that can be moved.
    pub(super) fn grown(&mut self, node: NodeId, way: Move) -> Option<Grown> {
        if self.builder.height(node) > MOST_HEIGHT {
            return None;
        }
        let (span, facts) = (self.builder.span(node), *self.builder.facts(node));
        match self.builder.get(node).clone() {
            Node::Paint(material, child) => {
                let Grown { node, added } = self.grown(child, way)?;
                let node = self.builder.node(Node::Paint(material, node), span, facts.class, facts.lipschitz);
                Some(Grown { node, added })
            }
            Node::Negate(child) => {
                let face = way.face.flipped();
                let Grown { node, added } = self.grown(child, Move { face: &face, by: -way.by, ..way })?;
                let node = self.builder.node(Node::Negate(node), span, facts.class, facts.lipschitz);
                Some(Grown { node, added })
            }
            Node::Boolean(operation, joint, children) => {
                let grown: Vec<Option<Grown>> = children.iter().map(|child| self.grown(*child, way)).collect();
                let parts: Vec<NodeId> = grown
                    .iter()
                    .zip(&children)
                    .map(|(grown, child)| grown.as_ref().map_or(*child, |g| g.node))
                    .collect();
                let mut added = Vec::new();
                for (index, grown) in grown.into_iter().enumerate() {
                    for node in grown.into_iter().flat_map(|grown| grown.added) {
                        added.push(if operation == Operation::Union { node } else { self.within(node, &parts, index) });
                    }
                }
                if added.is_empty() {
                    return None;
                }
                let whole = Node::Boolean(operation, joint, parts);
                let node = self.builder.node(whole, span, facts.class, facts.lipschitz);
                Some(Grown { node, added })
            }
            Node::Extrude(height, child, point) => self.grown_extrusion((&height, child, point), node, way),
            Node::Adjust(row, arguments, child) if is_rounding(row, &arguments) => {
                self.grown_rounding(&arguments[0], child, node, way)
            }
            leaf => self.grown_leaf(&leaf, node, way),
        }
    }

    /// What has round edges, with the flat part of a face moved: together with what is within, drawn out through that part.
    fn grown_rounding(&mut self, by: &Scalar, child: NodeId, node: NodeId, way: Move) -> Option<Grown> {
        let face = way.face.moved(&Linear::from(by).times(-1.0))?;
        if way.by < 0.0 {
            return None;
        }
        let inner = Move { face: &face, by: way.by + by.range().max, ..way };
        let Grown { node: within, added } = self.grown(child, inner)?;
        let (span, facts) = (self.builder.span(node), *self.builder.facts(node));
        let lipschitz = facts.lipschitz.max(self.builder.facts(within).lipschitz);
        let whole = Node::Boolean(Operation::Union, None, vec![node, within]);
        Some(Grown { node: self.builder.node(whole, span, Class::Bound, lipschitz), added })
    }

    /// What was added to one operand of an intersection, within the others that have an end.
    fn within(&mut self, added: NodeId, operands: &[NodeId], index: usize) -> NodeId {
        let others = operands.iter().enumerate().filter(|(other, _)| *other != index).map(|(_, id)| *id);
        let others = others.filter(|id| !matches!(self.builder.get(*id), Node::Negate(_)));
        let parts: Vec<NodeId> = std::iter::once(added).chain(others).collect();
        if parts.len() < 2 {
            return added;
        }
        let (span, facts) = (self.builder.span(added), *self.builder.facts(added));
        self.builder.node(Node::Boolean(Operation::Intersection, None, parts), span, Class::Bound, facts.lipschitz)
    }

    fn grown_extrusion(
        &mut self,
        (height, child, point): (&Scalar, NodeId, PointId),
        node: NodeId,
        way: Move,
    ) -> Option<Grown> {
        let (span, facts) = (self.builder.span(node), *self.builder.facts(node));
        let Place { map, turned: None } = Place::of(&self.builder, point, way.frame)? else { return None };
        let (face, factor) = below(way.face, &map)?;
        let by = way.by * factor;
        let extruded = |lowering: &mut Self, height: Scalar, child: NodeId, point: PointId| {
            lowering.builder.node(Node::Extrude(height, child, point), span, facts.class, facts.lipschitz)
        };
        if let Face::Flat { normal: [_, _, up], offset } = &face
            && up.abs() > 1.0 - SAME
        {
            let end = if *up > 0.0 { Linear::from(height) } else { Linear::from(0.0) };
            if end.plus(offset, -1.0).range().magnitude() > way.tolerance * factor {
                return None;
            }
            let by = by.max(-MOST_SHRINKING * height.range().min);
            let taller = height.clone() + Scalar::from(by);
            let from = |lowering: &mut Self, z: Scalar| lowering.shifted(point, [Scalar::ZERO, Scalar::ZERO, z]);
            // The plane shape is asked at the old point: only the height counts from another.
            let (whole, slab) = if *up > 0.0 {
                let slab = if by > 0.0 { height.clone() } else { taller.clone() };
                (point, from(self, slab))
            } else {
                (from(self, Scalar::from(-by)), from(self, Scalar::from(-by.max(0.0))))
            };
            let added = extruded(self, Scalar::from(by.abs()), child, slab);
            return Some(Grown { node: extruded(self, taller, child, whole), added: vec![added] });
        }
        let beside = Move { face: &face, frame: point, by, tolerance: way.tolerance * factor };
        let grown = self.grown(child, beside)?;
        let added = grown.added.into_iter().map(|added| extruded(self, height.clone(), added, point)).collect();
        Some(Grown { node: extruded(self, height.clone(), grown.node, point), added })
    }

    fn grown_leaf(&mut self, leaf: &Node, node: NodeId, way: Move) -> Option<Grown> {
        let point = match leaf {
            Node::Shape(_, _, point) | Node::Outline(_, point) | Node::Polytope(_, point) => *point,
            _ => return None,
        };
        let place = Place::of(&self.builder, point, way.frame)?;
        let (mut face, mut factor) = (way.face.clone(), 1.0);
        if let Some(turned) = &place.turned {
            let (of_solid, stretch) = below(&face, &turned.map)?;
            face = profile_face(&of_solid, turned.facets, way.tolerance)?;
            factor *= stretch;
        }
        let (face, stretch) = below(&face, &place.map)?;
        factor *= stretch;
        let local = Local { face: &face, by: way.by * factor, tolerance: way.tolerance * factor };
        match leaf {
            Node::Shape(row, arguments, _) => self.grown_shape(row, arguments, point, node, &local),
            Node::Outline(region, _) => {
                let [whole, added] = local.outline(region)?;
                Some(
                    self.replaced(node, [Node::Outline(Arc::new(whole), point), Node::Outline(Arc::new(added), point)]),
                )
            }
            Node::Polytope(triangles, _) => {
                let [whole, added] = local.polytope(triangles)?;
                Some(self.replaced(node, [Node::Polytope(whole, point), Node::Polytope(added, point)]))
            }
            _ => None,
        }
    }

    fn grown_shape(
        &mut self,
        row: &'static Row,
        arguments: &[Scalar],
        point: PointId,
        node: NodeId,
        local: &Local,
    ) -> Option<Grown> {
        if *row == rows::HALF_SPACE {
            let [x, y, z, offset] = arguments else { return None };
            let normal = [x.constant()?, y.constant()?, z.constant()?];
            local.is_at(normal, &Linear::from(offset)).then_some(())?;
            let moved = vec![x.clone(), y.clone(), z.clone(), offset.clone() + Scalar::from(local.by)];
            let whole = Node::Shape(row, moved, point);
            return Some(self.replaced(node, [whole.clone(), whole]));
        }
        if let Some(triangles) = polytope::of_shape(row, arguments) {
            let [whole, added] = local.polytope(&triangles)?;
            return Some(self.replaced(node, [Node::Polytope(whole, point), Node::Polytope(added, point)]));
        }
        if let Some(region) = outline::of_shape(row, arguments) {
            let [whole, added] = local.outline(&region)?;
            return Some(
                self.replaced(node, [Node::Outline(Arc::new(whole), point), Node::Outline(Arc::new(added), point)]),
            );
        }
        if let Some(round) = row.form.rounds.iter().find(|round| local.is_round(round, arguments)) {
            let radius = weighted(round.radius, arguments);
            // A hollow that is filled stays one.
            let most = if round.is_hollow { MOST_SHRINKING * radius.range().min } else { f64::INFINITY };
            let whole = moved(arguments, round.growth, local.by.min(most), &radius)?;
            let whole = Node::Shape(row, whole.arguments, point);
            let added = if round.is_hollow {
                Node::Shape(&rows::CIRCLE, vec![radius.number()], point)
            } else if local.by > 0.0 {
                whole.clone()
            } else {
                Node::Shape(row, arguments.to_vec(), point)
            };
            return Some(self.replaced(node, [whole, added]));
        }
        let flat = row.form.flats.iter().find(|flat| local.is_at(flat.normal, &weighted(flat.offset, arguments)))?;
        self.grown_flat(row, arguments, point, node, (flat, local.by))
    }

    /// A shape with one of its flat faces moved.
    fn grown_flat(
        &mut self,
        row: &'static Row,
        arguments: &[Scalar],
        point: PointId,
        node: NodeId,
        (flat, by): (&Flat, f64),
    ) -> Option<Grown> {
        let offset = weighted(flat.offset, arguments);
        let moved = moved(arguments, flat.growth?, by, &offset)?;
        let along = |lengths: Scalar| flat.normal.map(|part| Scalar::from(part) * lengths.clone());
        let at = self.shifted(point, along(Scalar::from(moved.shift)));
        let whole = Node::Shape(row, moved.arguments, at);
        let added = match flat.growth {
            // Where growing by a length is adding half of it to half a size, what is added is as thick as the length.
            Some(Growth::Argument { index, factor: 0.5, .. }) => {
                let mut slab = arguments.to_vec();
                let half = std::mem::replace(&mut slab[index], Scalar::from(0.5 * moved.by.abs()));
                let middle = half + Scalar::from(0.5 * moved.by);
                let at = self.shifted(point, along(middle));
                Node::Shape(row, slab, at)
            }
            _ if by > 0.0 => whole.clone(),
            _ => self.builder.get(node).clone(),
        };
        Some(self.replaced(node, [whole, added]))
    }

    /// A node and what is added to it, of the same class and span as another.
    fn replaced(&mut self, node: NodeId, [whole, added]: [Node; 2]) -> Grown {
        let (span, facts) = (self.builder.span(node), *self.builder.facts(node));
        let [whole, added] = [whole, added].map(|node| self.builder.node(node, span, facts.class, facts.lipschitz));
        Grown { node: whole, added: vec![added] }
    }

    /// The point at which something is asked that stands so much farther along a point's axes.
    fn shifted(&mut self, point: PointId, by: [Scalar; 3]) -> PointId {
        let shift = Affine::translation(by);
        let (parent, forward) = match self.builder.get_point(point) {
            Point::Affine(undone, parent) => {
                let forward = self.builder.forward(point).cloned().unwrap_or_else(|| undone.inverse());
                (*parent, forward.after(&shift))
            }
            _ => (point, shift),
        };
        self.point_at(parent, &forward, false)
    }
}

/// A face that is to be moved, where a shape is asked.
struct Local<'a> {
    face: &'a Face,
    by: f64,
    tolerance: f64,
}

impl Local<'_> {
    fn is_at(&self, normal: Vec3, offset: &Linear) -> bool {
        let face = Face::Flat { normal, offset: offset.clone() };
        face.is(self.face, self.tolerance)
    }

    fn is_round(&self, round: &Round, arguments: &[Scalar]) -> bool {
        let face = Face::Round {
            center: Default::default(),
            axis: (!round.is_sphere).then_some([0.0, 0.0, 1.0]),
            radius: weighted(round.radius, arguments),
            is_hollow: round.is_hollow,
        };
        face.is(self.face, self.tolerance)
    }

    /// The face's normal and its constant offset.
    fn plane(&self) -> Option<(Vec3, f64)> {
        let Face::Flat { normal, offset } = self.face else { return None };
        let range = offset.range();
        range.is_point().then_some((*normal, range.min))
    }

    fn outline(&self, region: &chiaro_plane::Region) -> Option<[chiaro_plane::Region; 2]> {
        let ([x, y, z], offset) = self.plane()?;
        if z.abs() > SAME || self.by < 0.0 {
            return None;
        }
        outline::grown(region, [x, y], offset, self.by, self.tolerance)
    }

    fn polytope(&self, triangles: &[[Vec3; 3]]) -> Option<[polytope::Triangles; 2]> {
        let (normal, offset) = self.plane()?;
        polytope::grown(triangles, normal, offset, self.by, self.tolerance)
    }
}

/// A shape's arguments when a face has moved, how far the shape has along that face's normal, and how far the face has.
struct Moved {
    arguments: Vec<Scalar>,
    shift: f64,
    by: f64,
}

fn moved(arguments: &[Scalar], growth: Growth, by: f64, offset: &Linear) -> Option<Moved> {
    match growth {
        Growth::Argument { index, factor, shift } => {
            // A face that moves inwards stops before it meets the opposite one, or the centre.
            let by = if by < 0.0 { by.max(-MOST_SHRINKING * offset.range().min.max(0.0)) } else { by };
            if by == 0.0 {
                return None;
            }
            let mut arguments = arguments.to_vec();
            arguments[index] = arguments[index].clone() + Scalar::from(factor * by);
            Some(Moved { arguments, shift: shift * by, by })
        }
        Growth::Constant(grow) => {
            let constants: Vec<f64> = arguments.iter().map(Scalar::constant).collect::<Option<_>>()?;
            let (arguments, shift) = grow(&constants, by)?;
            Some(Moved { arguments: arguments.into_iter().map(Scalar::from).collect(), shift, by })
        }
    }
}

/// A face of the frame in the coordinates that a map takes there, and what lengths across it are multiplied by.
fn below(face: &Face, map: &Map) -> Option<(Face, f64)> {
    match face {
        Face::Flat { normal, offset } => {
            let (normal, offset, factor) = map.plane_below(*normal, offset);
            Some((Face::Flat { normal, offset }, factor))
        }
        Face::Round { center, axis, radius, is_hollow } => {
            let factor = map.factor()?;
            let face = Face::Round {
                center: map.point_below(center, factor),
                axis: axis.map(|axis| scale(map.direction_below(axis), 1.0 / factor)),
                radius: radius.times(1.0 / factor),
                is_hollow: *is_hollow,
            };
            Some((face, 1.0 / factor))
        }
    }
}

/// The edge of a profile that is turned to a face.
fn profile_face(face: &Face, facets: bool, tolerance: f64) -> Option<Face> {
    match face {
        Face::Flat { normal, offset } if normal[2].abs() > 1.0 - SAME => {
            Some(Face::Flat { normal: [0.0, normal[2].signum(), 0.0], offset: offset.clone() })
        }
        Face::Round { center, axis: Some(axis), radius, is_hollow } if !facets && axis[2].abs() > 1.0 - SAME => {
            let is_central = (0..2).all(|i| center[i].range().magnitude() <= tolerance);
            let sign = if *is_hollow { -1.0 } else { 1.0 };
            is_central.then(|| Face::Flat { normal: [sign, 0.0, 0.0], offset: radius.times(sign) })
        }
        _ => None,
    }
}
