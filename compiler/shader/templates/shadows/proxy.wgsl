// The proxy occluder: the half space that the minimal tangent cone touches, in the place of the scene.
//
// Theory: Bán, Bálint and Valasek (2019), section 4.2. The slimmest cone that touches the scene touches it at c = q − f ∇f,
// q = o + t w; to the light, the scene is about the half space through o and c with that normal. Samples of the light
// are tested against it and not against the scene, so that any light whose points can be drawn is integrated at
// the cost of one march and one normal.
// Changes: For a minimiser that is only near the minimum the normal is made perpendicular to c − o. The samples are
// drawn from the light's own solid angle or area and not from the cone about it, which wastes half of them.
// Practice: One call of the scene: the march, then four probes of the gradient. `task.cells` samples.

const PROXY_STEPS: u32 = 512u;
const CONE_TOLERANCE: f32 = 0.1;

/// The k-th corner of a tetrahedron about the origin.
fn corner(k: u32) -> vec3<f32> {
    return vec3<f32>(f32(((k + 3u) >> 1u) & 1u), f32((k >> 1u) & 1u), f32(k & 1u)) * 2.0 - 1.0;
}

fn visibility(receiver: Receiver, light: Light, index: u32) -> Visibility {
    let o = shadow_origin(receiver);
    let n = receiver.n.xyz;
    if is_within(light, o) {
        return Visibility(1.0, 1.0, 0u);
    }
    let disc = disc_of(light, o, n);
    if disc.horizon <= -1.0 {
        return Visibility(0.0, 0.0, 0u);
    }
    // The minimal tangent cone, and where it touches.
    var m = 1.0;
    var t = 0.0;
    var contact = vec2<f32>(0.0);
    var slope = vec3<f32>(0.0);
    var probes = 0u;
    var marching = true;
    var evaluations = 0u;
    let h = 0.25 * receiver.p.w;
    while evaluations < PROXY_STEPS {
        if marching && (t >= disc.t_max || m <= -1.0) {
            if m >= 1.0 || m <= -1.0 {
                break;
            }
            marching = false;
            probes = 4u;
        }
        let at = select(contact.x, t, marching);
        let shift = select(h * corner(probes - 1u), vec3<f32>(0.0), marching);
        let f = scene_distance(o + at * disc.w + shift) / view.eye.w;
        evaluations += 1u;
        if !marching {
            slope += f * corner(probes - 1u);
            probes -= 1u;
            if probes == 0u {
                break;
            }
            continue;
        }
        let rho = max(t * disc.sine, 1e-3 * receiver.p.w);
        if t > 0.0 && f / rho < m {
            m = f / rho;
            contact = vec2<f32>(t, f);
        }
        let mu = max(-1.0, m - CONE_TOLERANCE);
        t += max((f - mu * rho) / (1.0 + mu * disc.sine), max(f, max(0.1 * rho, 0.02 * receiver.p.w)));
    }
    let covered = m <= -1.0;
    let gradient = slope / max(length(slope), TINY);
    let c = contact.x * disc.w - contact.y * gradient;
    let side = gradient - dot(gradient, c) / max(dot(c, c), TINY) * c;

    // The light against the half space and the horizon.
    let seed = hash(index, 0x5eedu + (task.sample >> 16u));
    let by_irradiance = !(light.kind.x == LIGHT_SPHERE || light.kind.x == LIGHT_SUN);
    var seen = 0.0;
    var bare = 0.0;
    var total = 0.0;
    for (var k = 0u; k < task.cells; k++) {
        let ray = light_drawn(light, o, unit_square(seed, (task.sample & 0xffffu) + k, 0u));
        let cosine = dot(n, ray.w);
        let share = ray.weight * select(1.0, max(cosine, 0.0), by_irradiance);
        total += share;
        bare += select(0.0, share, cosine > 0.0);
        let passes = (m >= 1.0 || dot(ray.w, side) >= 0.0) && !covered;
        seen += select(0.0, share, cosine > 0.0 && passes);
    }
    let whole = max(select(total, bare, by_irradiance), TINY);
    return Visibility(seen / whole, select(bare / whole, f32(bare > 0.0), by_irradiance), evaluations);
}
