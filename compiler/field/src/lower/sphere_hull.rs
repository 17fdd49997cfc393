//! Convex hulls of spheres.

use std::f64::consts::TAU;
use std::sync::Arc;

use chiaro_plane::{Contour, Region};
use chiaro_solid::scalar::Function;
use chiaro_solid::{Affine, Scalar};
use chiaro_syntax::{Diagnostic, Span};
use chiaro_vocabulary::{Class, rows};

use super::Lowering;
use super::context::{Context, Place};
use super::shape::class_at;
use crate::graph::{Node, NodeId, Point};
use crate::hull::{self, Hull, Vec3, add, cross, dot, hull, length, scale, sub};

/// More spheres of different radii than this are refused: finding their edges takes the third power of the number.
const MOST_UNEQUAL: usize = 200;

/// Spheres whose centres are nearer than this, in millimetres, count as concentric.
const LEAST_APART: f64 = 1e-9;

/// A sphere of constant numbers.
type Sphere = (Vec3, f64);

impl Lowering {
    /// The convex hull of spheres: of two, a round cone; of equal ones, the grown hull of their centres; of others,
    /// the round cones along its edges and the polytope between its flat parts.
    pub(super) fn sphere_hull(
        &mut self,
        spheres: &[([Scalar; 3], Scalar)],
        context: &Context,
        span: Span,
    ) -> Option<NodeId> {
        let below = self.settled(context);
        if let [one, other] = spheres {
            return Some(self.round_cone(one, other, &below, span));
        }
        let constant =
            |centre: &[Scalar; 3]| Some([centre[0].constant()?, centre[1].constant()?, centre[2].constant()?]);
        let centres: Option<Vec<Vec3>> = spheres.iter().map(|(centre, _)| constant(centre)).collect();
        let Some(centres) = centres else {
            let message = "the centres of three or more hulled spheres have to be constant";
            self.say(Diagnostic::error(span, message).with_hint("make the live number in it structural"));
            return None;
        };
        if spheres.iter().all(|(_, radius)| *radius == spheres[0].1) {
            return self.grown_hull(&centres, &spheres[0].1, &below, span);
        }
        let radii: Option<Vec<f64>> = spheres.iter().map(|(_, radius)| radius.constant()).collect();
        match radii {
            Some(radii) if radii.len() <= MOST_UNEQUAL => {
                let spheres: Vec<Sphere> = centres.into_iter().zip(radii).collect();
                self.unequal_hull(&spheres, &below, span)
            }
            Some(_) => {
                let message = format!("a hull takes at most {MOST_UNEQUAL} spheres of different radii");
                self.say(Diagnostic::error(span, message));
                None
            }
            None => {
                let message = "the radii of three or more hulled spheres have to be constant or all the same";
                self.say(Diagnostic::error(span, message).with_hint("make the live number in it structural"));
                None
            }
        }
    }

    fn round_cone(
        &mut self,
        (from, bottom): &([Scalar; 3], Scalar),
        (to, top): &([Scalar; 3], Scalar),
        context: &Context,
        span: Span,
    ) -> NodeId {
        let along = [0, 1, 2].map(|i| to[i].clone() - from[i].clone());
        let squares = along.iter().map(|component| component.clone() * component.clone());
        let apart = squares.fold(Scalar::ZERO, |sum, square| sum + square).sqrt();
        let height = apart.clone().max(Scalar::from(LEAST_APART));
        // Of concentric spheres any direction will do.
        let concentric = Scalar::apply(Function::Less, vec![apart, height.clone()]);
        let mut axis = [Scalar::ZERO, Scalar::ZERO, Scalar::ONE].into_iter();
        let direction = along.map(|component| {
            let upwards = axis.next().unwrap_or(Scalar::ZERO);
            Scalar::apply(Function::Select, vec![concentric.clone(), upwards, component / height.clone()])
        });
        let here = self.derive(context, |here| here.since = upright_to(direction, from));
        self.shape(&rows::ROUND_CONE, &[bottom.clone(), top.clone(), height], &here, span)
    }

    fn constant_round_cone(&mut self, one: Sphere, other: Sphere, context: &Context, span: Span) -> NodeId {
        let scalars = |(centre, radius): Sphere| (centre.map(Scalar::from), Scalar::from(radius));
        self.round_cone(&scalars(one), &scalars(other), context, span)
    }

