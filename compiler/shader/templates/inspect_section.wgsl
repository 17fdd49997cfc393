// Inspects a section: the scene's distance where pixels see a plane.
//
// Theory: The differences of the distance to the corners of a tetrahedron sum up to its gradient.
// Practice: five evaluations a pixel.

/// For each pixel: the distance; how fast it changes at most, by the point; how far along the ray the plane is, negative if
/// it is not seen; 0.
@group(1) @binding(1) var<storage, read_write> sections: array<vec4<f32>>;

@compute @workgroup_size(8, 8)
fn section(@builtin(global_invocation_id) id: vec3<u32>) {
    let pixel = view.part.xy + id.xy;
    if any(id.xy >= view.part.zw) || any(pixel >= view.size.xy) {
        return;
    }
    let ray = camera_ray(vec2<f32>(pixel) + 0.5);
    let t = plane_crossing(ray);
    let p = ray.o + t * ray.w;
    let h = max(0.5 * t * view.forward.w, 16.0 * view.box_min.w);
    var d = 0.0;
    var gradient = vec3<f32>(0.0);
    for (var k = 0u; k < 5u; k++) {
        // The corners, and the centre last.
        let corner = vec3<f32>(f32(((k + 3u) >> 1u) & 1u), f32((k >> 1u) & 1u), f32(k & 1u)) * 2.0 - 1.0;
        let direction = select(corner, vec3<f32>(0.0), k == 4u);
        d = scene_distance(p + h * direction);
        gradient += d * direction;
    }
    let seen = select(-1.0, t, t < FAR);
    sections[pixel.y * view.size.x + pixel.x] = vec4<f32>(d, length(gradient) / (4.0 * h), seen, 0.0);
}
