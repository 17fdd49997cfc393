// Verified cones, first pass: which receivers see all or nothing of a light.
//
// Practice: One cone for the whole light. Where it is free, V is what the horizon leaves; where its axis ends deep
// within a solid, V is 0. The rest, the receivers in penumbrae, are written into the lists of the stages.

@group(1) @binding(1) var<storage, read> lights: array<Light>;
/// For each receiver: V, or where it is not yet known minus how far the light's cone is free; V₀; evaluations; E₀.
@group(1) @binding(2) var<storage, read_write> visibilities: array<vec4<f32>>;
/// How many receivers each stage has; then, for each stage, room for the indices of all receivers.
@group(1) @binding(4) var<storage, read_write> touched: array<atomic<u32>>;
/// For each stage, the workgroups that look at its receivers.
@group(1) @binding(5) var<storage, read_write> touched_groups: array<atomic<u32>>;

const MOST_GATE_EVALUATIONS: u32 = 256u;

/// What the whole light comes to.
struct Gate {
    seen: f32,
    bare: f32,
    evaluations: u32,
    irradiance: f32,
    /// How far the cone is free; negative where V is known.
    contact: f32,
}

@compute @workgroup_size(64)
fn shadow(@builtin(workgroup_id) group: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let index = linear_index(group, groups, lane);
    if index >= task.receivers {
        return;
    }
    let receiver = receivers[index];
    var gate = Gate(0.0, 0.0, 0u, 0.0, -1.0);
    if receiver.p.w >= 0.0 && light_weight(receiver, task.light) > 0.0 {
        gate = gate_of(receiver, lights[light_index(receiver, task.light)]);
    }
    if gate.contact >= 0.0 {
        gate.seen = -gate.contact - TINY;
        let stage = stage_of(index % task.width, index / task.width);
        let place = atomicAdd(&touched[stage], 1u);
        atomicStore(&touched[STAGES + stage * task.receivers + place], index);
        if place % 64u == 0u {
            let number = place / 64u;
            atomicMax(&touched_groups[4u * stage], min(number + 1u, GROUPS_IN_ROW));
            atomicMax(&touched_groups[4u * stage + 1u], number / GROUPS_IN_ROW + 1u);
            atomicMax(&touched_groups[4u * stage + 2u], 1u);
        }
    }
    visibilities[index] = vec4<f32>(gate.seen, gate.bare, f32(gate.evaluations), gate.irradiance);
}

fn gate_of(receiver: Receiver, light: Light) -> Gate {
    let o = shadow_origin(receiver);
    let n = receiver.n.xyz;
    let irradiance = light_irradiance(light, o, n);
    if irradiance <= 0.0 {
        return Gate(0.0, 0.0, 0u, 0.0, -1.0);
    }
    if is_within(light, o) {
        return Gate(1.0, 1.0, 0u, irradiance, -1.0);
    }
    let disc = disc_of(light, o, n);
    if disc.horizon <= -1.0 {
        return Gate(0.0, 0.0, 0u, irradiance, -1.0);
    }
    let is_patch = !is_round(light);
    let bare = select(segment_area(disc.horizon), 1.0, is_patch);
    let is_single = task.cells == 1u && !is_patch;

    // Aim at the middle of what is above the horizon.
    let across = basis_across(disc.w);
    let uphill = vec2<f32>(dot(n, across[0]), dot(n, across[1]));
    let h = min(disc.horizon, 0.0);
    let aim = select(0.0, 0.5 * (1.0 - h), h < 0.0) * uphill / max(length(uphill), 1e-9);
    let width = select(1.0, min(1.0, sqrt(1.0 - h * h + 0.25 * (1.0 + h) * (1.0 + h))), h < 0.0);
    let w = normalize(disc.w + disc.tangent * (across[0] * aim.x + across[1] * aim.y));
    let least_step = select(0.6, 0.1, is_single);
    var m = march_along(w, disc.sine * width, disc.t_max, n, receiver.p.w, task.looking, least_step, true);
    var contact = -1.0;
    var evaluations = 0u;
    while !m.over && evaluations < MOST_GATE_EVALUATIONS {
        let t = march_asks(m);
        let f = scene_distance(o + t * m.w) / view.eye.w;
        evaluations += 1u;
        m = march_takes(m, t, f);
        if m.touched && contact < 0.0 {
            // Look on from here along the axis, more carefully, whether all of the light is covered.
            contact = m.t;
            m.looking = false;
            m.planar = task.following;
            m.least = UNBOUNDED;
            m.careful = false;
        }
    }
    if contact < 0.0 {
        return Gate(bare, bare, evaluations, irradiance, -1.0);
    }
    if m.least <= -0.999 * m.sine {
        return Gate(0.0, bare, evaluations, irradiance, -1.0);
    }
    let seen = min(bare, smooth_area(m.least / m.sine));
    return Gate(seen, bare, evaluations, irradiance, select(contact, -1.0, is_single));
}
