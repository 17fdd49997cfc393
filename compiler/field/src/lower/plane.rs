//! Solids made from plane shapes, and plane shapes made from solids.

use std::f64::consts::PI;
use std::sync::Arc;

use chiaro_solid::{Affine, Scalar, Solid};
use chiaro_syntax::{Diagnostic, Span};
use chiaro_vocabulary::{Class, rows};

use super::Lowering;
use super::context::{Context, Place};
use super::warp::{Reach, twisted_slope};
use crate::graph::{Node, NodeId, Point, PointId};

impl Lowering {
    /// A plane shape drawn out: height, twist and the scale of the top in x and y.
    pub(super) fn extrude(
        &mut self,
        [height, twist, scale_x, scale_y]: [&Scalar; 4],
        child: &Arc<Solid>,
        context: &Context,
        span: Span,
    ) -> Option<NodeId> {
        let straight = scale_x.is(1.0) && scale_y.is(1.0);
        if twist.is(0.0) && straight {
            return self.upright(height, child, context, span);
        }
        let place = self.place(context);
        let point = self.point_at(context.base, &place.forward, false);
        let height = height.clone() * place.size.clone();
        let scale = [scale_x.clone(), scale_y.clone()];
        let arguments = vec![height.clone(), twist.clone(), scale[0].clone(), scale[1].clone()];
        let section = self.builder.point(Point::Warp(&rows::EXTRUDE, arguments, point));

        let mut reach = self.reach(child, span, "an endless plane shape can't be twisted or tapered")?;
        let size = place.size.range().max;
        reach.radius *= size;
        let confine = reach.class == Class::Bound || scale[0] != scale[1];
        let tilt = level_slope(&reach, confine, &height, twist, &scale);
        // Seen from the section, lengths at the narrowest level are the longest.
        let narrowest = if straight { 1.0 } else { narrowest(&scale) };
        let below = self.below(context, &place, section, |below| {
            below.plane = true;
            below.slope = context.slope * (1.0 + tilt * tilt).sqrt() / narrowest;
            below.best = Class::Bound;
        });
        let mut node = self.lower_confined(child, &below, confine.then_some(&reach), span)?;
        let slope = self.builder.facts(node).lipschitz * narrowest;
        if !straight {
            let taper = Node::Taper(height.clone(), scale, node, point);
            node = self.builder.node(taper, span, Class::Bound, slope);
        }
        // The flat ends meet the sides at an angle that is not a right one.
        let slope = slope / (1.0 + tilt * tilt).sqrt() * twisted_slope(tilt);
        self.warn_of_slope("this twist or taper", slope / context.slope, span);
        Some(self.builder.node(Node::Extrude(height, node, point), span, Class::Bound, slope.max(context.slope)))
    }

    /// A plane shape drawn straight up. Stretched along its axes it is the same of a stretched plane shape.
    fn upright(&mut self, height: &Scalar, child: &Arc<Solid>, context: &Context, span: Span) -> Option<NodeId> {
        let (place, factors) = match self.stretched_place(context) {
            Some((place, factors)) => (place, Some(factors)),
            None => (self.place(context), None),
        };
        let point = self.point_at(context.base, &place.forward, false);
        let section = self.builder.point(Point::Warp(&rows::SLICE, Vec::new(), point));
        let below = self.below(context, &place, section, |below| {
            below.plane = true;
            if let Some(factors) = &factors {
                below.since = Affine::scaling([factors[0].clone(), factors[1].clone(), Scalar::ONE]);
                below.transformed_at = context.transformed_at;
            }
        });
        let node = self.lower(child, &below)?;
        let facts = *self.builder.facts(node);
        let stretch = factors.map_or(Scalar::ONE, |[_, _, z]| z);
        let height = height.clone() * stretch * place.size;
        let node = Node::Extrude(height, node, point);
        Some(self.builder.node(node, span, facts.class.max(below.best), facts.lipschitz.max(context.slope)))
    }

