// Hard shadows: a ray to the light's centre.
//
// Theory: Sphere tracing (Hart 1996) with the scene's distance d/L; the light is seen if nothing is met.

const HARD_STEPS: u32 = 512u;

fn visibility(receiver: Receiver, light: Light, index: u32) -> Visibility {
    let o = shadow_origin(receiver);
    let disc = disc_of(light, o, receiver.n.xyz);
    if disc.horizon <= 0.0 {
        return Visibility(0.0, 0.0, 0u);
    }
    // What is nearer than this counts as met.
    let contact = 0.25 * receiver.p.w;
    var t = 0.0;
    var evaluations = 0u;
    while t < disc.t_max && evaluations < HARD_STEPS {
        let f = scene_distance(o + t * disc.w) / view.eye.w;
        evaluations += 1u;
        if f < contact {
            return Visibility(0.0, 1.0, evaluations);
        }
        t += f;
    }
    return Visibility(1.0, 1.0, evaluations);
}
