// The scene as a solid among others: where a ray meets it, and how it faces there.
//
// Theory: Sphere tracing (Hart 1996) with steps that are relaxed by the mean slope of the distances met so far (Bálint, Valasek,
// Gera, "Operations on Signed Distance Function Estimates", 2023): where two spheres come apart, the ray goes back.
// Practice: some twenty evaluations for a ray, and four for a normal.

/// Of one ray. Few grazing rays come near it.
const MAX_SCENE_STEPS: i32 = 400;
/// The share of the newest slope in the mean.
const SLOPE_SHARE: f32 = 0.3;

/// Where a ray enters the scene's box and where it leaves it; it misses the box if it leaves before it enters.
fn scene_box_crossing(o: vec3<f32>, w: vec3<f32>) -> vec2<f32> {
    // A component of 0 would give 0 × ∞ for an origin on the slab.
    let way = select(w, vec3<f32>(1e-20), abs(w) < vec3<f32>(1e-20));
    let to_min = (SCENE_MIN - o) / way;
    let to_max = (SCENE_MAX - o) / way;
    let enter = min(to_min, to_max);
    let leave = max(to_min, to_max);
    return vec2<f32>(max(enter.x, max(enter.y, enter.z)), min(leave.x, min(leave.y, leave.z)));
}

/// How far a ray goes from o along w, of length 1, until it meets the scene between start and end; negative if it doesn't. What is
/// nearer than near + growth * way counts as met: a part of a pixel's size.
fn scene_hit(o: vec3<f32>, w: vec3<f32>, start: f32, end: f32, near: f32, growth: f32) -> f32 {
    let crossing = scene_box_crossing(o, w);
    let last = min(end, crossing.y);
    // The ray is free up to t, and r around it; the scene is asked next z ahead; m is the mean slope of r.
    var t = max(start, crossing.x);
    var r = 0.0;
    var z = 0.0;
    var m = -1.0;
    for (var i = 0; i < MAX_SCENE_STEPS; i++) {
        if t >= last {
            return -1.0;
        }
        let ahead = min(t + z, last);
        let way = ahead - t;
        let met = near + growth * abs(ahead);
        let d = scene_distance(o + ahead * w);
        let free = d / SCENE_LIPSCHITZ;
        if way > r + free && z > max(r, met) {
            m = -1.0;
            z = max(r, met);
            continue;
        }
        if d < met {
            return ahead;
        }
        m = select(-1.0, mix(m, (free - r) / way, SLOPE_SHARE), way > 0.0 && r > 0.0);
        t = ahead;
        r = free;
        // The next sphere touches this one if the slope stays what it was.
        z = max(r * max(1.0, 2.0 / (1.0 - min(m, 0.6))), met);
    }
    return -1.0;
}

/// The normal of the surface at p, outwards, from the distances h around it.
fn scene_normal(p: vec3<f32>, h: f32) -> vec3<f32> {
    let gradient = scene_gradient(p, h);
    return gradient / max(length(gradient), 1e-20);
}