    /// The hull of points, grown by a radius.
    fn grown_hull(&mut self, centres: &[Vec3], radius: &Scalar, context: &Context, span: Span) -> Option<NodeId> {
        let flat = match hull(centres) {
            Hull::Empty => return None,
            Hull::Point(centre) => {
                let shift = Affine::translation(centre.map(Scalar::from));
                let here = self.derive(context, |here| here.since = shift);
                return Some(self.shape(&rows::SPHERE, std::slice::from_ref(radius), &here, span));
            }
            Hull::Segment(from, to) => {
                let end = |centre: Vec3| (centre.map(Scalar::from), radius.clone());
                return Some(self.round_cone(&end(from), &end(to), context, span));
            }
            Hull::Polygon(corners) => self.plate(&corners, context, span),
            Hull::Solid(triangles) => self.polytope(triangles, context, span),
        };
        if radius.is(0.0) {
            return Some(flat);
        }
        let lipschitz = self.builder.facts(flat).lipschitz;
        // Growing a convex solid keeps its distances exact.
        let class = self.builder.facts(flat).class;
        let arguments = vec![context.length(radius)];
        Some(self.builder.node(Node::Adjust(&rows::OFFSET, arguments, flat), span, class, lipschitz))
    }

    /// A convex polygon without thickness.
    fn plate(&mut self, corners: &[Vec3], context: &Context, span: Span) -> NodeId {
        let along = sub(corners[1], corners[0]);
        let x = scale(along, 1.0 / length(along));
        let across = sub(corners[2], corners[0]);
        let y = sub(across, scale(x, dot(across, x)));
        let y = scale(y, 1.0 / length(y));
        let z = cross(x, y);
        let rows = [0, 1, 2].map(|i| [x[i], y[i], z[i], corners[0][i]]);
        let here = self.derive(context, |here| here.since = Affine::constant(rows));
        let place = self.place(&here);
        let point = self.point_at(context.base, &place.forward, false);
        let section = self.builder.point(Point::Warp(&rows::SLICE, Vec::new(), point));
        let flat = |corner: &Vec3| [dot(sub(*corner, corners[0]), x), dot(sub(*corner, corners[0]), y)];
        let region = Region { contours: vec![Contour::polygon(corners.iter().map(flat))] };
        let below = self.below(&here, &place, section, |below| below.plane = true);
        let class = class_at(Class::Exact, &place, context);
        match self.region(&Arc::new(region), &below, span) {
            Some(outline) => {
                let node = Node::Extrude(Scalar::ZERO, outline, point);
                self.builder.node(node, span, class.max(Class::ExactOutside), context.slope)
            }
            None => self.builder.node(Node::Nothing, span, Class::Exact, 1.0),
        }
    }

    fn polytope(&mut self, triangles: Vec<[Vec3; 3]>, context: &Context, span: Span) -> NodeId {
        let place = Place { forward: context.forward.clone(), size: context.size.clone(), rigid: true };
        let class = class_at(Class::ExactOutside, &place, context);
        if let Some(size) = place.size.constant() {
            let triangles = triangles.into_iter().map(|corners| corners.map(|corner| scale(corner, size)));
            let point = self.point_at(context.base, &place.forward, false);
            let node = Node::Polytope(triangles.collect(), point);
            return self.builder.node(node, span, class, context.slope);
        }
        let forward = place.forward.after(&Affine::scaling([(); 3].map(|()| place.size.clone())));
        let point = self.point_at(context.base, &forward, false);
        let slope = context.slope / place.size.range().min.max(f64::MIN_POSITIVE);
        let polytope = self.builder.node(Node::Polytope(triangles.into(), point), span, class, slope);
        self.builder.node(Node::Adjust(&rows::SCALE, vec![place.size], polytope), span, class, context.slope)
    }

    /// The hull is the union of the round cones along its edges and the polytope Q of all points where flat parts
    /// touch spheres: a face of Q is a flat part, or its corners are all in one such cone, and so is what the hull has
    /// beyond it.
    fn unequal_hull(&mut self, spheres: &[Sphere], context: &Context, span: Span) -> Option<NodeId> {
        let mut parts = Vec::new();
        let mut touched = Vec::new();
        for (i, one) in spheres.iter().enumerate() {
            for (j, other) in spheres.iter().enumerate().skip(i + 1) {
                if let Some(mut corners) = edge(spheres, i, j) {
                    touched.append(&mut corners);
                    parts.push(self.constant_round_cone(*one, *other, context, span));
                }
            }
        }
        if parts.is_empty() {
            // One sphere holds all others.
            let largest = spheres.iter().copied().max_by(|a, b| a.1.total_cmp(&b.1))?;
            return Some(self.constant_round_cone(largest, largest, context, span));
        }
        if let Hull::Solid(triangles) = hull::hull(&touched) {
            parts.push(self.polytope(triangles, context, span));
        }
        self.union(parts, None, span)
    }
}

