// Cone tracing: whether the cone of a light is free.
//
// Theory: Bálint and Valasek, "Accelerating Sphere Tracing" (EG 2018): the clearance g(t) = f − ρ(t) of a cone with
// ρ(t) = t sin α falls at most by 1 + sin α, so that g/(1 + sin α) is a safe step.
// Changes: A cone that is touched counts as covered.
// Practice: V is 0 or what the horizon leaves; it tells where a light is surely seen as a whole.

const CONE_STEPS: u32 = 256u;

fn visibility(receiver: Receiver, light: Light, index: u32) -> Visibility {
    let o = shadow_origin(receiver);
    if is_within(light, o) {
        return Visibility(1.0, 1.0, 0u);
    }
    let disc = disc_of(light, o, receiver.n.xyz);
    let bare = segment_area(disc.horizon);
    if disc.horizon <= -1.0 {
        return Visibility(0.0, 0.0, 0u);
    }
    var t = 0.0;
    var evaluations = 0u;
    while t < disc.t_max && evaluations < CONE_STEPS {
        let clearance = scene_distance(o + t * disc.w) / view.eye.w - t * disc.sine;
        evaluations += 1u;
        if clearance < 0.02 * receiver.p.w {
            return Visibility(0.0, bare, evaluations);
        }
        t += clearance / (1.0 + disc.sine);
    }
    return Visibility(bare, bare, evaluations);
}
