//! Solids as convex hulls of balls: a corner is a ball without radius. Hulls and sums of convex solids are again hulls
//! of balls.

use std::sync::Arc;

use chiaro_plane::{Edge, Region};
use chiaro_solid::affine::Similarity;
use chiaro_solid::scalar::degrees;
use chiaro_solid::{Affine, Boolean, Scalar, Solid, SolidKind};
use chiaro_syntax::{Diagnostic, Span};
use chiaro_vocabulary::rows;

use super::make::{moved, shape};
use super::outline::outline;
use super::pieces::image;
use super::{Built, Stop, decide};

/// More balls than this are refused.
const MOST: usize = 100_000;

/// A ball's centre and radius.
type Ball = ([Scalar; 3], Scalar);

/// Balls whose convex hull is meant.
#[derive(Clone, Default)]
pub(super) struct Balls(Vec<Ball>);

impl Balls {
    /// Adds the balls whose hull is a solid's hull, for the instance at `span`.
    pub(super) fn add(&mut self, solid: &Arc<Solid>, span: Span) -> Result<(), Stop> {
        self.add_under(&Affine::identity(), solid, span)
    }

    /// Whether there are none.
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// All sums of one of these balls and one of the others: their hull is the sum of both hulls.
    pub(super) fn plus(&self, other: &Balls, span: Span) -> Result<Balls, Stop> {
        if self.0.len().saturating_mul(other.0.len()) > MOST {
            return Err(too_many(span));
        }
        let sum = |(center, radius): &Ball, (by, more): &Ball| {
            let center = std::array::from_fn(|axis| center[axis].clone() + by[axis].clone());
            (center, radius.clone() + more.clone())
        };
        Ok(Balls(self.0.iter().flat_map(|ball| other.0.iter().map(move |by| sum(ball, by))).collect()))
    }

    /// Their hull. Of three balls or more, the centres have to be constant, and the radii too unless all are the same.
    pub(super) fn hull(self, span: Span) -> Built {
        if let [(center, radius)] = self.0.as_slice() {
            return Ok(moved(center.clone(), shape(&rows::SPHERE, [radius.clone()], span), span));
        }
        if let [first, _, _, ..] = self.0.as_slice() {
            let same_radii = self.0.iter().all(|(_, radius)| *radius == first.1);
            for (center, radius) in &self.0 {
                let radius = (!same_radii).then_some(radius);
                for number in center.iter().chain(radius) {
                    decide::constant(number, span, "the hull of more than two solids")?;
                }
            }
        }
        Ok(Solid::new(SolidKind::SphereHull(self.0), span))
    }

    fn add_under(&mut self, map: &Affine, solid: &Arc<Solid>, span: Span) -> Result<(), Stop> {
        match &solid.kind {
            SolidKind::Boolean { operation: Boolean::Union, joint: None, children } => {
                children.iter().try_for_each(|child| self.add_under(map, child, span))
            }
            SolidKind::Transform(inner, child) => self.add_under(&map.after(inner), child, span),
            SolidKind::Paint(_, child) => self.add_under(map, child, span),
            SolidKind::SphereHull(balls) => self.add_images(map, balls.clone(), solid, span),
            SolidKind::Offset(by, child) if by.range().min >= 0.0 => {
                let mut grown = Balls::default();
                grown.add(child, span)?;
                grown.0.iter_mut().for_each(|(_, radius)| *radius = radius.clone() + by.clone());
                self.add_images(map, grown.0, solid, span)
            }
            SolidKind::Shape(row, arguments) => match shape_balls(row.name, arguments) {
                Some(balls) => self.add_images(map, balls, solid, span),
                None => Err(not_balls(solid, span)),
            },
            SolidKind::Extrude { height, twist, scale, child } if twist.is(0.0) => {
                let corners = corners(&outline(child)?).ok_or_else(|| not_balls(solid, span))?;
                self.add_images(map, extruded(&corners, height, scale), solid, span)
            }
            SolidKind::Loft(loft) => {
                let corner = |corner: [f64; 3]| (corner.map(Scalar::from), Scalar::ZERO);
                self.add_images(map, loft.corners().map(corner).collect(), solid, span)
            }
            SolidKind::Revolve { sweep: None, facets: Some(sides), child } => {
                let corners = corners(&outline(child)?).ok_or_else(|| not_balls(solid, span))?;
                self.add_images(map, revolved(&corners, *sides), solid, span)
            }
            _ => Err(not_balls(solid, span)),
        }
    }

