//! Solids made from plane shapes, and plane shapes made from solids.

use std::f64::consts::PI;
use std::sync::Arc;

use chiaro_solid::{Affine, Scalar, Solid};
use chiaro_syntax::Span;
use chiaro_vocabulary::{Class, rows};

use super::Lowering;
use super::context::{Context, Place};
use crate::graph::{Node, NodeId, Point, PointId};

impl Lowering {
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
    ) -> Box<Context> {
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
}
