// Verified cones: marches that prove the cone of a light, or of a part of it, to be free.
//
// Theory: For an exact distance f to any closed set, f² − t² is concave along a ray, because the squared distance to
// each point of the set is t² plus something linear. So two samples bound f from below between them,
// f²(t) ≥ (t − t₁)(t − t₂) + lerp(f₁², f₂²), and with it the slimmest cone from the ray's origin that touches the set:
// the minimum of f/t. A march may therefore step far past the sphere around it, and prove afterwards that the cone of
// the light is free; where it can't be proven, the interval is refined.
// Changes: Aaltonen (GDC 2018) takes the bound's minimum, for steps of one sphere's radius, as the estimate of the miss.
// Practice: The stack of refinements has three entries, in named registers. All lengths are relative to the receiver's
// offset, so that nothing depends on the scene's size. A march doesn't ask the scene itself: a kernel does, at one
// place, for whatever march it is about.

/// The ε of the minimal cone: a cone that is slimmer by less is not looked for.
const TOLERANCE: f32 = 0.1;
/// The most evaluations of a march for a part of a light. Slim cones along an edge take many small steps; one that is
/// given up counts what it has not yet reached as free.
const MOST_CELL_EVALUATIONS: u32 = 192u;
/// No bound: the minimum is at an end of the interval.
const UNBOUNDED: f32 = 1e9;

/// A march along a cone with its apex at the origin of shadow rays.
struct March {
    w: vec3<f32>,
    /// The sine of its half angle: the sphere at t that the cone is about has the radius ρ = t sine.
    sine: f32,
    t_max: f32,
    /// The receiver's offset: f at the origin.
    offset: f32,
    /// How far ahead a planar silhouette lets a step go, of what it would allow.
    planar: f32,
    /// The shortest step, of ρ.
    least_step: f32,
    /// Whether it looks for contact only, and goes on from before it.
    looking: bool,
    /// Whether what two samples leave open between them is asked, or else guessed.
    proves: bool,
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
    /// Whether the cone is touched by something else than the receiver's tangent plane.
    touched: bool,
    over: bool,
    /// Where to ask next: between samples, or (if 0) a step ahead.
    ask: f32,
    /// Samples ahead that are not yet accepted, the nearest first: t and f.
    waiting: u32,
    first: vec2<f32>,
    second: vec2<f32>,
    third: vec2<f32>,
}

fn march_along(w: vec3<f32>, sine: f32, t_max: f32, n: vec3<f32>, offset: f32, planar: f32, least_step: f32, looking: bool) -> March {
    let own_slope = dot(n, w);
    let none = vec2<f32>(0.0);
    return March(
        w, sine, t_max, offset, planar, least_step, looking, true, own_slope, own_slope < 1.02 * sine, 0.0, offset, own_slope,
        UNBOUNDED, false, false, t_max <= 0.0, 0.0, 0u, none, none, none,
    );
}

/// Where the march wants to know the distance.
fn march_asks(m: March) -> f32 {
    if m.ask > 0.0 {
        return m.ask;
    }
    let rho = m.sine * m.t;
    if m.f <= 0.0 {
        let mu = max(-1.0, m.least / m.sine - TOLERANCE);
        return min(m.t + max(0.35 * rho, (m.f - mu * rho) / (1.0 + mu * m.sine)), m.t_max);
    }
    var step = m.f;
    let clear2 = (m.f - rho) * (m.f + rho);
    if clear2 > 0.0 && !m.own && !m.careful {
        // On a plane that keeps its slope the next sphere of the same height touches this one so far ahead.
        let c = clamp(m.slope, -0.9, 0.95);
        step = max(step, m.planar * 2.0 * (sqrt(clear2) + m.f * c) / (1.0 - c * c));
    }
    return min(m.t + max(step, max(m.least_step * rho, 0.05 * m.offset)), m.t_max);
}

/// Whether a sample is on the receiver's own tangent plane.
fn is_own_plane(m: March, t: f32, f: f32) -> bool {
    return f >= 0.98 * (m.offset + t * m.own_slope);
}

/// Takes the distance f that was asked for at t.
fn march_takes(march: March, t: f32, f: f32) -> March {
    var m = march;
    let unit = 0.05 * m.offset;
    m.ask = 0.0;
    m.third = m.second;
    m.second = m.first;
    m.first = vec2<f32>(t, f);
    m.waiting += 1u;
    // Accept what waits, until something has to be asked.
    while m.waiting > 0u {
        let t2 = m.first.x;
        let f2 = m.first.y;
        let step = t2 - m.t;
        if step <= 0.0 {
            m.over = true;
            break;
        }
        let bound = interval_bound(m.t, m.f, t2, f2);
        let ratio1 = m.f / max(m.t, unit);
        let ratio2 = f2 / t2;
        if bound.x < UNBOUNDED {
            let worth = min(m.sine, min(m.least, min(ratio1, ratio2)) - TOLERANCE * m.sine);
            let fine = select(0.02, 0.15, bound.x > 0.0) * m.sine * t2 + unit;
            let own_plane = m.own && is_own_plane(m, m.t, m.f) && is_own_plane(m, t2, f2);
            if m.proves && bound.x < worth && step > fine && m.waiting < 3u && !own_plane {
                m.ask = clamp(bound.y, m.t + 0.12 * step, t2 - 0.12 * step);
                break;
            }
        }
        if m.f > 0.0 && f2 <= 0.0 && step > max(m.f, m.least_step * m.sine * m.t) * 1.01 + unit {
            // It overshot into a solid: approach it again by plain steps.
            m.waiting = 0u;
            m.careful = true;
            break;
        }
        m.first = m.second;
        m.second = m.third;
        m.waiting = select(m.waiting - 1u, 0u, f2 <= 0.0);
        m.careful = m.careful && !(m.f <= 0.0 && f2 > 0.0);
        m.least = min(m.least, ratio2);
        if bound.x < UNBOUNDED && !m.own {
            m.least = min(m.least, 0.5 * (bound.x + min(ratio1, ratio2)));
        }
        if m.least < m.sine && (!m.own || !is_own_plane(m, t2, f2)) {
            m.touched = true;
            if m.looking {
                m.waiting = 0u;
                break;
            }
        }
        // Nothing rises faster than along the ray itself: a receiver that isn't of the scene, as the studio's floor, has nothing of
        // it at the origin, and its first slope tells nothing.
        let slope = (f2 - m.f) / step;
        m.slope = select(slope, -1.0, slope > 1.001);
        m.t = t2;
        m.f = f2;
        if f2 <= -m.sine * t2 || t2 >= m.t_max * 0.999999 {
            m.over = true;
            break;
        }
    }
    return m;
}

/// The lower bound of f/t between two samples, `UNBOUNDED` where the ends are the minimum; and where it is reached.
fn interval_bound(t1: f32, f1: f32, t2: f32, f2: f32) -> vec2<f32> {
    let step = t2 - t1;
    let ahead = 0.5 * (step + (f1 - f2) * (f1 + f2) / step);
    let tc = t1 + ahead;
    let h2 = (f1 - ahead) * (f1 + ahead);
    let ts = tc + h2 / max(tc, 1e-30);
    if f1 <= 0.0 || f2 <= 0.0 || tc <= 0.0 || ts <= t1 || ts >= t2 {
        return vec2<f32>(UNBOUNDED, 0.0);
    }
    let between = vec2<f32>(sqrt(max(h2, 0.0) / (tc * tc + max(h2, 1e-30))), ts);
    return select(between, vec2<f32>(0.0, clamp(tc, t1, t2)), h2 <= 0.0);
}
