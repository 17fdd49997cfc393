//! Solids recognised as balls, rectangles and prisms, wherever they have been moved: the operands whose sums and hulls
//! are known in closed form.

use std::sync::Arc;

use chiaro_solid::affine::Similarity;
use chiaro_solid::{Affine, Boolean, Scalar, Solid, SolidKind};
use chiaro_syntax::Span;
use chiaro_vocabulary::{Row, rows};

use super::exactness::is_straight;
use super::make::{shape, transformed};
use super::transforms::planar;

/// A ball, or a disc of the plane.
#[derive(Clone)]
pub(super) struct Ball {
    pub(super) row: &'static Row,
    pub(super) center: [Scalar; 3],
    pub(super) radius: Scalar,
}

impl Ball {
    pub(super) fn of(solid: &Solid) -> Option<Ball> {
        match &solid.kind {
            SolidKind::Shape(row, arguments) if matches!(row.name, "sphere" | "circle") => {
                let [radius] = arguments.as_slice() else { return None };
                let origin = [Scalar::ZERO, Scalar::ZERO, Scalar::ZERO];
                Some(Ball { row, center: origin, radius: radius.clone() })
            }
            SolidKind::Transform(map, child) => {
                let Similarity::Uniform(factor) = map.similarity() else { return None };
                let ball = Ball::of(child)?;
                Some(Ball { center: image(map, &ball.center), radius: ball.radius * factor, ..ball })
            }
            SolidKind::Paint(_, child) => Ball::of(child),
            _ => None,
        }
    }

    pub(super) fn plus(self, other: Ball) -> Ball {
        let [x, y, z] = self.center;
        let [u, v, w] = other.center;
        Ball { center: [x + u, y + v, z + w], radius: self.radius + other.radius, ..self }
    }
}

/// A rectangle with its edges along the axes.
pub(super) struct Rectangle {
    pub(super) center: [Scalar; 2],
    pub(super) half: [Scalar; 2],
}

impl Rectangle {
    pub(super) fn of(solid: &Solid) -> Option<Rectangle> {
        match &solid.kind {
            SolidKind::Shape(row, arguments) if row.name == "rectangle" => {
                let [x, y] = arguments.as_slice() else { return None };
                Some(Rectangle { center: [Scalar::ZERO, Scalar::ZERO], half: [x.clone(), y.clone()] })
            }
            SolidKind::Transform(map, child) => {
                let Rectangle { center: [x, y], half: [u, v] } = Rectangle::of(child)?;
                let rows = map.rows();
                let is_diagonal = rows[0][1].is(0.0) && rows[1][0].is(0.0);
                let is_swap = rows[0][0].is(0.0) && rows[1][1].is(0.0);
                let half = if is_diagonal {
                    [u * rows[0][0].clone().abs(), v * rows[1][1].clone().abs()]
                } else if is_swap {
                    [v * rows[0][1].clone().abs(), u * rows[1][0].clone().abs()]
                } else {
                    return None;
                };
                let [x, y, _] = image(map, &[x, y, Scalar::ZERO]);
                Some(Rectangle { center: [x, y], half })
            }
            SolidKind::Paint(_, child) => Rectangle::of(child),
            _ => None,
        }
    }
}

/// A plane shape drawn out along z.
pub(super) struct Prism {
    pub(super) base: Arc<Solid>,
    pub(super) bottom: Scalar,
    pub(super) height: Scalar,
}

impl Prism {
    pub(super) fn of(solid: &Arc<Solid>) -> Option<Prism> {
        let centred = |base: Arc<Solid>, half: &Scalar| {
            Some(Prism { base, bottom: -half.clone(), height: half.clone() * Scalar::from(2.0) })
        };
        match &solid.kind {
            SolidKind::Shape(row, arguments) => match (row.name, arguments.as_slice()) {
                ("box", [x, y, z]) => centred(shape(&rows::RECTANGLE, [x.clone(), y.clone()], solid.span), z),
                ("cylinder", [radius, half]) => centred(shape(&rows::CIRCLE, [radius.clone()], solid.span), half),
                _ => None,
            },
            SolidKind::Extrude { height, twist, scale, child } if is_straight(twist, scale) => {
                Some(Prism { base: child.clone(), bottom: Scalar::ZERO, height: height.clone() })
            }
            SolidKind::Transform(map, child) => Prism::of(child)?.under(map, solid.span),
            SolidKind::Paint(_, child) => Prism::of(child),
            _ => None,
        }
    }

    /// The prism under a map that keeps it upright.
    fn under(self, map: &Affine, span: Span) -> Option<Prism> {
        let rows = map.rows();
        let tilting = [&rows[0][2], &rows[1][2], &rows[2][0], &rows[2][1]];
        let factor = rows[2][2].constant()?;
        if !tilting.iter().all(|entry| entry.is(0.0)) || factor == 0.0 {
            return None;
        }
        let end = if factor > 0.0 { self.bottom } else { self.bottom + self.height.clone() };
        Some(Prism {
            base: transformed(planar(map), self.base, span),
            bottom: end * Scalar::from(factor) + rows[2][3].clone(),
            height: self.height * Scalar::from(factor.abs()),
        })
    }

    /// The prisms that a solid is the union of.
    pub(super) fn all_of(solid: &Arc<Solid>, prisms: &mut Vec<Prism>) -> Option<()> {
        match &solid.kind {
            SolidKind::Boolean { operation: Boolean::Union, joint: None, children } => {
                children.iter().try_for_each(|child| Prism::all_of(child, prisms))
            }
            _ => Prism::of(solid).map(|prism| prisms.push(prism)),
        }
    }
}

/// A point under a map.
pub(super) fn image(map: &Affine, point: &[Scalar; 3]) -> [Scalar; 3] {
    std::array::from_fn(|i| {
        let row = &map.rows()[i];
        (0..3).fold(row[3].clone(), |sum, j| sum + row[j].clone() * point[j].clone())
    })
}
