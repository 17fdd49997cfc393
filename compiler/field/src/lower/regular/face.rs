//! The faces that bound a node, and discs whose hull holds it.

use chiaro_plane::{Edge, Region};
use chiaro_solid::Scalar;
use chiaro_vocabulary::form::{Disc as FormDisc, Round, Weights};
use chiaro_vocabulary::{Form, Row, rows};

use super::linear::Linear;
use super::outline;
use super::place::{Map, Place, SAME, Turned};
use super::polytope;
use crate::build::Builder;
use crate::graph::{Node, NodeId, Operation, PointId};
use crate::hull::{Vec3, dot, scale};

/// Of nodes that are nested deeper than this nothing but the box is known: recursion ends there.
pub(super) const MOST_HEIGHT: u32 = 48;

/// The inner side of a face, in the coordinates of a frame.
#[derive(Clone, Debug)]
pub(super) enum Face {
    /// What lies below a plane: dot(p, normal) ≤ offset, the normal of length 1.
    Flat { normal: Vec3, offset: Linear },
    /// What lies within a radius of a line, or of a point where there is no axis; or outside of that, if it is hollow.
    Round { center: [Linear; 3], axis: Option<Vec3>, radius: Linear, is_hollow: bool },
}

/// The faces of a node.
#[derive(Debug, Default)]
pub(super) struct Faces {
    pub(super) list: Vec<Face>,
    /// Whether the node is what lies within all of them.
    pub(super) are_whole: bool,
}

/// A disc grown by a ball, in the coordinates of a frame.
#[derive(Clone, Debug)]
pub(super) struct Disc {
    pub(super) center: [Linear; 3],
    /// The direction across it.
    pub(super) axis: Vec3,
    pub(super) radius: Linear,
    pub(super) ball: Linear,
}

impl Face {
    /// The other side of a plane.
    pub(super) fn flipped(&self) -> Face {
        match self {
            Face::Flat { normal, offset } => Face::Flat { normal: scale(*normal, -1.0), offset: offset.times(-1.0) },
            Face::Round { center, axis, radius, is_hollow } => {
                Face::Round { center: center.clone(), axis: *axis, radius: radius.clone(), is_hollow: !is_hollow }
            }
        }
    }

    /// A flat face moved out by a length.
    pub(super) fn moved(&self, by: &Linear) -> Option<Face> {
        let Face::Flat { normal, offset } = self else { return None };
        Some(Face::Flat { normal: *normal, offset: offset.clone().plus(by, 1.0) })
    }

    /// Whether two faces coincide, to a tolerance, and bound the same side.
    pub(super) fn is(&self, other: &Face, tolerance: f64) -> bool {
        let near = |a: &Linear, b: &Linear| a.clone().plus(b, -1.0).range().magnitude() <= tolerance;
        match (self, other) {
            (Face::Flat { normal, offset }, Face::Flat { normal: other, offset: by }) => {
                dot(*normal, *other) > 1.0 - SAME && near(offset, by)
            }
            (
                Face::Round { center, axis, radius, is_hollow },
                Face::Round { center: other, axis: along, radius: by, is_hollow: hollow },
            ) => {
                let same_axis = match (axis, along) {
                    (None, None) => true,
                    (Some(axis), Some(along)) => dot(*axis, *along).abs() > 1.0 - SAME,
                    _ => false,
                };
                let apart: [Linear; 3] = std::array::from_fn(|i| other[i].clone().plus(&center[i], -1.0));
                let (across, along) = offsets(&apart, axis.unwrap_or([0.0, 0.0, 1.0]));
                let apart = if axis.is_some() { across } else { across.hypot(along) };
                is_hollow == hollow && same_axis && near(radius, by) && apart <= tolerance
            }
            _ => false,
        }
    }

