//! Affine maps of space.

use std::array;
use std::hash::{Hash, Hasher};

use crate::scalar::{Function, Scalar};
use crate::singular;

/// An affine map: the upper three rows of a 4 × 4 matrix, the last column being the translation in millimetres.
#[derive(Clone, Debug)]
pub struct Affine {
    rows: [[Scalar; 4]; 3],
    /// The one factor it changes all distances by, if it is known to be a similarity: from its entries if they are
    /// constant, else from how it was made.
    factor: Option<Scalar>,
    /// The determinant of its linear part, if that is known from how it was made. Of live entries, it has a tighter
    /// range than what they come to: of a turn, it is 1.
    determinant: Option<Scalar>,
    /// What it changes distances by at the least, if it is no similarity and that is known from how it was made: turns
    /// before or after a stretch don't change it.
    least: Option<Scalar>,
}

/// How an affine map changes distances.
#[derive(Clone, Debug, PartialEq)]
pub enum Similarity {
    /// All of them by this positive factor.
    Uniform(Scalar),
    /// By different factors in different directions, by this one at the least.
    AtLeast(Scalar),
}

impl Affine {
    /// The map that changes nothing.
    pub fn identity() -> Self {
        Self::scaling([Scalar::ONE, Scalar::ONE, Scalar::ONE])
    }

    /// The map with these rows.
    pub fn new(rows: [[Scalar; 4]; 3]) -> Self {
        let factor = uniform_factor(&rows);
        Self { rows, factor, determinant: None, least: None }
    }

    /// The map with these rows, of which the caller knows that it changes all distances by this positive factor.
    pub fn similar(rows: [[Scalar; 4]; 3], factor: Scalar) -> Self {
        Self { rows, factor: Some(factor), determinant: None, least: None }
    }

    /// The map with these constant rows.
    pub fn constant(rows: [[f64; 4]; 3]) -> Self {
        Self::new(rows.map(|row| row.map(Scalar::Constant)))
    }

    /// Moves by `by`.
    pub fn translation(by: [Scalar; 3]) -> Self {
        let mut map = Self::identity();
        for (row, component) in map.rows.iter_mut().zip(by) {
            row[3] = component;
        }
        map
    }

    /// Scales the axes.
    pub fn scaling(factors: [Scalar; 3]) -> Self {
        let factor = (factors[0] == factors[1] && factors[1] == factors[2]).then(|| factors[0].clone().abs());
        let [x, y, z] = factors;
        let determinant = x.clone() * y.clone() * z.clone();
        let zero = || Scalar::ZERO;
        let rows = [[x, zero(), zero(), zero()], [zero(), y, zero(), zero()], [zero(), zero(), z, zero()]];
        Self { factor: factor.or_else(|| uniform_factor(&rows)), rows, determinant: Some(determinant), least: None }
    }

    /// Turns about an axis (0 = x, 1 = y, 2 = z) by an angle in degrees.
    pub fn rotation(axis: usize, degrees: Scalar) -> Self {
        let sin = Scalar::apply(Function::Sin, vec![degrees.clone()]);
        let cos = Scalar::apply(Function::Cos, vec![degrees]);
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut map = Self::identity();
        map.rows[i][i] = cos.clone();
        map.rows[j][j] = cos;
        map.rows[j][i] = sin.clone();
        map.rows[i][j] = -sin;
        map
    }

    /// Turns by an angle in degrees about an axis through the origin, given by a vector that is not zero
    /// (Rodrigues' formula).
    pub fn rotation_about(axis: [Scalar; 3], degrees: Scalar) -> Self {
        let u = normalized(axis);
        let sin = Scalar::apply(Function::Sin, vec![degrees.clone()]);
        let cos = Scalar::apply(Function::Cos, vec![degrees]);
        let cross = |i: usize, j: usize| match (3 + j - i) % 3 {
            0 => Scalar::ZERO,
            1 => -u[3 - i - j].clone(),
            _ => u[3 - i - j].clone(),
        };
        let entry = |i: usize, j: usize| {
            let along = u[i].clone() * u[j].clone() * (Scalar::ONE - cos.clone());
            let across = if i == j { cos.clone() } else { cross(i, j) * sin.clone() };
            along + across
        };
        Self::rigid(entry, Scalar::ONE)
    }

    /// Mirrors at the plane through the origin with this normal, which is not zero.
    pub fn reflection(normal: [Scalar; 3]) -> Self {
        let n = normalized(normal);
        let entry =
            |i: usize, j: usize| Scalar::from(f64::from(i == j)) - Scalar::from(2.0) * n[i].clone() * n[j].clone();
        Self::rigid(entry, -Scalar::ONE)
    }

