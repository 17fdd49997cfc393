// How a surface scatters light: a Lambertian body under a GGX interface.
//
// Theory: f = (1 − E) ρ/π + g D V F with the distribution D of Trowbridge and Reitz (GGX), Smith's height-correlated
// visibility V and Schlick's F. What light loses between microfacets comes back by the gain g = 1 + F₀ (1/E₁ − 1), where E₁ is
// the albedo of D V (Turquin, "Practical Multiple Scattering Compensation for Microfacet Models", 2019); the body
// gets what the interface, whose albedo is E, doesn't send back. So a white surface sends back all that it gets.
// Changes: For a light of a given angular radius D is widened by it, so that a small and bright highlight
// on a polished surface makes no isolated bright pixels.

/// A surface at a point.
struct Vertex {
    /// The normal, outwards, of length 1.
    n: vec3<f32>,
    /// The way back along the ray, on n's side.
    v: vec3<f32>,
    /// What the body scatters, ρ.
    body: vec3<f32>,
    /// What the interface reflects head-on, F₀.
    f0: vec3<f32>,
    /// GGX's α, the square of the roughness.
    alpha: f32,
    /// What the interface sends back of a radiance of 1 from everywhere.
    albedo: vec3<f32>,
    /// By how much its lobe is brighter than after one reflection.
    gain: vec3<f32>,
}

fn vertex_of(surface: Surface, n: vec3<f32>, back: vec3<f32>) -> Vertex {
    // Seen at a grazing angle a normal may point away from the eye: turn the view into the surface's horizon.
    let cos_v = dot(n, back);
    let v = normalize(back + max(0.02 - cos_v, 0.0) * n);
    let roughness = clamp(surface.finish.x, LEAST_ROUGHNESS, 1.0);
    let metallic = clamp(surface.finish.y, 0.0, 1.0);
    let color = clamp(surface.color.rgb, vec3<f32>(0.0), vec3<f32>(1.0));
    let f0 = mix(vec3<f32>(0.04), color, metallic);
    let once = gloss_entry(roughness, dot(n, v), 1u).xy;
    let gain = 1.0 + f0 * (1.0 / max(once.x, 0.1) - 1.0);
    let albedo = gain * (f0 * once.x + (1.0 - f0) * once.y);
    return Vertex(n, v, (1.0 - metallic) * color, f0, roughness * roughness, albedo, gain);
}

fn fresnel(f0: vec3<f32>, cosine: f32) -> vec3<f32> {
    let x = clamp(1.0 - cosine, 0.0, 1.0);
    let x2 = x * x;
    return f0 + (1.0 - f0) * (x2 * x2 * x);
}

/// Smith's Λ-form of the masking of one direction: G₁ = 2 / (1 + this).
fn smith(alpha: f32, cosine: f32) -> f32 {
    let c2 = cosine * cosine;
    return sqrt(1.0 + alpha * alpha * (1.0 - c2) / c2);
}

/// f · cos for light from l, itself of an angular radius.
fn scatter_towards(x: Vertex, l: vec3<f32>, angular_radius: f32) -> vec3<f32> {
    return (1.0 - x.albedo) * x.body / PI * max(dot(x.n, l), 0.0) + gloss_towards(x, l, angular_radius);
}

/// The interface's part of that.
fn gloss_towards(x: Vertex, l: vec3<f32>, angular_radius: f32) -> vec3<f32> {
    let cos_l = dot(x.n, l);
    if cos_l <= 0.0 {
        return vec3<f32>(0.0);
    }
    let cos_v = max(dot(x.n, x.v), 0.01);
    let h = normalize(l + x.v);
    let cos_h = clamp(dot(x.n, h), 0.0, 1.0);
    let F = fresnel(x.f0, dot(h, l));

    let alpha = max(x.alpha, angular_radius);
    let a2 = alpha * alpha;
    let sine_h = cross(x.n, h);
    let spread = a2 * cos_h * cos_h + dot(sine_h, sine_h);
    let D = a2 / (PI * spread * spread);
    let lambdas = cos_l * cos_v * (smith(alpha, cos_v) + smith(alpha, cos_l));
    let V = 0.5 / max(lambdas, 1e-4);

    return x.gain * D * V * F * cos_l;
}
