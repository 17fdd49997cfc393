// Verified cones: the visible part of a light from cones that are proven free, and from cells where they are not.
//
// Theory: For an exact distance f to any closed set, f² − t² is concave along a ray, because the squared distance to
// each point of the set is t² plus something linear. So two samples bound f from below between them,
// f²(t) ≥ (t − t₁)(t − t₂) + lerp(f₁², f₂²), and with it the slimmest cone from the ray's origin that touches the set:
// the minimum of f/t. A march may therefore step far past the sphere around it, and prove afterwards that the cone of
// the light is free. Where it can't be proven, the interval is refined; where the cone is touched, the light is cut
// into cells, each with a cone of its own, and a cell that is still touched counts by the segment of its disc that a
// straight silhouette at the sine min f/t leaves.
// Changes: Where the minimal tangent cone of Bán, Bálint and Valasek (2019) is one estimate for a whole light, most
// receivers here are proven to see all of it or none, and only those in penumbrae pay for cells.
// Practice: One call of the scene, in the loop of a state machine: gate (the whole light, until it is touched), axis
// (to see whether it is wholly covered), cells. The stack of refinements has three entries, in named registers. All
// lengths are relative to the receiver's offset, so that nothing depends on the scene's size.

/// How far ahead a planar silhouette lets one step, of what it would allow: while looking for contact, and behind it.
const LOOKING: f32 = 0.9;
const FOLLOWING: f32 = 0.4;
/// The ε of the minimal cone: a cone that is slimmer by less is not looked for.
const TOLERANCE: f32 = 0.1;
/// Evaluations of the gate and the axis together, and of each cell.
const MOST_EVALUATIONS: u32 = 256u;
const MOST_CELL_EVALUATIONS: u32 = 64u;
/// The most cells that a light is cut into.
const MOST_CELLS: u32 = 64u;
/// No bound: the minimum is at an end of the interval.
const UNBOUNDED: f32 = 1e9;

/// What a march is about.
const GATE: u32 = 0u;
const AXIS: u32 = 1u;
const CELL: u32 = 2u;

/// The lower bound of f/t between two samples.
struct IntervalBound {
    /// The bound; `UNBOUNDED` where the ends are the minimum.
    ratio: f32,
    /// Where it is reached.
    t: f32,
}

fn interval_bound(t1: f32, f1: f32, t2: f32, f2: f32) -> IntervalBound {
    let step = t2 - t1;
    let ahead = 0.5 * (step + (f1 - f2) * (f1 + f2) / step);
    let tc = t1 + ahead;
    let h2 = (f1 - ahead) * (f1 + ahead);
    if tc <= 0.0 {
        return IntervalBound(UNBOUNDED, 0.0);
    }
    let ts = tc + h2 / tc;
    if ts <= t1 || ts >= t2 {
        return IntervalBound(UNBOUNDED, ts);
    }
    if h2 <= 0.0 {
        return IntervalBound(0.0, clamp(tc, t1, t2));
    }
    return IntervalBound(sqrt(h2 / (tc * tc + h2)), ts);
}

/// A march along a cone with its apex at the origin of shadow rays.
struct March {
    w: vec3<f32>,
    /// The sine of its half angle: the sphere at t that the cone is about has the radius ρ = t sine.
    sine: f32,
    t_max: f32,
    /// n·w, the slope of the receiver's own tangent plane; and whether the cone cuts that.
    own_slope: f32,
    own: bool,
    /// The last accepted sample, and the slope before it.
    t: f32,
    f: f32,
    slope: f32,
    /// The least f/t so far.
    least: f32,
    /// Whether the step before overshot into a solid.
    careful: bool,
}

fn march_along(w: vec3<f32>, sine: f32, t_max: f32, n: vec3<f32>) -> March {
    let own_slope = dot(n, w);
    return March(w, sine, t_max, own_slope, own_slope < 1.02 * sine, 0.0, 0.0, own_slope, UNBOUNDED, false);
}

