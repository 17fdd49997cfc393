//! What can be measured of a region: bounds, membership, distance, length and area.

use std::f64::consts::{FRAC_PI_2, TAU};

use crate::region::{Contour, Edge, Point, Region, cross, distance, on_circle, sub};

impl Region {
    /// The smallest box around its outlines, arcs included exactly, as its least and its greatest corner; `None` if
    /// it is empty.
    pub fn bounds(&self) -> Option<(Point, Point)> {
        self.edges().map(Edge::bounds).reduce(join)
    }

    /// The length of the diagonal of its bounding box, in millimetres; 0 if it is empty.
    pub fn diagonal(&self) -> f64 {
        self.bounds().map_or(0.0, |(min, max)| distance(min, max))
    }

    /// Whether a point is inside: around it is an odd number of contours. On the outline it may say either.
    pub fn contains(&self, point: Point) -> bool {
        self.contours.iter().fold(false, |odd, contour| odd ^ contour.surrounds(point))
    }

    /// The distance of a point from the outlines, in millimetres, negative inside; infinite if the region is empty.
    pub fn signed_distance(&self, point: Point) -> f64 {
        let outline = self.edges().map(|edge| edge.distance(point)).fold(f64::INFINITY, f64::min);
        if self.contains(point) { -outline } else { outline }
    }
}

impl Contour {
    /// The area it encloses, in square millimetres: positive if it runs anticlockwise.
    pub fn signed_area(&self) -> f64 {
        let Some(origin) = self.edges.first().map(Edge::start) else { return 0.0 };
        self.edges.iter().map(|edge| edge.area_about(origin)).sum()
    }

    /// Its length, in millimetres.
    pub fn length(&self) -> f64 {
        self.edges.iter().map(Edge::length).sum()
    }

    /// Whether the ray from a point towards greater x meets it an odd number of times.
    fn surrounds(&self, point: Point) -> bool {
        let next = self.edges.iter().cycle().skip(1);
        // Edges end exactly where the next ones start, lest a ray slips through between the two.
        self.edges.iter().zip(next).fold(false, |odd, (edge, next)| odd ^ edge.crosses(next.start(), point))
    }
}

impl Edge {
    /// The smallest box around it, as its least and its greatest corner.
    pub fn bounds(&self) -> (Point, Point) {
        let (a, b) = (self.start(), self.end());
        let mut bounds = join((a, a), (b, b));
        if let Edge::Arc { center, radius, start, sweep } = *self {
            let extremes = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
            for (quarter, direction) in extremes.into_iter().enumerate() {
                if turn_from(start, quarter as f64 * FRAC_PI_2, sweep) <= sweep.abs() {
                    let point = [center[0] + radius * direction[0], center[1] + radius * direction[1]];
                    bounds = join(bounds, (point, point));
                }
            }
        }
        bounds
    }

    /// The distance of a point from it, in millimetres.
    pub fn distance(&self, point: Point) -> f64 {
        match *self {
            Edge::Line { from, to } => {
                let (along, offset) = (sub(to, from), sub(point, from));
                let length2 = along[0] * along[0] + along[1] * along[1];
                let t = ((offset[0] * along[0] + offset[1] * along[1]) / length2).clamp(0.0, 1.0);
                let t = if t.is_nan() { 0.0 } else { t };
                distance(point, [from[0] + t * along[0], from[1] + t * along[1]])
            }
            Edge::Arc { center, radius, start, sweep } => {
                let offset = sub(point, center);
                let angle = offset[1].atan2(offset[0]);
                if turn_from(start, angle, sweep) <= sweep.abs() {
                    (offset[0].hypot(offset[1]) - radius).abs()
                } else {
                    distance(point, self.start()).min(distance(point, self.end()))
                }
            }
        }
    }

