//! OpenSCAD's plane shapes: square, circle, polygon.

use std::sync::Arc;

use chiaro_plane::{Point, Region};
use chiaro_solid::{Scalar, Solid};
use chiaro_syntax::Span;
use chiaro_vocabulary::rows;

use super::arguments::numbers;
use super::instance::{Instance, Module};
use super::make::{empty, half, moved, offset, region, shape};
use super::outline::opened;
use super::{Built, Stop, decide};
use crate::value::Value;

pub(super) const MODULES: &[Module] = &[
    Module { name: "square", positional: &["size", "center"], named: &["r"], build: square },
    Module { name: "circle", positional: &["r"], named: &["d"], build: circle },
    Module { name: "polygon", positional: &["points", "paths"], named: &["r"], build: polygon },
];

fn square(instance: &mut Instance) -> Built {
    instance.without_children();
    let size = instance.number_or_vector::<2>("size", 2, 0.0).unwrap_or([Scalar::ONE, Scalar::ONE]);
    if !instance.are_sizes(&size, instance.place("size"))? {
        return Ok(empty(instance.head));
    }
    let half = size.map(|side| half(&side));
    let [x, y] = half.clone();
    let rounding = instance.rounding("r", &x.min(y))?.unwrap_or(Scalar::ZERO);
    let inner = half.clone().map(|side| side - rounding.clone());
    let solid = offset(rounding, shape(&rows::RECTANGLE, inner, instance.head), instance.head);
    let corner = Scalar::ONE - instance.truth("center").unwrap_or(Scalar::ZERO);
    let [x, y] = half.map(|side| side * corner.clone());
    Ok(moved([x, y, Scalar::ZERO], solid, instance.head))
}

fn circle(instance: &mut Instance) -> Built {
    instance.without_children();
    let radius = instance.radius("r", "d").unwrap_or(Scalar::ONE);
    if !instance.are_sizes(std::slice::from_ref(&radius), instance.place_of_radius())? {
        return Ok(empty(instance.head));
    }
    Ok(disc(radius, instance.sides()?, instance.head))
}

/// A disc, or the regular polygon in its circle.
fn disc(radius: Scalar, sides: Option<u32>, span: Span) -> Arc<Solid> {
    match sides {
        None => shape(&rows::CIRCLE, [radius], span),
        Some(sides) => shape(&rows::NGON, [radius, Scalar::from(f64::from(sides))], span),
    }
}

fn polygon(instance: &mut Instance) -> Built {
    instance.without_children();
    let points = read_points(instance)?;
    let paths = read_paths(instance, points.len())?;
    let outline = Region::polygon(&points, paths.as_deref());
    let rounding = match instance.finite_number("r")? {
        Some(radius) => decide::constant(&radius, instance.place("r"), "the radius of a polygon's corners")?,
        None => 0.0,
    };
    let outline = if rounding > 0.0 { opened(&outline, rounding, instance.head)? } else { outline };
    Ok(region(outline, instance.head))
}

/// The points; those that are none are reported and stand at the origin, as in OpenSCAD.
fn read_points(instance: &mut Instance) -> Result<Vec<Point>, Stop> {
    let Some((value, span)) = instance.value("points") else {
        instance.warn(instance.head, "this polygon has no points, so that there is nothing");
        return Ok(Vec::new());
    };
    let Value::List(items) = &value else {
        instance.unfit::<()>("points", &value, span, "a list of points");
        return Ok(Vec::new());
    };
    let mut points = Vec::with_capacity(items.len());
    for (index, item) in items.iter().enumerate() {
        let point = match numbers(item).as_deref() {
            Some([x, y, ..]) => {
                let reason = "a point of a polygon";
                [decide::constant(x, span, reason)?, decide::constant(y, span, reason)?]
            }
            _ => [f64::NAN; 2],
        };
        if point.iter().all(|x| x.is_finite()) {
            points.push(point);
        } else {
            instance.warn(span, format!("point {index} of this polygon is not two finite numbers: [0, 0] is used"));
            points.push([0.0, 0.0]);
        }
    }
    Ok(points)
}

/// The paths, if they are given, as indices of points. A list of numbers is one path.
fn read_paths(instance: &mut Instance, points: usize) -> Result<Option<Vec<Vec<usize>>>, Stop> {
    let Some((value, span)) = instance.value("paths") else { return Ok(None) };
    let Value::List(items) = &value else {
        return Ok(instance.unfit("paths", &value, span, "a list of lists of indices"));
    };
    let lists: Vec<Vec<Scalar>> = match numbers(&value) {
        Some(path) if !path.is_empty() => vec![path],
        _ => items.iter().filter_map(numbers).collect(),
    };
    let mut invalid = false;
    let mut paths = Vec::with_capacity(lists.len());
    for list in lists {
        let mut path = Vec::with_capacity(list.len());
        for index in list {
            let index = decide::constant(&index, span, "an index of a polygon's path")?;
            let valid = !index.is_nan() && index >= 0.0 && (index as usize) < points;
            invalid |= !valid;
            if valid {
                path.push(index as usize);
            }
        }
        paths.push(path);
    }
    if invalid {
        instance.warn(span, format!("indices that are not of one of the {points} points are left out of the paths"));
    }
    // An empty list of paths is one path of all points.
    Ok((!paths.is_empty()).then_some(paths))
}
