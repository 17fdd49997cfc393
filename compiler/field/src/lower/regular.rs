//! Regularised Booleans: the result where faces of operands coincide.
//!
//! Theory: A Boolean means the closure of the interior of what the sets come to (Requicha, "Representations for Rigid Solids",
//! 1980). The greatest of a and −b is 0 all over coincident faces, which is a skin without thickness. A face
//! that can't matter is therefore moved out of the way. A cut is A \ B = A \ (B ∪ Z), if Z has at most its surface in common
//! with A; so the face of a cutter that A doesn't cross is moved out of A. Operands of a joint that all lie within C and
//! have faces in it come to C ∩ (A′ ∪ᵣ B′), where those faces are moved out. Of a union A ∪ B = (A ∪ Z) ∪ B, if Z lies in
//! B; so a face that touches B's is moved into B, or else both are drawn out across it, and what they have in common then
//! joins them. And A \ B is A, and A ∩ B nothing, if a plane parts them.
//! Changes: The shape's row tells its faces and how they move; what has none (a surface that is bent, or turns with a live
//! number) stays as it is. A cut distributes over a union where that opens a face.
//! Practice: Comparing is linear in live numbers, so that equal heights are equal for all values. The tolerance is a
//! millionth of the size.

mod face;
mod grow;
mod linear;
mod outline;
mod place;
mod polytope;
mod separate;

use chiaro_solid::{Affine, Joint, Scalar};
use chiaro_syntax::{Diagnostic, Span};
use chiaro_vocabulary::rows;

use super::Lowering;
use super::context::Context;
use crate::graph::{Node, NodeId, Operation, Point, PointId};
use crate::hull::{Vec3, cross, dot, length, scale};
use face::{Face, MOST_HEIGHT};
use grow::{Grown, Move};
use separate::{Body, Query};

/// What is nearer than this part of the size touches.
const TOLERANCE: f64 = 1e-6;
/// How many pairs of operands are compared at the most: beyond, they stay as they are.
const MOST_PAIRS: usize = 40_000;
/// How many operands of a union are looked at for faces that touch.
const MOST_TOUCHING: usize = 48;
/// A face that can't be moved by as much as would be best is moved by this part of it, and so on.
const SHORTER: [f64; 4] = [1.0, 0.25, 0.0625, 0.015_625];

/// A face of a cutter that lies in one of what it cuts, and can't be moved.
struct Closed {
    cutter: NodeId,
    /// The part of the solid that has the face.
    solid: NodeId,
}

impl Lowering {
    /// What is left of a solid without cutters; none if it is better taken from each part of the solid.
    pub(super) fn cut(
        &mut self,
        solid: NodeId,
        cutters: Vec<NodeId>,
        joint: Option<&Joint>,
        context: &Context,
        span: Span,
    ) -> Option<NodeId> {
        if self.is_covered(solid, &cutters, context) {
            return None;
        }
        let reach = joint.map_or(0.0, |joint| joint.radius.range().max);
        let mut closed = Vec::new();
        let opened = self.opened(solid, &cutters, reach, context, &mut closed);
        if !closed.is_empty()
            && joint.is_none()
            && let Node::Boolean(Operation::Union, None, parts) = self.builder.get(solid).clone()
            && parts.len() * cutters.len() <= MOST_PAIRS
        {
            let mut still_closed = Vec::new();
            let each: Vec<Vec<NodeId>> =
                parts.iter().map(|part| self.opened(*part, &cutters, reach, context, &mut still_closed)).collect();
            if still_closed.len() < closed.len() {
                self.say_closed(&still_closed);
                return self.cut_apart(&parts, &each, span);
            }
        }
        self.say_closed(&closed);
        self.without(solid, opened, joint, span)
    }

    /// Whether a cutter leaves nothing of a solid.
    fn is_covered(&self, solid: NodeId, cutters: &[NodeId], context: &Context) -> bool {
        let tolerance = self.tolerance(solid, context.base);
        let query = Query { builder: &self.builder, frame: context.base, tolerance };
        let body = query.body(solid);
        let covers = |cutter: &NodeId| body.as_ref().is_some_and(|body| query.holds(*cutter, body));
        cutters.iter().any(|cutter| *cutter == solid || covers(cutter))
    }

