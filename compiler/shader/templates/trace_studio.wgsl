// What surrounds a scene. One without lights stands in a studio: a backdrop, soft boxes, a floor that catches shadows (and
// a key light, which the host adds to the lights). One with lights has the sky that its text asks for.
//
// Practice: everything is a closed form of a direction, so that a ray which leaves the scene costs no evaluation.
// Radiances are such that a white surface in full light is about 1.

/// The sky's radiance overhead, level, and, where there is no floor, below.
const SKY_ZENITH: vec3<f32> = vec3<f32>(0.46, 0.49, 0.53);
const SKY_LEVEL: vec3<f32> = vec3<f32>(0.26, 0.27, 0.29);
const SKY_NADIR: vec3<f32> = vec3<f32>(0.36, 0.35, 0.34);

/// What the floor scatters, and the share of the key light in the light that reaches it.
const FLOOR_ALBEDO: vec3<f32> = vec3<f32>(0.62, 0.61, 0.60);
const FLOOR_KEY_SHARE: vec3<f32> = vec3<f32>(0.50, 0.48, 0.455);

/// A direction of the world as the studio's axes see it: x to the right, y away from the viewer, z up.
fn into_studio(w: vec3<f32>) -> vec3<f32> {
    let turn = setting_azimuth();
    return vec3<f32>(w.x * turn.x + w.y * turn.y, w.y * turn.x - w.x * turn.y, w.z);
}

/// How much of a box filter of a width about x lies within ±reach, along one axis.
fn strip(x: f32, reach: f32, width: f32) -> f32 {
    return max(min(reach, x + 0.5 * width) - max(-reach, x - 0.5 * width), 0.0) / width;
}

/// A soft box about the unit direction c, seen in direction w, as sharp as the lobe that sees it.
fn soft_box(w: vec3<f32>, c: vec3<f32>, half_size: vec2<f32>, blur: f32) -> f32 {
    let facing = dot(w, c);
    let level = normalize(vec3<f32>(-c.y, c.x, 0.0));
    let on_plane = vec2<f32>(dot(w, level), dot(w, cross(c, level))) / max(facing, 0.05);
    let width = 0.06 + 2.5 * blur;
    let seen = strip(on_plane.x, half_size.x, width) * strip(on_plane.y, half_size.y, width);
    return seen * smoothstep(0.0, 0.25, facing);
}

/// The radiance from a direction of the world, for a lobe between a mirror's (0) and a matt body's (1).
fn sky(w: vec3<f32>, blur: f32) -> vec3<f32> {
    if setting_is_studio() {
        return studio_sky(into_studio(w), blur);
    }
    // The horizon is as blurred as the lobe.
    let above = smoothstep(-1.0, 1.0, w.z / (0.02 + blur));
    let upwards = mix(setting_horizon(), setting_zenith(), max(w.z, 0.0));
    return mix(setting_ground(), upwards, above);
}

fn studio_sky(w: vec3<f32>, blur: f32) -> vec3<f32> {
    let gradient = select(mix(SKY_LEVEL, SKY_NADIR, -w.z), mix(SKY_LEVEL, SKY_ZENITH, w.z), w.z > 0.0);
    let overhead = soft_box(w, normalize(vec3<f32>(0.05, 0.15, 1.0)), vec2<f32>(0.75, 0.45), blur);
    let left = soft_box(w, normalize(vec3<f32>(-1.0, -0.35, 0.45)), vec2<f32>(0.28, 0.62), blur);
    let rim = soft_box(w, normalize(vec3<f32>(0.85, 0.75, 0.35)), vec2<f32>(0.20, 0.70), blur);
    let behind = soft_box(w, normalize(vec3<f32>(0.1, 1.0, 0.62)), vec2<f32>(0.85, 0.22), blur);
    return gradient
        + 1.5 * overhead * vec3<f32>(0.98, 0.99, 1.0)
        + 1.9 * left * vec3<f32>(1.0, 0.97, 0.93)
        + 1.3 * rim * vec3<f32>(0.92, 0.96, 1.0)
        + 0.9 * behind * vec3<f32>(1.0, 0.99, 0.97);
}

/// The sky's irradiance over π on a surface whose normal is n: what a white one sends back, where nothing hides it.
fn ambient(n: vec3<f32>) -> vec3<f32> {
    if !setting_is_studio() {
        let upwards = mix(setting_horizon(), setting_zenith(), 2.0 / 3.0 * max(n.z, 0.0));
        return mix(setting_ground(), upwards, 0.5 + 0.5 * n.z);
    }
    return mix(vec3<f32>(0.34, 0.34, 0.35), vec3<f32>(0.62, 0.64, 0.67), 0.5 + 0.5 * n.z);
}

/// What the camera sees behind everything in direction w, at a point of the picture, whose corners are at a distance of
/// 1 from its centre.
fn background_of(w: vec3<f32>, point: vec2<f32>) -> vec3<f32> {
    if !setting_is_studio() {
        return sky(w, 0.0);
    }
    let from_centre = point - vec2<f32>(0.0, -0.08);
    let falloff = 1.0 / (1.0 + 0.42 * dot(from_centre, from_centre));
    return vec3<f32>(0.86, 0.87, 0.885) * falloff;
}

/// How far along a ray it meets the floor; not at all if negative. The floor is seen from above only.
fn floor_crossing(ray: Ray) -> f32 {
    let falls = setting_has_floor() && ray.w.z < -1e-6 && ray.o.z > setting_floor();
    return select(-1.0, (setting_floor() - ray.o.z) / min(ray.w.z, -1e-6), falls);
}