    fn rigid(entry: impl Fn(usize, usize) -> Scalar, determinant: Scalar) -> Self {
        let rows = array::from_fn(|i| array::from_fn(|j| if j == 3 { Scalar::ZERO } else { entry(i, j) }));
        Self { rows, factor: Some(Scalar::ONE), determinant: Some(determinant), least: None }
    }

    /// Its rows.
    pub fn rows(&self) -> &[[Scalar; 4]; 3] {
        &self.rows
    }

    /// The map that applies `inner` first and then `self`.
    pub fn after(&self, inner: &Affine) -> Affine {
        let entry = |i: usize, j: usize| {
            let products = (0..3).map(|k| &self.rows[i][k] * &inner.rows[k][j]);
            let linear = products.fold(Scalar::ZERO, |sum, product| sum + product);
            if j == 3 { linear + self.rows[i][3].clone() } else { linear }
        };
        let rows = array::from_fn(|i| array::from_fn(|j| entry(i, j)));
        let factor = self.factor.clone().zip(inner.factor.clone()).map(|(outer, inner)| outer * inner);
        let factor = factor.or_else(|| uniform_factor(&rows));
        if is_constant(&rows) {
            return Affine { rows, factor, determinant: None, least: None };
        }
        let determinant = Some(self.determinant() * inner.determinant());
        let least = match (self.similarity(), inner.similarity()) {
            (Similarity::Uniform(factor), Similarity::AtLeast(least))
            | (Similarity::AtLeast(least), Similarity::Uniform(factor)) => Some(factor * least),
            _ => None,
        };
        Affine { rows, factor, determinant, least }
    }

    /// The map that first divides the axes by these factors, which are not zero, and then applies `self` with
    /// everything it moves by multiplied by `size`.
    pub fn divided(&self, factors: &[Scalar; 3], size: &Scalar) -> Affine {
        let row = |row: &[Scalar; 4]| {
            let [x, y, z] = array::from_fn(|j| ratio(&row[j], &factors[j]));
            [x, y, z, row[3].clone() * size.clone()]
        };
        let rows = self.rows.each_ref().map(row);
        let factor = self.factor.as_ref().map(|_| Scalar::ONE).or_else(|| uniform_factor(&rows));
        let [x, y, z] = factors.clone();
        let determinant = (!is_constant(&rows)).then(|| self.determinant() / (x * y * z));
        Affine { rows, factor, determinant, least: None }
    }

    /// Where it takes a point.
    pub fn point(&self, point: &[Scalar; 3]) -> [Scalar; 3] {
        array::from_fn(|i| {
            let products = (0..3).map(|k| &self.rows[i][k] * &point[k]);
            products.fold(self.rows[i][3].clone(), |sum, product| sum + product)
        })
    }

    /// The determinant of its linear part.
    pub fn determinant(&self) -> Scalar {
        if let Some(known) = &self.determinant {
            return known.clone();
        }
        (0..3).map(|j| self.rows[0][j].clone() * self.cofactor(0, j)).fold(Scalar::ZERO, |sum, term| sum + term)
    }

    /// The map that undoes it. It has to be regular.
    pub fn inverse(&self) -> Affine {
        let determinant = self.determinant();
        let linear: [[Scalar; 3]; 3] =
            array::from_fn(|i| array::from_fn(|j| self.cofactor(j, i) / determinant.clone()));
        let shift = |row: &[Scalar; 3]| {
            let products = (0..3).map(|k| row[k].clone() * self.rows[k][3].clone());
            -products.fold(Scalar::ZERO, |sum, product| sum + product)
        };
        let rows = linear.map(|row| {
            let translation = shift(&row);
            let [x, y, z] = row;
            [x, y, z, translation]
        });
        let factor = self.factor.clone().map(|factor| Scalar::ONE / factor);
        Affine { rows, factor, determinant: Some(Scalar::ONE / determinant), least: None }
    }

    /// Whether all its entries are constants.
    pub fn is_constant(&self) -> bool {
        is_constant(&self.rows)
    }

