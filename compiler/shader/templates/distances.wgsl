// Distances: answers the scene's distance at each of a list of points.

@group(1) @binding(0) var<storage, read> points: array<vec4<f32>>;
@group(1) @binding(1) var<storage, read_write> answers: array<f32>;

@compute @workgroup_size(64)
fn distances(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
    @builtin(local_invocation_index) lane: u32,
) {
    // A dispatch may have at most 65535 groups along one axis: long lists are dispatched in rows.
    let index = 64u * (group.y * groups.x + group.x) + lane;
    if index < arrayLength(&points) {
        answers[index] = scene_distance(points[index].xyz);
    }
}
