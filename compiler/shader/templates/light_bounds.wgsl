// How lights bound the rays towards them.

/// The cone about a light as seen from p: the unit direction of its axis; w: the sine of its half angle, 1 within the
/// light's bounding sphere.
fn light_bound(light: Light, p: vec3<f32>) -> vec4<f32> {
    if light.kind.x == LIGHT_SUN {
        return light.a;
    }
    let sphere = light_sphere(light);
    let to_centre = sphere.xyz - p;
    let far = length(to_centre);
    return vec4<f32>(to_centre / max(far, 1e-20), min(sphere.w / max(far, 1e-20), 1.0));
}

/// The centre and the radius of a light's bounding sphere; not of a sun.
fn light_sphere(light: Light) -> vec4<f32> {
    if light.kind.x == LIGHT_QUAD {
        let centre = 0.25 * (light.a.xyz + light.b.xyz + light.c.xyz + light.d.xyz);
        let nearer = max(distance(light.a.xyz, centre), distance(light.b.xyz, centre));
        let farther = max(distance(light.c.xyz, centre), distance(light.d.xyz, centre));
        return vec4<f32>(centre, max(nearer, farther));
    }
    if light.kind.x == LIGHT_TUBE {
        return vec4<f32>(light.a.xyz, length(vec2<f32>(light.a.w, length(light.b.xyz))));
    }
    return light.a;
}

/// How far a ray from p in the unit direction w goes until it is at the light. Rays at a sphere end before its front,
/// where the cone about it is narrowest; those to flat lights at the light's plane; those to a sun never.
fn light_reach(light: Light, p: vec3<f32>, w: vec3<f32>) -> f32 {
    if light.kind.x == LIGHT_SUN {
        return FAR;
    }
    if light.kind.x == LIGHT_QUAD {
        return plane_reach(quad_normal(light), light.a.xyz - p, w);
    }
    if light.kind.x == LIGHT_DISK {
        return plane_reach(light.b.xyz, light.a.xyz - p, w);
    }
    return max(distance(light.a.xyz, p) - light.a.w, 0.0);
}

/// How far along w a plane is that goes through a point; its normal need not have length 1.
fn plane_reach(normal: vec3<f32>, to_plane: vec3<f32>, w: vec3<f32>) -> f32 {
    let falls = dot(w, normal);
    return clamp(dot(to_plane, normal) / select(falls, 1e-12, abs(falls) < 1e-12), 0.0, length(to_plane) * 1e3);
}

/// The normal of a quadrilateral's lit side, as long as twice its area.
fn quad_normal(light: Light) -> vec3<f32> {
    return cross(light.c.xyz - light.a.xyz, light.d.xyz - light.b.xyz);
}