    /// The union of parts, each without cutters of its own. Parts with the same cutters stay together.
    fn cut_apart(&mut self, parts: &[NodeId], cutters: &[Vec<NodeId>], span: Span) -> Option<NodeId> {
        let mut groups: Vec<(&[NodeId], Vec<NodeId>)> = Vec::new();
        for (part, own) in parts.iter().zip(cutters) {
            match groups.iter_mut().find(|(cutters, _)| cutters == own) {
                Some((_, members)) => members.push(*part),
                None => groups.push((own, vec![*part])),
            }
        }
        let mut pieces = Vec::with_capacity(groups.len());
        for (cutters, members) in groups {
            let together = self.union(members, None, span);
            pieces.extend(together.and_then(|solid| self.without(solid, cutters.to_vec(), None, span)));
        }
        self.union(pieces, None, span)
    }

    /// Cutters without those that only touch a solid, and with faces that the solid doesn't cross moved out of it.
    fn opened(
        &mut self,
        solid: NodeId,
        cutters: &[NodeId],
        reach: f64,
        context: &Context,
        closed: &mut Vec<Closed>,
    ) -> Vec<NodeId> {
        let tolerance = self.tolerance(solid, context.base);
        let query = Query { builder: &self.builder, frame: context.base, tolerance };
        let touches = |cutter: &NodeId| query.body(*cutter).is_none_or(|body| !query.is_apart(&body, solid));
        let kept: Vec<NodeId> = cutters.iter().copied().filter(touches).collect();
        kept.into_iter().map(|cutter| self.opened_cutter(solid, cutter, reach, tolerance, context, closed)).collect()
    }

    fn opened_cutter(
        &mut self,
        solid: NodeId,
        cutter: NodeId,
        reach: f64,
        tolerance: f64,
        context: &Context,
        closed: &mut Vec<Closed>,
    ) -> NodeId {
        let frame = context.base;
        let query = Query { builder: &self.builder, frame, tolerance };
        let Some(depth) = self.depth(cutter, frame) else { return cutter };
        let by = depth + reach;
        let mut faces: Vec<(Face, f64, bool)> = Vec::new();
        for face in query.faces(cutter).list {
            let gap = query.gap(solid, &face);
            let is_crossed = gap < -tolerance;
            let is_known = faces.iter().any(|(known, ..)| known.is(&face, tolerance));
            if gap < by && !is_known && (!is_crossed || !query.parts_with(solid, &face).is_empty()) {
                faces.push((face, gap, is_crossed));
            }
        }
        let mut opened = cutter;
        for (face, gap, is_crossed) in faces {
            match self.moved_out(opened, solid, &face, by, is_crossed, tolerance, frame) {
                Some(node) => opened = node,
                None if gap <= tolerance => {
                    let query = Query { builder: &self.builder, frame, tolerance };
                    let parts = query.parts_with(solid, &face);
                    closed.extend(
                        parts
                            .into_iter()
                            .filter(|part| query.share_area(*part, cutter, &face))
                            .map(|solid| Closed { cutter, solid }),
                    );
                }
                None => {}
            }
        }
        opened
    }

    /// A cutter with a face moved out of a solid, if what that adds keeps clear of the solid.
    #[expect(clippy::too_many_arguments, reason = "they are what a move is made of")]
    fn moved_out(
        &mut self,
        cutter: NodeId,
        solid: NodeId,
        face: &Face,
        by: f64,
        is_crossed: bool,
        tolerance: f64,
        frame: PointId,
    ) -> Option<NodeId> {
        for part in SHORTER {
            let Grown { node, added } = self.grown(cutter, Move { face, frame, by: part * by, tolerance })?;
            let query = Query { builder: &self.builder, frame, tolerance };
            let is_clear = |added: &NodeId| {
                query.body(*added).is_some_and(|body| query.is_apart(&body.beyond(face.clone()), solid))
            };
            if !is_crossed || added.iter().all(is_clear) {
                return Some(node);
            }
        }
        None
    }

