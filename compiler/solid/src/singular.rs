//! Singular values of 3 × 3 matrices.
//!
//! They come from one-sided Jacobi rotations (Hestenes 1958), which turn pairs of columns until all are at right
//! angles; their lengths are the singular values then. The eigenvalues of MᵀM would have the same squares, but to
//! form that product squares the condition number: the least value drowns in rounding where the greatest is some
//! hundred times as large.
//!
//! [`greatest`] and [`least`] are bounds that hold in spite of rounding. How far a field may be trusted rests on them.

use std::array;

/// A 3 × 3 matrix by rows.
pub type Matrix = [[f64; 3]; 3];

/// Three rounds of rotations suffice for most matrices, and this many for all that are finite.
const MOST_ROUNDS: usize = 16;
/// Columns count as at right angles if their product is below this part of that of their lengths.
const RIGHT: f64 = 1e-15;
/// What rounding in all rotations comes to at most, as a part of the result: some ten units in the last place for each
/// of them.
const ROUNDING: f64 = 1e-13;

/// The singular values, without regard to rounding; the greatest comes first.
pub fn values(matrix: &Matrix) -> [f64; 3] {
    let (columns, scale) = turned(matrix);
    let mut lengths = columns.map(|column| scale * length(column));
    lengths.sort_unstable_by(|a, b| b.total_cmp(a));
    lengths
}

/// At least the greatest singular value: what the matrix makes lengths longer by at the most.
pub fn greatest(matrix: &Matrix) -> f64 {
    let (columns, scale) = turned(matrix);
    // What is left of the angles counts too: no eigenvalue is above the greatest row sum (Gershgorin).
    let row_sum = |i: usize| (0..3).map(|j| dot(columns[i], columns[j]).abs()).sum::<f64>();
    let greatest = row_sum(0).max(row_sum(1)).max(row_sum(2)).sqrt();
    scale * greatest * (1.0 + ROUNDING)
}

/// At most the least singular value: what the matrix makes lengths longer by at the least. Zero, if rounding leaves
/// no more than that.
///
/// The product of all three is the determinant, and that of the other two the greatest one of the adjugate.
pub fn least(matrix: &Matrix) -> f64 {
    let scale = scale(matrix);
    let matrix = matrix.map(|row| row.map(|entry| entry / scale));
    let adjugate = adjugate(&matrix);
    let least = scale * (least_determinant(&matrix, &adjugate) / greatest(&adjugate)) * (1.0 - ROUNDING);
    if least > 0.0 { least } else { 0.0 }
}

