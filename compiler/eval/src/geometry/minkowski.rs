//! Minkowski sums: of balls and one other operand, of rectangles, and of upright prisms.

use std::sync::Arc;

use chiaro_solid::{Dimension, Scalar, Solid};
use chiaro_syntax::{Diagnostic, Span};
use chiaro_vocabulary::rows;

use super::instance::{Instance, Module};
use super::make::{empty, moved, prism, shape};
use super::offsets::grown;
use super::pieces::{Ball, Prism, Rectangle};
use super::{Built, Stop};

pub(super) const MODULES: &[Module] = &[Module { name: "minkowski", positional: &[], named: &[], build: minkowski }];

fn minkowski(instance: &mut Instance) -> Built {
    let operands = instance.operands();
    match operands.first().and_then(|first| first.dimension()) {
        None => Ok(empty(instance.head)),
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

/// The sum of plane shapes: of one, or of rectangles along the axes.
fn plane_sum(operands: Vec<Arc<Solid>>, span: Span) -> Built {
    if let [only] = operands.as_slice() {
        return Ok(only.clone());
    }
    let mut half = [Scalar::ZERO, Scalar::ZERO];
    let mut center = half.clone();
    for operand in &operands {
        let Some(rectangle) = Rectangle::of(operand) else { return Err(no_sum(operand, span)) };
        for axis in 0..2 {
            half[axis] = half[axis].clone() + rectangle.half[axis].clone();
            center[axis] = center[axis].clone() + rectangle.center[axis].clone();
        }
    }
    let [x, y] = center;
    Ok(moved([x, y, Scalar::ZERO], shape(&rows::RECTANGLE, half, span), span))
}

/// The sum of solids: of one, or of upright prisms, whose plane shapes and heights add up.
fn space_sum(operands: Vec<Arc<Solid>>, span: Span) -> Built {
    if let [only] = operands.as_slice() {
        return Ok(only.clone());
    }
    let mut bases = Vec::new();
    let (mut bottom, mut height) = (Scalar::ZERO, Scalar::ZERO);
    for operand in &operands {
        let Some(prism) = Prism::of(operand) else { return Err(no_sum(operand, span)) };
        bases.push(prism.base);
        bottom = bottom + prism.bottom;
        height = height + prism.height;
    }
    let base = sum(bases, span, plane_sum)?;
    Ok(moved([Scalar::ZERO, Scalar::ZERO, bottom], prism(height, base, span), span))
}

fn no_sum(operand: &Solid, span: Span) -> Stop {
    let diagnostic = Diagnostic::error(span, "the Minkowski sum of these operands is not supported yet")
        .with_related(operand.span, "of this, only sums with balls or discs are")
        .with_hint("it can be made of balls and one other operand, and of boxes and upright prisms and cylinders");
    Stop::Error(Box::new(diagnostic))
}