    /// A plane shape turned about z.
    pub(super) fn revolve(
        &mut self,
        sweep: Option<&[Scalar; 2]>,
        facets: Option<u32>,
        child: &Arc<Solid>,
        context: &Context,
        span: Span,
    ) -> Option<NodeId> {
        let about_z = |factors: &[Scalar; 3]| factors[0] == factors[1];
        let (place, factors) = match self.stretched_place(context).filter(|(_, factors)| about_z(factors)) {
            Some((place, factors)) => (place, Some(factors)),
            None => (self.place(context), None),
        };
        let point = self.point_at(context.base, &place.forward, false);
        let (row, arguments, stretch) = match facets {
            Some(n) => (&rows::REVOLVE_FACETS, vec![Scalar::from(f64::from(n))], 1.0 / (PI / f64::from(n)).cos()),
            None => (&rows::REVOLVE, Vec::new(), 1.0),
        };
        let section = self.builder.point(Point::Warp(row, arguments, point));
        let mut below = self.below(context, &place, section, |below| {
            below.plane = true;
            below.slope = context.slope * stretch;
            // Inside, what the axis cuts the plane shape off at would count as near.
            below.best = below.best.max(if facets.is_some() { Class::Bound } else { Class::ExactOutside });
            if let Some([radial, _, z]) = factors {
                below.since = Affine::scaling([radial, z, Scalar::ONE]);
                below.transformed_at = context.transformed_at;
            }
        });
        let mut node = self.lower(child, &below)?;
        let across = self.builder.extent_at(node, section).bounds.axis(0);
        if across.min < 0.0 && across.min != -across.max {
            // What lies beyond the axis is not part of the solid, but may be nearer than what is.
            below = self.derive(&below, |below| below.best = Class::Bound);
            node = self.lower(child, &below)?;
        }
        match sweep {
            None => Some(node),
            Some([start, sweep]) => {
                let slice = self.builder.point(Point::Warp(&rows::SLICE, Vec::new(), point));
                let arguments = vec![start.clone(), sweep.clone()];
                let class = rows::WEDGE.class.max(context.best);
                let wedge = Node::Shape(&rows::WEDGE, arguments, slice);
                let wedge = self.builder.node(wedge, span, class, context.slope);
                self.intersection(vec![node, wedge], None, span)
            }
        }
    }

    /// The plane shape in which z = 0 cuts a solid.
    pub(super) fn slice(&mut self, child: &Arc<Solid>, context: &Context) -> Option<NodeId> {
        let place = self.place(context);
        let point = self.point_at(context.base, &place.forward, false);
        let flattened = self.builder.point(Point::Flattened(point));
        let below = self.below(context, &place, flattened, |below| {
            below.plane = false;
            below.best = Class::Bound;
        });
        self.lower(child, &below)
    }

    /// The context of what is asked at a new base point that belongs to a place.
    pub(super) fn below(
        &mut self,
        context: &Context,
        place: &Place,
        base: PointId,
        change: impl FnOnce(&mut Context),
    ) -> Context {
        self.derive(context, |below| {
            below.base = base;
            below.forward = Affine::identity();
            below.size = place.size.clone();
            below.since = Affine::identity();
            if !place.rigid {
                below.best = Class::Bound;
            }
            change(below);
        })
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
        let radius = Scalar::from(reach.confinement());
        let confined = self.builder.point(Point::Confined(radius.clone(), context.base));
        let below = self.derive(context, |below| below.base = confined);
        let node = self.lower(child, &below)?;
        let facts = *self.builder.facts(node);
        let confine = Node::Confine(radius, reach.lipschitz, node, context.base);
        Some(self.builder.node(confine, span, Class::Bound, facts.lipschitz))
    }

    pub(super) fn warn_of_slope(&mut self, what: &str, slope: f64, span: Span) {
        const MUCH: f64 = 2.0;
        if slope > MUCH {
            let message = format!("{what} makes distances {slope:.1} times too long here");
            let label = "rays take as many times more steps around it";
            self.say(Diagnostic::warning(span, message).with_label(label));
        }
    }
}

/// How fast, at most, a distance in a level of a twisted and tapered extrusion changes with the height of the point
/// that is asked about, relative to how fast it changes within its level.
///
/// Let s be the level's scale, q = R p / s the point in its section, d the distance there and f = min(s) d(q) the
/// distance at p. Then ∂f/∂z has one part from the twist, at most |twist / h| max(s) |∇d · Jq|, and two from the taper,
/// at most |s'| (|d| + |∇d · q|). If d is the distance to a point c within the reach ρ, both parts are those of the
/// point s R c that moves by at most ρ √(s'² + (s twist / h)²). Else ρ is a little larger and the values are confined
/// to the disc of that radius, in which |d| ≤ 2 ρ; beyond it the confinement keeps these bounds.
fn level_slope(reach: &Reach, confined: bool, height: &Scalar, twist: &Scalar, scale: &[Scalar; 2]) -> f64 {
    let height = height.range().min;
    let tops = scale.each_ref().map(Scalar::range);
    let widest = tops.iter().map(|top| top.max).fold(1.0, f64::max);
    let narrowing = tops.iter().map(|top| (top.max - 1.0).abs().max((top.min - 1.0).abs())).fold(0.0, f64::max);
    let rate = twist.range().magnitude() / height * widest;
    let taper = narrowing / height;
    let radius = if confined { reach.confinement() } else { reach.radius };
    let exact = reach.class == Class::Exact && !confined;
    if exact || (taper == 0.0) {
        radius * taper.hypot(rate)
    } else {
        // The union of exact distances inside is as well confined to its own radius as the others.
        radius * (3.0 * taper + rate)
    }
}

/// The least scale of a level.
fn narrowest(scale: &[Scalar; 2]) -> f64 {
    const LEAST_SCALE: f64 = 1e-4;
    scale.iter().map(|top| top.range().min).fold(1.0, f64::min).max(LEAST_SCALE)
}
