//! Outlines as polygons.

use crate::region::{Edge, Point, Region, on_circle};

/// The default tolerance of flattened arcs, as a part of the diagonal of the region's bounding box.
pub const DEFAULT_TOLERANCE: f64 = 1e-4;

/// The most chords one arc becomes.
const MAX_CHORDS: f64 = 16384.0;

/// The default distance, in millimetres, between the arcs of a region and their chords: [`DEFAULT_TOLERANCE`] of
/// the diagonal of its bounding box.
pub fn default_tolerance(region: &Region) -> f64 {
    region.diagonal() * DEFAULT_TOLERANCE
}

impl Region {
    /// The corners of polygons whose edges are no further than `tolerance` millimetres from the outlines. The
    /// corners lie on the outlines. (One arc becomes at most 16,384 edges, however small the tolerance.)
    pub fn flatten(&self, tolerance: f64) -> Vec<Vec<Point>> {
        let corners = |edges: &[Edge]| {
            let mut points = Vec::with_capacity(edges.len());
            for edge in edges {
                edge.flatten_into(tolerance, &mut points);
            }
            points
        };
        self.contours.iter().map(|contour| corners(&contour.edges)).collect()
    }
}

impl Edge {
    /// Appends the corners of a flattened edge, but for the last, which is the first of the edge that follows.
    fn flatten_into(&self, tolerance: f64, points: &mut Vec<Point>) {
        points.push(self.start());
        if let Edge::Arc { center, radius, start, sweep } = *self {
            let chords = chord_count(radius, sweep, tolerance);
            let angle = |k| start + sweep * f64::from(k) / f64::from(chords);
            points.extend((1..chords).map(|k| on_circle(center, radius, angle(k))));
        }
    }
}

/// How many chords an arc needs so that they are within the tolerance of it: never fewer than four a turn.
fn chord_count(radius: f64, sweep: f64, tolerance: f64) -> u32 {
    let sagitta = (tolerance / radius).clamp(0.0, 0.25);
    let step = 2.0 * (1.0 - sagitta).acos();
    // A tolerance of zero (or NaN) makes this infinite (or NaN): both are clamped.
    (sweep.abs() / step).min(MAX_CHORDS).max((sweep.abs() / 1.6).ceil()).ceil().max(1.0) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chords_keep_to_the_tolerance() {
        for tolerance in [0.5, 1e-2, 1e-5] {
            let corners = &Region::circle(10.0).flatten(tolerance)[0];
            let chord = crate::region::distance(corners[0], corners[1]);
            let sagitta = 10.0 - (100.0 - chord * chord / 4.0).sqrt();
            assert!(sagitta <= tolerance * 1.0001, "{sagitta} > {tolerance}");
            assert!(sagitta >= tolerance * 0.2, "needlessly fine: {sagitta} for {tolerance}");
        }
        assert_eq!(Region::circle(1.0).flatten(100.0)[0].len(), 5);
        assert_eq!(Region::circle(1.0).flatten(0.0)[0].len(), 16384);
        assert_eq!(Region::circle(1.0).flatten(f64::NAN)[0].len(), 16384);
    }
}
