//! Translate, rotate, scale, mirror, multmatrix.

use std::sync::Arc;

use chiaro_solid::affine::Similarity;
use chiaro_solid::{Affine, Dimension, Scalar, Solid};
use chiaro_syntax::Span;

use super::arguments::numbers;
use super::decide::{self, Sign};
use super::instance::{Instance, Module};
use super::make::{empty, is_empty, transformed};
use super::{Aside, Built, Stop};
use crate::value::Value;

pub(super) const MODULES: &[Module] = &[
    Module { name: "translate", positional: &["v"], named: &[], build: translate },
    Module { name: "rotate", positional: &["a", "v"], named: &[], build: rotate },
    Module { name: "scale", positional: &["v"], named: &[], build: scale },
    Module { name: "mirror", positional: &["v"], named: &[], build: mirror },
    Module { name: "multmatrix", positional: &["m"], named: &[], build: multmatrix },
];

/// Below this share of the product of its columns' lengths, a determinant counts as zero.
const SINGULAR: f64 = 1e-12;

fn translate(instance: &mut Instance) -> Built {
    let by = instance.vector::<3>("v", 2, 0.0);
    let map = by.map_or_else(Affine::identity, Affine::translation);
    transform(instance, map)
}

fn rotate(instance: &mut Instance) -> Built {
    let map = read_rotation(instance)?;
    transform(instance, map)
}

fn read_rotation(instance: &mut Instance) -> Result<Affine, Stop> {
    match instance.value("a") {
        None => Ok(Affine::identity()),
        Some((Value::Number(angle), span)) => {
            if !angle.is_finite() {
                instance.warn(span, "this angle is not finite, so that nothing is turned");
                return Ok(Affine::identity());
            }
            let axis = instance.vector::<3>("v", 3, 0.0);
            match axis {
                None => Ok(Affine::rotation(2, angle)),
                Some(axis) if is_nonzero(&axis, instance.place("v"), "an axis")? => {
                    Ok(Affine::rotation_about(axis, angle))
                }
                Some(_) => {
                    instance.warn(instance.place("v"), "this axis has no direction, so that nothing is turned");
                    Ok(Affine::identity())
                }
            }
        }
        Some((value @ Value::List(_), span)) => {
            if instance.value("v").is_some() {
                let span = instance.place("v");
                instance.warn(span, "the axis is ignored, because there is an angle for each of x, y and z");
            }
            let angles = read_angles(instance, &value, span);
            let [x, y, z] = angles;
            Ok(Affine::rotation(2, z).after(&Affine::rotation(1, y)).after(&Affine::rotation(0, x)))
        }
        Some((value, span)) => {
            instance.unfit::<()>("a", &value, span, "an angle or a list of three angles");
            Ok(Affine::identity())
        }
    }
}

/// The angles about x, y and z. As in OpenSCAD, missing ones are zero and what follows the third does not count; one
/// that is not finite makes the matrix so, and that leaves nothing.
fn read_angles(instance: &mut Instance, value: &Value, span: Span) -> [Scalar; 3] {
    let Some(angles) = numbers(value) else {
        instance.unfit::<()>("a", value, span, "an angle or a list of three angles");
        return [Scalar::ZERO, Scalar::ZERO, Scalar::ZERO];
    };
    if angles.len() > 3 {
        instance.warn(span, "there are angles about x, y and z: what follows the third does not count");
    }
    std::array::from_fn(|axis| angles.get(axis).cloned().unwrap_or(Scalar::ZERO))
}

fn scale(instance: &mut Instance) -> Built {
    let factors = instance.number_or_vector::<3>("v", 2, 1.0);
    let map = factors.map_or_else(Affine::identity, Affine::scaling);
    transform(instance, map)
}

fn mirror(instance: &mut Instance) -> Built {
    let normal = instance.vector::<3>("v", 2, 0.0).unwrap_or([Scalar::ONE, Scalar::ZERO, Scalar::ZERO]);
    let map = if is_nonzero(&normal, instance.place("v"), "a mirror's normal")? {
        Affine::reflection(normal)
    } else {
        Affine::identity()
    };
    transform(instance, map)
}

fn multmatrix(instance: &mut Instance) -> Built {
    match read_matrix(instance)? {
        Some(map) => transform(instance, map),
        None => {
            *instance.aside = Aside::default();
            Ok(empty(instance.head))
        }
    }
}

