//! The point that fits planes best.

use crate::vector::{Vector, dot, scale, sub};

/// The sum of the squared distances to planes, as a function of the way from a point of reference.
pub(crate) struct Quadric {
    /// The sum of n nᵀ.
    matrix: [Vector; 3],
    /// The sum of n (n · (p − reference)).
    target: Vector,
    planes: f64,
}

/// What is flatter than this, relative to the number of planes, counts as flat: planes that meet at less than some 11°
/// do not make an edge.
const FLAT: f64 = 0.01;

impl Quadric {
    /// Of planes through points with unit normals.
    pub(crate) fn new(reference: Vector, planes: impl Iterator<Item = (Vector, Vector)>) -> Self {
        let mut quadric = Self { matrix: [[0.0; 3]; 3], target: [0.0; 3], planes: 0.0 };
        for (point, normal) in planes {
            let height = dot(normal, sub(point, reference));
            for axis in 0..3 {
                quadric.target[axis] += normal[axis] * height;
                (0..3).for_each(|other| quadric.matrix[axis][other] += normal[axis] * normal[other]);
            }
            quadric.planes += 1.0;
        }
        quadric
    }

    /// The shortest way from the reference to where the sum is least within a box, whose corners are given as ways from the
    /// reference, which is inside.
    pub(crate) fn least_within(&self, low: Vector, high: Vector) -> Vector {
        self.least_between(low, high, FLAT)
    }

    /// The same for planes that are known to be different ones, whatever their angle is.
    pub(crate) fn exact_within(&self, low: Vector, high: Vector) -> Vector {
        const EXACTLY_FLAT: f64 = 1e-9;
        self.least_between(low, high, EXACTLY_FLAT)
    }

    fn least_between(&self, low: Vector, high: Vector, flat: f64) -> Vector {
        let mut held: [Option<f64>; 3] = [None; 3];
        loop {
            let way = self.least(&held, flat);
            let beyond = |axis: usize| (low[axis] - way[axis]).max(way[axis] - high[axis]);
            let free = (0..3).filter(|axis| held[*axis].is_none());
            let worst = free.max_by(|a, b| beyond(*a).total_cmp(&beyond(*b)));
            match worst {
                Some(axis) if beyond(axis) > 0.0 => held[axis] = Some(way[axis].clamp(low[axis], high[axis])),
                _ => return std::array::from_fn(|axis| way[axis].clamp(low[axis], high[axis])),
            }
        }
    }

    /// The shortest way to where the sum is least, while some of its components are held.
    fn least(&self, held: &[Option<f64>; 3], flat: f64) -> Vector {
        let is_free = |axis: usize| held[axis].is_none();
        let mut matrix = self.matrix;
        let mut target = self.target;
        for axis in 0..3 {
            for other in 0..3 {
                if let (true, Some(way)) = (is_free(axis), held[other]) {
                    target[axis] -= matrix[axis][other] * way;
                }
            }
        }
        for axis in 0..3 {
            (0..3).filter(|other| !is_free(axis) || !is_free(*other)).for_each(|other| matrix[axis][other] = 0.0);
            if !is_free(axis) {
                target[axis] = 0.0;
            }
        }
        let mut way: Vector = held.map(|way| way.unwrap_or(0.0));
        for (value, direction) in eigenvectors(matrix) {
            if value > flat * self.planes {
                let part = scale(direction, dot(direction, target) / value);
                (0..3).filter(|axis| is_free(*axis)).for_each(|axis| way[axis] += part[axis]);
            }
        }
        way
    }
}

/// The eigenvalues of a symmetric matrix with their unit eigenvectors, by Jacobi's rotations.
fn eigenvectors(mut matrix: [Vector; 3]) -> [(f64, Vector); 3] {
    const MOST_SWEEPS: usize = 12;
    let mut vectors = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for _ in 0..MOST_SWEEPS {
        let off: f64 = matrix[0][1].abs() + matrix[0][2].abs() + matrix[1][2].abs();
        if off < 1e-14 {
            break;
        }
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            rotate(&mut matrix, &mut vectors, p, q);
        }
    }
    std::array::from_fn(|index| (matrix[index][index], vectors[index]))
}

/// Turns the axes p and q so that the matrix has a zero there. The vectors are the rows.
fn rotate(matrix: &mut [Vector; 3], vectors: &mut [Vector; 3], p: usize, q: usize) {
    let off = matrix[p][q];
    if off == 0.0 {
        return;
    }
    let theta = (matrix[q][q] - matrix[p][p]) / (2.0 * off);
    let tangent = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
    let cosine = 1.0 / (tangent * tangent + 1.0).sqrt();
    let sine = tangent * cosine;
    let turn = |a: f64, b: f64| (cosine * a - sine * b, sine * a + cosine * b);
    for row in matrix.iter_mut() {
        (row[p], row[q]) = turn(row[p], row[q]);
    }
    for column in 0..3 {
        (matrix[p][column], matrix[q][column]) = turn(matrix[p][column], matrix[q][column]);
        (vectors[p][column], vectors[q][column]) = turn(vectors[p][column], vectors[q][column]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FAR: Vector = [10.0; 3];

    fn fit(planes: &[(Vector, Vector)]) -> Vector {
        Quadric::new([0.0; 3], planes.iter().copied()).least_within(scale(FAR, -1.0), FAR)
    }

    fn assert_near(a: Vector, b: Vector) {
        assert!((0..3).all(|axis| (a[axis] - b[axis]).abs() < 1e-9), "{a:?} instead of {b:?}");
    }

    #[test]
    fn three_planes_meet_in_a_point() {
        let planes = [
            ([1.0, 5.0, 5.0], [1.0, 0.0, 0.0]),
            ([0.0, 2.0, 0.0], [0.0, 0.6, 0.8]),
            ([0.0, 0.0, 3.0], [0.0, 0.0, 1.0]),
        ];
        assert_near(fit(&planes), [1.0, -2.0, 3.0]);
    }

    #[test]
    fn two_planes_leave_the_way_along_their_edge_alone() {
        assert_near(fit(&[([1.0, 5.0, 5.0], [1.0, 0.0, 0.0]), ([4.0, 2.0, 7.0], [0.0, 1.0, 0.0])]), [1.0, 2.0, 0.0]);
    }

    /// The edge x = y, z = 2 x leaves the box where z does.
    #[test]
    fn an_edge_is_followed_into_the_box() {
        let half = 0.5f64.sqrt();
        let lean = 1.0 / 5.0f64.sqrt();
        let planes = [([0.0; 3], [half, -half, 0.0]), ([0.0; 3], [2.0 * lean, 0.0, -lean])];
        let quadric = Quadric::new([3.0, 2.0, 0.5], planes.into_iter());
        let way = quadric.least_within([-4.0, -4.0, -4.5], [4.0, 4.0, 0.5]);
        assert_near([3.0 + way[0], 2.0 + way[1], 0.5 + way[2]], [0.5, 0.5, 1.0]);
    }
}
