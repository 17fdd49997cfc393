// What live numbers may be computed with, beside what every language has.

// x to the power y, also for negative x and whole y.
fn live_power(x: f32, y: f32) -> f32 {
    let is_odd = abs(y - 2.0 * trunc(0.5 * y)) > 0.5;
    return select(1.0, -1.0, (x < 0.0) & is_odd) * pow(abs(x), y);
}

// What the matrix with these rows scales lengths by at the least: its least singular value, by turning pairs of columns
// until all are at right angles (Hestenes, "Inversion of matrices by biorthogonalization", 1958). Each turn goes on to
// the next pair.
fn least_stretch(x: vec3<f32>, y: vec3<f32>, z: vec3<f32>) -> f32 {
    var a = vec3(x.x, y.x, z.x);
    var b = vec3(x.y, y.y, z.y);
    var c = vec3(x.z, y.z, z.z);
    for (var turn = 0; turn < 18; turn++) {
        let skew = 2.0 * dot(a, b);
        let longer = dot(b, b) - dot(a, a);
        let tangent = select(-skew, skew, longer >= 0.0) / max(abs(longer) + length(vec2(longer, skew)), 1e-30);
        let cosine = inverseSqrt(1.0 + tangent * tangent);
        let turned = cosine * (a - tangent * b);
        a = cosine * (b + tangent * a);
        b = c;
        c = turned;
    }
    return min(length(a), min(length(b), length(c)));
}
