// Rays, and the box that all of the scene is in.

struct Ray {
    /// Where it starts.
    o: vec3<f32>,
    /// Where it goes, of length 1.
    w: vec3<f32>,
}

/// Where a ray enters the scene's box and where it leaves it; it misses the box if it leaves before it enters.
fn box_crossing(ray: Ray) -> vec2<f32> {
    // A direction's zero component would give 0 × ∞ for an origin on the slab.
    let w = select(ray.w, vec3<f32>(1e-20), abs(ray.w) < vec3<f32>(1e-20));
    let to_min = (setting_box_min() - ray.o) / w;
    let to_max = (setting_box_max() - ray.o) / w;
    let enter = min(to_min, to_max);
    let leave = max(to_min, to_max);
    return vec2<f32>(max(max(enter.x, enter.y), max(enter.z, 0.0)), min(leave.x, min(leave.y, leave.z)));
}
