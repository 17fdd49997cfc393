// Aaltonen 2018: penumbrae from the nearest miss, triangulated between two samples.
//
// Theory: S. Aaltonen, "GPU-based clay simulation and ray-tracing tech in Claybook" (GDC 2018): two spheres in succession
// that touch the same surface meet in a circle, and that circle is nearer to the silhouette than either sphere's
// centre: y = f₂²/(2 f₁), the miss is √(f₂² − y²) at t − y.
// Changes: k = 1/tan α; lengths relative to the receiver's offset.
// Practice: it bounds the miss from below for exact distances. A covered ray is black.

const AALTONEN_STEPS: u32 = 512u;

fn visibility(receiver: Receiver, light: Light, index: u32) -> Visibility {
    let o = shadow_origin(receiver);
    if is_within(light, o) {
        return Visibility(1.0, 1.0, 0u);
    }
    let disc = disc_of(light, o, receiver.n.xyz);
    if disc.horizon <= -1.0 {
        return Visibility(0.0, 0.0, 0u);
    }
    var seen = 1.0;
    var t = 5.0 * receiver.p.w;
    var f_before = FAR;
    var evaluations = 0u;
    while t < disc.t_max && evaluations < AALTONEN_STEPS {
        let f = scene_distance(o + t * disc.w) / view.eye.w;
        evaluations += 1u;
        if f < 0.5 * receiver.p.w {
            seen = 0.0;
            break;
        }
        let y = min(0.5 * f * (f / f_before), f);
        let miss = sqrt((f - y) * (f + y));
        seen = min(seen, miss / (disc.tangent * max(t - y, 1e-6 * t)));
        f_before = f;
        t += f;
    }
    return Visibility(seen, segment_area(disc.horizon), evaluations);
}
