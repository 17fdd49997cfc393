// Drawing points of lights.
//
// Theory: A sphere and a sun are drawn evenly from the cap of directions that they cover (cos θ = 1 − u (1 − cos α)).

/// A direction towards a light.
struct LightSample {
    /// Of length 1.
    w: vec3<f32>,
    /// How far away the light is in this direction.
    distance: f32,
    /// One over the density of directions; 0 if the light doesn't shine that way.
    weight: f32,
}

fn light_drawn(light: Light, p: vec3<f32>, u: vec2<f32>) -> LightSample {
    let cone = light_bound(light, p);
    if cone.w >= 1.0 {
        let w = ball_direction(u);
        return LightSample(w, 0.0, 4.0 * PI);
    }
    // 1 − cos α, without its cancellation.
    let cap = cone.w * cone.w / (1.0 + sqrt(1.0 - cone.w * cone.w));
    let cosine = 1.0 - u.x * cap;
    let sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    let w = basis_across(cone.xyz) * vec3<f32>(sine * cos(TAU * u.y), sine * sin(TAU * u.y), cosine);
    var reach = FAR;
    if light.kind.x == LIGHT_SPHERE {
        let to_centre = light.a.xyz - p;
        let along = dot(to_centre, w);
        let lateral = to_centre - along * w;
        reach = along - sqrt(max(light.a.w * light.a.w - dot(lateral, lateral), 0.0));
    }
    return LightSample(normalize(w), reach, TAU * cap);
}

/// A direction of all, evenly.
fn ball_direction(u: vec2<f32>) -> vec3<f32> {
    let z = 1.0 - 2.0 * u.x;
    let r = sqrt(max(1.0 - z * z, 0.0));
    return vec3<f32>(r * cos(TAU * u.y), r * sin(TAU * u.y), z);
}
