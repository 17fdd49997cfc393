// Inspects what pixels see: the surface that the ray through the centre of each meets, and what that cost.
//
// Theory: The ray marches as those of pictures do, so that it asks the scene as often.
// Changes: A scene that is cut open lacks what lies on the eye's side of the plane: rays start where they meet that. They
// may start within the scene; then they meet its surface at once.
// Practice: one ray a pixel and nothing else, at the speed of the first segment of a picture's paths; after the prepass, or
// without it where what rays cost is to be seen.

/// Where pixels see a surface; w: how far along the ray, negative if there is none.
@group(1) @binding(1) var<storage, read_write> positions: array<vec4<f32>>;
/// The unit normals there, outwards; w: the slope of the distance.
@group(1) @binding(2) var<storage, read_write> normals: array<vec4<f32>>;
/// How often the scene was asked.
@group(1) @binding(3) var<storage, read_write> evaluations: array<u32>;

/// The prepass's depths.
@group(1) @binding(4) var<storage, read> starts: array<vec2<f32>>;

@compute @workgroup_size(8, 8)
fn inspect(@builtin(global_invocation_id) id: vec3<u32>) {
    let pixel = view.part.xy + id.xy;
    if any(id.xy >= view.part.zw) || any(pixel >= view.size.xy) {
        return;
    }
    let ray = camera_ray(vec2<f32>(pixel) + 0.5);
    let free = starts[tile_index(pixel, START_EDGE, view.level.w)].x * f32(view.size.w);
    let start = max(free, select(0.0, plane_crossing(ray), cut[1].x > 0.5));
    let hit = vec2<f32>(view.box_min.w, HIT * view.forward.w);
    let met = meet(Segment(ray, start, FAR, hit, 1.0, false));
    let slope = length(met.n);
    let n = met.n / max(slope, TINY);
    let index = pixel.y * view.size.x + pixel.x;
    positions[index] = vec4<f32>(ray.o + met.t * ray.w, met.t);
    normals[index] = vec4<f32>(n, slope / max(4.0 * met.h, TINY));
    evaluations[index] = met.evaluations;
}
