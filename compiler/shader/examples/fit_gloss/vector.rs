//! Vectors, as far as the fit needs them.

pub(crate) type Vector = [f64; 3];

pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn normalized(v: Vector) -> Vector {
    let length = dot(v, v).sqrt();
    v.map(|x| x / length)
}

/// The mirror image of a direction about another.
pub(crate) fn reflected(v: Vector, h: Vector) -> Vector {
    let twice = 2.0 * dot(v, h);
    [0, 1, 2].map(|i| twice * h[i] - v[i])
}
