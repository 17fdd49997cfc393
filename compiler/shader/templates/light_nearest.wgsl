// The direction of a light that is nearest to a given one.

/// The unit direction from p to the point of a light that a ray in the unit direction w meets, or passes nearest to.
fn light_nearest(light: Light, p: vec3<f32>, w: vec3<f32>) -> vec3<f32> {
    switch light.kind.x {
        case LIGHT_QUAD: {
            return nearest_of_quad(light, p, w);
        }
        case LIGHT_DISK: {
            let on_plane = where_plane_is_met(light.b.xyz, light.a.xyz - p, w) - (light.a.xyz - p);
            let inside = on_plane * min(light.a.w / max(length(on_plane), 1e-20), 1.0);
            return normalize(light.a.xyz - p + inside);
        }
        case LIGHT_TUBE: {
            // The point of the axis that is nearest to the ray, then the tube's radius towards it.
            let half_length = length(light.b.xyz);
            let axis = light.b.xyz / max(half_length, 1e-20);
            let middle = light.a.xyz - p;
            let c = dot(axis, w);
            let along = (c * dot(middle, w) - dot(middle, axis)) / max(1.0 - c * c, 1e-6);
            let point = middle + clamp(along, -half_length, half_length) * axis;
            return nearest_of_ball(point, light.a.w, w);
        }
        case LIGHT_SUN: {
            return nearest_of_cap(light.a.xyz, light.a.w, w);
        }
        default: {
            return nearest_of_ball(light.a.xyz - p, light.a.w, w);
        }
    }
}

fn nearest_of_ball(centre: vec3<f32>, radius: f32, w: vec3<f32>) -> vec3<f32> {
    let distance = max(length(centre), 1e-20);
    return nearest_of_cap(centre / distance, min(radius / distance, 1.0), w);
}

/// Of the cap of directions about an axis whose half angle has this sine.
fn nearest_of_cap(axis: vec3<f32>, sine: f32, w: vec3<f32>) -> vec3<f32> {
    let cosine = sqrt(max(1.0 - sine * sine, 0.0));
    if dot(w, axis) >= cosine {
        return w;
    }
    let lateral = w - dot(w, axis) * axis;
    return normalize(cosine * axis + sine * lateral / max(length(lateral), 1e-20));
}

/// Where a ray from the origin meets a plane through a point; far ahead, if it goes away from it.
fn where_plane_is_met(normal: vec3<f32>, point: vec3<f32>, w: vec3<f32>) -> vec3<f32> {
    let unit = normalize(normal);
    let depth = dot(point, unit);
    let falls = dot(w, unit) * sign(depth);
    return w * (abs(depth) / max(falls, 1e-3));
}

/// The mirrored ray's point of the plane, moved to the nearest of the edges that it lies outside of.
fn nearest_of_quad(light: Light, p: vec3<f32>, w: vec3<f32>) -> vec3<f32> {
    let normal = quad_normal(light);
    let met = p + where_plane_is_met(normal, light.a.xyz - p, w);
    if is_in_quad(light, met) {
        return normalize(met - p);
    }
    var best = nearest_of_edge(light.a.xyz, light.b.xyz, met);
    let bc = nearest_of_edge(light.b.xyz, light.c.xyz, met);
    best = select(best, bc, distance(bc, met) < distance(best, met));
    let cd = nearest_of_edge(light.c.xyz, light.d.xyz, met);
    best = select(best, cd, distance(cd, met) < distance(best, met));
    let da = nearest_of_edge(light.d.xyz, light.a.xyz, met);
    best = select(best, da, distance(da, met) < distance(best, met));
    return normalize(best - p);
}

fn nearest_of_edge(a: vec3<f32>, b: vec3<f32>, p: vec3<f32>) -> vec3<f32> {
    let ab = b - a;
    return a + clamp(dot(p - a, ab) / max(dot(ab, ab), 1e-20), 0.0, 1.0) * ab;
}