/// How far to step, by the sample at hand.
fn step_of(m: March, planar: f32, least_step: f32, unit: f32) -> f32 {
    let rho = m.sine * m.t;
    if m.f <= 0.0 {
        let mu = max(-1.0, m.least / m.sine - TOLERANCE);
        return max(0.35 * rho, (m.f - mu * rho) / (1.0 + mu * m.sine));
    }
    var step = m.f;
    let clear2 = (m.f - rho) * (m.f + rho);
    if clear2 > 0.0 && !m.own && !m.careful {
        // On a plane that keeps its slope the next sphere of the same height touches this one so far ahead.
        let c = clamp(m.slope, -0.9, 0.95);
        step = max(step, planar * 2.0 * (sqrt(clear2) + m.f * c) / (1.0 - c * c));
    }
    return max(step, max(least_step * rho, unit));
}


fn visibility(receiver: Receiver, light: Light, index: u32) -> Visibility {
    let o = shadow_origin(receiver);
    let n = receiver.n.xyz;
    let offset = receiver.p.w;
    let unit = 0.05 * offset;
    if light_bound(light, o).w >= 1.0 {
        return Visibility(1.0, 1.0, 0u);
    }
    let disc = disc_of(light, o, n);
    let is_patch = !is_round(light);
    let bare = select(segment_area(disc.horizon), 1.0, is_patch);
    if disc.horizon <= -1.0 {
        return Visibility(0.0, 0.0, 0u);
    }
    let across = basis_across(disc.w);
    let uphill = vec2<f32>(dot(n, across[0]), dot(n, across[1]));
    let up = uphill / max(length(uphill), 1e-9);
    let cells = clamp(task.cells, 1u, MOST_CELLS);
    let least_step = select(0.6, 0.1, cells == 1u);

    // Aim at the middle of what is above the horizon.
    var aim = vec2<f32>(0.0);
    var width = 1.0;
    if disc.horizon < 0.0 {
        let h = disc.horizon;
        aim = 0.5 * (1.0 - h) * up;
        width = min(1.0, sqrt(1.0 - h * h + 0.25 * (1.0 + h) * (1.0 + h)));
    }
    let whole = normalize(disc.w + disc.tangent * (across[0] * aim.x + across[1] * aim.y));
    var m = march_along(whole, disc.sine * width, disc.t_max, n);
    m.f = offset;

    var stage = GATE;
    var cell = 0u;
    var piece = Piece(whole, 1.0, 0.0, 0.0, 1.0);
    // The seen part of the pieces' weights, and their sum.
    var seen = 0.0;
    var total = 0.0;
    var evaluations = 0u;
    var cell_evaluations = 0u;
    var contact = m.t;
    // Samples ahead that are not yet accepted, the nearest last.
    var waiting = 0u;
    var s0 = vec2<f32>(0.0);
    var s1 = vec2<f32>(0.0);
    var s2 = vec2<f32>(0.0);
    // Where to ask next: at the start of a cell, between samples, or (if 0) a step ahead.
    var ask = 0.0;
    var starting = false;
    // Between marches: whether the last one is over.
    var over = false;

    while evaluations < MOST_EVALUATIONS + cells * MOST_CELL_EVALUATIONS {
        if over {
            // The march is over: what does it say, and what comes next?
            over = false;
            let part = smooth_area(m.least / m.sine);
            if stage == GATE {
                return Visibility(bare, bare, evaluations);
            }
            if stage == AXIS {
                if m.least <= -0.999 * m.sine {
                    return Visibility(0.0, bare, evaluations);
                }
                if cells == 1u {
                    return Visibility(min(bare, part), bare, evaluations);
                }
                stage = CELL;
            } else {
                seen += piece.weight * min(part, segment_area(piece.horizon));
            }
            // The next piece that is above the horizon.
            piece.weight = 0.0;
            loop {
                if cell >= cells || piece.weight > 0.0 {
                    break;
                }
                if is_patch {
                    piece = piece_of_patch(light, o, n, cell, cells);
                } else {
                    piece = piece_of_disc(disc, across, up, task.cells_of_disc[cell]);
                }
                total += piece.weight;
                cell += 1u;
            }
            if piece.weight <= 0.0 {
                return Visibility(visible_part(seen, total, bare, is_patch), bare, evaluations);
            }
            m = march_along(piece.w, piece.sine, piece.t_max, n);
            m.f = offset;
            waiting = 0u;
            cell_evaluations = 0u;
            ask = 0.0;
            // Far from the receiver all cells are free up to where the whole light is touched.
            starting = contact > 25.0 * offset;
            if starting {
                ask = 0.98 * contact;
            }
        }

        if ask <= 0.0 {
            ask = min(m.t + step_of(m, select(FOLLOWING, LOOKING, stage == GATE), least_step, unit), m.t_max);
        }
        let f_asked = scene_distance(o + ask * m.w) / view.eye.w;
        evaluations += 1u;
        cell_evaluations += 1u;
        if starting {
            starting = false;
            m.t = ask;
            m.f = f_asked;
            m.slope = 0.0;
            ask = 0.0;
            if f_asked <= 0.0 {
                m.least = 0.0;
                over = true;
            }
            continue;
        }
        s2 = s1;
        s1 = s0;
        s0 = vec2<f32>(ask, f_asked);
        waiting += 1u;
        ask = 0.0;

        // Accept what waits, until something has to be asked.
        loop {
            if waiting == 0u || over {
                break;
            }
            let t2 = s0.x;
            let f2 = s0.y;
            let step = t2 - m.t;
            if step <= 0.0 {
                over = true;
                break;
            }
            var bound = IntervalBound(UNBOUNDED, 0.0);
            let ratio1 = m.f / max(m.t, unit);
            let ratio2 = f2 / t2;
            if m.f > 0.0 && f2 > 0.0 {
                bound = interval_bound(m.t, m.f, t2, f2);
                let worth = min(m.sine, min(m.least, min(ratio1, ratio2)) - TOLERANCE * m.sine);
                let fine = select(0.02, 0.15, bound.ratio > 0.0) * m.sine * t2 + unit;
                let own_plane = m.own && m.f >= 0.98 * (offset + m.t * m.own_slope)
                    && f2 >= 0.98 * (offset + t2 * m.own_slope);
                if bound.ratio < worth && step > fine && waiting < 3u && !own_plane {
                    ask = clamp(bound.t, m.t + 0.12 * step, t2 - 0.12 * step);
                    break;
                }
            } else if m.f > 0.0 && step > max(m.f, least_step * m.sine * m.t) * 1.01 + unit {
                // It overshot into a solid: approach it again by plain steps.
                waiting = 0u;
                m.careful = true;
                break;
            }
            s0 = s1;
            s1 = s2;
            waiting -= 1u;
            if f2 <= 0.0 {
                waiting = 0u;
            }
            m.careful = m.careful && !(m.f <= 0.0 && f2 > 0.0);
            m.least = min(m.least, ratio2);
            if bound.ratio < UNBOUNDED && !m.own {
                m.least = min(m.least, 0.5 * (bound.ratio + min(ratio1, ratio2)));
            }
            if stage == GATE && m.least < m.sine && (!m.own || f2 < 0.98 * (offset + t2 * m.own_slope)) {
                // Touched: look on from here, along the axis, more carefully.
                stage = AXIS;
                contact = m.t;
                m.least = UNBOUNDED;
                m.careful = false;
                waiting = 0u;
                break;
            }
            m.slope = (f2 - m.f) / step;
            m.t = t2;
            m.f = f2;
            if f2 <= -m.sine * t2 || t2 >= m.t_max * 0.999999 || (stage == CELL && cell_evaluations >= MOST_CELL_EVALUATIONS) {
                over = true;
            }
        }
    }
    return Visibility(visible_part(seen, total, bare, is_patch), bare, evaluations);
}

/// V from the seen part of the pieces' weights. Those of a disc are its areas, those of a patch irradiances.
fn visible_part(seen: f32, total: f32, bare: f32, is_patch: bool) -> f32 {
    return min(select(seen, seen / max(total, TINY), is_patch), bare);
}
