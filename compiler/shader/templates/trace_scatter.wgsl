// Drawing the directions that paths go on to from a surface.
//
// Theory: Directions of the interface are drawn from the visible normals (Heitz, "Sampling the GGX Distribution of Visible
// Normals", JCGT 2018), so that a drawn direction weighs F G₂/G₁; those of the body by the cosine.

/// A direction that light comes from, and what of it the surface sends back.
struct Scattered {
    w: vec3<f32>,
    weight: vec3<f32>,
    /// From 0 for a mirror's lobe to 1 for the body's.
    blur: f32,
}

/// Draws a direction: from the interface's lobe or from the body's, as `lobe` decides.
fn scatter_drawn(x: Vertex, u: vec2<f32>, lobe: f32) -> Scattered {
    let cos_v = max(dot(x.n, x.v), 0.01);
    let across = basis_across(x.n);

    // Choose a lobe in proportion to what it is about to reflect.
    let interface_share = max(x.albedo.x, max(x.albedo.y, x.albedo.z));
    let body_share = max(x.body.x, max(x.body.y, x.body.z)) * (1.0 - interface_share);
    let p_interface = interface_share / max(interface_share + body_share, 1e-4);
    if lobe >= p_interface {
        return Scattered(cosine_drawn(x.n, u), (1.0 - x.albedo) * x.body / max(1.0 - p_interface, 1e-4), 1.0);
    }

    // The interface: stretch the view, draw one of the normals that it sees, unstretch that.
    let v = vec3<f32>(dot(across[0], x.v), dot(across[1], x.v), cos_v);
    let stretched = normalize(vec3<f32>(x.alpha * v.xy, v.z));
    let level = normalize(vec3<f32>(-stretched.y, stretched.x + 1e-7, 0.0));
    let rising = cross(stretched, level);
    let d = unit_disc(u);
    let s = 0.5 * (1.0 + stretched.z);
    let e = mix(sqrt(max(1.0 - d.x * d.x, 0.0)), d.y, s);
    let seen = d.x * level + e * rising + sqrt(max(1.0 - d.x * d.x - e * e, 0.0)) * stretched;
    let h = normalize(vec3<f32>(x.alpha * seen.xy, max(seen.z, 1e-4)));
    let l = reflect(-v, h);
    if l.z <= 0.0 {
        return Scattered(x.n, vec3<f32>(0.0), 0.0);
    }
    let masking_v = smith(x.alpha, v.z);
    let G2_by_G1 = (1.0 + masking_v) / (masking_v + smith(x.alpha, l.z));
    let weight = x.gain * fresnel(x.f0, dot(h, l)) * G2_by_G1 / p_interface;
    return Scattered(normalize(across * l), weight, sqrt(x.alpha));
}