    /// The operands of an intersection; none if a plane parts two of them, so that nothing is left.
    pub(super) fn meet(&mut self, operands: Vec<NodeId>, context: &Context) -> Option<Vec<NodeId>> {
        if operands.len() * operands.len() > MOST_PAIRS {
            return Some(operands);
        }
        let tolerance = operands.iter().map(|id| self.tolerance(*id, context.base)).fold(f64::INFINITY, f64::min);
        let query = Query { builder: &self.builder, frame: context.base, tolerance };
        let bodies: Vec<Option<Body>> = operands.iter().map(|id| query.body(*id)).collect();
        for (index, body) in bodies.iter().enumerate() {
            let Some(body) = body else { continue };
            let mut others = operands.iter().enumerate().filter(|(other, _)| *other != index);
            if others.any(|(_, other)| query.is_apart(body, *other)) {
                return None;
            }
        }
        Some(operands)
    }

    /// The joint of operands, whose common faces stay flat and sharp.
    pub(super) fn joined(
        &mut self,
        operation: Operation,
        operands: Vec<NodeId>,
        joint: Joint,
        context: &Context,
        span: Span,
    ) -> Option<NodeId> {
        let tolerance = operands.iter().map(|id| self.tolerance(*id, context.base)).fold(0.0, f64::max);
        let mut parts = operands;
        let mut caps = Vec::new();
        for face in self.common_faces(&parts, tolerance, context) {
            let size = parts.iter().map(|id| self.size(*id, context.base)).fold(0.0, f64::max);
            let way = Move { face: &face, frame: context.base, by: size + joint.radius.range().max, tolerance };
            let mut has_moved = false;
            for part in &mut parts {
                if let Some(grown) = self.grown(*part, way) {
                    *part = grown.node;
                    has_moved = true;
                }
            }
            if has_moved {
                caps.push(self.cap(&face, context, span));
            }
        }
        let joined = self.reduced(operation, Some(joint), parts, span)?;
        if caps.is_empty() {
            return Some(joined);
        }
        caps.insert(0, joined);
        self.intersection(caps, None, span)
    }

    /// The faces that two operands or more have in common and none crosses.
    fn common_faces(&self, operands: &[NodeId], tolerance: f64, context: &Context) -> Vec<Face> {
        let query = Query { builder: &self.builder, frame: context.base, tolerance };
        if operands.len() * operands.len() > MOST_PAIRS {
            return Vec::new();
        }
        let mut common: Vec<Face> = Vec::new();
        for face in operands.iter().flat_map(|operand| query.faces(*operand).list) {
            if common.iter().any(|known| known.is(&face, tolerance)) {
                continue;
            }
            let gaps: Vec<f64> = operands.iter().map(|operand| query.gap(*operand, &face)).collect();
            let touching = gaps.iter().filter(|gap| gap.abs() <= tolerance).count();
            if touching > 1 && gaps.iter().all(|gap| *gap >= -tolerance) {
                common.push(face);
            }
        }
        common
    }

    /// The operands of a union, with faces that touch another operand moved into it, or with a bridge across them. Those
    /// that become equal are one.
    pub(super) fn merged(&mut self, operands: Vec<NodeId>, context: &Context, span: Span) -> Vec<NodeId> {
        if operands.len() > MOST_TOUCHING {
            return operands;
        }
        let frame = context.base;
        let mut parts = operands.clone();
        let mut bridges = Vec::new();
        for (i, j) in (0..operands.len()).flat_map(|j| (0..j).map(move |i| (i, j))) {
            let pair = [operands[i], operands[j]];
            if !self.look_alike(pair) {
                continue;
            }
            let tolerance = pair.map(|id| self.tolerance(id, frame)).into_iter().fold(f64::INFINITY, f64::min);
            for face in self.touching_faces(pair, tolerance, frame) {
                let back = face.flipped();
                let forth = self.moved_into(parts[i], pair[1], &face, tolerance, frame);
                let back_moved = self.moved_into(parts[j], pair[0], &back, tolerance, frame);
                if forth.is_none() && back_moved.is_none() {
                    bridges.extend(self.bridge(pair, &face, tolerance, frame, span));
                }
                parts[i] = forth.unwrap_or(parts[i]);
                parts[j] = back_moved.unwrap_or(parts[j]);
            }
        }
        let mut distinct: Vec<NodeId> = Vec::with_capacity(parts.len());
        parts.into_iter().chain(bridges).for_each(|part| {
            if !distinct.contains(&part) {
                distinct.push(part);
            }
        });
        distinct
    }