    /// Whether the ray from a point towards greater x meets the edge, made to end at `end`, an odd number of times.
    fn crosses(&self, end: Point, point: Point) -> bool {
        match *self {
            Edge::Line { from, .. } => line_crosses(from, end, point),
            Edge::Arc { center, radius, start, sweep } => {
                // Each piece crosses as its chord does, unless the point lies between the chord and the arc.
                let inside_circle = distance(point, center) < radius;
                let pieces = (sweep.abs() / FRAC_PI_2).ceil().clamp(1.0, 4.0) as u32;
                let mut odd = false;
                let mut from = self.start();
                for k in 1..=pieces {
                    let angle = start + sweep * f64::from(k) / f64::from(pieces);
                    let to = if k == pieces { end } else { on_circle(center, radius, angle) };
                    let beyond_chord = is_left(from, to, point) != (sweep > 0.0);
                    odd ^= line_crosses(from, to, point) ^ (inside_circle && beyond_chord);
                    from = to;
                }
                odd
            }
        }
    }

    /// The area swept by the straight line from `origin` to a point that walks along the edge.
    fn area_about(&self, origin: Point) -> f64 {
        let triangle = 0.5 * cross(sub(self.start(), origin), sub(self.end(), origin));
        match *self {
            Edge::Line { .. } => triangle,
            Edge::Arc { radius, sweep, .. } => triangle + 0.5 * radius * radius * (sweep - sweep.sin()),
        }
    }
}

/// How far one turns, in the direction of `sweep`, from the angle `start` to `angle`: from 0 to a full turn.
pub(crate) fn turn_from(start: f64, angle: f64, sweep: f64) -> f64 {
    let turn = if sweep < 0.0 { start - angle } else { angle - start };
    turn.rem_euclid(TAU)
}

/// The smallest box around two boxes.
pub(crate) fn join(a: (Point, Point), b: (Point, Point)) -> (Point, Point) {
    let least = [a.0[0].min(b.0[0]), a.0[1].min(b.0[1])];
    let greatest = [a.1[0].max(b.1[0]), a.1[1].max(b.1[1])];
    (least, greatest)
}

fn line_crosses(from: Point, to: Point, point: Point) -> bool {
    let spans = (from[1] > point[1]) != (to[1] > point[1]);
    // The point is left of an upward line, or right of a downward one: the line is on its side of greater x.
    spans && is_left(from, to, point) == (to[1] > from[1])
}

fn is_left(from: Point, to: Point, point: Point) -> bool {
    cross(sub(to, from), sub(point, from)) > 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// The upper half of the unit disc.
    fn half_disc() -> Region {
        let arc = Edge::Arc { center: [0.0, 0.0], radius: 1.0, start: 0.0, sweep: PI };
        let base = Edge::Line { from: [-1.0, 0.0], to: [1.0, 0.0] };
        Region { contours: vec![Contour { edges: vec![arc, base] }] }
    }

    #[test]
    fn bounds_include_what_an_arc_bulges() {
        let (min, max) = half_disc().bounds().unwrap();
        assert_eq!(max, [1.0, 1.0]);
        assert!((min[0] + 1.0).abs() < 1e-15 && min[1].abs() < 1e-15);
        assert_eq!(Region::default().bounds(), None);
    }

    #[test]
    fn membership_agrees_with_the_definition() {
        let half = half_disc();
        let ring = Region { contours: [Region::circle(2.0), Region::circle(1.0)].concat_contours() };
        for i in 0..60 {
            for j in 0..60 {
                let p = [f64::from(i) * 0.081 - 2.4, f64::from(j) * 0.081 - 2.4];
                let r = p[0].hypot(p[1]);
                assert_eq!(half.contains(p), r < 1.0 && p[1] > 0.0, "{p:?}");
                assert_eq!(ring.contains(p), (1.0..2.0).contains(&r), "{p:?}");
                let expected = if r < 1.5 { 1.0 - r } else { r - 2.0 };
                assert!((ring.signed_distance(p) - expected).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn areas_count_the_arcs() {
        assert!((half_disc().contours[0].signed_area() - PI / 2.0).abs() < 1e-12);
        assert!((Region::circle(3.0).contours[0].signed_area() - 9.0 * PI).abs() < 1e-12);
    }

    trait ConcatContours {
        fn concat_contours(self) -> Vec<Contour>;
    }

    impl<const N: usize> ConcatContours for [Region; N] {
        fn concat_contours(self) -> Vec<Contour> {
            self.into_iter().flat_map(|region| region.contours).collect()
        }
    }
}