    /// How far a disc keeps from the face at the least, whatever values the live numbers take: negative if it crosses it.
    pub(super) fn gap(&self, disc: &Disc) -> f64 {
        match self {
            Face::Flat { normal, offset } => {
                let cosine = dot(*normal, disc.axis);
                let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
                let sine = if sine < SAME.sqrt() { 0.0 } else { sine };
                let center = (0..3).fold(offset.clone(), |gap, i| gap.plus(&disc.center[i], -normal[i]));
                center.plus(&disc.ball, -1.0).plus(&disc.radius, -sine).range().min
            }
            Face::Round { is_hollow: true, .. } => f64::NEG_INFINITY,
            Face::Round { center, axis, radius, .. } => {
                let apart: [Linear; 3] = std::array::from_fn(|i| disc.center[i].clone().plus(&center[i], -1.0));
                let room = radius.clone().plus(&disc.ball, -1.0);
                match axis {
                    Some(axis) => {
                        let (across, _) = offsets(&apart, *axis);
                        room.plus(&disc.radius, -1.0).range().min - across
                    }
                    None => {
                        let (across, along) = offsets(&apart, disc.axis);
                        let rim = across + disc.radius.range().magnitude();
                        if rim == 0.0 { room.range().min - along } else { room.range().min - rim.hypot(along) }
                    }
                }
            }
        }
    }
}

/// The most that a vector reaches across a direction, and along it.
fn offsets(vector: &[Linear; 3], axis: Vec3) -> (f64, f64) {
    let along = (0..3).fold(Linear::default(), |sum, i| sum.plus(&vector[i], axis[i]));
    let across = (0..3).map(|i| vector[i].clone().plus(&along, -axis[i]).range().magnitude());
    (across.map(|part| part * part).sum::<f64>().sqrt(), along.range().magnitude())
}

/// The faces of a node in the coordinates of a frame. What is not known is left out.
pub(super) fn faces(builder: &Builder, node: NodeId, frame: PointId) -> Faces {
    if builder.height(node) > MOST_HEIGHT {
        return Faces::default();
    }
    match builder.get(node) {
        Node::Paint(_, child) => faces(builder, *child, frame),
        Node::Negate(child) => {
            let list = faces(builder, *child, frame).list.iter().map(Face::flipped).collect();
            Faces { list, are_whole: false }
        }
        Node::Boolean(operation, joint, children) => {
            let parts: Vec<Faces> = children.iter().map(|child| faces(builder, *child, frame)).collect();
            let are_whole =
                *operation == Operation::Intersection && joint.is_none() && parts.iter().all(|faces| faces.are_whole);
            Faces { list: parts.into_iter().flat_map(|faces| faces.list).collect(), are_whole }
        }
        Node::Extrude(height, child, point) => {
            let Some(Place { map, turned: None }) = Place::of(builder, *point, frame) else { return Faces::default() };
            let Faces { mut list, are_whole } = faces(builder, *child, *point);
            list.push(Face::Flat { normal: [0.0, 0.0, 1.0], offset: Linear::from(height) });
            list.push(Face::Flat { normal: [0.0, 0.0, -1.0], offset: Linear::from(0.0) });
            placed(Faces { list, are_whole }, &map)
        }
        Node::Adjust(row, arguments, child) if is_rounding(row, arguments) => {
            let by = Linear::from(&arguments[0]);
            let flats = faces(builder, *child, frame).list.into_iter().filter_map(|face| face.moved(&by));
            Faces { list: flats.collect(), are_whole: false }
        }
        leaf => {
            let Some((point, local)) = leaf_faces(leaf) else { return Faces::default() };
            match Place::of(builder, point, frame) {
                Some(Place { map, turned: None }) => placed(local, &map),
                Some(Place { map, turned: Some(turned) }) => {
                    let profile = leaf_discs(leaf).map(|(_, discs)| discs).unwrap_or_default();
                    let profile: Option<Vec<Disc>> = profile.iter().map(|disc| placed_disc(disc, &map)).collect();
                    turned_faces(placed(local, &map), &profile.unwrap_or_default(), &turned)
                }
                None => Faces::default(),
            }
        }
    }
}

