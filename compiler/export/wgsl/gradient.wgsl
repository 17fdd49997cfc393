// The slope of the distance at p, from four values at the corners of a tetrahedron h away. Normalised, it is the normal.
fn scene_gradient(p: vec3<f32>, h: f32) -> vec3<f32> {
    var gradient = vec3<f32>(0.0);
    for (var i = 0; i < 4; i++) {
        let side = vec3<f32>(select(-1.0, 1.0, i == 0 || i == 3), select(-1.0, 1.0, i == 1 || i == 3), select(-1.0, 1.0, i >= 2));
        gradient += side * scene_distance(p + h * side);
    }
    return gradient / (4.0 * h);
}
