//! Points and vectors in space, known numbers all.

pub(super) type Point = [f64; 3];

pub(super) fn sub(a: Point, b: Point) -> Point {
    std::array::from_fn(|i| a[i] - b[i])
}

pub(super) fn dot(a: Point, b: Point) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

pub(super) fn cross(a: Point, b: Point) -> Point {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j] * b[k] - a[k] * b[j]
    })
}

pub(super) fn length(vector: Point) -> f64 {
    dot(vector, vector).sqrt()
}

/// The vector made as long as 1; zero if it is zero.
pub(super) fn normalised(vector: Point) -> Point {
    let length = length(vector);
    if length > 0.0 { vector.map(|c| c / length) } else { vector }
}