/// The matrix; none if its last entry divides by zero. Missing entries are those of the identity.
fn read_matrix(instance: &mut Instance) -> Result<Option<Affine>, Stop> {
    let Some((value, span)) = instance.value("m") else { return Ok(Some(Affine::identity())) };
    let Value::List(rows) = &value else {
        instance.unfit::<()>("m", &value, span, "a matrix of four rows");
        return Ok(Some(Affine::identity()));
    };
    let rows: Vec<Vec<Scalar>> = rows.iter().map(|row| numbers(row).unwrap_or_default()).collect();
    let entry = |i: usize, j: usize| {
        let given = rows.get(i).and_then(|row| row.get(j));
        given.cloned().unwrap_or(Scalar::from(f64::from(i == j)))
    };
    let divisor = entry(3, 3);
    if decide::sign(&divisor, span, "the last entry of a matrix")? == Sign::Zero {
        instance.warn(span, "the last entry of this matrix is zero, so that there is nothing");
        return Ok(None);
    }
    let rows = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j) / divisor.clone()));
    Ok(Some(Affine::new(rows)))
}

/// The children under a map.
fn transform(instance: &mut Instance, map: Affine) -> Built {
    instance.move_aside(&map)?;
    let child = instance.union();
    apply(instance, map, child)
}

/// A solid under a map that may be singular or not finite, in which case there is nothing.
pub(super) fn apply(instance: &mut Instance, map: Affine, child: Arc<Solid>) -> Built {
    if is_empty(&child) {
        return Ok(child);
    }
    let map = if child.dimension() == Some(Dimension::Plane) { planar(&map) } else { map };
    if !decide::are_finite(map.rows().iter().flatten(), instance.head)? {
        instance.warn(instance.head, format!("`{}` is not finite here, so that there is nothing", instance.name));
        return Ok(empty(instance.head));
    }
    if !is_regular(&map, instance.head)? {
        instance.warn(instance.head, format!("`{}` flattens this to nothing", instance.name));
        return Ok(empty(instance.head));
    }
    Ok(transformed(map, child, instance.head))
}

/// What a map does to plane shapes: as in OpenSCAD, its parts that involve z do not count. Its factor for z is chosen
/// so that the map is a similarity if it is one in the plane, and so that z does not lessen what it scales by.
pub(super) fn planar(map: &Affine) -> Affine {
    let [[a, b, _, x], [c, d, _, y], [zx, zy, z, _]] = map.rows().clone();
    let is_planar = [&map.rows()[0][2], &map.rows()[1][2], &zx, &zy].iter().all(|entry| entry.is(0.0));
    let is_similarity = matches!(map.similarity(), Similarity::Uniform(_));
    if is_planar && is_similarity && !z.is(0.0) && map.rows()[2][3].is(0.0) {
        return map.clone();
    }
    let zero = || Scalar::ZERO;
    let shift = Affine::translation([x, y, zero()]);
    if b.is(0.0) && c.is(0.0) {
        let z = if a == d { a.clone() } else { a.clone().abs().max(d.clone().abs()) };
        return shift.after(&Affine::scaling([a, d, z]));
    }
    let length = |p: &Scalar, q: &Scalar| (p.clone() * p.clone() + q.clone() * q.clone()).sqrt();
    let z = length(&a, &c).max(length(&b, &d));
    let linear = [[a, b, zero(), zero()], [c, d, zero(), zero()], [zero(), zero(), z, zero()]];
    shift.after(&Affine::new(linear))
}

/// Whether a map keeps its dimensions apart.
pub(super) fn is_regular(map: &Affine, span: Span) -> Result<bool, Stop> {
    let reason = "whether a matrix flattens what it is applied to";
    if let Similarity::Uniform(factor) = map.similarity() {
        return Ok(decide::sign(&factor, span, reason)? != Sign::Zero);
    }
    let determinant = map.determinant();
    let length = |j: usize| (0..3).map(|i| map.rows()[i][j].range().magnitude().powi(2)).sum::<f64>().sqrt();
    if determinant.range().abs().min > SINGULAR * length(0) * length(1) * length(2) {
        return Ok(true);
    }
    match live_entries(map) {
        Some(entries) if !determinant.is(0.0) => Err(decide::demote(entries, span, reason)),
        _ => Ok(false),
    }
}

/// A number with all live parameters in it that a map depends on; none, if it is constant.
pub(super) fn live_entries(map: &Affine) -> Option<Scalar> {
    let live = map.rows().iter().flatten().filter(|entry| entry.constant().is_none());
    live.cloned().reduce(|sum, entry| sum + entry)
}

/// Whether a vector has a direction.
pub(super) fn is_nonzero(vector: &[Scalar; 3], span: Span, reason: &'static str) -> Result<bool, Stop> {
    let mut undecided = None;
    for component in vector {
        match decide::sign(component, span, reason) {
            Ok(Sign::Zero) => {}
            Ok(_) => return Ok(component.is_finite()),
            Err(stop) => undecided = Some(stop),
        }
    }
    undecided.map_or(Ok(false), Err)
}
