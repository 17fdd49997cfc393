//! Cutting the disc of a light into cells of equal area.

use std::f64::consts::{PI, TAU};

/// Turns by it in a row never come near each other, in radians.
const GOLDEN_ANGLE: f64 = 2.399_963_229_728_653;

/// The most cells that a disc is cut into.
pub(crate) const MOST_CELLS: u32 = 64;

/// So many cells of the unit disc: centre, share of the area, and radius of a disc as large. They lie in rings about the
/// centre; a cell's centre is its centroid.
///
/// Samples cut the disc in ways of their own: what cells make of a silhouette is wrong by little, but where one is wrong so are
/// its neighbours in the picture, and that shows. Another cut is wrong elsewhere.
pub(crate) fn cells_of_disc(count: u32, sample: u32) -> Vec<[f32; 4]> {
    let turn = f64::from(sample) * GOLDEN_ANGLE;
    let share = 1.0 / f64::from(count);
    let mut cells = Vec::new();
    let mut inner: f64 = 0.0;
    for (ring, of_ring) in rings(count, sample % 2 == 1).into_iter().enumerate() {
        let outer = (inner * inner + f64::from(of_ring) * share).sqrt();
        let half_angle = PI / f64::from(of_ring);
        let is_disc = of_ring == 1 && inner == 0.0;
        let cubes = (outer.powi(3) - inner.powi(3)) / (outer * outer - inner * inner);
        let centroid = if is_disc { 0.0 } else { 2.0 / 3.0 * cubes * half_angle.sin() / half_angle };
        // Every other ring is turned, so that cells don't line up.
        let phase = if ring % 2 == 0 { 0.5 } else { 0.0 };
        for k in 0..of_ring {
            let angle = TAU * (f64::from(k) + phase) / f64::from(of_ring) + turn;
            let centre = [centroid * angle.cos(), centroid * angle.sin()];
            cells.push([centre[0] as f32, centre[1] as f32, share as f32, share.sqrt() as f32]);
        }
        inner = outer;
    }
    cells
}

/// How many cells each ring has, from the centre outwards: in proportion to its circumference, so that cells are about
/// as wide as high. One cell is in the middle, or three are about it.
fn rings(count: u32, is_hollow: bool) -> Vec<u32> {
    match count {
        4 if !is_hollow => return vec![4],
        12 => return vec![3, 9],
        16 if !is_hollow => return vec![5, 11],
        _ => {}
    }
    let first = if is_hollow && count > 3 { 3 } else { 1 };
    let mut rings = vec![first];
    let mut left = count.saturating_sub(first);
    // A ring of the width of a cell has six cells more than the one within.
    let mut full = if first == 3 { 9 } else { 6 };
    while left > 0 {
        let of_ring = if left < full + full / 2 + 3 { left } else { full };
        rings.push(of_ring);
        left -= of_ring;
        full += 6;
    }
    rings
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_share_the_disc_and_lie_around_its_centre() {
        for (count, sample) in (1..=MOST_CELLS).flat_map(|count| [(count, 0), (count, 1)]) {
            let cells = cells_of_disc(count, sample);
            assert_eq!(cells.len(), count as usize);
            let sum = |i: usize| cells.iter().map(|cell| cell[i]).sum::<f32>();
            assert!((sum(2) - 1.0).abs() < 1e-5 && sum(0).abs() < 1e-4 && sum(1).abs() < 1e-4, "{count}");
            assert!(cells.iter().all(|cell| cell[0].hypot(cell[1]) < 1.0));
        }
    }
}
