// The cones that a glossy lobe is made of: what a rough surface mirrors.
//
// Theory: As for voxel cone tracing's specular cone (Crassin et al. 2011), but several in place of one, so that the lobe keeps
// its shape at grazing angles: directions of the visible normals (Heitz 2018) at even places of the unit disc, one in the
// middle and the others around it.

const LOBE_CONES: i32 = 7;
/// Lobes with a smaller α mirror what a ray meets; wider ones what these cones see.
const LEAST_LOBE_ALPHA: f32 = 0.04;
/// The sine of a cone's half angle, as a part of α.
const LOBE_SINE: f32 = 1.2;

/// The k-th direction of a lobe, for one of a pixel's rays; w: what it weighs.
fn lobe_direction(x: Vertex, k: i32, ray: i32) -> vec4<f32> {
    // The disc's middle, or the centre of a part of the ring around it: all have the same area. Each ray turns the ring.
    let angle = 2.0 * PI / f32(LOBE_CONES - 1) * (f32(k) + (f32(ray) + 0.5) / f32(RAYS));
    let d = select(0.736, 0.0, k == 0) * vec2<f32>(cos(angle), sin(angle));

    // The view and one direction across, by which the disc is turned, in the surface's own axes.
    let cos_v = max(dot(x.n, x.v), 0.01);
    let level_v = x.v - cos_v * x.n;
    let ahead = select(basis_across(x.n)[0], level_v / max(length(level_v), 1e-9), length(level_v) > 1e-4);
    let across = cross(x.n, ahead);
    let v = vec3<f32>(dot(ahead, x.v), 0.0, cos_v);

    let stretched = normalize(vec3<f32>(x.alpha * v.x, 0.0, v.z));
    let level = vec3<f32>(0.0, 1.0, 0.0);
    let rising = cross(stretched, level);
    let share = 0.5 * (1.0 + stretched.z);
    let e = mix(sqrt(max(1.0 - d.x * d.x, 0.0)), d.y, share);
    let seen = d.x * level + e * rising + sqrt(max(1.0 - d.x * d.x - e * e, 0.0)) * stretched;
    let h = normalize(vec3<f32>(x.alpha * seen.x, x.alpha * seen.y, max(seen.z, 1e-4)));
    let l = reflect(-v, h);
    if l.z <= 0.02 {
        return vec4<f32>(x.n, 0.0);
    }
    let masking_v = smith(x.alpha, v.z);
    let weight = (1.0 + masking_v) / (masking_v + smith(x.alpha, l.z));
    return vec4<f32>(normalize(l.x * ahead + l.y * across + l.z * x.n), weight);
}
