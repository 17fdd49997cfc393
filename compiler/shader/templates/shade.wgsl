// Adds a light to the picture: what receivers send back of it to the eye, by how much of it they see.
//
// Theory: The reflected radiance is taken as the product of the unoccluded integral and the visible part,
// L = (ρ/π E₀ + gloss) L_e V/V₀ (Bán, Bálint, Valasek 2019, eq. 2). The gloss is what the lobe's linearly transformed cosine
// comes to over the light's outline.

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
    let sent = light_weight(receiver, task.x) * seen * reflected(receiver, light, visibility.w);
    sums[pixel.y * view.size.x + pixel.x] += vec4<f32>(min(sent, vec3<f32>(MAX_RADIANCE)), visibility.z);
}

/// What a receiver sends to the eye of a light of which it sees all, and gets the irradiance E₀ per radiance.
fn reflected(receiver: Receiver, light: Light, irradiance: f32) -> vec3<f32> {
    if receiver.n.w < 0.0 {
        return receiver.color.rgb;
    }
    if irradiance <= 0.0 {
        return vec3<f32>(0.0);
    }
    let surface = Surface(vec4<f32>(receiver.color.rgb, 1.0), vec4<f32>(receiver.color.w, receiver.n.w, 0.0, 0.0));
    let x = vertex_of(surface, receiver.n.xyz, normalize(view.eye.xyz - receiver.p.xyz));
    let body = (1.0 - x.albedo) * x.body / PI * irradiance;
    return (body + gloss_of_light(light, x, shadow_origin(receiver))) * light.radiance.rgb;
}
