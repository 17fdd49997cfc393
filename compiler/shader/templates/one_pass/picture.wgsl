// The pass in our own renderer: the rays of each pixel.
//
// Theory: A tent filter of one pixel, as that of `trace.wgsl`, here at four places of a rotated grid.

@group(1) @binding(1) var<storage, read_write> sums: array<vec4<f32>>;

@compute @workgroup_size(8, 8)
fn draw(@builtin(global_invocation_id) id: vec3<u32>) {
    let pixel = view.part.xy + id.xy;
    if any(id.xy >= view.part.zw) || any(pixel >= view.size.xy) {
        return;
    }
    let size = vec2<f32>(view.size.xy);
    var sum = vec4<f32>(0.0);
    for (var i = 0; i < RAYS; i++) {
        // Rows of pixels go downwards, offsets upwards.
        let place = vec2<f32>(pixel) + 0.5 + ray_offset(i) * vec2<f32>(1.0, -1.0);
        let ray = camera_ray(place);
        let from_centre = (2.0 * place - size) / length(size);
        let seen = one_pass(ray.o, ray.w, view.forward.w, vec2<f32>(from_centre.x, -from_centre.y), i);
        sum += vec4<f32>(seen.color, f32(seen.evaluations)) / f32(RAYS);
    }
    sums[pixel.y * view.size.x + pixel.x] = sum;
}
