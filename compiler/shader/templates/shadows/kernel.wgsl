// What every shadow method is run by: one receiver and one light an invocation.

@group(1) @binding(1) var<storage, read> lights: array<Light>;
/// For each receiver: V, the part of the light that is seen from it; V₀, the same if nothing but its horizon covered
/// the light; how often the scene was evaluated; E₀, the irradiance per radiance if nothing covered the light. Flat lights
/// and tubes count by irradiance, others by solid angle.
@group(1) @binding(2) var<storage, read_write> visibilities: array<vec4<f32>>;

/// What a method answers.
struct Visibility {
    /// V.
    seen: f32,
    /// V₀.
    bare: f32,
    evaluations: u32,
}

@compute @workgroup_size(64)
fn shadow(@builtin(workgroup_id) group: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let index = linear_index(group, groups, lane);
    if index >= task.receivers {
        return;
    }
    let receiver = receivers[index];
    var answer = Visibility(0.0, 0.0, 0u);
    var irradiance = 0.0;
    if receiver.p.w >= 0.0 && light_weight(receiver, task.light) > 0.0 {
        let light = lights[light_index(receiver, task.light)];
        irradiance = light_irradiance(light, shadow_origin(receiver), receiver.n.xyz);
        if irradiance > 0.0 {
            answer = visibility(receiver, light, index);
        }
    }
    visibilities[index] = vec4<f32>(answer.seen, answer.bare, f32(answer.evaluations), irradiance);
}