    /// Whether it can't be seen which of two nodes a surface is of.
    fn look_alike(&self, pair: [NodeId; 2]) -> bool {
        match pair.map(|id| self.builder.get(id)) {
            [Node::Paint(a, _), Node::Paint(b, _)] => a == b,
            [Node::Paint(..), _] | [_, Node::Paint(..)] => false,
            _ => true,
        }
    }

    /// The faces of the first node that touch one of the second from outside.
    fn touching_faces(&self, [node, other]: [NodeId; 2], tolerance: f64, frame: PointId) -> Vec<Face> {
        let query = Query { builder: &self.builder, frame, tolerance };
        let near = |id: NodeId| self.builder.extent_at(id, frame).bounds.inflate(tolerance);
        if near(node).intersection(&near(other)).is_empty() {
            return Vec::new();
        }
        let against = query.faces(other).list;
        let is_touching = |face: &Face| {
            against.iter().any(|other| other.flipped().is(face, tolerance)) && query.share_area(node, other, face)
        };
        let mut touching: Vec<Face> = Vec::new();
        for face in query.faces(node).list {
            if is_touching(&face) && !touching.iter().any(|known| known.is(&face, tolerance)) {
                touching.push(face);
            }
        }
        touching
    }

    /// A node with a face that touches another node moved into that, as far as it reaches; none if it would come out
    /// elsewhere.
    fn moved_into(
        &mut self,
        node: NodeId,
        other: NodeId,
        face: &Face,
        tolerance: f64,
        frame: PointId,
    ) -> Option<NodeId> {
        let query = Query { builder: &self.builder, frame, tolerance };
        let depth = match face {
            Face::Round { radius, is_hollow: true, .. } => radius.range().min,
            _ => -query.gap(other, face),
        };
        if !(depth.is_finite() && depth > tolerance) {
            return None;
        }
        for part in SHORTER {
            let grown = self.grown(node, Move { face, frame, by: part * depth, tolerance })?;
            let query = Query { builder: &self.builder, frame, tolerance };
            let is_held = |added: &NodeId| query.body(*added).is_some_and(|body| query.holds(other, &body));
            if grown.added.iter().all(is_held) {
                return Some(grown.node);
            }
        }
        None
    }

    /// What lies to both sides of where two nodes touch, within both of them: what both come to have in common when both
    /// are drawn out across the face.
    fn bridge(&mut self, pair: [NodeId; 2], face: &Face, tolerance: f64, frame: PointId, span: Span) -> Option<NodeId> {
        let by = self.depth(pair[0], frame)?.min(self.depth(pair[1], frame)?);
        let forth = self.grown(pair[0], Move { face, frame, by, tolerance })?;
        let back = self.grown(pair[1], Move { face: &face.flipped(), frame, by, tolerance })?;
        self.intersection(vec![forth.node, back.node], None, span)
    }

    /// The inner side of a face as a node.
    fn cap(&mut self, face: &Face, context: &Context, span: Span) -> NodeId {
        let frame = context.base;
        let class = context.best;
        let shape = match face {
            Face::Flat { normal, offset } if self.builder.dimension(frame) == 2 => {
                // The half plane above the x axis of a point that is turned to the face.
                let [x, y, _] = *normal;
                let map = [[-y, -x, 0.0], [x, -y, 0.0], [0.0, 0.0, 1.0]];
                let at = normal.map(|part| Scalar::from(part) * offset.number());
                let point = self.placed(map, at, frame);
                let arguments = [0.0, std::f64::consts::PI].map(Scalar::from).to_vec();
                Node::Shape(&rows::WEDGE, arguments, point)
            }
            Face::Flat { normal, offset } => {
                let [x, y, z] = normal.map(Scalar::from);
                Node::Shape(&rows::HALF_SPACE, vec![x, y, z, offset.number()], frame)
            }
            Face::Round { center, axis, radius, .. } => {
                let at = center.each_ref().map(|coordinate| coordinate.number());
                let axis = axis.unwrap_or([0.0, 0.0, 1.0]);
                let point = self.placed(turn_to(axis), at, frame);
                self.round_cap(face, vec![radius.number()], point, frame)
            }
        };
        let cap = self.builder.node(shape, span, class, context.slope);
        match face {
            Face::Round { is_hollow: true, .. } => self.complement(cap, span),
            _ => cap,
        }
    }