    fn cofactor(&self, i: usize, j: usize) -> Scalar {
        let (i1, i2, j1, j2) = ((i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3);
        let at = |i: usize, j: usize| self.rows[i][j].clone();
        at(i1, j1) * at(i2, j2) - at(i1, j2) * at(i2, j1)
    }

    /// Whether its linear part is the identity.
    pub fn is_translation(&self) -> bool {
        (0..3).all(|i| (0..3).all(|j| self.rows[i][j].is(f64::from(i == j))))
    }

    /// How it changes distances.
    pub fn similarity(&self) -> Similarity {
        match &self.factor {
            Some(factor) => Similarity::Uniform(factor.clone()),
            None => Similarity::AtLeast(self.least.clone().unwrap_or_else(|| {
                let mut numbers = linear_part(&self.rows);
                numbers.push(self.determinant());
                Scalar::apply(Function::SmallestSingularValue, numbers)
            })),
        }
    }

    /// Its rows while the parameters have these values.
    pub fn value(&self, parameters: &[f64]) -> [[f64; 4]; 3] {
        array::from_fn(|i| array::from_fn(|j| self.rows[i][j].value(parameters)))
    }
}

impl PartialEq for Affine {
    /// By what it does; the rest follows from that.
    fn eq(&self, other: &Affine) -> bool {
        self.rows == other.rows && self.factor == other.factor
    }
}

impl Eq for Affine {}

impl Hash for Affine {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.rows.hash(state);
        self.factor.hash(state);
    }
}

fn is_constant(rows: &[[Scalar; 4]; 3]) -> bool {
    rows.iter().flatten().all(|entry| entry.constant().is_some())
}

/// A number divided by a positive one; exactly ±1 where they are equal up to the sign.
fn ratio(number: &Scalar, by: &Scalar) -> Scalar {
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

fn linear_part(rows: &[[Scalar; 4]; 3]) -> Vec<Scalar> {
    (0..9).map(|k| rows[k / 3][k % 3].clone()).collect()
}

/// The factor of a constant similarity. Dumps round to six digits, so that columns count as perpendicular and equally
/// long up to what that leaves of it; and a factor within that of 1 is 1.
fn uniform_factor(rows: &[[Scalar; 4]; 3]) -> Option<Scalar> {
    const TOLERANCE: f64 = 1e-4;
    let linear = linear_part(rows);
    let m: Vec<f64> = linear.iter().map(Scalar::constant).collect::<Option<_>>()?;
    let dot = |i: usize, j: usize| (0..3).map(|k| m[3 * k + i] * m[3 * k + j]).sum::<f64>();
    let length2 = dot(0, 0);
    let near = |value: f64, expected: f64| (value - expected).abs() <= TOLERANCE * length2;
    let lengths_equal = near(dot(1, 1), length2) && near(dot(2, 2), length2);
    let perpendicular = near(dot(0, 1), 0.0) && near(dot(0, 2), 0.0) && near(dot(1, 2), 0.0);
    if !(lengths_equal && perpendicular) {
        return None;
    }
    let [_, _, factor] = singular::values(&[[m[0], m[1], m[2]], [m[3], m[4], m[5]], [m[6], m[7], m[8]]]);
    Some(Scalar::from(if (factor - 1.0).abs() < TOLERANCE { 1.0 } else { factor }))
}

fn normalized(v: [Scalar; 3]) -> [Scalar; 3] {
    let squares = v.iter().map(|c| c.clone() * c.clone());
    let length = squares.fold(Scalar::ZERO, |sum, square| sum + square).sqrt();
    v.map(|c| c / length.clone())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_inverse_undoes_its_map() {
        let map = Affine::constant([[1.0, 2.0, 0.0, 5.0], [0.0, -1.0, 0.5, 6.0], [2.0, 0.0, 1.0, -7.0]]);
        let both = map.inverse().after(&map).value(&[]);
        for (i, row) in both.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                assert!((entry - f64::from(i == j)).abs() < 1e-12, "{both:?}");
            }
        }
    }

    #[test]
    fn a_turn_about_an_axis_is_a_turn_about_that_axis() {
        for axis in 0..3 {
            let vector = array::from_fn(|i| Scalar::from(f64::from(i == axis) * 2.0));
            let about = Affine::rotation_about(vector, Scalar::from(37.0)).value(&[]);
            let along = Affine::rotation(axis, Scalar::from(37.0)).value(&[]);
            for (a, b) in about.iter().flatten().zip(along.iter().flatten()) {
                assert!((a - b).abs() < 1e-12, "{about:?} {along:?}");
            }
        }
    }

    #[test]
    fn turns_and_mirrors_are_similarities_and_shears_are_not() {
        let turn = Affine::rotation(0, Scalar::from(30.0)).after(&Affine::scaling([-2.0, 2.0, 2.0].map(Scalar::from)));
        match turn.similarity() {
            Similarity::Uniform(factor) => assert!((factor.constant().unwrap() - 2.0).abs() < 1e-7),
            other => panic!("{other:?}"),
        }
        let shear = Affine::constant([[1.0, 1.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]]);
        assert!(matches!(shear.similarity(), Similarity::AtLeast(_)));
    }
}
