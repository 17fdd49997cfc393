// A light as a disc: how methods that know spheres only see any light.
//
// Theory: A sphere of radius R at the distance D is seen from p' as the cap of half angle α, sin α = R/D. The receiver's
// horizon cuts from it what lies below; on the unit disc that the cap is projected to, the horizon is the chord at the
// signed distance x_h = (n·w) / (|n_lateral| tan α) from the centre.
// Changes: Where a paper's cone mixes tan and sin, the inscribed spheres of the cone are meant, ρ(t) = t sin α.

struct Disc {
    /// The unit direction to its centre.
    w: vec3<f32>,
    /// sin α.
    sine: f32,
    /// tan α.
    tangent: f32,
    /// How far a ray goes until it is at the light.
    t_max: f32,
    /// x_h.
    horizon: f32,
}

/// The part of a unit disc on the near side of a chord at the signed distance x from its centre.
fn segment_area(x: f32) -> f32 {
    let m = clamp(x, -1.0, 1.0);
    return (m * sqrt(max(1.0 - m * m, 0.0)) + asin(m)) / PI + 0.5;
}

/// The same, but for at most 0.04, by a cubic: silhouettes are seldom straight, and this errs less on average.
fn smooth_area(x: f32) -> f32 {
    let s = clamp(0.5 * x + 0.5, 0.0, 1.0);
    return s * s * (3.0 - 2.0 * s);
}

/// The light as seen from p, whose horizon's normal is n. The point must be outside the light's bounding sphere.
fn disc_of(light: Light, p: vec3<f32>, n: vec3<f32>) -> Disc {
    let cone = light_bound(light, p);
    let w = cone.xyz;
    let sine = clamp(cone.w, 1e-6, 0.9999);
    let tangent = sine / sqrt(1.0 - sine * sine);
    let cosine = dot(n, w);
    let lateral = sqrt(max(1.0 - cosine * cosine, 1e-12));
    // Behind the scene's box nothing covers the cone any more.
    let t_max = min(light_reach(light, p, w), scene_reach(p, w) * (1.0 + tangent * tangent));
    return Disc(w, sine, tangent, t_max, cosine / (lateral * tangent));
}

/// How far along w the scene can reach, as seen from p.
fn scene_reach(p: vec3<f32>, w: vec3<f32>) -> f32 {
    let centre = 0.5 * (setting_box_min() + setting_box_max());
    let extent = 0.5 * (setting_box_max() - setting_box_min());
    return max(dot(centre - p, w) + dot(extent, abs(w)), 0.0);
}

/// Whether a point is so near to a light that it is not seen as a disc.
fn is_within(light: Light, p: vec3<f32>) -> bool {
    return light_bound(light, p).w >= 1.0;
}

/// Whether a light is wholly below the horizon of a point with the normal n.
fn below_horizon(light: Light, p: vec3<f32>, n: vec3<f32>) -> bool {
    let cone = light_bound(light, p);
    return dot(n, cone.xyz) <= -cone.w;
}
