// Verified cones, third pass of a stage: the cells of the light, one an invocation.
//
// Theory: A cell whose cone is touched counts by the segment of its disc that a straight silhouette at the sine min f/t
// leaves.
// Practice: A march starts where the whole light's cone was still free.

@group(1) @binding(1) var<storage, read> lights: array<Light>;
@group(1) @binding(2) var<storage, read> visibilities: array<vec4<f32>>;
@group(1) @binding(4) var<storage, read> left: array<u32>;
/// See `sums.wgsl`.
@group(1) @binding(5) var<storage, read_write> sums: array<atomic<u32>>;

@compute @workgroup_size(64)
fn cells(@builtin(workgroup_id) group: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let place = linear_index(group, groups, lane);
    if place >= left[task.stage] {
        return;
    }
    let index = left[STAGES + place];
    let receiver = receivers[index];
    let light = lights[light_index(receiver, task.light)];
    let answer = visibilities[index];
    let o = shadow_origin(receiver);
    let n = receiver.n.xyz;
    let offset = receiver.p.w;
    let is_patch = !is_round(light);
    var piece: Piece;
    // What the cell adds to the shares: those of a disc count as parts of the whole disc, whatever the horizon covers.
    var share = select(0.0, 1.0, group.z == 0u);
    if is_patch {
        piece = piece_of_patch(light, o, n, group.z, task.cells);
        piece.weight /= max(answer.w, TINY);
        share = piece.weight;
    } else {
        let disc = disc_of(light, o, n);
        let across = basis_across(disc.w);
        let uphill = vec2<f32>(dot(n, across[0]), dot(n, across[1]));
        piece = piece_of_disc(disc, across, uphill / max(length(uphill), 1e-9), disc_cell(group.z));
    }
    let contact = -answer.x;
    var m = march_along(piece.w, piece.sine, piece.t_max, n, offset, task.following, 0.6, false);
    // Near the receiver cells begin at its tangent plane, far from it where the whole light was still free.
    let starts_ahead = contact > 25.0 * offset;
    var evaluations = 0u;
    m.over = m.over || piece.weight <= 0.0;
    while !m.over && evaluations < MOST_CELL_EVALUATIONS {
        let is_start = starts_ahead && evaluations == 0u;
        let t = select(march_asks(m), 0.98 * contact, is_start);
        let f = scene_distance(o + t * m.w) / view.eye.w;
        evaluations += 1u;
        if is_start {
            m.t = t;
            m.f = f;
            m.slope = 0.0;
            if f <= 0.0 {
                m.least = 0.0;
                m.over = true;
            }
        } else {
            m = march_takes(m, t, f);
        }
    }
    let seen = min(smooth_area(m.least / m.sine), segment_area(piece.horizon));
    atomicAdd(&sums[SUMS * index], u32(piece.weight * seen * WHOLE));
    atomicAdd(&sums[SUMS * index + 1u], u32(share * WHOLE));
    atomicAdd(&sums[SUMS * index + 2u], evaluations);
}