/// If two spheres share an edge of the hull of spheres: the points in which the flat parts at that edge touch them
/// and the third sphere.
///
/// The planes that touch both spheres have the normals u = a e + b (cos θ f + sin θ g), e being the direction from
/// one to the other. Each other sphere rules out those θ for which it reaches beyond the plane; at the ends of what
/// is left, it touches it.
fn edge(spheres: &[Sphere], i: usize, j: usize) -> Option<Vec<Vec3>> {
    let ((from, r_from), (to, r_to)) = (spheres[i], spheres[j]);
    let apart = length(sub(to, from));
    let tolerance = 1e-9 * (apart + r_from + r_to);
    if apart <= (r_to - r_from).abs() + tolerance {
        return None;
    }
    let e = scale(sub(to, from), 1.0 / apart);
    let a = (r_from - r_to) / apart;
    let b = (1.0 - a * a).sqrt();
    let (f, g) = across(e);
    let mut ruled_out: Vec<(f64, f64, usize)> = Vec::new();
    for (k, (centre, radius)) in spheres.iter().enumerate() {
        if k == i || k == j {
            continue;
        }
        let offset = sub(*centre, from);
        let beyond = a * dot(offset, e) + radius - r_from;
        let swing = b * dot(offset, f).hypot(dot(offset, g));
        let middle = dot(offset, g).atan2(dot(offset, f));
        if beyond - swing > tolerance {
            return None;
        }
        if beyond + swing > tolerance {
            let half = (-beyond / swing).clamp(-1.0, 1.0).acos();
            ruled_out.push((middle - half, middle + half, k));
        }
    }
    let normal = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        add(scale(e, a), add(scale(f, b * cos), scale(g, b * sin)))
    };
    let allowed = |angle: f64| {
        ruled_out.iter().all(|(start, end, _)| {
            let turned = (angle - start).rem_euclid(TAU);
            turned >= end - start - 1e-9 || turned <= 1e-9 || turned >= TAU - 1e-9
        })
    };
    if ruled_out.is_empty() {
        return Some(Vec::new());
    }
    let mut touched = Vec::new();
    for (start, end, k) in &ruled_out {
        for angle in [*start, *end].into_iter().filter(|angle| allowed(*angle)) {
            let u = normal(angle);
            touched.extend([i, j, *k].map(|sphere| add(spheres[sphere].0, scale(u, spheres[sphere].1))));
        }
    }
    (!touched.is_empty()).then_some(touched)
}

/// Two directions at right angles to a direction and to each other.
fn across(e: Vec3) -> (Vec3, Vec3) {
    let least = (0..3).min_by(|i, j| e[*i].abs().total_cmp(&e[*j].abs())).unwrap_or(0);
    let mut axis = [0.0; 3];
    axis[least] = 1.0;
    let f = cross(e, axis);
    let f = scale(f, 1.0 / length(f));
    (f, cross(e, f))
}

/// The rigid map that turns z to a direction of length 1 and then moves the origin (Duff et al. 2017: a frame without
/// branches and with one singular sign).
fn upright_to(direction: [Scalar; 3], origin: &[Scalar; 3]) -> Affine {
    let one = || Scalar::ONE;
    let [x, y, z] = direction;
    let up = Scalar::apply(Function::LessEqual, vec![Scalar::ZERO, z.clone()]);
    let sign = Scalar::apply(Function::Select, vec![up, one(), -one()]);
    let a = -one() / (sign.clone() + z.clone());
    let b = x.clone() * y.clone() * a.clone();
    let first = [
        one() + sign.clone() * x.clone() * x.clone() * a.clone(),
        sign.clone() * b.clone(),
        -(sign.clone() * x.clone()),
    ];
    let second = [b, sign + y.clone() * y.clone() * a, -y.clone()];
    let third = [x, y, z];
    let row = |i: usize| [first[i].clone(), second[i].clone(), third[i].clone(), origin[i].clone()];
    Affine::similar([row(0), row(1), row(2)], Scalar::ONE)
}
