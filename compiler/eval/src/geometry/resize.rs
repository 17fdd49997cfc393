//! `resize`: scales its children to a given size.

use chiaro_plane::Point;
use chiaro_solid::{Affine, Dimension, Scalar, Solid};
use chiaro_syntax::Diagnostic;
use chiaro_vocabulary::{Bounds, Interval};

use super::instance::{Instance, Module};
use super::make::is_empty;
use super::outline::outline;
use super::transforms::apply;
use super::witnesses::exact_box;
use super::{Built, Stop};
use crate::value::Value;

pub(super) const MODULES: &[Module] =
    &[Module { name: "resize", positional: &["newsize", "auto"], named: &[], build: resize }];

fn resize(instance: &mut Instance) -> Built {
    let child = instance.union();
    let size = instance.vector::<3>("newsize", 1, 0.0).unwrap_or([Scalar::ZERO, Scalar::ZERO, Scalar::ZERO]);
    let auto = read_auto(instance);
    if is_empty(&child) || size.iter().all(|side| side.is(0.0)) {
        return Ok(child);
    }
    let is_plane = child.dimension() == Some(Dimension::Plane);
    let bounds = if is_plane { plane_box(&child)? } else { exact_box(&child)? };
    let Some(bounds) = bounds else {
        let diagnostic = Diagnostic::error(instance.head, "the size of what is resized here is not known exactly")
            .with_related(child.span, "this")
            .with_hint("`resize` knows shapes, unions and simple differences of them; `scale` works on all");
        return Err(Stop::Error(Box::new(diagnostic)));
    };
    let axes = if is_plane { 2 } else { 3 };
    let factor = |axis: usize| {
        let known = axis < axes && !size[axis].is(0.0) && bounds.size()[axis] > 0.0;
        known.then(|| size[axis].clone() / Scalar::from(bounds.size()[axis]))
    };
    let common = largest(&size[..axes]).and_then(factor).unwrap_or(Scalar::ONE);
    let factors = std::array::from_fn(|axis| match factor(axis) {
        Some(factor) => factor,
        None if axis < axes && auto[axis] => common.clone(),
        None => Scalar::ONE,
    });
    apply(instance, Affine::scaling(factors), child)
}

/// The smallest box around a plane shape.
fn plane_box(child: &Solid) -> Result<Option<Bounds>, Stop> {
    let bounds = outline(child)?.bounds();
    let of_corners = |(min, max): (Point, Point)| {
        Bounds::new(Interval::new(min[0], max[0]), Interval::new(min[1], max[1]), Interval::point(0.0))
    };
    Ok(bounds.map(of_corners))
}

/// Which axes follow the one that is given the largest size. One truth value is for all of them.
fn read_auto(instance: &mut Instance) -> [bool; 3] {
    let truth = |value: &Value| match value {
        Value::Bool(truth) => *truth,
        Value::Number(number) => !number.is(0.0),
        _ => false,
    };
    match instance.value("auto") {
        None => [false; 3],
        Some((Value::List(items), _)) => std::array::from_fn(|axis| items.get(axis).is_some_and(truth)),
        Some((value @ (Value::Bool(_) | Value::Number(_)), _)) => [truth(&value); 3],
        Some((value, span)) => {
            instance.unfit::<()>("auto", &value, span, "a truth value or a list of three, known beforehand");
            [false; 3]
        }
    }
}

/// The axis with the largest new size. A live size counts with the greatest value it may take.
fn largest(size: &[Scalar]) -> Option<usize> {
    let most = |axis: &usize| size[*axis].range().max;
    (0..size.len()).max_by(|a, b| most(a).total_cmp(&most(b)).then(b.cmp(a)))
}
