//! Numbers of small matrices.

use chiaro_solid::{Affine, Scalar};

/// A 3 × 3 matrix by rows.
pub(crate) type Linear = [[f64; 3]; 3];

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
pub(crate) fn linear(rows: &[[f64; 4]; 3]) -> Linear {
    rows.map(|row| [row[0], row[1], row[2]])
}

/// The inverse of a regular map.
pub(crate) fn inverse(rows: &[[f64; 4]; 3]) -> [[f64; 4]; 3] {
    let cofactor = |i: usize, j: usize| {
        let (i1, i2, j1, j2) = ((i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3);
        rows[i1][j1] * rows[i2][j2] - rows[i1][j2] * rows[i2][j1]
    };
    let determinant: f64 = (0..3).map(|j| rows[0][j] * cofactor(0, j)).sum();
    let mut result = [[0.0; 4]; 3];
    for (i, row) in result.iter_mut().enumerate() {
        for (j, entry) in row[..3].iter_mut().enumerate() {
            // Adding zero turns −0 into 0, so that equal maps are equal bit for bit.
            *entry = cofactor(j, i) / determinant + 0.0;
        }
        row[3] = 0.0 - (0..3).map(|j| row[j] * rows[j][3]).sum::<f64>();
    }
    result
}

/// The greatest singular value: what a matrix makes lengths longer by at the most.
pub(crate) fn largest_singular_value(m: &Linear) -> f64 {
    symmetric_eigenvalues(&gram(m)).1.max(0.0).sqrt()
}

/// The ratio of the greatest and the least singular value.
pub(crate) fn condition(m: &Linear) -> f64 {
    let (least, most) = symmetric_eigenvalues(&gram(m));
    if least > 0.0 { (most / least).sqrt() } else { f64::INFINITY }
}

/// MᵀM.
fn gram(m: &Linear) -> Linear {
    let dot = |i: usize, j: usize| (0..3).map(|k| m[k][i] * m[k][j]).sum::<f64>();
    std::array::from_fn(|i| std::array::from_fn(|j| dot(i, j)))
}

/// The least and greatest eigenvalue of a symmetric matrix, in closed form (Smith 1961).
fn symmetric_eigenvalues(m: &Linear) -> (f64, f64) {
    let mean = (m[0][0] + m[1][1] + m[2][2]) / 3.0;
    let off = m[0][1].powi(2) + m[0][2].powi(2) + m[1][2].powi(2);
    let spread = ((0..3).map(|i| (m[i][i] - mean).powi(2)).sum::<f64>() + 2.0 * off) / 6.0;
    if spread <= 1e-30 * mean * mean {
        return (mean, mean);
    }
    let p = spread.sqrt();
    let b: Linear = std::array::from_fn(|i| std::array::from_fn(|j| (m[i][j] - if i == j { mean } else { 0.0 }) / p));
    let determinant = b[0][0] * (b[1][1] * b[2][2] - b[1][2] * b[2][1])
        - b[0][1] * (b[1][0] * b[2][2] - b[1][2] * b[2][0])
        + b[0][2] * (b[1][0] * b[2][1] - b[1][1] * b[2][0]);
    let angle = (0.5 * determinant).clamp(-1.0, 1.0).acos() / 3.0;
    let most = mean + 2.0 * p * angle.cos();
    let least = mean + 2.0 * p * (angle + 2.0 * std::f64::consts::FRAC_PI_3).cos();
    (least, most)
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
    let gram = gram(&m);
    let lengths = [0, 1, 2].map(|i| gram[i][i].sqrt());
    let right = |i: usize, j: usize| gram[i][j].abs() <= TOLERANCE * lengths[i] * lengths[j];
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

/// A number divided by a positive one; exactly ±1 where they are equal up to the sign.
pub(crate) fn ratio(number: &Scalar, by: &Scalar) -> Scalar {
    if by.is(1.0) || number.is(0.0) {
        number.clone()
    } else if number == by || (number.clone().abs() == *by && number.range().min >= 0.0) {
        Scalar::ONE
    } else if -number.clone() == *by || (number.clone().abs() == *by && number.range().max <= 0.0) {
        -Scalar::ONE
    } else {
        number.clone() / by.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn singular_values_of_a_turned_stretch() {
        let turn = Affine::rotation_about([1.0, 2.0, 3.0].map(Scalar::from), Scalar::from(50.0));
        let stretch = Affine::scaling([2.0, 3.0, 5.0].map(Scalar::from));
        let map = turn.after(&stretch);
        let m = linear(&constant_rows(&map).unwrap());
        assert!((largest_singular_value(&m) - 5.0).abs() < 1e-9);
        assert!((condition(&m) - 2.5).abs() < 1e-9);
        let lengths = orthogonal_columns(&map).unwrap().map(|length| length.constant().unwrap());
        assert!(lengths.iter().zip([2.0, 3.0, 5.0]).all(|(a, b)| (a - b).abs() < 1e-12), "{lengths:?}");
        assert_eq!(orthogonal_columns(&stretch.after(&turn)), None);
    }
}