    /// Adds balls under a map. Corners stay corners under any map, but balls stay balls only under similarities.
    fn add_images(&mut self, map: &Affine, balls: Vec<Ball>, solid: &Solid, span: Span) -> Result<(), Stop> {
        if self.0.len() + balls.len() > MOST {
            return Err(too_many(span));
        }
        for (center, radius) in balls {
            let radius = match map.similarity() {
                _ if radius.is(0.0) => Scalar::ZERO,
                Similarity::Uniform(factor) => radius * factor,
                Similarity::AtLeast(_) => return Err(not_balls(solid, span)),
            };
            self.0.push((image(map, &center), radius));
        }
        Ok(())
    }
}

/// The balls whose hull is that of a shape.
fn shape_balls(name: &str, arguments: &[Scalar]) -> Option<Vec<Ball>> {
    let at = |z: &Scalar, radius: &Scalar| ([Scalar::ZERO, Scalar::ZERO, z.clone()], radius.clone());
    match (name, arguments) {
        ("sphere", [radius]) => Some(vec![at(&Scalar::ZERO, radius)]),
        ("capsule", [height, radius]) => Some(vec![at(&Scalar::ZERO, radius), at(height, radius)]),
        ("round_cone", [bottom, top, height]) => Some(vec![at(&Scalar::ZERO, bottom), at(height, top)]),
        ("box", [x, y, z]) => Some(box_corners([x, y, z])),
        _ => None,
    }
}

fn box_corners(half: [&Scalar; 3]) -> Vec<Ball> {
    let side = |corner: usize, axis: usize| {
        let side = half[axis].clone();
        if corner >> axis & 1 == 1 { side } else { -side }
    };
    let corner = |corner: usize| (std::array::from_fn(|axis| side(corner, axis)), Scalar::ZERO);
    (0..8).map(corner).collect()
}

/// An outline's corners, if it has no arcs.
fn corners(outline: &Region) -> Option<Vec<[f64; 2]>> {
    let corner = |edge: &Edge| match edge {
        Edge::Line { from, .. } => Some(*from),
        Edge::Arc { .. } => None,
    };
    outline.edges().map(corner).collect()
}

/// The corners of the bottom and of the top.
fn extruded(corners: &[[f64; 2]], height: &Scalar, scale: &[Scalar; 2]) -> Vec<Ball> {
    let bottom = |[x, y]: &[f64; 2]| ([Scalar::from(*x), Scalar::from(*y), Scalar::ZERO], Scalar::ZERO);
    let top = |[x, y]: &[f64; 2]| {
        let [x, y] = [(x, &scale[0]), (y, &scale[1])].map(|(c, factor)| Scalar::from(*c) * factor.clone());
        ([x, y, height.clone()], Scalar::ZERO)
    };
    corners.iter().map(bottom).chain(corners.iter().map(top)).collect()
}

/// The corners of a profile at each of the corners of its turn.
fn revolved(corners: &[[f64; 2]], sides: u32) -> Vec<Ball> {
    let at = |[x, y]: [f64; 2], side: u32| {
        let angle = 360.0 * f64::from(side) / f64::from(sides);
        let center = [x * degrees::cos(angle), x * degrees::sin(angle), y];
        (center.map(Scalar::from), Scalar::ZERO)
    };
    let around = |corner: &[f64; 2]| {
        let corner = *corner;
        // On the axis, all of them are one.
        let sides = if corner[0] == 0.0 { 1 } else { sides };
        (0..sides).map(move |side| at(corner, side))
    };
    corners.iter().flat_map(around).collect()
}

fn not_balls(solid: &Solid, span: Span) -> Stop {
    refused(span, "this hull or sum of solids is not supported yet", solid)
}

/// The error that a hull or sum is not known in closed form, because of an operand.
pub(super) fn refused(span: Span, message: &str, operand: &Solid) -> Stop {
    let diagnostic = Diagnostic::error(span, message)
        .with_related(operand.span, "because of this")
        .with_hint("it works for balls, for convex polyhedra such as boxes, and for upright cylinders of one height");
    Stop::Error(Box::new(diagnostic))
}

fn too_many(span: Span) -> Stop {
    Stop::Error(Box::new(Diagnostic::error(span, format!("this hull or sum has more than {MOST} corners"))))
}
