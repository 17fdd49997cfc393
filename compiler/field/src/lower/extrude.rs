//! Plane shapes drawn out along z.

use std::sync::Arc;

use chiaro_plane::Loft;
use chiaro_solid::{Affine, Scalar, Solid};
use chiaro_syntax::Span;
use chiaro_vocabulary::{Class, rows};

use super::Lowering;
use super::context::Context;
use super::warp::{Reach, twisted_slope};
use crate::graph::{Node, NodeId, Point};

/// The vocabulary's extrusions are nowhere narrower than this.
const LEAST_SCALE: f64 = 1e-4;

impl Lowering {
    /// A plane shape drawn out: height, twist and the scale of the top in x and y.
    pub(super) fn extrude(
        &mut self,
        [height, twist, scale_x, scale_y]: [&Scalar; 4],
        child: &Arc<Solid>,
        context: &Context,
        span: Span,
    ) -> Option<NodeId> {
        if twist.is(0.0) && scale_x.is(1.0) && scale_y.is(1.0) {
            return self.upright(height, child, context, span);
        }
        let reach = self.reach(child, span, "an endless plane shape can't be twisted or tapered")?;
        let scale = [scale_x.clone(), scale_y.clone()];
        let levels = Levels::new(&reach, height, twist, &scale);
        self.check_slope("this twist or taper", twisted_slope(levels.tilt), span)?;
        let place = self.place(context);
        let height = height.clone() * place.size.clone();
        let point = self.point_at(context.base, &place.forward, false);
        let radius = levels.cylinder.map(|radius| Scalar::from(radius) * place.size.clone());
        let within = radius.clone().map(|radius| self.builder.point(Point::Confined(radius, point)));
        let inner = within.unwrap_or(point);
        let arguments = vec![height.clone(), twist.clone(), scale[0].clone(), scale[1].clone()];
        let section = self.builder.point(Point::Warp(&rows::EXTRUDE, arguments, inner));
        let below = self.below(context, &place, section, |below| {
            below.plane = true;
            // Seen from the section, lengths at the narrowest level are the longest.
            below.slope = context.slope * levels.slope() / levels.narrowest;
            below.best = Class::Bound;
        });
        let mut node = self.lower_confined(child, &below, levels.confined.then_some(&reach), span)?;
        let slope = self.builder.facts(node).lipschitz * levels.narrowest;
        if !(scale[0].is(1.0) && scale[1].is(1.0)) {
            let taper = Node::Taper(height.clone(), scale, node, inner);
            node = self.builder.node(taper, span, Class::Bound, slope);
        }
        if let Some(radius) = radius {
            let confine = Node::Confine(radius, slope / context.slope, node, point);
            node = self.builder.node(confine, span, Class::Bound, slope);
        }
        // The flat ends meet the sides at an angle that is not a right one.
        let slope = slope / levels.slope() * twisted_slope(levels.tilt);
        Some(self.builder.node(Node::Extrude(height, node, point), span, Class::Bound, slope.max(context.slope)))
    }

