// What live numbers may be computed with, beside what every language has.

// x to the power y, also for negative x and whole y.
fn live_power(x: f32, y: f32) -> f32 {
    let is_odd = abs(y - 2.0 * trunc(0.5 * y)) > 0.5;
    return select(1.0, -1.0, (x < 0.0) & is_odd) * pow(abs(x), y);
}

// What the matrix with these rows scales lengths by at the least: the square root of the least eigenvalue of its square
// (Smith, "Eigenvalues of a symmetric 3 × 3 matrix", 1961).
fn least_stretch(x: vec3<f32>, y: vec3<f32>, z: vec3<f32>) -> f32 {
    let diagonal = x * x + y * y + z * z;
    let across = vec3(
        x.x * x.y + y.x * y.y + z.x * z.y,
        x.y * x.z + y.y * y.z + z.y * z.z,
        x.x * x.z + y.x * y.z + z.x * z.z,
    );
    let mean = (diagonal.x + diagonal.y + diagonal.z) / 3.0;
    let from_mean = diagonal - mean;
    let spread = sqrt(max((dot(from_mean, from_mean) + 2.0 * dot(across, across)) / 6.0, 1e-12 * mean * mean));
    let d = from_mean / spread;
    let e = across / spread;
    let determinant = d.x * (d.y * d.z - e.y * e.y) - e.x * (e.x * d.z - e.y * e.z) + e.z * (e.x * e.y - d.y * e.z);
    let angle = acos(clamp(0.5 * determinant, -1.0, 1.0)) / 3.0;
    return sqrt(max(mean + 2.0 * spread * cos(angle + 2.0943951), 0.0));
}
