// The cone prepass: how far every ray of a tile may go before it can touch anything.
//
// Theory: All rays of a tile lie in a cone about its axis with the half-angle α. At the same distance t from the eye
// they are at most r(t) = 2 t sin(α/2) from the axis. The scene keeps the distance R = d/L from the axis's point, so
// every ray is free from t to t + R − r(t).
// Changes: Distances are measured from the eye and not along the axis, so no factor 1/(1 + tan α) slows the steps.
// Practice: one invocation per 16 × 16 pixels; then per 4 × 4, starting where the tile around it ended. The result
// lives as long as the view and the live numbers do.

/// For each tile of each level: the depth, and how often the scene was evaluated for it.
@group(1) @binding(0) var<storage, read_write> starts: array<vec2<f32>>;

const MAX_CONE_STEPS: u32 = 128u;

@compute @workgroup_size(8, 8)
fn prepass(@builtin(global_invocation_id) id: vec3<u32>) {
    let edge = view.level.x;
    let corner = id.xy * edge;
    if any(corner >= view.size.xy) {
        return;
    }

    // The cone about the tile, as wide as its corners, a pixel wider for the reconstruction filter; or its axis only.
    let axis = camera_ray(vec2<f32>(corner) + 0.5 * f32(edge));
    let rim = camera_ray(vec2<f32>(corner) - 1.0);
    let opposite = camera_ray(vec2<f32>(corner) + f32(edge) + 1.0);
    let spread = max(length(rim.w - axis.w), length(opposite.w - axis.w)) * f32(view.size.w);

    // Start at the scene's box, or where the wider cone ended.
    let nearest = clamp(axis.o, view.box_min.xyz, view.box_max.xyz);
    let farthest = max(abs(view.box_min.xyz - axis.o), abs(view.box_max.xyz - axis.o));
    let t_end = length(farthest);
    let before = starts[tile_index(corner, max(view.level.z, 1u), view.level.w)].x;
    var t = max(distance(axis.o, nearest), select(0.0, before, view.level.z > 0u));

    // March the axis while the free sphere is wider than the cone.
    var evaluations = 0u;
    for (var step = 0u; step < MAX_CONE_STEPS; step++) {
        let r = t * spread;
        let R = scene_distance(axis.o + t * axis.w) / view.eye.w;
        evaluations += 1u;
        let free = R - r;
        if free > 0.0 {
            t += free;
        }
        // Go on only while it pays: the next level steps as well with half the cone.
        if free < max(0.25 * r, view.box_min.w) || t > t_end {
            break;
        }
    }
    starts[tile_index(corner, edge, view.level.y)] = vec2<f32>(t, f32(evaluations));
}
