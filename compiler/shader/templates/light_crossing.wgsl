// Where rays meet lights.

/// How far from o along the unit direction w a ray meets a light's shining side; `FAR` if it doesn't. A sun is met just
/// before that.
fn light_crossing(light: Light, o: vec3<f32>, w: vec3<f32>) -> f32 {
    if light.kind.x == LIGHT_SUN {
        let lateral = length(cross(light.a.xyz, w));
        return select(FAR, 0.999 * FAR, dot(light.a.xyz, w) > 0.0 && lateral <= light.a.w);
    }
    if light.kind.x == LIGHT_DISK {
        let t = flat_crossing(light, light.b.xyz, o, w);
        return select(FAR, t, distance(o + t * w, light.a.xyz) <= light.a.w);
    }
    if light.kind.x == LIGHT_QUAD {
        let t = flat_crossing(light, quad_normal(light), o, w);
        return select(FAR, t, is_in_quad(light, o + t * w));
    }
    if light.kind.x == LIGHT_TUBE {
        return tube_crossing(light, o, w);
    }
    let to_centre = light.a.xyz - o;
    let along = dot(to_centre, w);
    let lateral = to_centre - along * w;
    let half_chord2 = light.a.w * light.a.w - dot(lateral, lateral);
    let t = along - sqrt(max(half_chord2, 0.0));
    return select(FAR, t, half_chord2 > 0.0 && t > 0.0);
}

/// Where a ray meets the plane of a flat light from a side that shines.
fn flat_crossing(light: Light, normal: vec3<f32>, o: vec3<f32>, w: vec3<f32>) -> f32 {
    let falls = dot(w, normal);
    let t = dot(light.a.xyz - o, normal) / select(falls, 1e-12, abs(falls) < 1e-12);
    let shines = falls < 0.0 || (light.kind.y & LIGHT_TWO_SIDED) > 0u;
    return select(FAR, t, shines && t > 0.0 && abs(falls) > 1e-12);
}

/// Whether a point of a quadrilateral's plane is within it.
fn is_in_quad(light: Light, p: vec3<f32>) -> bool {
    let n = quad_normal(light);
    let ab = dot(cross(light.b.xyz - light.a.xyz, p - light.a.xyz), n);
    let bc = dot(cross(light.c.xyz - light.b.xyz, p - light.b.xyz), n);
    let cd = dot(cross(light.d.xyz - light.c.xyz, p - light.c.xyz), n);
    let da = dot(cross(light.a.xyz - light.d.xyz, p - light.d.xyz), n);
    return min(min(ab, bc), min(cd, da)) >= 0.0;
}

/// Where a ray meets the outside of a tube.
fn tube_crossing(light: Light, o: vec3<f32>, w: vec3<f32>) -> f32 {
    let half_length = length(light.b.xyz);
    let axis = light.b.xyz / max(half_length, 1e-20);
    let from_middle = o - light.a.xyz;
    // Across the axis it is a circle.
    let o_across = from_middle - dot(from_middle, axis) * axis;
    let w_across = w - dot(w, axis) * axis;
    let speed2 = max(dot(w_across, w_across), 1e-20);
    let nearest = -dot(o_across, w_across) / speed2;
    let lateral = o_across + nearest * w_across;
    let half_chord2 = (light.a.w * light.a.w - dot(lateral, lateral)) / speed2;
    let t = nearest - sqrt(max(half_chord2, 0.0));
    let along = dot(from_middle + t * w, axis);
    return select(FAR, t, half_chord2 > 0.0 && t > 0.0 && abs(along) <= half_length);
}
