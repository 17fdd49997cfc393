// Irradiances of lights in closed form, per radiance: E₀ = ∫ max(cos θ, 0) dω over the whole light, nothing in between.
//
// Theory: A sphere and a sun cover a cap of directions; for one that the horizon cuts, Lagarde and de Rousiers ("Moving
// Frostbite to Physically Based Rendering", 2014, listing 10) give the integral. Of all others the outline is a polygon.

fn light_irradiance(light: Light, p: vec3<f32>, n: vec3<f32>) -> f32 {
    if light.kind.x == LIGHT_SPHERE || light.kind.x == LIGHT_SUN {
        let cone = light_bound(light, p);
        if cone.w >= 1.0 {
            return PI;
        }
        return cap_irradiance(dot(n, cone.xyz), cone.w);
    }
    if !shines_at(light, p) {
        return 0.0;
    }
    return polygon_irradiance(light, p, n);
}

/// Of a cap of directions whose half angle has this sine, about an axis at this cosine to the normal.
fn cap_irradiance(cosine: f32, sine: f32) -> f32 {
    let sine2 = sine * sine;
    if cosine >= sine {
        return PI * sine2 * cosine;
    }
    if cosine <= -sine {
        return 0.0;
    }
    let lateral = sqrt(max(1.0 - cosine * cosine, 1e-12));
    let x = sqrt(1.0 / sine2 - 1.0);
    let y = clamp(-x * cosine / lateral, -1.0, 1.0);
    let chord = lateral * sqrt(1.0 - y * y);
    return max((cosine * acos(y) - x * chord) * sine2 + atan2(chord, x), 0.0);
}

/// Whether p is on a side of a light that shines.
fn shines_at(light: Light, p: vec3<f32>) -> bool {
    if light.kind.x == LIGHT_TUBE || (light.kind.y & LIGHT_TWO_SIDED) > 0u {
        return true;
    }
    let normal = select(light.b.xyz, quad_normal(light), light.kind.x == LIGHT_QUAD);
    return dot(p - light.a.xyz, normal) > 0.0;
}

/// Of what is within a light's outline.
fn polygon_irradiance(light: Light, p: vec3<f32>, n: vec3<f32>) -> f32 {
    let outline = outline_of(light, p);
    var boundary = boundary_begun(n, outline.middle);
    for (var i = 0u; i < outline.corners; i++) {
        boundary = boundary_to(boundary, outline_corner(outline, i));
    }
    return max(dot(boundary_integral(boundary), n), 0.0);
}

/// The i-th of four corners, from p: of a quadrilateral, or of a tube's silhouette between the lines where planes through
/// p touch it.
fn light_corner(light: Light, p: vec3<f32>, i: u32) -> vec3<f32> {
    if light.kind.x == LIGHT_TUBE {
        // Across the axis the tube is a circle; the touching lines are nearer than its middle by r²/d, and to the sides by
        // r √(1 − r²/d²).
        let axis = normalize(light.b.xyz);
        let to_middle = light.a.xyz - p;
        let across = to_middle - dot(to_middle, axis) * axis;
        let d = max(length(across), light.a.w * 1.0001);
        let towards = across / d;
        let part = light.a.w / d;
        let sideways = cross(axis, towards) * (light.a.w * sqrt(max(1.0 - part * part, 0.0)));
        let nearer = towards * (light.a.w * part);
        let end = select(-1.0, 1.0, i == 1u || i == 2u);
        let side = select(-1.0, 1.0, i >= 2u);
        return to_middle - nearer + end * light.b.xyz + side * sideways;
    }
    return select(select(light.a.xyz, light.b.xyz, i == 1u), select(light.c.xyz, light.d.xyz, i == 3u), i >= 2u) - p;
}