    fn round_cap(&mut self, face: &Face, radius: Vec<Scalar>, point: PointId, frame: PointId) -> Node {
        if matches!(face, Face::Round { axis: None, .. }) {
            return Node::Shape(&rows::SPHERE, radius, point);
        }
        let slice = match self.builder.dimension(frame) {
            2 => point,
            _ => self.builder.point(Point::Warp(&rows::SLICE, Vec::new(), point)),
        };
        Node::Shape(&rows::CIRCLE, radius, slice)
    }

    /// A point that is turned and moved from a frame.
    fn placed(&mut self, turn: [Vec3; 3], at: [Scalar; 3], frame: PointId) -> PointId {
        let linear = Affine::constant(turn.map(|[x, y, z]| [x, y, z, 0.0]));
        let forward = Affine::translation(at).after(&linear);
        self.point_at(frame, &forward, false)
    }

    fn size(&self, node: NodeId, frame: PointId) -> f64 {
        let mut bounds = self.builder.extent_at(node, frame).bounds;
        if self.builder.dimension(frame) == 2 {
            (bounds.min[2], bounds.max[2]) = (0.0, 0.0);
        }
        if bounds.is_finite() { bounds.diagonal() } else { 1.0 }
    }

    /// As deep as a point of a face can be within a node: half a ball of that radius fits into the boxes of its shapes. It
    /// is the same however the node is turned, so that equal parts stay equal.
    fn depth(&self, node: NodeId, frame: PointId) -> Option<f64> {
        let within = |point: PointId| {
            let dimension = self.builder.dimension(point);
            let mut sizes = self.builder.extent_at(node, point).bounds.size()[..dimension].to_vec();
            sizes.sort_by(f64::total_cmp);
            Some(sizes[0].min(0.5 * sizes[1])).filter(|depth| depth.is_finite() && *depth > 0.0)
        };
        if self.builder.height(node) > MOST_HEIGHT {
            return within(frame);
        }
        match self.builder.get(node) {
            Node::Paint(_, child) => self.depth(*child, frame),
            Node::Boolean(operation, _, children) => {
                let positive = children.iter().filter(|child| !matches!(self.builder.get(**child), Node::Negate(_)));
                let depths = positive.filter_map(|child| self.depth(*child, frame));
                match operation {
                    Operation::Union => depths.reduce(f64::max),
                    Operation::Intersection => depths.reduce(f64::min),
                }
            }
            Node::Adjust(row, arguments, child) if **row == rows::OFFSET => {
                Some(self.depth(*child, frame)? + arguments[0].range().max.max(0.0))
            }
            Node::Shape(_, _, point) | Node::Outline(_, point) | Node::Polytope(_, point) => within(*point),
            Node::Extrude(_, _, point) => within(*point),
            _ => within(frame),
        }
    }

    fn tolerance(&self, node: NodeId, frame: PointId) -> f64 {
        TOLERANCE * self.size(node, frame)
    }

    fn say_closed(&mut self, closed: &[Closed]) {
        for Closed { cutter, solid } in closed {
            let (cutter, solid) = (self.builder.span(*cutter), self.builder.span(*solid));
            let message = "a face of what is taken away lies in a face of what it is taken from";
            let diagnostic = Diagnostic::warning(cutter, message)
                .with_related(solid, "the other face is of this")
                .with_hint("it is drawn right, but slowly: let what is taken away stand out by a little");
            self.say(diagnostic);
        }
    }
}

/// A turn that takes the z axis to a direction.
fn turn_to(axis: Vec3) -> [Vec3; 3] {
    let aside = if axis[2].abs() < 0.9 { [0.0, 0.0, 1.0] } else { [1.0, 0.0, 0.0] };
    let across = cross(aside, axis);
    let x = scale(across, 1.0 / length(across));
    let y = cross(axis, x);
    debug_assert!((dot(x, y)).abs() < 1e-9);
    std::array::from_fn(|i| [x[i], y[i], axis[i]])
}
