//! Twists, and what they need to know of the solid they twist.

use std::sync::Arc;

use chiaro_solid::{Scalar, Solid};
use chiaro_syntax::{Diagnostic, Span};
use chiaro_vocabulary::{Class, rows};

use super::context::Context;
use super::{Lowering, STEEPEST};
use crate::graph::{Node, NodeId, Point};

/// How far a solid reaches from the z axis, and what its values are. (Of a plane shape: from the origin.)
#[derive(Clone, Copy, Debug)]
pub(super) struct Reach {
    /// The radius of a cylinder about z around the solid, in millimetres.
    pub(super) radius: f64,
    /// Its class, asked at rest.
    pub(super) class: Class,
    /// Its Lipschitz constant, asked at rest.
    pub(super) lipschitz: f64,
}

impl Reach {
    /// The radius of a cylinder that the solid keeps clear of.
    pub(super) fn confinement(&self) -> f64 {
        self.radius * 1.01 + 1e-6
    }
}

/// The Lipschitz constant of a distance asked behind a shear by `slope`: the greatest singular value of
/// ((1, 0), (slope, 1)).
pub(super) fn twisted_slope(slope: f64) -> f64 {
    0.5 * (slope + (slope * slope + 4.0).sqrt())
}

impl Lowering {
    /// A solid turned about z in proportion to the height.
    ///
    /// The warp turns the point by the angle −rate z, so to its gradient's z component it adds rate |∇d · Jq|, q being
    /// the turned point: a shear of the tangential and the vertical component. If d is the distance to a point within
    /// the reach ρ, then |∇d · Jq| is at most ρ times the component of ∇d across that point's own direction. Else
    /// values are confined to a disc of little more than ρ.
    pub(super) fn twist(&mut self, rate: &Scalar, child: &Arc<Solid>, context: &Context, span: Span) -> Option<NodeId> {
        if rate.is(0.0) {
            return self.lower(child, context);
        }
        let reach = self.reach(child, span, "an endless solid can't be twisted")?;
        let confine = reach.class == Class::Bound;
        let radius = if confine { reach.confinement() } else { reach.radius };
        let slope = twisted_slope(radius * rate.range().magnitude());
        self.check_slope("this twist", slope, span)?;
        let place = self.place(context);
        let point = self.point_at(context.base, &place.forward, false);
        let rate = rate.clone() / place.size.clone();
        let warped = self.builder.point(Point::Warp(&rows::TWIST, vec![rate], point));
        let below = self.below(context, &place, warped, |below| {
            below.slope = context.slope * slope;
            below.best = Class::Bound;
        });
        self.lower_confined(child, &below, confine.then_some(&reach), span)
    }

    /// Lowers what a warp stretches without limit: confined to its reach, if its values follow from more than that.
    pub(super) fn lower_confined(
        &mut self,
        child: &Arc<Solid>,
        context: &Context,
        reach: Option<&Reach>,
        span: Span,
    ) -> Option<NodeId> {
        let Some(reach) = reach else { return self.lower(child, context) };
        let radius = context.length(&Scalar::from(reach.confinement()));
        let confined = self.builder.point(Point::Confined(radius.clone(), context.base));
        let below = self.derive(context, |below| below.base = confined);
        let node = self.lower(child, &below)?;
        let facts = *self.builder.facts(node);
        let confine = Node::Confine(radius, reach.lipschitz, node, context.base);
        Some(self.builder.node(confine, span, Class::Bound, facts.lipschitz))
    }

    /// Warns if distances are much too long; none, with an error, if there is no saying how much.
    pub(super) fn check_slope(&mut self, what: &str, slope: f64, span: Span) -> Option<()> {
        const MUCH: f64 = 2.0;
        if !slope.is_finite() {
            let message = format!("{what} may make distances any number of times too long");
            let hint = "keep the live numbers in it within smaller ranges, away from a height of zero";
            self.say(Diagnostic::error(span, message).with_hint(hint));
            return None;
        }
        if slope > STEEPEST {
            let message = format!("{what} makes distances more than {STEEPEST:e} times too long");
            self.say(Diagnostic::error(span, message).with_hint("it takes more turns than can be drawn"));
            return None;
        }
        if slope > MUCH {
            let message = format!("{what} makes distances {slope:.1} times too long here");
            let label = "rays take as many times more steps around it";
            self.say(Diagnostic::warning(span, message).with_label(label));
        }
        Some(())
    }

    /// How far a solid reaches from the z axis; an error, if without end.
    pub(super) fn reach(&mut self, solid: &Arc<Solid>, span: Span, error: &str) -> Option<Reach> {
        let node = self.probe(solid)?;
        let facts = *self.builder.facts(node);
        let radius = facts.bounds.axis(0).magnitude().hypot(facts.bounds.axis(1).magnitude());
        if !radius.is_finite() {
            let hint = "intersect it with something finite first";
            self.say(Diagnostic::error(span, error).with_hint(hint));
            return None;
        }
        Some(Reach { radius, class: facts.class, lipschitz: facts.lipschitz })
    }
}
