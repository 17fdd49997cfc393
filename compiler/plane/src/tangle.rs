//! How often outlines cross themselves and each other.
//!
//! Booleans, offsets and sums take time and memory for every crossing, and n edges may have n² / 2 of them. So who takes
//! outlines from anywhere estimates that number first.

use crate::region::{Point, Region, cross, sub};

/// How many edges are looked at for an estimate.
const SAMPLES: usize = 48;

impl Region {
    /// About how often the edges of the regions cross each other: the crossings of some edges, spread evenly, with
    /// all edges, as if the others had as many. Arcs count as their chords.
    pub fn crossings_estimate(regions: &[Region]) -> f64 {
        let chords: Vec<[Point; 2]> =
            regions.iter().flat_map(Region::edges).map(|edge| [edge.start(), edge.end()]).collect();
        let samples = SAMPLES.min(chords.len());
        let sampled = (0..samples).map(|i| chords[i * chords.len() / samples]);
        let crossings: usize =
            sampled.map(|sample| chords.iter().filter(|chord| cross_each_other(sample, **chord)).count()).sum();
        // Each crossing belongs to two edges.
        0.5 * crossings as f64 * chords.len() as f64 / samples.max(1) as f64
    }
}

/// Whether two segments cross at an inner point of both.
fn cross_each_other(a: [Point; 2], b: [Point; 2]) -> bool {
    let parted = |[from, to]: [Point; 2], [p, q]: [Point; 2]| {
        cross(sub(to, from), sub(p, from)) * cross(sub(to, from), sub(q, from)) < 0.0
    };
    parted(a, b) && parted(b, a)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_convex_outline_never_crosses_itself_and_a_star_polygon_does() {
        assert_eq!(Region::crossings_estimate(&[Region::ngon(10.0, 1000)]), 0.0);
        // {n/k} with k near n/2: every edge crosses nearly all others.
        let n = 1001;
        let corner = |i: usize| {
            let angle = std::f64::consts::TAU * (i * 500 % n) as f64 / n as f64;
            [angle.cos(), angle.sin()]
        };
        let corners: Vec<Point> = (0..n).map(corner).collect();
        let estimate = Region::crossings_estimate(&[Region::polygon(&corners, None)]);
        let exact = (n * (500 - 1)) as f64;
        assert!((estimate / exact - 1.0).abs() < 0.05, "{estimate} of {exact}");
    }
}
