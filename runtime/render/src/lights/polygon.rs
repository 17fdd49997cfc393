//! Polygon lights as convex pieces.

/// Quadrilaterals that together are the simple polygon with these corners; the last two corners of a triangle are the
/// same.
pub(crate) fn quadrilaterals(corners: &[[f64; 2]]) -> Vec<[[f64; 2]; 4]> {
    if let [a, b, c, d] = *corners
        && is_convex(&[a, b, c, d])
    {
        return vec![[a, b, c, d]];
    }
    let mut indices: Vec<u32> = Vec::new();
    earcut::Earcut::new().earcut(corners.iter().copied(), &[], &mut indices);
    let triangle = |of: &[u32]| [0, 1, 2, 2].map(|k: usize| corners[of[k] as usize]);
    indices.chunks_exact(3).map(triangle).collect()
}

fn is_convex(corners: &[[f64; 2]; 4]) -> bool {
    let turn = |i: usize| {
        let [a, b, c] = [i, (i + 1) % 4, (i + 2) % 4].map(|k| corners[k]);
        (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
    };
    let turns = [0, 1, 2, 3].map(turn);
    turns.iter().all(|&turn| turn > 0.0) || turns.iter().all(|&turn| turn < 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(piece: &[[f64; 2]; 4]) -> f64 {
        let cross = |i: usize| {
            let (a, b) = (piece[i], piece[(i + 1) % 4]);
            a[0] * b[1] - a[1] * b[0]
        };
        (0.5 * (0..4).map(cross).sum::<f64>()).abs()
    }

    #[test]
    fn pieces_cover_the_polygon() {
        let arrow = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [2.0, 1.0], [0.0, 3.0]];
        let pieces = quadrilaterals(&arrow);
        assert_eq!(pieces.len(), 3);
        assert!((pieces.iter().map(area).sum::<f64>() - 8.0).abs() < 1e-12);
        assert_eq!(quadrilaterals(&[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]]).len(), 1);
        assert_eq!(quadrilaterals(&[[0.0, 0.0], [4.0, 0.0], [0.5, 0.5], [0.0, 4.0]]).len(), 2);
    }
}
