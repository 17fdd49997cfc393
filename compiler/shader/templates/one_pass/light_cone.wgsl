// The cones that tell how much of a light a point sees.
//
// Theory: As in `shadows/verified/`: one cone for the whole light proves most points lit or dark; where it is touched, the
// light is cut into cells with a cone each.
// Changes: One point after the other, without lists.

/// The cells of a light that is partly covered; 1 for none.
const CELLS: i32 = 8;

/// A cell of the unit disc: centre, share of the area, radius of a disc with that area. Some are in the middle, the others around
/// them: the rays of a pixel cut the disc in ways of their own, whose errors differ. `k` counts the cells of one ray after those
/// of the other.
fn disc_cell(k: u32) -> vec4<f32> {
    let ray = i32(k) / CELLS;
    let cell = i32(k) % CELLS;
    let share = 1.0 / f32(CELLS);
    let within = select(1, 3, ray % 2 == 1 && CELLS > 3);
    if cell == 0 && within == 1 {
        return vec4<f32>(0.0, 0.0, share, sqrt(share));
    }
    let is_within = cell < within;
    let edge = sqrt(f32(within) * share);
    let of_ring = select(CELLS - within, within, is_within);
    let inner = select(edge, 0.0, is_within);
    let outer = select(1.0, edge, is_within);
    let half_angle = PI / f32(of_ring);
    let centroid = 2.0 / 3.0 * (outer + inner * inner / (outer + inner)) * sin(half_angle) / half_angle;
    let angle = 2.0 * half_angle * (f32(cell) + f32(ray) / f32(RAYS));
    return vec4<f32>(centroid * cos(angle), centroid * sin(angle), share, sqrt(share));
}

/// A cone that is about all of a light which is above the horizon; its sine is 0 if there is nothing to ask.
fn light_cone(light: Light, o: vec3<f32>, n: vec3<f32>, offset: f32) -> Query {
    let disc = disc_of(light, o, n);
    let across = basis_across(disc.w);
    let uphill = vec2<f32>(dot(n, across[0]), dot(n, across[1]));
    let h = min(disc.horizon, 0.0);
    let aim = select(0.0, 0.5 * (1.0 - h), h < 0.0) * uphill / max(length(uphill), 1e-9);
    let width = select(1.0, min(1.0, sqrt(max(1.0 - h * h + 0.25 * (1.0 + h) * (1.0 + h), 0.0))), h < 0.0);
    let w = normalize(disc.w + disc.tangent * (across[0] * aim.x + across[1] * aim.y));
    let asks = disc.horizon > -1.0 && !is_within(light, o);
    return query_cone(o, w, select(0.0, disc.sine * width, asks), disc.t_max, n, offset, true);
}

/// V₀, the part of a light that the horizon leaves.
fn light_bare(light: Light, o: vec3<f32>, n: vec3<f32>) -> f32 {
    if !is_round(light) || is_within(light, o) {
        return 1.0;
    }
    return segment_area(disc_of(light, o, n).horizon);
}

/// A cell of a light, seen from o, for one of a pixel's rays.
fn light_piece(light: Light, o: vec3<f32>, n: vec3<f32>, k: i32, ray: i32) -> Piece {
    let of_disc = u32(k + CELLS * ray);
    if !is_round(light) {
        return piece_of_patch(light, o, n, select(u32(k), of_disc, light.kind.x == LIGHT_DISK), u32(CELLS));
    }
    let disc = disc_of(light, o, n);
    let across = basis_across(disc.w);
    let uphill = vec2<f32>(dot(n, across[0]), dot(n, across[1]));
    return piece_of_disc(disc, across, uphill / max(length(uphill), 1e-9), disc_cell(of_disc));
}

/// The cone about a cell of a light whose own cone is free up to `contact`.
fn piece_cone(piece: Piece, o: vec3<f32>, n: vec3<f32>, offset: f32, contact: f32) -> Query {
    var query = query_cone(o, piece.w, piece.sine, piece.t_max, n, offset, true);
    // Near the point cells begin at its tangent plane, far from it where the whole light was still free.
    query.start = select(0.0, 0.98 * contact, contact > 25.0 * offset);
    query.looks = false;
    return query;
}

/// The light that a ray from the eye meets first: how far along the ray, `FAR` for none; then its radiance.
fn nearest_shining(ray: Ray) -> vec4<f32> {
    var shining = vec4<f32>(0.0, 0.0, 0.0, FAR);
    for (var i = 0; i < setting_light_count(); i++) {
        let light = setting_light(i);
        if (light.kind.y & LIGHT_VISIBLE) > 0u {
            let t = light_crossing(light, ray.o, ray.w);
            if t < shining.w {
                shining = vec4<f32>(light.radiance.rgb, t);
            }
        }
    }
    return shining;
}
