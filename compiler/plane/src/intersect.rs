//! Where lines and circles meet.

use crate::contour::unit;
use crate::overlay::Curve;
use crate::region::{Point, add, cross, distance, dot, scale, sub};

/// The points two curves have in common.
pub(crate) struct Crossing {
    pub(crate) points: [Option<Point>; 2],
}

/// Where two curves meet. Curves that miss each other by no more than `slack` touch where they are nearest.
pub(crate) fn crossings(curves: [Curve; 2], slack: f64) -> Crossing {
    let points = match curves {
        [Curve::Line { from, to }, Curve::Line { from: other, to: end }] => {
            [line_line(from, sub(to, from), other, sub(end, other)), None]
        }
        [Curve::Line { from, to }, Curve::Circle { center, radius, .. }]
        | [Curve::Circle { center, radius, .. }, Curve::Line { from, to }] => {
            line_circle(from, unit(sub(to, from)), center, radius, slack)
        }
        [Curve::Circle { center, radius, .. }, Curve::Circle { center: other, radius: other_radius, .. }] => {
            circle_circle((center, radius), (other, other_radius), slack)
        }
    };
    Crossing { points }
}

fn line_line(a: Point, along_a: Point, b: Point, along_b: Point) -> Option<Point> {
    let sine = cross(unit(along_a), unit(along_b));
    let t = cross(sub(b, a), along_b) / cross(along_a, along_b);
    (sine.abs() > 1e-9).then(|| add(a, scale(along_a, t)))
}

fn line_circle(from: Point, along: Point, center: Point, radius: f64, slack: f64) -> [Option<Point>; 2] {
    let foot = add(from, scale(along, dot(sub(center, from), along)));
    let height = distance(foot, center);
    if height > radius + slack {
        return [None, None];
    }
    if height > radius {
        return [Some(add(center, scale(sub(foot, center), radius / height))), None];
    }
    let half = ((radius - height) * (radius + height)).sqrt();
    [half, -half].map(|t| Some(add(foot, scale(along, t))))
}

fn circle_circle(a: (Point, f64), b: (Point, f64), slack: f64) -> [Option<Point>; 2] {
    let apart = distance(a.0, b.0);
    let gap = (apart - a.1 - b.1).max((a.1 - b.1).abs() - apart);
    if gap > slack || apart <= 1e-9 * a.1.max(b.1) {
        return [None, None];
    }
    let along = unit(sub(b.0, a.0));
    let foot = ((apart * apart + (a.1 - b.1) * (a.1 + b.1)) / (2.0 * apart)).clamp(-a.1, a.1);
    let height = ((a.1 - foot) * (a.1 + foot)).max(0.0).sqrt();
    let point = |h: f64| Some(add(a.0, [along[0] * foot - along[1] * h, along[1] * foot + along[0] * h]));
    [point(height), point(-height)]
}
