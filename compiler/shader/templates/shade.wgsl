// Adds a light to the picture: what receivers send back of it to the eye, by how much of it they see.
//
// Theory: The reflected radiance is taken as the product of the unoccluded integral and the visible part,
// L = (ρ/π E₀ + gloss) L_e V/V₀ (Bán, Bálint, Valasek 2019, eq. 2).

@group(1) @binding(0) var<storage, read> receivers: array<Receiver>;
@group(1) @binding(1) var<storage, read> lights: array<Light>;
@group(1) @binding(2) var<storage, read> visibilities: array<vec4<f32>>;
@group(1) @binding(3) var<storage, read_write> sums: array<vec4<f32>>;
/// x: the light's index, or `DRAWN_LIGHT`.
@group(1) @binding(4) var<storage, read> task: vec4<u32>;

/// The most that one sample may add.
const MAX_RADIANCE: f32 = 12.0;

@compute @workgroup_size(8, 8)
fn shade(@builtin(global_invocation_id) id: vec3<u32>) {
    let pixel = view.part.xy + id.xy;
    if any(id.xy >= view.part.zw) || any(pixel >= view.size.xy) {
        return;
    }
    let place = id.y * view.part.z + id.x;
    let receiver = receivers[place];
    if receiver.p.w < 0.0 {
        return;
    }
    let visibility = visibilities[place];
    let seen = select(0.0, visibility.x / max(visibility.y, TINY), visibility.y > 0.0);
    let light = lights[light_index(receiver, task.x)];
    let added = min(light_weight(receiver, task.x) * seen * reflected(receiver, light), vec3<f32>(MAX_RADIANCE));
    sums[pixel.y * view.size.x + pixel.x] += vec4<f32>(added, visibility.z);
}

/// What a receiver sends to the eye of a light of which it sees all.
fn reflected(receiver: Receiver, light: Light) -> vec3<f32> {
    if receiver.n.w < 0.0 {
        return receiver.color.rgb;
    }
    let surface = Surface(vec4<f32>(receiver.color.rgb, 1.0), vec4<f32>(receiver.color.w, receiver.n.w, 0.0, 0.0));
    let x = vertex_of(surface, receiver.n.xyz, normalize(view.eye.xyz - receiver.p.xyz));
    let cone = light_bound(light, receiver.p.xyz);
    return scatter_towards(x, cone.xyz, cone.w) * light.radiance.rgb * PI * cone.w * cone.w;
}