/// Whether an adjustment grows what is below it, and so rounds its edges.
pub(super) fn is_rounding(row: &Row, arguments: &[Scalar]) -> bool {
    *row == rows::OFFSET && arguments.first().is_some_and(|by| by.range().min > 0.0)
}

/// The faces of a shape where it is asked, and that point.
fn leaf_faces(leaf: &Node) -> Option<(PointId, Faces)> {
    match leaf {
        Node::Shape(row, arguments, point) => {
            let faces = match (**row == rows::HALF_SPACE, polytope::of_shape(row, arguments)) {
                (true, _) => half_space(arguments)?,
                (false, Some(triangles)) => polytope::faces(&triangles),
                (false, None) => match outline::of_shape(row, arguments) {
                    Some(region) => outline::faces(&region),
                    None => form_faces(row.form, arguments),
                },
            };
            Some((*point, faces))
        }
        Node::Outline(region, point) => Some((*point, outline::faces(region))),
        Node::Polytope(triangles, point) => Some((*point, polytope::faces(triangles))),
        _ => None,
    }
}

fn half_space(arguments: &[Scalar]) -> Option<Faces> {
    let [x, y, z, offset] = arguments else { return None };
    let normal = [x.constant()?, y.constant()?, z.constant()?];
    Some(Faces { list: vec![Face::Flat { normal, offset: Linear::from(offset) }], are_whole: true })
}

fn form_faces(form: &Form, arguments: &[Scalar]) -> Faces {
    let flats =
        form.flats.iter().map(|flat| Face::Flat { normal: flat.normal, offset: weighted(flat.offset, arguments) });
    let rounds = form.rounds.iter().map(|round| round_face(round, arguments));
    Faces { list: flats.chain(rounds).collect(), are_whole: form.is_whole }
}

fn round_face(round: &Round, arguments: &[Scalar]) -> Face {
    Face::Round {
        center: Default::default(),
        axis: (!round.is_sphere).then_some([0.0, 0.0, 1.0]),
        radius: weighted(round.radius, arguments),
        is_hollow: round.is_hollow,
    }
}

pub(super) fn weighted(weights: Weights, arguments: &[Scalar]) -> Linear {
    let terms = weights.iter();
    terms.fold(Linear::default(), |sum, (index, weight)| sum.plus(&Linear::from(&arguments[*index]), *weight))
}

/// Faces under a map. Round ones remain so only if all lengths are stretched alike.
fn placed(faces: Faces, map: &Map) -> Faces {
    let mut all_known = faces.are_whole;
    let mut list = Vec::with_capacity(faces.list.len());
    for face in faces.list {
        match (face, map.factor()) {
            (Face::Flat { normal, offset }, _) => {
                let (normal, offset, _) = map.plane(normal, &offset);
                list.push(Face::Flat { normal, offset });
            }
            (Face::Round { center, axis, radius, is_hollow }, Some(factor)) => list.push(Face::Round {
                center: map.point(&center),
                axis: axis.map(|axis| scale(map.direction(axis), 1.0 / factor)),
                radius: radius.times(factor),
                is_hollow,
            }),
            (Face::Round { .. }, None) => all_known = false,
        }
    }
    Faces { list, are_whole: all_known }
}

