// Drawing points of lights.
//
// Theory: A sphere and a sun are drawn evenly from the cap of directions that they cover, cos θ = 1 − u (1 − cos α); a
// rectangle evenly from its solid angle (Ureña, Fajardo, King, "An Area-Preserving Parametrization for Spherical
// Rectangles", 2013); other quadrilaterals, disks and tubes by area.
// Practice: a rectangle whose solid angle is too small for f32 is drawn by area, which is then as good.

/// A direction towards a light.
struct LightSample {
    /// Of length 1.
    w: vec3<f32>,
    /// How far away the light is in this direction.
    distance: f32,
    /// One over the density of directions; 0 if the light doesn't shine that way.
    weight: f32,
}

/// Below this solid angle a rectangle is drawn by area.
const LEAST_SOLID_ANGLE: f32 = 1e-3;

fn light_drawn(light: Light, p: vec3<f32>, u: vec2<f32>) -> LightSample {
    if light.kind.x == LIGHT_SPHERE || light.kind.x == LIGHT_SUN {
        return cap_drawn(light, p, u);
    }
    if !shines_at(light, p) {
        return LightSample(vec3<f32>(0.0, 0.0, 1.0), 0.0, 0.0);
    }
    if light.kind.x == LIGHT_DISK {
        let across = basis_across(light.b.xyz);
        let at = light.a.w * unit_disc(u);
        let area = PI * light.a.w * light.a.w;
        return point_drawn(light.a.xyz + at.x * across[0] + at.y * across[1] - p, light.b.xyz, area);
    }
    if light.kind.x == LIGHT_TUBE {
        return tube_drawn(light, p, u);
    }
    if (light.kind.y & LIGHT_RECTANGLE) > 0u {
        let drawn = rectangle_drawn(light, p, u);
        if drawn.weight > LEAST_SOLID_ANGLE {
            return drawn;
        }
    }
    return quad_drawn(light, p, u);
}

/// A point of a surface with this area that is drawn evenly.
fn point_drawn(to_point: vec3<f32>, normal: vec3<f32>, area: f32) -> LightSample {
    let distance2 = max(dot(to_point, to_point), 1e-20);
    let distance = sqrt(distance2);
    let w = to_point / distance;
    return LightSample(w, distance, area * abs(dot(normal, w)) / distance2);
}

fn cap_drawn(light: Light, p: vec3<f32>, u: vec2<f32>) -> LightSample {
    let cone = light_bound(light, p);
    if cone.w >= 1.0 {
        return LightSample(ball_direction(u), 0.0, 2.0 * TAU);
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

/// By area: from one of the two triangles, evenly.
fn quad_drawn(light: Light, p: vec3<f32>, u: vec2<f32>) -> LightSample {
    let first = length(cross(light.b.xyz - light.a.xyz, light.c.xyz - light.a.xyz));
    let second = length(cross(light.c.xyz - light.a.xyz, light.d.xyz - light.a.xyz));
    let share = first / max(first + second, 1e-30);
    let is_first = u.x < share;
    let x = select((u.x - share) / max(1.0 - share, 1e-9), u.x / max(share, 1e-9), is_first);
    let root = sqrt(clamp(x, 0.0, 1.0));
    let b = select(light.c.xyz, light.b.xyz, is_first);
    let c = select(light.d.xyz, light.c.xyz, is_first);
    let point = light.a.xyz + root * (1.0 - u.y) * (b - light.a.xyz) + root * u.y * (c - light.a.xyz);
    return point_drawn(point - p, normalize(quad_normal(light)), 0.5 * (first + second));
}

/// By area, from the part of a tube that is seen from p.
fn tube_drawn(light: Light, p: vec3<f32>, u: vec2<f32>) -> LightSample {
    let half_length = length(light.b.xyz);
    let axis = light.b.xyz / max(half_length, 1e-20);
    let to_p = p - light.a.xyz;
    let across = to_p - dot(to_p, axis) * axis;
    let d = length(across);
    if d <= light.a.w {
        // From within, light is all around; past the ends, which are dark, there is none.
        let is_inside = abs(dot(to_p, axis)) <= half_length;
        return LightSample(ball_direction(u), 0.0, select(0.0, 2.0 * TAU, is_inside));
    }
    // Seen is what faces p: cos φ > r/d.
    let widest = acos(light.a.w / d);
    let angle = (2.0 * u.x - 1.0) * widest;
    let towards = across / d;
    let normal = cos(angle) * towards + sin(angle) * cross(axis, towards);
    let point = light.a.xyz + light.a.w * normal + (2.0 * u.y - 1.0) * light.b.xyz;
    return point_drawn(point - p, normal, 4.0 * widest * light.a.w * half_length);
}

/// Evenly from a rectangle's solid angle. The names are the paper's.
fn rectangle_drawn(light: Light, p: vec3<f32>, u: vec2<f32>) -> LightSample {
    let ex = light.b.xyz - light.a.xyz;
    let ey = light.d.xyz - light.a.xyz;
    let x = normalize(ex);
    let y = normalize(ey);
    let low = light.a.xyz - p;
    let z0 = dot(low, cross(x, y));
    // The third axis points away from the rectangle.
    let z = cross(x, y) * select(1.0, -1.0, z0 > 0.0);
    let depth = max(abs(z0), 1e-12);
    let x0 = dot(low, x);
    let x1 = x0 + length(ex);
    let y0 = dot(low, y);
    let y1 = y0 + length(ey);
    // The normals of the planes through p and the edges, as far as they are along z.
    let n0 = -y0 / sqrt(depth * depth + y0 * y0);
    let n1 = x1 / sqrt(depth * depth + x1 * x1);
    let n2 = y1 / sqrt(depth * depth + y1 * y1);
    let n3 = -x0 / sqrt(depth * depth + x0 * x0);
    let g2 = acos(clamp(-n2 * n3, -1.0, 1.0));
    let g3 = acos(clamp(-n3 * n0, -1.0, 1.0));
    let k = TAU - g2 - g3;
    let S = acos(clamp(-n0 * n1, -1.0, 1.0)) + acos(clamp(-n1 * n2, -1.0, 1.0)) - k;

    let au = u.x * S + k;
    let fu = (cos(au) * n0 - n2) / sin(au);
    let cu = clamp(select(-1.0, 1.0, fu > 0.0) / sqrt(fu * fu + n0 * n0), -1.0, 1.0);
    let xu = clamp(cu * depth / sqrt(max(1.0 - cu * cu, 1e-12)), x0, x1);
    let d = sqrt(xu * xu + depth * depth);
    let h0 = y0 / sqrt(d * d + y0 * y0);
    let h1 = y1 / sqrt(d * d + y1 * y1);
    let hv = h0 + u.y * (h1 - h0);
    let yv = select(y1, hv * d / sqrt(max(1.0 - hv * hv, 1e-12)), hv * hv < 1.0 - 1e-6);
    let to_point = xu * x + clamp(yv, y0, y1) * y - depth * z;
    let distance = length(to_point);
    return LightSample(to_point / distance, distance, max(S, 0.0));
}