/// The transposed matrix of cofactors. Every entry is right up to two units in its last place.
pub fn adjugate(m: &Matrix) -> Matrix {
    let cofactor = |i: usize, j: usize| {
        let (i1, i2, j1, j2) = ((i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3);
        difference_of_products(m[i1][j1], m[i2][j2], m[i1][j2], m[i2][j1])
    };
    array::from_fn(|i| array::from_fn(|j| cofactor(j, i)))
}

/// At most the determinant's absolute value, by the expansion that cancels least.
fn least_determinant(m: &Matrix, adjugate: &Matrix) -> f64 {
    const PART: f64 = 16.0 * f64::EPSILON;
    let along = |terms: [f64; 3]| {
        let sum: f64 = terms.iter().sum();
        sum.abs() - PART * terms.iter().map(|term| term.abs()).sum::<f64>()
    };
    let row = |i: usize| along(array::from_fn(|j| m[i][j] * adjugate[j][i]));
    let column = |j: usize| along(array::from_fn(|i| m[i][j] * adjugate[j][i]));
    (0..3).map(|k| row(k).max(column(k))).fold(0.0, f64::max)
}

/// ab − cd (Kahan; Jeannerod et al. 2013).
fn difference_of_products(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let product = c * d;
    let error = (-c).mul_add(d, product);
    a.mul_add(b, -product) + error
}

/// The matrix's columns turned to right angles, divided by a number, and that number.
fn turned(matrix: &Matrix) -> ([[f64; 3]; 3], f64) {
    let scale = scale(matrix);
    let mut columns: Matrix = array::from_fn(|j| array::from_fn(|i| matrix[i][j] / scale));
    for _ in 0..MOST_ROUNDS {
        let turns = [(0, 1), (0, 2), (1, 2)].map(|(i, j)| turn(&mut columns, i, j));
        if turns == [false; 3] {
            break;
        }
    }
    (columns, scale)
}

/// Turns two columns to a right angle and puts the longer one first. Answers whether that changed anything.
fn turn(columns: &mut [[f64; 3]; 3], i: usize, j: usize) -> bool {
    // The longer column comes first (de Rijk 1989): that keeps short ones precise.
    let swapped = dot(columns[i], columns[i]) < dot(columns[j], columns[j]);
    if swapped {
        columns.swap(i, j);
    }
    let (p, q) = (columns[i], columns[j]);
    let (pp, qq, pq) = (dot(p, p), dot(q, q), dot(p, q));
    if pq.abs() <= RIGHT * (pp * qq).sqrt() || pq == 0.0 {
        return swapped;
    }
    let zeta = (qq - pp) / (2.0 * pq);
    let tangent = 1f64.copysign(zeta) / (zeta.abs() + 1f64.hypot(zeta));
    let cosine = 1.0 / 1f64.hypot(tangent);
    let sine = cosine * tangent;
    columns[i] = array::from_fn(|k| cosine * p[k] - sine * q[k]);
    columns[j] = array::from_fn(|k| sine * p[k] + cosine * q[k]);
    true
}

/// A power of two about as large as the greatest entry, so that squares are within range; 1, if all are zero.
fn scale(matrix: &Matrix) -> f64 {
    let greatest = matrix.iter().flatten().fold(0f64, |greatest, entry| greatest.max(entry.abs()));
    if greatest > 0.0 && greatest.is_finite() { greatest.log2().floor().clamp(-1000.0, 1000.0).exp2() } else { 1.0 }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn product(a: &Matrix, b: &Matrix) -> Matrix {
        array::from_fn(|i| array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
    }

    /// A turn about an axis by an angle in radians.
    fn turn_about(axis: usize, angle: f64) -> Matrix {
        let (sin, cos) = angle.sin_cos();
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut m = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        (m[i][i], m[j][j], m[j][i], m[i][j]) = (cos, cos, sin, -sin);
        m
    }

    fn assert_near(found: f64, expected: f64, tolerance: f64) {
        assert!((found / expected - 1.0).abs() <= tolerance, "{found} is not {expected}");
    }

    #[test]
    fn values_of_known_matrices() {
        let golden = (5f64.sqrt() + 1.0) / 2.0;
        let known: [(Matrix, [f64; 3]); 5] = [
            ([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [1.0, 1.0, 1.0]),
            ([[0.0, -3.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.0, 5.0]], [5.0, 3.0, 2.0]),
            ([[1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [golden, 1.0, 1.0 / golden]),
            ([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.0]], [1.0, 1.0, 0.0]),
            ([[3.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 0.0, 1e-200]], [5.0, 1e-200, 0.0]),
        ];
        for (matrix, expected) in known {
            for (value, expected) in values(&matrix).into_iter().zip(expected) {
                assert!((value - expected).abs() <= 1e-15 * (1.0 + expected), "{matrix:?}: {value}, not {expected}");
            }
            let (least, greatest) = (least(&matrix), greatest(&matrix));
            assert!(least <= expected[2] && expected[0] <= greatest, "{least} to {greatest}: {expected:?}");
        }
    }

    /// ((1, k), (0, 1)) has the singular values (√(k² + 4) ± k) / 2, of which the product is 1.
    #[test]
    fn bounds_hold_for_any_shear_from_any_side() {
        for k in [0.5, 3.0, 300.0, 1e3, 1e5, 1e7, 1e9] {
            let greatest_value = (f64::hypot(k, 2.0) + k) / 2.0;
            let shear = [[1.0, k, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            let around = [turn_about(0, 0.3), turn_about(1, 1.1), turn_about(2, -0.7)];
            for (before, after) in around.iter().flat_map(|a| around.iter().map(move |b| (a, b))) {
                // To round the product's entries moves the least value by as much.
                let moved = 8.0 * f64::EPSILON * k * k;
                let turned = product(&product(after, &shear), before);
                let (low, high) = (least(&turned), greatest(&turned));
                assert!(low * greatest_value <= 1.0 + moved && high >= greatest_value * (1.0 - 1e-15), "{k}: {low}");
                assert_near(high, greatest_value, 1e-12);
                assert_near(low, 1.0 / greatest_value, 1e-12 + moved);
            }
            assert!(least(&shear) * greatest_value <= 1.0);
            assert_near(least(&shear), 1.0 / greatest_value, 1e-12);
        }
    }

    #[test]
    fn the_order_of_axes_does_not_matter() {
        let orders = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];
        let shear = [[1.0, 2.2, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let greatest_value = (f64::hypot(2.2, 2.0) + 2.2) / 2.0;
        for (rows, columns) in orders.iter().flat_map(|a| orders.iter().map(move |b| (a, b))) {
            let matrix: Matrix = array::from_fn(|i| array::from_fn(|j| shear[rows[i]][columns[j]]));
            let [most, middle, least_value] = values(&matrix);
            assert_near(most, greatest_value, 1e-15);
            assert_near(middle, 1.0, 1e-15);
            assert_near(least_value, 1.0 / greatest_value, 1e-14);
            assert_near(least(&matrix), 1.0 / greatest_value, 1e-12);
            assert_near(greatest(&matrix), greatest_value, 1e-12);
        }
    }

    #[test]
    fn scaling_scales_the_bounds_at_any_size() {
        let matrix = [[1.0, 30.0, 0.5], [0.0, 1.0, 2.0], [0.25, 0.0, 4.0]];
        let (low, high) = (least(&matrix), greatest(&matrix));
        for size in [1e-140, 1e-30, 1e30, 1e140] {
            let scaled = matrix.map(|row| row.map(|entry| entry * size));
            assert_near(least(&scaled), low * size, 1e-12);
            assert_near(greatest(&scaled), high * size, 1e-12);
        }
    }

    #[test]
    fn what_is_singular_or_no_number_has_no_least_stretch() {
        let flat = [[1.0, 2.0, 3.0], [2.0, 4.0, 6.0], [1.0, 0.0, 1.0]];
        assert_eq!(least(&flat), 0.0);
        assert_eq!(least(&[[0.0; 3]; 3]), 0.0);
        assert_eq!(least(&[[f64::NAN; 3]; 3]), 0.0);
        assert_eq!(least(&[[f64::INFINITY, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]), 0.0);
    }
}
