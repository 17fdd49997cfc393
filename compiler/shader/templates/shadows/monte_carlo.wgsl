// Monte Carlo: the part of a light that random rays reach.
//
// Theory: Rays are drawn evenly from the directions that a light covers; a scrambled Sobol' sequence of its own for
// every receiver (see `trace_numbers.wgsl`) spreads them. V is the part of them that is above the horizon and arrives.
// Practice: One call of the scene: a loop over steps draws the next ray where one ends. The lower half of `task.sample`
// is the number of rays drawn before, so that passes add up to one sequence, and its upper half chooses the sequence;
// `task.cells` is how many rays are drawn now. Where `task.stage` asks for the whole integral, V₀ gives way to it.

/// How far steps go beyond what is free, in offsets: a distance of 0 may be no surface.
const BEYOND: f32 = 0.025;
const RAY_STEPS: u32 = 600u;
/// What `task.stage` may ask for: that ∫ max(cos θ, 0) dω over what is seen of the light stands where else V₀ does.
const WITH_IRRADIANCE: u32 = 1u;

fn visibility(receiver: Receiver, light: Light, index: u32) -> Visibility {
    let o = shadow_origin(receiver);
    let n = receiver.n.xyz;
    let asks_irradiance = task.stage == WITH_IRRADIANCE;
    let by_irradiance = !(light.kind.x == LIGHT_SPHERE || light.kind.x == LIGHT_SUN);
    if !by_irradiance && is_within(light, o) {
        return Visibility(1.0, select(1.0, PI, asks_irradiance), 0u);
    }
    if below_horizon(light, o, n) {
        return Visibility(0.0, 0.0, 0u);
    }
    let seed = hash(index, 0x5eedu + (task.sample >> 16u));
    var seen = 0.0;
    // The irradiance of the rays that arrived, and of the one on its way.
    var received = 0.0;
    var brings = 0.0;
    var bare = 0.0;
    var total = 0.0;
    var evaluations = 0u;
    var drawn = 0u;
    var t = 0.0;
    var steps = 0u;
    var weight = 0.0;
    var reach = -1.0;
    var w = vec3<f32>(0.0);
    loop {
        if t >= reach {
            // Arrived; the first time round, there is no ray yet.
            seen += weight;
            received += brings;
            if drawn >= task.cells {
                break;
            }
            let ray = light_drawn(light, o, unit_square(seed, (task.sample & 0xffffu) + drawn, 0u));
            drawn += 1u;
            w = ray.w;
            let cosine = dot(n, w);
            let share = ray.weight * select(1.0, max(cosine, 0.0), by_irradiance);
            total += share;
            weight = select(0.0, share, cosine > 0.0);
            bare += weight;
            brings = ray.weight * max(cosine, 0.0);
            t = 0.0;
            steps = 0u;
            reach = min(ray.distance, scene_reach(o, w));
            reach = select(reach, -1.0, weight <= 0.0);
            continue;
        }
        let f = scene_distance(o + t * w) / view.eye.w;
        evaluations += 1u;
        steps += 1u;
        t += f + BEYOND * receiver.p.w;
        if f < 0.0 || steps >= RAY_STEPS {
            weight = 0.0;
            brings = 0.0;
            t = reach;
        }
    }
    let whole = select(total, bare, by_irradiance);
    let above = select(bare / max(whole, TINY), f32(bare > 0.0), by_irradiance);
    let second = select(above, received / f32(max(drawn, 1u)), asks_irradiance);
    return Visibility(seen / max(whole, TINY), second, evaluations);
}