/// The faces of a profile's edges across and along the axis that it is turned about; of those that face the axis, only the
/// innermost.
fn turned_faces(profile: Faces, discs: &[Disc], turned: &Turned) -> Faces {
    let mut are_whole = profile.are_whole;
    let mut list = Vec::new();
    let is_innermost = |face: &Face| !discs.is_empty() && discs.iter().all(|disc| face.gap(disc) >= -SAME);
    for face in profile.list {
        if matches!(&face, Face::Flat { normal: [x, ..], .. } if *x < -SAME) && !is_innermost(&face) {
            are_whole = false;
            continue;
        }
        let turned_face = match face {
            Face::Flat { normal: [x, y, _], offset } if x.abs() < SAME => {
                Some(Face::Flat { normal: [0.0, 0.0, y.signum()], offset })
            }
            Face::Flat { normal: [x, y, _], offset } if y.abs() < SAME && !turned.facets => {
                // The radius of an inner side is the offset of a plane that faces the axis.
                let is_hollow = x < 0.0;
                let radius = offset.times(x.signum());
                // The axis itself is no face.
                (radius.range().max > 0.0).then(|| Face::Round {
                    center: Default::default(),
                    axis: Some([0.0, 0.0, 1.0]),
                    radius,
                    is_hollow,
                })
            }
            _ => {
                are_whole = false;
                None
            }
        };
        are_whole &= !matches!(&turned_face, Some(Face::Round { is_hollow: true, .. }));
        list.extend(turned_face);
    }
    placed(Faces { list, are_whole }, &turned.map)
}

/// Discs whose hull holds a node, in the coordinates of a frame; the corners of its box, if nothing better is known; none if
/// it has no end.
pub(super) fn discs(builder: &Builder, node: NodeId, frame: PointId) -> Option<Vec<Disc>> {
    known_discs(builder, node, frame).or_else(|| box_corners(builder, node, frame))
}

fn known_discs(builder: &Builder, node: NodeId, frame: PointId) -> Option<Vec<Disc>> {
    if builder.height(node) > MOST_HEIGHT {
        return None;
    }
    match builder.get(node) {
        Node::Paint(_, child) => known_discs(builder, *child, frame),
        Node::Boolean(Operation::Union, None, children) => {
            let mut all = Vec::new();
            for child in children {
                all.extend(discs(builder, *child, frame)?);
            }
            Some(all)
        }
        Node::Boolean(Operation::Intersection, _, children) => {
            let base = children.iter().find(|child| !matches!(builder.get(**child), Node::Negate(_)))?;
            known_discs(builder, *base, frame)
        }
        Node::Adjust(row, arguments, child) if **row == rows::OFFSET => {
            let by = Linear::from(arguments.first()?);
            // Only where the distance outside is known is a point grown by it no farther off.
            if by.range().min < 0.0 || builder.facts(*child).class > chiaro_vocabulary::Class::ExactOutside {
                return None;
            }
            let discs = known_discs(builder, *child, frame)?;
            Some(discs.into_iter().map(|disc| Disc { ball: disc.ball.plus(&by, 1.0), ..disc }).collect())
        }
        Node::Extrude(height, child, point) => {
            let Place { map, turned: None } = Place::of(builder, *point, frame)? else { return None };
            let flat = known_discs(builder, *child, *point)?;
            let top = flat.iter().cloned().map(|mut disc| {
                disc.center[2] = Linear::from(height);
                disc
            });
            // A ball of the plane is a disc.
            let levels = flat.iter().cloned().chain(top).map(|disc| Disc {
                radius: disc.radius.plus(&disc.ball, 1.0),
                ball: Linear::default(),
                ..disc
            });
            levels.map(|disc| placed_disc(&disc, &map)).collect()
        }
        leaf => {
            let (point, local) = leaf_discs(leaf)?;
            match Place::of(builder, point, frame)? {
                Place { map, turned: None } => local.iter().map(|disc| placed_disc(disc, &map)).collect(),
                Place { map, turned: Some(turned) } => {
                    let profile: Option<Vec<Disc>> = local.iter().map(|disc| placed_disc(disc, &map)).collect();
                    let rings: Option<Vec<Disc>> = profile?.iter().map(ring).collect();
                    rings?.iter().map(|disc| placed_disc(disc, &turned.map)).collect()
                }
            }
        }
    }
}

