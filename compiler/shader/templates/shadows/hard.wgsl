// Hard shadows: a ray to the light's centre.
//
// Theory: Sphere tracing (Hart 1996) with the scene's distance d/L; the light is seen if the ray enters no solid.

const HARD_STEPS: u32 = 512u;

fn visibility(receiver: Receiver, light: Light, index: u32) -> Visibility {
    let o = shadow_origin(receiver);
    let disc = disc_of(light, o, receiver.n.xyz);
    if disc.horizon <= 0.0 {
        return Visibility(0.0, 0.0, 0u);
    }
    // Steps go so far beyond what is free: a distance of 0 may be no surface.
    let beyond = 0.25 * receiver.p.w;
    var t = 0.0;
    var evaluations = 0u;
    while t < disc.t_max && evaluations < HARD_STEPS {
        let f = scene_distance(o + t * disc.w) / view.eye.w;
        evaluations += 1u;
        if f < 0.0 {
            return Visibility(0.0, 1.0, evaluations);
        }
        t += f + beyond;
    }
    return Visibility(1.0, 1.0, evaluations);
}
