//! `aim`: the direction that a light shines in.

use chiaro_solid::{Affine, Scalar};

use super::super::Stop;
use super::super::decide::{self, Sign};
use super::super::instance::{Instance, error};
use super::super::transforms::is_nonzero;

/// A direction, with its lengths.
pub(super) struct Aim {
    direction: [Scalar; 3],
    /// Whether it is straight up or down, and which.
    upright: Option<Sign>,
}

/// The direction that is given.
pub(super) fn read(instance: &mut Instance) -> Result<Option<Aim>, Stop> {
    let Some(direction) = instance.vector::<3>("aim", 3, 0.0) else { return Ok(None) };
    let span = instance.place("aim");
    if !direction.iter().all(Scalar::is_finite) {
        return Err(error(span, "`aim` has to be finite"));
    }
    let [x, y, z] = direction.clone();
    if is_nonzero(&[x, y, Scalar::ZERO], span, "whether a light is aimed straight up or down")? {
        return Ok(Some(Aim { direction, upright: None }));
    }
    match decide::sign(&z, span, "whether a light is aimed up or down")? {
        Sign::Zero => Err(error(span, "a light can't be aimed at its own place")),
        upright => Ok(Some(Aim { direction, upright: Some(upright) })),
    }
}

impl Aim {
    /// The turn that takes +z to the direction.
    pub(super) fn forwards(self) -> Affine {
        match self.upright {
            Some(Sign::Negative) => Affine::rotation(0, Scalar::from(180.0)),
            Some(_) => Affine::identity(),
            None => level(self.direction),
        }
    }

    /// The turn that takes −z to the direction.
    pub(super) fn backwards(self) -> Affine {
        let upright = self.upright.map(|sign| match sign {
            Sign::Negative => Sign::Positive,
            _ => Sign::Negative,
        });
        Aim { direction: self.direction.map(|component| -component), upright }.forwards()
    }
}

/// The turn that takes +z to a direction that is not upright and keeps x level.
fn level([x, y, z]: [Scalar; 3]) -> Affine {
    let square = |number: &Scalar| number.clone() * number.clone();
    let across = (square(&x) + square(&y)).sqrt();
    let length = (square(&x) + square(&y) + square(&z)).sqrt();
    let [dx, dy, dz] = [&x, &y, &z].map(|component| component.clone() / length.clone());
    let [rx, ry] = [-y / across.clone(), x / across.clone()];
    let up = [-(dz.clone() * ry.clone()), dz.clone() * rx.clone(), across / length];
    let [ux, uy, uz] = up;
    let zero = || Scalar::ZERO;
    Affine::similar([[rx, ux, dx, zero()], [ry, uy, dy, zero()], [zero(), uz, dz, zero()]], Scalar::ONE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn aiming_turns_z_there_and_keeps_x_level() {
        for direction in [[1.0, 2.0, -3.0], [0.0, -4.0, 0.0], [-2.0, 0.0, 0.5]] {
            let length = direction.iter().map(|c: &f64| c * c).sum::<f64>().sqrt();
            let rows = level(direction.map(Scalar::from)).value(&[]);
            let column = |j: usize| [0, 1, 2].map(|i: usize| rows[i][j]);
            let dot = |a: [f64; 3], b: [f64; 3]| (0..3).map(|i| a[i] * b[i]).sum::<f64>();
            for i in 0..3 {
                assert!((rows[i][2] - direction[i] / length).abs() < 1e-12, "{direction:?}: {rows:?}");
                for j in 0..3 {
                    let expected = f64::from(i == j);
                    assert!((dot(column(i), column(j)) - expected).abs() < 1e-12, "{direction:?}: {rows:?}");
                }
            }
            let determinant = {
                let ([a, b, c], [d, e, f], [g, h, i]) = (column(0), column(1), column(2));
                a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
            };
            assert!(determinant > 0.0 && rows[2][0] == 0.0 && rows[2][1] > 0.0, "{direction:?}: {rows:?}");
        }
    }
}
