//! The corners of a polygon light: a simple polygon, anticlockwise.

use chiaro_solid::Scalar;
use chiaro_syntax::{Diagnostic, Span};

use super::super::arguments::numbers;
use super::super::instance::{Instance, error};
use super::super::{Stop, decide};
use super::LARGEST;
use crate::value::Value;

type Corner = [f64; 2];

/// A light has no more corners than this.
const MOST_CORNERS: usize = 1000;

/// The corners. As with `polygon`, they are constants.
pub(super) fn read(instance: &mut Instance) -> Result<Vec<[Scalar; 2]>, Stop> {
    let Some((value, span)) = instance.value("points") else {
        let needs = Diagnostic::error(instance.head, "`polygon_light` needs its `points`")
            .with_hint("`points` is a list of three corners or more, each [x, y]");
        return Err(Stop::Error(Box::new(needs)));
    };
    let mut corners = points(&value, span)?;
    if corners.len() < 3 {
        return Err(error(span, "a polygon light needs three different corners or more"));
    }
    if corners.len() > MOST_CORNERS {
        return Err(error(span, format!("a polygon light has no more than {MOST_CORNERS} corners")));
    }
    if let Some((first, second)) = meeting(&corners) {
        let message = format!("this outline crosses or touches itself: its edges {first} and {second} meet");
        return Err(Stop::Error(Box::new(
            Diagnostic::error(span, message)
                .with_hint("a polygon light needs an outline without crossings; use several"),
        )));
    }
    if twice_area(&corners) < 0.0 {
        corners.reverse();
    }
    Ok(corners.into_iter().map(|corner| corner.map(Scalar::from)).collect())
}

/// The points, without those that repeat the one before.
fn points(value: &Value, span: Span) -> Result<Vec<Corner>, Stop> {
    let Value::List(items) = value else {
        return Err(error(span, "`points` has to be a list of points, each [x, y]"));
    };
    let mut corners: Vec<Corner> = Vec::with_capacity(items.len());
    for (index, item) in items.iter().enumerate() {
        let coordinates = numbers(item);
        let Some([x, y]) = coordinates.as_deref() else {
            return Err(error(span, format!("point {index} of this light is not [x, y]")));
        };
        let reason = "a corner of a light";
        let corner = [decide::constant(x, span, reason)?, decide::constant(y, span, reason)?];
        if !corner.iter().all(|coordinate| coordinate.is_finite()) {
            return Err(error(span, format!("point {index} of this light is not finite")));
        }
        if corner.iter().any(|coordinate| coordinate.abs() > LARGEST) {
            return Err(error(span, format!("point {index} of this light is farther away than 1000 km")));
        }
        if corners.last() != Some(&corner) {
            corners.push(corner);
        }
    }
    if corners.len() > 1 && corners.first() == corners.last() {
        corners.pop();
    }
    Ok(corners)
}

/// Two edges that have a point in common which they should not have. Edge i goes from corner i to the next.
fn meeting(corners: &[Corner]) -> Option<(usize, usize)> {
    let count = corners.len();
    let edge = |i: usize| [corners[i], corners[(i + 1) % count]];
    for i in 0..count {
        let next = (i + 1) % count;
        if folds_back(edge(i), edge(next)) {
            return Some((i, next));
        }
        // All later edges but the two beside it.
        let last = if i == 0 { count - 1 } else { count };
        if let Some(j) = (i + 2..last).find(|j| touch(edge(i), edge(*j))) {
            return Some((i, j));
        }
    }
    None
}

/// Whether an edge goes back along the one before.
fn folds_back([a, b]: [Corner; 2], [_, c]: [Corner; 2]) -> bool {
    let (p, q) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
    turn(a, b, c) == 0.0 && p[0] * q[0] + p[1] * q[1] < 0.0
}

/// Whether two segments have a point in common.
fn touch([a, b]: [Corner; 2], [c, d]: [Corner; 2]) -> bool {
    let (from_c, from_d) = (turn(a, b, c), turn(a, b, d));
    let (from_a, from_b) = (turn(c, d, a), turn(c, d, b));
    let overlap =
        |axis: usize| a[axis].min(b[axis]) <= c[axis].max(d[axis]) && c[axis].min(d[axis]) <= a[axis].max(b[axis]);
    let opposite = |p: f64, q: f64| p == 0.0 || q == 0.0 || (p > 0.0) != (q > 0.0);
    opposite(from_c, from_d) && opposite(from_a, from_b) && overlap(0) && overlap(1)
}

/// Positive, if the way from a by b to c turns left.
fn turn(a: Corner, b: Corner, c: Corner) -> f64 {
    (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
}

fn twice_area(corners: &[Corner]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn simple_outlines_do_not_meet_themselves() {
        let simple: [&[Corner]; 3] = [
            &[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]],
            &[[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [2.0, 1.0], [0.0, 3.0]],
            &[[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 3.0]],
        ];
        for corners in simple {
            assert_eq!(meeting(corners), None, "{corners:?}");
        }
    }

    #[test]
    fn others_meet_themselves() {
        let tangled: [(&[Corner], (usize, usize)); 4] = [
            (&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]], (0, 2)),
            (&[[0.0, 0.0], [4.0, 0.0], [2.0, 0.0]], (0, 1)),
            (&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 0.0], [0.0, 4.0]], (0, 2)),
            (&[[0.0, 0.0], [4.0, 0.0], [5.0, 2.0], [4.0, 0.0], [0.0, 4.0]], (0, 2)),
        ];
        for (corners, edges) in tangled {
            assert_eq!(meeting(corners), Some(edges), "{corners:?}");
        }
    }
}
