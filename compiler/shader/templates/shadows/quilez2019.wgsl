// Quilez 2019: penumbrae from both sides of a silhouette.
//
// Theory: I. Quilez, shader "Soft shadow improved" (2019): the ray goes on into solids, where f is negative, and the least
// f/(t tan α), from −1 for a light that is wholly covered to 1, is mapped to V by a cubic.
// Changes: Lengths that are absolute in the shader are relative to the receiver's offset; the shortest step is 2.5 and
// the longest 250 offsets.
// Practice: inside a sheet thinner than the light's cone the depth stays small, and the umbra grey.

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
    let offset = receiver.p.w;
    var least = 1.0;
    var t = 5.0 * offset;
    var evaluations = 0u;
    while t < disc.t_max && evaluations < QUILEZ_STEPS {
        let f = scene_distance(o + t * disc.w) / view.eye.w;
        evaluations += 1u;
        least = min(least, f / (disc.tangent * t));
        if least < -1.0 {
            break;
        }
        t += clamp(f, 2.5 * offset, 250.0 * offset);
    }
    return Visibility(smooth_area(least), segment_area(disc.horizon), evaluations);
}
