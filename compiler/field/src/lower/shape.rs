//! Shapes of the table, and outlines.

use std::sync::Arc;

use chiaro_plane::Region;
use chiaro_solid::{Affine, Scalar};
use chiaro_syntax::Span;
use chiaro_vocabulary::{Class, Row, Unit, rows};

use super::Lowering;
use super::context::{Context, Place};
use crate::graph::{Node, NodeId};

impl Lowering {
    /// A shape of the table, its lengths made millimetres of the world.
    pub(super) fn shape(&mut self, row: &'static Row, arguments: &[Scalar], context: &Context, span: Span) -> NodeId {
        if let Some((place, factors)) = self.stretched_place(context)
            && let Some((row, arguments)) = stretched(row, arguments, &factors)
        {
            return self.shape_at(row, &arguments, &place, context, span);
        }
        let place = self.place(context);
        self.shape_at(row, arguments, &place, context, span)
    }

    fn shape_at(
        &mut self,
        row: &'static Row,
        arguments: &[Scalar],
        place: &Place,
        context: &Context,
        span: Span,
    ) -> NodeId {
        let point = self.point_at(context.base, &place.forward, row.round && place.rigid);
        let node = Node::Shape(row, sized(row, arguments, &place.size), point);
        self.builder.node(node, span, class_at(row.class, place, context), context.slope)
    }

    /// An outline. A constant map of lengths goes into its numbers.
    pub(super) fn region(&mut self, region: &Arc<Region>, context: &Context, span: Span) -> Option<NodeId> {
        if region.is_empty() {
            return None;
        }
        let place = match self.stretched_place(context) {
            Some((place, factors)) => match stretched_region(region, &place, &factors) {
                Some(region) => return Some(self.outline(region, &place.forward, Class::Exact, context, span)),
                None => self.place(context),
            },
            None => self.place(context),
        };
        let class = class_at(Class::Exact, &place, context);
        if place.size.is(1.0) {
            return Some(self.outline(region.clone(), &place.forward, class, context, span));
        }
        if let Some(size) = place.size.constant() {
            let scaled = Arc::new(region.transform([[size, 0.0, 0.0], [0.0, size, 0.0]]));
            return Some(self.outline(scaled, &place.forward, class, context, span));
        }
        // Of a live size, the outline is asked in its own millimetres.
        let forward = place.forward.after(&Affine::scaling([(); 3].map(|()| place.size.clone())));
        let point = self.point_at(context.base, &forward, false);
        let slope = context.slope / place.size.range().min.max(f64::MIN_POSITIVE);
        let outline = self.builder.node(Node::Outline(region.clone(), point), span, class, slope);
        Some(self.builder.node(Node::Adjust(&rows::SCALE, vec![place.size], outline), span, class, context.slope))
    }

    fn outline(
        &mut self,
        region: Arc<Region>,
        forward: &Affine,
        class: Class,
        context: &Context,
        span: Span,
    ) -> NodeId {
        let point = self.point_at(context.base, forward, false);
        self.builder.node(Node::Outline(region, point), span, class.max(context.best), context.slope)
    }
}

/// The class of a shape in its place.
pub(super) fn class_at(class: Class, place: &Place, context: &Context) -> Class {
    if place.rigid { class.max(context.best) } else { Class::Bound }
}

/// A shape's arguments, its lengths multiplied by a size.
fn sized(row: &Row, arguments: &[Scalar], size: &Scalar) -> Vec<Scalar> {
    if size.is(1.0) {
        return arguments.to_vec();
    }
    let units = row.parameters.iter().flat_map(|parameter| std::iter::repeat_n(parameter.unit, parameter.ty.len()));
    let sized = arguments.iter().zip(units).map(|(argument, unit)| match unit {
        Unit::Size | Unit::Length => argument.clone() * size.clone(),
        Unit::Angle | Unit::Direction | Unit::Number => argument.clone(),
    });
    sized.collect()
}

/// The shape that comes of stretching a shape along its own axes by factors, if the table has it.
fn stretched(row: &'static Row, arguments: &[Scalar], factors: &[Scalar; 3]) -> Option<(&'static Row, Vec<Scalar>)> {
    let each = |lengths: &[Scalar]| lengths.iter().zip(factors).map(|(a, b)| a.clone() * b.clone()).collect();
    let about_z = factors[0] == factors[1];
    if [&rows::BOX, &rows::ELLIPSOID, &rows::RECTANGLE, &rows::ELLIPSE].contains(&row) {
        Some((row, each(arguments)))
    } else if *row == rows::SPHERE {
        Some((&rows::ELLIPSOID, each(&[(); 3].map(|()| arguments[0].clone()))))
    } else if *row == rows::CIRCLE {
        Some((&rows::ELLIPSE, each(&[(); 2].map(|()| arguments[0].clone()))))
    } else if (*row == rows::CYLINDER || *row == rows::CONE) && about_z {
        let (height, radii) = arguments.split_last()?;
        let mut lengths: Vec<Scalar> = radii.iter().map(|radius| radius.clone() * factors[0].clone()).collect();
        lengths.push(height.clone() * factors[2].clone());
        Some((row, lengths))
    } else {
        None
    }
}

/// The outline that comes of stretching an outline along its own axes, if all is constant.
fn stretched_region(region: &Region, place: &Place, factors: &[Scalar; 3]) -> Option<Arc<Region>> {
    let size = place.size.constant()?;
    let [x, y] = [factors[0].constant()?, factors[1].constant()?];
    Some(Arc::new(region.transform([[x * size, 0.0, 0.0], [0.0, y * size, 0.0]])))
}
