// Pieces of a light, each seen as a disc.
//
// Practice: a sphere is cut as the unit disc that it is seen as is; a rectangle, a tube's silhouette and any quadrilateral
// into rows and columns that are about as wide as high; a disk as a disc in its own plane.

struct Piece {
    /// The unit direction of its middle, or of the middle of what is above the horizon.
    w: vec3<f32>,
    /// The sine of the half angle of a cone as large.
    sine: f32,
    t_max: f32,
    /// What it counts, if all of it is seen; 0 below the horizon.
    weight: f32,
    /// The signed distance of the horizon from its middle, in its radii, where the weight doesn't know of it.
    horizon: f32,
}

/// Whether a light is seen as a disc from everywhere.
fn is_round(light: Light) -> bool {
    return light.kind.x == LIGHT_SPHERE || light.kind.x == LIGHT_SUN;
}

/// A cell of the unit disc that a light is seen as; `up` points to where the horizon's normal lies.
fn piece_of_disc(disc: Disc, across: mat3x3<f32>, up: vec2<f32>, cell: vec4<f32>) -> Piece {
    let horizon = (dot(cell.xy, up) + disc.horizon) / cell.w;
    // Of a cell that the horizon cuts, aim at the middle of what is above.
    let shift = select(0.0, 0.5 * (1.0 - horizon) * cell.w, horizon < 0.0);
    let centre = cell.xy + shift * up;
    let w = normalize(disc.w + disc.tangent * (across[0] * centre.x + across[1] * centre.y));
    return Piece(w, disc.sine * cell.w, disc.t_max, select(0.0, cell.z, horizon > -1.0), horizon);
}

/// The k-th of `count` pieces of a flat light or a tube, seen from p; it weighs its irradiance.
fn piece_of_patch(light: Light, p: vec3<f32>, n: vec3<f32>, k: u32, count: u32) -> Piece {
    if light.kind.x == LIGHT_DISK {
        return piece_of_disk(light, p, n, disc_cell(k));
    }
    let a = light_corner(light, p, 0u);
    let b = light_corner(light, p, 1u);
    let c = light_corner(light, p, 2u);
    let d = light_corner(light, p, 3u);
    let aspect = max(length(b - a) + length(c - d), 1e-9) / max(length(d - a) + length(c - b), 1e-9);
    let columns = u32(clamp(round(sqrt(f32(count) * aspect)), 1.0, f32(count)));
    let rows = max(count / columns, 1u);
    if k >= columns * rows {
        return Piece(n, 1.0, 0.0, 0.0, 1.0);
    }
    let low = vec2<f32>(f32(k % columns), f32(k / columns)) / vec2<f32>(f32(columns), f32(rows));
    let to = low + 1.0 / vec2<f32>(f32(columns), f32(rows));
    var quad = light;
    quad.kind.x = LIGHT_QUAD;
    quad.a = vec4<f32>(p + bilinear(a, b, c, d, low), 0.0);
    quad.b = vec4<f32>(p + bilinear(a, b, c, d, vec2<f32>(to.x, low.y)), 0.0);
    quad.c = vec4<f32>(p + bilinear(a, b, c, d, to), 0.0);
    quad.d = vec4<f32>(p + bilinear(a, b, c, d, vec2<f32>(low.x, to.y)), 0.0);
    let middle = bilinear(a, b, c, d, 0.5 * (low + to));
    let radius = sqrt(0.5 * length(quad_normal(quad)) / PI);
    return piece_about(light, p, n, middle, radius, polygon_irradiance(quad, p, n));
}

fn piece_of_disk(light: Light, p: vec3<f32>, n: vec3<f32>, cell: vec4<f32>) -> Piece {
    let across = basis_across(light.b.xyz);
    let middle = light.a.xyz - p + light.a.w * (cell.x * across[0] + cell.y * across[1]);
    let d2 = max(dot(middle, middle), 1e-20);
    let weight = max(dot(n, middle), 0.0) * abs(dot(light.b.xyz, middle)) / (d2 * d2);
    return piece_about(light, p, n, middle, light.a.w * cell.w, weight);
}

/// A piece with this middle, seen from p, as large as a disk of this radius.
fn piece_about(light: Light, p: vec3<f32>, n: vec3<f32>, middle: vec3<f32>, radius: f32, weight: f32) -> Piece {
    let reach = length(middle);
    // If the middle is below the horizon, look as high as the piece reaches.
    let height = dot(middle, n);
    let lifted = middle + n * max(0.25 * radius - height, 0.0);
    let w = lifted / max(length(lifted), 1e-20);
    let t_max = min(0.999 * reach, scene_reach(p, w) + 2.0 * radius);
    return Piece(w, clamp(radius / max(reach, 1e-20), 1e-6, 0.99), t_max, weight, 1.0);
}

fn bilinear(a: vec3<f32>, b: vec3<f32>, c: vec3<f32>, d: vec3<f32>, at: vec2<f32>) -> vec3<f32> {
    return mix(mix(a, b, at.x), mix(d, c, at.x), at.y);
}
