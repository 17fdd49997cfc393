// Quilez 2010: penumbrae from the nearest miss of a ray to the light's centre.
//
// Theory: I. Quilez, "Free penumbra shadows for raymarching distance fields" (2010): V = min over the samples of k f/t.
// Changes: k = 1/tan α, so that the penumbra's outer rim is the light's; the lengths that are absolute in the listing are
// relative to the receiver's offset.
// Practice: umbrae are too large by as much as penumbrae lack within, since a covered ray is black.

const QUILEZ_STEPS: u32 = 512u;

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
    var evaluations = 0u;
    while t < disc.t_max && evaluations < QUILEZ_STEPS {
        let f = scene_distance(o + t * disc.w) / view.eye.w;
        evaluations += 1u;
        if f < 0.5 * receiver.p.w {
            seen = 0.0;
            break;
        }
        seen = min(seen, f / (disc.tangent * t));
        t += f;
    }
    return Visibility(seen, segment_area(disc.horizon), evaluations);
}
