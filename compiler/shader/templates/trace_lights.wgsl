// The lights, as paths use them.
//
// Theory: A surface draws one light, in proportion to an estimate of what it gets of each, and a direction towards it
// (next-event estimation). The choice is made in one walk over the lights by weighted reservoir sampling (Chao 1982).
// Practice: rays drawn from surfaces don't meet lights, or their light would count twice.

/// A direction towards a light.
struct Drawn {
    w: vec3<f32>,
    distance: f32,
    /// The light's radiance, times the solid angle that the direction stands for.
    radiance: vec3<f32>,
    angular_radius: f32,
}

/// The light that a camera ray meets first.
struct Shining {
    /// How far along the ray; `FAR` for none.
    t: f32,
    radiance: vec3<f32>,
}

/// One of the lights.
struct Choice {
    index: u32,
    /// 1 over the probability that it was chosen; 0 if there was none to choose.
    weight: f32,
}

/// Draws a direction towards one of the lights that have all of these flags.
fn some_light_drawn(p: vec3<f32>, n: vec3<f32>, u: vec2<f32>, choice: f32, flags: u32) -> Drawn {
    let chosen = some_light(p, n, choice, flags);
    let light = lights[chosen.index];
    let sample = light_drawn(light, p, u);
    let scale = sample.weight * chosen.weight;
    return Drawn(sample.w, sample.distance, scale * light.radiance.rgb, min(light_bound(light, p).w, 1.0));
}

/// Draws one of the lights that have all of these flags.
fn some_light(p: vec3<f32>, n: vec3<f32>, choice: f32, flags: u32) -> Choice {
    var chosen = 0u;
    var weight = 0.0;
    var total = 0.0;
    var remainder = choice;
    for (var i = 0u; i < arrayLength(&lights); i++) {
        let w = select(0.0, light_importance(lights[i], p, n), (lights[i].kind.y & flags) == flags);
        total += w;
        // The remainder stays evenly spread over [0, 1) given what was chosen.
        let p_chosen = w / max(total, TINY);
        if remainder < p_chosen {
            chosen = i;
            weight = w;
            remainder /= p_chosen;
        } else {
            remainder = (remainder - p_chosen) / max(1.0 - p_chosen, TINY);
        }
    }
    return Choice(chosen, select(0.0, total / max(weight, TINY), weight > 0.0));
}

/// About how much of a light's radiance a surface gets; 0 only if it gets none.
fn light_importance(light: Light, p: vec3<f32>, n: vec3<f32>) -> f32 {
    let cone = light_bound(light, p);
    let highest = dot(n, cone.xyz) + cone.w;
    let luminance = dot(light.radiance.rgb, vec3<f32>(0.2126, 0.7152, 0.0722));
    return select(0.0, luminance * max(cone.w * cone.w, 1e-12) * clamp(highest, 0.05, 1.0), highest > 0.0);
}

fn nearest_shining(ray: Ray) -> Shining {
    var shining = Shining(FAR, vec3<f32>(0.0));
    for (var i = 0u; i < arrayLength(&lights); i++) {
        let light = lights[i];
        if (light.kind.y & LIGHT_VISIBLE) > 0u {
            let t = light_crossing(light, ray.o, ray.w);
            if t < shining.t {
                shining = Shining(t, light.radiance.rgb);
            }
        }
    }
    return shining;
}
