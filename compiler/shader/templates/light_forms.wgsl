// Irradiances of lights in closed form, per radiance: E₀ = ∫ max(cos θ, 0) dω over the whole light, nothing in between.
//
// Theory: A sphere and a sun cover a cap of directions; for one that the horizon cuts, Lagarde and de Rousiers ("Moving
// Frostbite to Physically Based Rendering", 2014, listing 10) give the integral. A polygon is a sum over its edges,
// E₀ = ½ Σ ∠(vᵢ, vᵢ₊₁) n·(vᵢ × vᵢ₊₁)/|vᵢ × vᵢ₊₁| (Lambert 1760). Since the radiance is constant, of other lights only the
// silhouette counts: a disk is taken as a polygon of 24 corners with the same area, a tube as the quadrilateral
// between the lines where planes through p touch it.
// Changes: The horizon cuts a convex polygon's outline in two points; edges are cut one by one, and the edge that
// closes the gap lies on the horizon. So no list of corners is needed.

/// The corners of the polygon that stands for a disk.
const DISK_CORNERS: u32 = 24u;

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

/// How many corners the polygon has that stands for a light.
fn corner_count(light: Light) -> u32 {
    return select(4u, DISK_CORNERS, light.kind.x == LIGHT_DISK);
}

/// The i-th corner of the polygon that stands for a light, from p.
fn light_corner(light: Light, p: vec3<f32>, i: u32) -> vec3<f32> {
    switch light.kind.x {
        case LIGHT_DISK: {
            let across = basis_across(light.b.xyz);
            let angle = TAU * f32(i) / f32(DISK_CORNERS);
            // As large as the disk.
            let r = light.a.w * sqrt(TAU / f32(DISK_CORNERS) / sin(TAU / f32(DISK_CORNERS)));
            return light.a.xyz - p + r * (cos(angle) * across[0] + sin(angle) * across[1]);
        }
        case LIGHT_TUBE: {
            // Across the axis the tube is a circle; the touching lines are nearer than its middle by r²/d, and to the
            // sides by r √(1 − r²/d²).
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
        default: {
            return select(select(light.a.xyz, light.b.xyz, i == 1u), select(light.c.xyz, light.d.xyz, i == 3u), i >= 2u) - p;
        }
    }
}

fn polygon_irradiance(light: Light, p: vec3<f32>, n: vec3<f32>) -> f32 {
    let count = corner_count(light);
    var sum = 0.0;
    var leaves = vec3<f32>(0.0);
    var enters = vec3<f32>(0.0);
    var corner = light_corner(light, p, count - 1u);
    var height = dot(corner, n);
    for (var i = 0u; i < count; i++) {
        let next = light_corner(light, p, i);
        let next_height = dot(next, n);
        let crossing = mix(corner, next, clamp(height / select(height - next_height, 1.0, height == next_height), 0.0, 1.0));
        if height > 0.0 || next_height > 0.0 {
            let starts = select(crossing, corner, height > 0.0);
            let ends = select(crossing, next, next_height > 0.0);
            sum += edge_integral(starts, ends, n);
            if height > 0.0 && next_height <= 0.0 {
                leaves = crossing;
            }
            if height <= 0.0 && next_height > 0.0 {
                enters = crossing;
            }
        }
        corner = next;
        height = next_height;
    }
    return 0.5 * abs(sum + edge_integral(leaves, enters, n));
}

/// The angle between two corners, times the normal's component across the plane that they span.
fn edge_integral(a: vec3<f32>, b: vec3<f32>, n: vec3<f32>) -> f32 {
    let across = cross(a, b);
    let size = length(across);
    return atan2(size, dot(a, b)) * dot(across, n) / max(size, 1e-30);
}
