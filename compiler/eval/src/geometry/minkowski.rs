//! Minkowski sums: of plane shapes, of balls and one other operand, of upright prisms, and of convex solids that are
//! hulls of balls.

use std::sync::Arc;

use chiaro_solid::{Dimension, Scalar, Solid};
use chiaro_syntax::Span;
use chiaro_vocabulary::rows;

use super::balls::Balls;
use super::convexity::is_convex;
use super::instance::{Instance, Module, error};
use super::make::{empty, is_empty, moved, prism, region, shape};
use super::offsets::grown;
use super::outline::outline;
use super::pieces::{Ball, Prism, Rectangle};
use super::{Built, Stop};

pub(super) const MODULES: &[Module] = &[Module { name: "minkowski", positional: &[], named: &[], build: minkowski }];

fn minkowski(instance: &mut Instance) -> Built {
    let starts_empty = instance.children.first().is_some_and(|first| is_empty(first));
    let count = instance.children.len();
    let operands = instance.operands();
    match operands.first().and_then(|first| first.dimension()) {
        None => Ok(empty(instance.head)),
        // In the plane, unlike in space, nothing is the sum of nothing and something.
        Some(Dimension::Plane) if starts_empty || (operands.len() == 1 && count > 1) => Ok(empty(instance.head)),
        Some(Dimension::Plane) => sum(operands, instance.head, plane_sum),
        Some(Dimension::Space) => sum(operands, instance.head, space_sum),
    }
}

/// The sum of some operands: the balls among them grow and move the sum of the others.
fn sum(operands: Vec<Arc<Solid>>, span: Span, others_sum: fn(Vec<Arc<Solid>>, Span) -> Built) -> Built {
    let mut others = Vec::new();
    let mut balls: Option<Ball> = None;
    for operand in operands {
        match Ball::of(&operand) {
            Some(ball) => balls = Some(balls.map_or(ball.clone(), |sum| sum.plus(ball))),
            None => others.push(operand),
        }
    }
    let Some(ball) = balls else { return others_sum(others, span) };
    if others.is_empty() {
        return Ok(moved(ball.center, shape(ball.row, [ball.radius], span), span));
    }
    let grown = grown(ball.radius, others_sum(others, span)?, span)?;
    Ok(moved(ball.center, grown, span))
}

/// The sum of plane shapes, of which none is a disc.
fn plane_sum(operands: Vec<Arc<Solid>>, span: Span) -> Built {
    if let [only] = operands.as_slice() {
        return Ok(only.clone());
    }
    if let Some(rectangles) = operands.iter().map(|operand| Rectangle::of(operand)).collect::<Option<Vec<_>>>() {
        return Ok(rectangle_sum(&rectangles, span));
    }
    let outlines = operands.iter().map(|operand| outline(operand)).collect::<Result<Vec<_>, Stop>>()?;
    let sum = outlines.into_iter().map(Some).reduce(|sum, next| sum?.minkowski(&next?));
    match sum.flatten() {
        Some(sum) => Ok(region(sum, span)),
        None => Err(error(span, "these outlines have too many edges for their Minkowski sum")),
    }
}

fn rectangle_sum(rectangles: &[Rectangle], span: Span) -> Arc<Solid> {
    let total = |number: fn(&Rectangle) -> &[Scalar; 2], axis: usize| {
        rectangles.iter().fold(Scalar::ZERO, |sum, rectangle| sum + number(rectangle)[axis].clone())
    };
    let half = [0, 1].map(|axis| total(|rectangle| &rectangle.half, axis));
    let [x, y] = [0, 1].map(|axis| total(|rectangle| &rectangle.center, axis));
    moved([x, y, Scalar::ZERO], shape(&rows::RECTANGLE, half, span), span)
}

/// The sum of solids, of which none is a ball.
fn space_sum(operands: Vec<Arc<Solid>>, span: Span) -> Built {
    if let [only] = operands.as_slice() {
        return Ok(only.clone());
    }
    if let Some(prisms) = operands.iter().map(Prism::of).collect::<Option<Vec<_>>>() {
        return prism_sum(prisms, span);
    }
    if let Some(hollow) = operands.iter().find(|operand| !is_convex(operand)) {
        let message = "the sum of solids that are not known to be convex is not supported yet, except with balls";
        return Err(super::balls::refused(span, message, hollow));
    }
    let mut sum = Balls::default();
    for operand in &operands {
        let mut balls = Balls::default();
        balls.add(operand, span)?;
        sum = if sum.is_empty() { balls } else { sum.plus(&balls, span)? };
    }
    sum.hull(span)
}

/// The sum of upright prisms: their plane shapes and their heights add up.
fn prism_sum(prisms: Vec<Prism>, span: Span) -> Built {
    let bottom = prisms.iter().fold(Scalar::ZERO, |sum, prism| sum + prism.bottom.clone());
    let height = prisms.iter().fold(Scalar::ZERO, |sum, prism| sum + prism.height.clone());
    let base = sum(prisms.into_iter().map(|prism| prism.base).collect(), span, plane_sum)?;
    Ok(moved([Scalar::ZERO, Scalar::ZERO, bottom], prism(height, base, span), span))
}
