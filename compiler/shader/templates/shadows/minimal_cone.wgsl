// The minimal tangent cone: the slimmest cone about the axis of a light that still touches the scene.
//
// Theory: Bán, Bálint and Valasek, "Area Lights in Signed Distance Function Scenes" (EG 2019), algorithm 2. The cone's
// spheres are ρ(t) = r₀ + t s; where one is cut by the scene, the cone is shrunk to the part m = f/ρ of its width, less
// ε; for m < 0 it is inverted, and the march goes on into the solid, as deep as it is covered.
// Changes: The printed loop ends at m ≤ ε, which leaves umbrae half grey; m has to reach −1. A cone that starts at its
// own width never moves; it starts shrunk. The step follows the update and is as long as the signed Lipschitz constant
// 1 + μ s allows. The paper says no ε; between 0.1 and 0.2 it changes the cost and hardly what is seen. Each is a
// `MinimalCone` below, so that the printed form can be looked at too.
// Practice: V = A(m), the part of a disc on the near side of a straight silhouette at m.

struct MinimalCone {
    /// The ε: how much slimmer the cone gets with every contact.
    tolerance: f32,
    /// The least m at which the march goes on.
    least: f32,
    /// The radius at the start, in offsets; 0 for a cone with an apex.
    start: f32,
    /// Whether steps are at least as long as f, and 0.1 ρ.
    long_steps: bool,
    /// Whether the receiver's horizon cuts the light.
    horizon: bool,
}

const CONE_STEPS: u32 = 512u;

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
    let cone = minimal_cone();
    let offset = receiver.p.w;
    var m = 1.0;
    var t = 0.0;
    var evaluations = 0u;
    // The paper's cone starts as wide as the receiver is known; if that is not free, as wide as is.
    var r0 = cone.start * offset;
    while t < disc.t_max && m > cone.least && evaluations < CONE_STEPS {
        let f = scene_distance(o + t * disc.w) / view.eye.w;
        evaluations += 1u;
        if evaluations == 1u && cone.start > 0.0 {
            r0 = clamp(f, 1e-3 * offset, r0);
        }
        let rho = max(r0 + t * disc.sine, 1e-3 * offset);
        m = min(m, f / rho);
        let mu = max(-1.0, m - cone.tolerance);
        var step = (f - mu * rho) / (1.0 + mu * disc.sine);
        if cone.long_steps {
            step = max(step, max(f, 0.1 * rho));
        }
        t += max(step, 0.02 * offset);
    }
    let part = disc_part(m);
    return Visibility(select(part, min(part, bare), cone.horizon), bare, evaluations);
}