    /// Stages with flat sides. Distances within a level change no faster with the height than the sides and corners
    /// move in it.
    pub(super) fn loft(&mut self, loft: &Arc<Loft>, context: &Context, span: Span) -> Option<NodeId> {
        let slope = loft.slope();
        self.check_slope("this twist or taper", twisted_slope(slope), span)?;
        let place = self.place(context);
        let size = place.size.constant();
        let (loft, forward) = match size {
            Some(size) => (Arc::new(loft.scaled(size)), place.forward),
            // Of a live size, the stages are asked in their own millimetres.
            None => (loft.clone(), place.forward.after(&Affine::scaling([(); 3].map(|()| place.size.clone())))),
        };
        let own_slope =
            if size.is_some() { context.slope } else { context.slope / place.size.range().min.max(f64::MIN_POSITIVE) };
        let point = self.point_at(context.base, &forward, false);
        let height = Scalar::from(loft.height());
        let level = self.builder.node(Node::Loft(loft, point), span, Class::Bound, own_slope * 1f64.hypot(slope));
        let steepest = own_slope * twisted_slope(slope);
        let solid = self.builder.node(Node::Extrude(height, level, point), span, Class::Bound, steepest);
        if size.is_some() {
            return Some(solid);
        }
        let scaled = Node::Adjust(&rows::SCALE, vec![place.size], solid);
        Some(self.builder.node(scaled, span, Class::Bound, context.slope * twisted_slope(slope)))
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
}

/// What the levels of a twisted and tapered extrusion do to distances.
struct Levels {
    /// How fast, at most, a distance at a point changes with the point's height, relative to how fast it changes
    /// within the level.
    tilt: f64,
    /// The least scale of a level.
    narrowest: f64,
    /// Whether distances in the section are to be confined to the reach.
    confined: bool,
    /// The radius of a cylinder about z that the points are to be confined to first, if so.
    cylinder: Option<f64>,
}

impl Levels {
    /// Let s be the scale of a level in x and y, m = min(s), M the greatest scale of any level, τ the twist for each
    /// millimetre of height, u = p / s the point scaled back, q = R u the point turned back, which is the point in its
    /// section, d the distance there, and f = m d(q) the distance at p. Within a level, the slope of f is at most that
    /// of d. Along z it is m' d − m ∇d · R (s' / s u) − τ m ∇d · (J q), with J the quarter turn.
    ///
    /// If s is the same in x and y and d is the distance to a point c of the shape, within its reach ρ, then f is the
    /// distance to the point s R c, which moves by at most ρ √(s'² + (M τ)²).
    ///
    /// Else ρ is a little larger, and d is confined to the disc of that radius: inside |d| ≤ 2 ρ and |q| ≤ ρ, so that
    /// the slope is at most 3 ρ |s'| + τ M ρ. Outside, the confined distance is √(d² + g²) with g = |q| − ρ. Its
    /// tangential slope falls with ρ / |q|, and √(d² + g²) − ∂/∂q · q = (d² − g ρ) / √(d² + g²) is at most 2 ρ, so
    /// that the bound holds there too.
    ///
    /// If s differs in x and y, let j be the direction of the larger scale. Then s' / s u is m' / m u but for its
    /// component along j, and the first two terms are m' (d − ∇d · q) − (m s'_j / s_j − m') u_j ∇d · R e_j: at most
    /// |s'| (3 ρ + 2 |u_j|). That is bounded in a cylinder of radius P = M ρ: |u_j| ≤ P / max(s). And there m |q| ≤ |p|,
    /// so that the last term is at most P τ.
    fn new(reach: &Reach, height: &Scalar, twist: &Scalar, scale: &[Scalar; 2]) -> Self {
        let height = height.range().min;
        let tops = scale.each_ref().map(Scalar::range);
        let widest = tops[0].max.max(tops[1].max).max(1.0);
        let narrowest = tops[0].min.min(tops[1].min).clamp(LEAST_SCALE, 1.0);
        let change = tops.iter().map(|top| (top.max - 1.0).abs().max((top.min - 1.0).abs())).fold(0.0, f64::max);
        let (taper, rate) = (change / height, twist.range().magnitude() / height);
        let uniform = scale[0] == scale[1];
        let near = reach.class == Class::Exact || (reach.class == Class::ExactOutside && taper == 0.0);
        let confined = !(near && uniform);
        let radius = if confined { reach.confinement() } else { reach.radius };
        let cylinder = radius * widest;
        let tilt = if !confined {
            radius * taper.hypot(widest * rate)
        } else if uniform {
            radius * (3.0 * taper + widest * rate)
        } else {
            let level_width = tops[0].min.max(tops[1].min).clamp(LEAST_SCALE, 1.0);
            taper * (3.0 * radius + 2.0 * cylinder / level_width) + cylinder * rate
        };
        Self { tilt, narrowest, confined, cylinder: (!uniform).then_some(cylinder) }
    }

    /// The greatest slope of a distance in a level, by the point.
    fn slope(&self) -> f64 {
        (1.0 + self.tilt * self.tilt).sqrt()
    }
}
