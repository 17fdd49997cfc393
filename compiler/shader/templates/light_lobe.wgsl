// How much of a glossy lobe a light fills.
//
// Theory: Multiplied by the inverse matrix of a linearly transformed cosine, the light's outline becomes one under a plain
// cosine lobe, whose integral is known (Heitz, Dupuy, Hill, Neubelt 2016).
// Changes: The transformed cosine may reach below the surface's horizon, where nothing is reflected: outlines are cut there
// first, and the share is that of what is left of the lobe.

/// What of a lobe a light fills.
struct LobeShare {
    /// The part of what the lobe would send back if light came from everywhere, Fresnel's term aside.
    part: f32,
    /// The unit direction that the light comes from, on average.
    w: vec3<f32>,
}

/// What the interface sends to the eye of a light of radiance 1 of which all is seen.
fn gloss_of_light(light: Light, x: Vertex, p: vec3<f32>) -> vec3<f32> {
    if is_within_round(light, p) {
        return x.albedo;
    }
    let share = lobe_share(light, x, p);
    // Fresnel's term is that of the light's direction, and of the lobe's average where the light is all around.
    let once = gloss_entry(sqrt(x.alpha), dot(x.n, x.v), 1u);
    let grazing = pow(clamp(1.0 - dot(normalize(share.w + x.v), x.v), 0.0, 1.0), 5.0);
    let F = x.f0 + (1.0 - x.f0) * mix(grazing, once.y / once.x, share.part);
    return x.gain * F * once.x * share.part;
}

/// Whether p is within a sphere or a sun.
fn is_within_round(light: Light, p: vec3<f32>) -> bool {
    let is_round = light.kind.x == LIGHT_SPHERE || light.kind.x == LIGHT_SUN;
    return is_round && light_bound(light, p).w >= 1.0;
}

fn lobe_share(light: Light, x: Vertex, p: vec3<f32>) -> LobeShare {
    let n = x.n;
    let mirrored = reflect(-x.v, n);
    let sideways = cross(n, x.v);
    let y = select(basis_across(n)[0], sideways / max(length(sideways), 1e-20), length(sideways) > 1e-6);
    let towards = cross(y, mirrored);
    let entry = gloss_entry(sqrt(x.alpha), dot(n, x.v), 0u);
    let m = vec4<f32>(entry.x, x.alpha * entry.yzw);
    let to_lobe = transpose(mat3x3<f32>(m.x * towards + m.y * mirrored, y, m.z * towards + m.w * mirrored));

    // How much of the lobe is above the horizon: there, the horizon is a plane at an angle γ to the cosine's.
    let up = vec2<f32>(dot(n, towards), dot(n, mirrored));
    let horizon = normalize(vec2<f32>(up.x * m.w - up.y * m.z, up.y * m.x - up.x * m.y));
    let above = 0.5 + 0.5 * horizon.y;

    let outline = outline_of(light, p);
    let height_of_middle = dot(n, outline.middle);
    var boundary = boundary_begun(vec3<f32>(0.0, 0.0, 1.0), to_lobe * outline.middle);
    var corner = outline_corner(outline, outline.corners - 1u);
    var height = height_of_middle + dot(n, corner);
    for (var i = 0u; i < outline.corners; i++) {
        let next = outline_corner(outline, i);
        let next_height = height_of_middle + dot(n, next);
        if height > 0.0 || next_height > 0.0 {
            let crossing = clamp(height / select(height - next_height, 1.0, height == next_height), 0.0, 1.0);
            let between = corner + crossing * (next - corner);
            boundary = boundary_to(boundary, to_lobe * select(between, corner, height >= 0.0));
            boundary = boundary_to(boundary, to_lobe * select(between, next, next_height >= 0.0));
        }
        corner = next;
        height = next_height;
    }
    let sum = boundary_integral(boundary);
    let part = clamp(sum.z / (PI * max(above, 1e-3)), 0.0, 1.0);
    let from_lobe = vec2<f32>(m.w * sum.x - m.y * sum.z, m.x * sum.z - m.z * sum.x) / (m.x * m.w - m.y * m.z);
    let w = from_lobe.x * towards + sum.y * y + from_lobe.y * mirrored;
    return LobeShare(part, select(mirrored, normalize(w), dot(w, w) > 1e-30));
}
