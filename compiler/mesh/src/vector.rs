//! Arithmetic of vectors.

pub(crate) type Vector = [f64; 3];

pub(crate) fn add(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|axis| a[axis] + b[axis])
}

pub(crate) fn sub(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

pub(crate) fn scale(a: Vector, factor: f64) -> Vector {
    a.map(|component| component * factor)
}

pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

pub(crate) fn mean(points: impl ExactSizeIterator<Item = Vector>) -> Vector {
    let count = points.len() as f64;
    scale(points.fold([0.0; 3], add), 1.0 / count)
}

/// The direction of a vector, unless it is next to nothing or no number.
pub(crate) fn unit(a: Vector) -> Option<Vector> {
    let length = length(a);
    (length > 1e-12 && length.is_finite()).then(|| scale(a, 1.0 / length))
}