/// What a disc of the half plane of radius and height comes to when it is turned about z.
fn ring(disc: &Disc) -> Option<Disc> {
    let radius = match disc.center[0].range() {
        range if range.min >= 0.0 => disc.center[0].clone(),
        range => Linear::from(range.magnitude()),
    };
    let [_, height, _] = &disc.center;
    Some(Disc {
        center: [Linear::default(), Linear::default(), height.clone()],
        axis: [0.0, 0.0, 1.0],
        radius,
        ball: disc.radius.clone().plus(&disc.ball, 1.0),
    })
}

fn placed_disc(disc: &Disc, map: &Map) -> Option<Disc> {
    let is_point = |length: &Linear| length.range().magnitude() == 0.0;
    let factor = match map.factor() {
        Some(factor) => factor,
        None if is_point(&disc.radius) && is_point(&disc.ball) => 1.0,
        None => return None,
    };
    Some(Disc {
        center: map.point(&disc.center),
        axis: scale(map.direction(disc.axis), 1.0 / factor),
        radius: disc.radius.times(factor),
        ball: disc.ball.times(factor),
    })
}

fn leaf_discs(leaf: &Node) -> Option<(PointId, Vec<Disc>)> {
    match leaf {
        Node::Shape(row, arguments, point) => Some((*point, shape_discs(row, arguments)?)),
        Node::Outline(region, point) => Some((*point, outline_discs(region))),
        Node::Polytope(triangles, point) => {
            Some((*point, triangles.iter().flatten().map(|corner| point_disc(*corner)).collect()))
        }
        _ => None,
    }
}

fn shape_discs(row: &Row, arguments: &[Scalar]) -> Option<Vec<Disc>> {
    if let Some(region) = outline::of_shape(row, arguments) {
        return Some(outline_discs(&region));
    }
    let placed = |disc: &FormDisc| Disc {
        center: disc.center.map(|weights| weighted(weights, arguments)),
        axis: [0.0, 0.0, 1.0],
        radius: weighted(disc.radius, arguments),
        ball: weighted(disc.ball, arguments),
    };
    (!row.form.discs.is_empty()).then(|| row.form.discs.iter().map(placed).collect())
}

/// The corners of polygons around an outline.
fn outline_discs(region: &Region) -> Vec<Disc> {
    region.edges().flat_map(around_edge).map(|[x, y]| point_disc([x, y, 0.0])).collect()
}

/// Corners around an edge: of an arc, those of tangents that touch it where it crosses the axes and in between.
fn around_edge(edge: &Edge) -> Vec<[f64; 2]> {
    const PIECES: f64 = 24.0;
    let Edge::Arc { center, radius, start, sweep } = *edge else { return vec![edge.start(), edge.end()] };
    let quarter = std::f64::consts::TAU / PIECES;
    let (from, to) = if sweep < 0.0 { (start + sweep, start) } else { (start, start + sweep) };
    let mut touched = vec![from];
    let first = (from / quarter).ceil() as i64;
    touched.extend((first..).map(|k| k as f64 * quarter).take_while(|angle| *angle < to));
    touched.push(to);
    let mut corners = vec![edge.start(), edge.end()];
    for pair in touched.windows(2) {
        let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
        let reach = radius / half.cos();
        corners.push([center[0] + reach * middle.cos(), center[1] + reach * middle.sin()]);
    }
    corners
}

pub(super) fn point_disc(point: Vec3) -> Disc {
    let nothing = Linear::default;
    Disc { center: point.map(Linear::from), axis: [0.0, 0.0, 1.0], radius: nothing(), ball: nothing() }
}

fn box_corners(builder: &Builder, node: NodeId, frame: PointId) -> Option<Vec<Disc>> {
    let mut bounds = builder.extent_at(node, frame).bounds;
    if builder.dimension(frame) == 2 {
        (bounds.min[2], bounds.max[2]) = (0.0, 0.0);
    }
    if !bounds.is_finite() || bounds.is_empty() {
        return None;
    }
    let corner = |k: usize| std::array::from_fn(|i| if k >> i & 1 == 0 { bounds.min[i] } else { bounds.max[i] });
    Some((0..8).map(|k| point_disc(corner(k))).collect())
}
