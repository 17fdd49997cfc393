// Inspects materials: answers that of the scene at each of a list of points.

@group(1) @binding(0) var<storage, read> points: array<vec4<f32>>;
/// The colour, linear; w: the emission.
@group(1) @binding(1) var<storage, read_write> materials: array<vec4<f32>>;

@compute @workgroup_size(64)
fn inspect_materials(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
    @builtin(local_invocation_index) lane: u32,
) {
    let index = 64u * (group.y * groups.x + group.x) + lane;
    if index < arrayLength(&points) {
        let surface = scene_surface(points[index].xyz);
        materials[index] = vec4<f32>(surface.color.rgb, surface.finish.z);
    }
}
