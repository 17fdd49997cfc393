// Verified cones, last pass: what the cells come to.

@group(1) @binding(2) var<storage, read_write> visibilities: array<vec4<f32>>;
/// See `sums.wgsl`.
@group(1) @binding(4) var<storage, read> sums: array<u32>;

@compute @workgroup_size(64)
fn settle(@builtin(workgroup_id) group: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let index = linear_index(group, groups, lane);
    if index >= task.receivers {
        return;
    }
    let answer = visibilities[index];
    if answer.x < 0.0 {
        let seen = visible_part(sums[SUMS * index], sums[SUMS * index + 1u], answer.y);
        visibilities[index] = vec4<f32>(seen, answer.y, answer.z + f32(sums[SUMS * index + 2u]), answer.w);
    }
}
