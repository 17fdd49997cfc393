//! Numbers of small matrices.

use chiaro_solid::singular::{self, Matrix};
use chiaro_solid::{Affine, Scalar};

/// The rows of a map, if they are constant.
pub(crate) fn constant_rows(map: &Affine) -> Option<[[f64; 4]; 3]> {
    let mut rows = [[0.0; 4]; 3];
    for (row, entries) in rows.iter_mut().zip(map.rows()) {
        for (value, entry) in row.iter_mut().zip(entries) {
            *value = entry.constant()?;
        }
    }
    Some(rows)
}

/// The linear part of rows.
pub(crate) fn linear(rows: &[[f64; 4]; 3]) -> Matrix {
    rows.map(|row| [row[0], row[1], row[2]])
}

/// The inverse of a regular map.
pub(crate) fn inverse(rows: &[[f64; 4]; 3]) -> [[f64; 4]; 3] {
    let adjugate = singular::adjugate(&linear(rows));
    let determinant: f64 = (0..3).map(|j| rows[0][j] * adjugate[j][0]).sum();
    adjugate.map(|row| {
        // Adding zero turns −0 into 0, so that equal maps are equal bit for bit.
        let [x, y, z] = row.map(|entry| entry / determinant + 0.0);
        [x, y, z, 0.0 - (x * rows[0][3] + y * rows[1][3] + z * rows[2][3])]
    })
}

/// The lengths of the columns of a map's linear part, if the columns are at right angles to each other: then it is a
/// rotation (or reflection) after a scaling of the axes by them.
pub(crate) fn orthogonal_columns(map: &Affine) -> Option<[Scalar; 3]> {
    const TOLERANCE: f64 = 1e-6;
    let rows = map.rows();
    if (0..3).all(|i| (0..3).all(|j| i == j || rows[i][j].is(0.0))) {
        return Some([0, 1, 2].map(|i| magnitude(&rows[i][i])));
    }
    let m = linear(&constant_rows(map)?);
    let product = |i: usize, j: usize| (0..3).map(|k| m[k][i] * m[k][j]).sum::<f64>();
    let lengths = [0, 1, 2].map(|i| product(i, i).sqrt());
    let right = |i: usize, j: usize| product(i, j).abs() <= TOLERANCE * lengths[i] * lengths[j];
    (right(0, 1) && right(0, 2) && right(1, 2)).then(|| lengths.map(Scalar::from))
}

/// The absolute value; nothing to compute if the sign is known.
pub(crate) fn magnitude(number: &Scalar) -> Scalar {
    let range = number.range();
    if range.min >= 0.0 {
        number.clone()
    } else if range.max <= 0.0 {
        -number.clone()
    } else {
        number.clone().abs()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_of_a_turned_stretch() {
        let turn = Affine::rotation_about([1.0, 2.0, 3.0].map(Scalar::from), Scalar::from(50.0));
        let stretch = Affine::scaling([2.0, 3.0, 5.0].map(Scalar::from));
        let map = turn.after(&stretch);
        let m = linear(&constant_rows(&map).unwrap());
        let values = singular::values(&m);
        assert!(values.iter().zip([5.0, 3.0, 2.0]).all(|(a, b)| (a - b).abs() < 1e-12), "{values:?}");
        let lengths = orthogonal_columns(&map).unwrap().map(|length| length.constant().unwrap());
        assert!(lengths.iter().zip([2.0, 3.0, 5.0]).all(|(a, b)| (a - b).abs() < 1e-12), "{lengths:?}");
        assert_eq!(orthogonal_columns(&stretch.after(&turn)), None);
    }
}
