// Marches rays to the surfaces they meet.
//
// Theory: Sphere tracing (Hart 1996) with automatically relaxed steps: the slope of the distances met so far predicts how
// far the next sphere may lie for both to touch (Bálint, Valasek, Gera: "Operations on Signed Distance Function
// Estimates", 2023; step r ω with ω = 2/(1 − m)); where two spheres come apart, the ray goes back.
// Changes: A surface is met where the distance changes its sign, and not where it is small: faces of solids that lie in
// each other may leave zeros that no surface is at. So steps go on by a part of a pixel where they get short, and the
// crossing is where the line through the last two values is 0.
// Segments to surfaces, segments to lights and the probes of normals all ask the scene in one place of one loop,
// because drivers take time in proportion to the calls of the scene.
// Practice: some twenty evaluations for a ray from the eye, and four for the normal.

/// The β of the running mean of slopes.
const RELAXATION: f32 = 0.3;
/// A ray that comes nearer more slowly than this steps as if it came as fast.
const LEAST_FALL: f32 = 0.0625;
/// Of one segment; few grazing rays come near it. lavapipe ends all loops of an invocation together after 65535 rounds,
/// those within the scene's distance included.
const MAX_STEPS: u32 = 1500u;
/// The edge of the prepass's finest tiles.
const START_EDGE: u32 = 4u;
/// Steps go this part of a pixel beyond what is known to be free.
const HIT: f32 = 0.01;

/// A segment of a path.
struct Segment {
    ray: Ray,
    /// Up to here nothing is met.
    start: f32,
    /// Nor from here on.
    end: f32,
    /// How far steps go beyond what is free, and how much that grows along the ray. What is thinner may be missed.
    hit: vec2<f32>,
    /// 1 outside solids; −1 within a translucent one, where distances count from within.
    side: f32,
    /// Whether it goes to a light, and only has to know if anything is in between.
    to_light: bool,
}

/// What a segment meets.
struct Met {
    /// How far along the ray; nothing if negative.
    t: f32,
    /// The slope of the distance there: the normal, but for its length.
    n: vec3<f32>,
    /// How far around n was asked.
    h: f32,
    evaluations: u32,
}

/// The k-th corner of a tetrahedron about the origin.
fn corner(k: u32) -> vec3<f32> {
    return vec3<f32>(f32(((k + 3u) >> 1u) & 1u), f32((k >> 1u) & 1u), f32(k & 1u)) * 2.0 - 1.0;
}

/// Marches along a segment to the surface it meets, and probes that surface's normal.
fn meet(segment: Segment) -> Met {
    let o = segment.ray.o;
    let w = segment.ray.w;
    let crossing = box_crossing(segment.ray);
    let end = min(crossing.y, segment.end);
    // The ray is free up to t, where the free radius is r, and steps to `safe` beyond leap over nothing; the scene is asked
    // next z ahead; m is the mean slope of r.
    var t = max(crossing.x, segment.start);
    // Where a ray enters the box it may meet a surface at once; where it leaves a surface it must not.
    var r = select(0.0, FAR, t > 0.0);
    var safe = 0.0;
    var z = 0.0;
    var m = -1.0;
    var met = Met(-1.0, vec3<f32>(0.0), 0.0, 0u);
    // Corners of the tetrahedron about the hit that are still to be asked.
    var probes = 0u;

    while (probes > 0u) | ((t < end) & (met.evaluations < MAX_STEPS)) {
        // Ask the scene: ahead on the ray, or at a corner about the hit.
        let ahead = min(t + z, end);
        let at_corner = o + met.t * w + met.h * corner(probes - 1u);
        let d = scene_distance(select(o + ahead * w, at_corner, probes > 0u));
        met.evaluations += 1u;

        // The differences to the corners sum up to the slope, and so to the normal.
        if probes > 0u {
            met.n += d * corner(probes - 1u);
            probes -= 1u;
            if probes == 0u {
                break;
            }
            continue;
        }

        // Where the spheres come apart, or a relaxed step went into a solid, go back and step to the former one's end.
        let free = segment.side * d / view.eye.w;
        let step = ahead - t;
        if step > r + free && z > safe {
            m = -1.0;
            z = safe;
            continue;
        }

        // A hit: inside, and getting deeper (or a ray would hit what it leaves).
        let near = segment.hit.x + segment.hit.y * ahead;
        if free < 0.0 && free < r {
            met.t = select(ahead, t + step * r / (r - free), r > 0.0 && r < FAR);
            met.h = max(2.0 * near, 16.0 * view.box_min.w);
            probes = 4u;
        }
        m = select(-1.0, mix(m, (free - r) / step, RELAXATION), step > 0.0 && r < FAR);
        t = ahead;
        r = free;

        // The next sphere touches this one if the slope stays what it was. Near a surface the ray goes on to where the slope
        // says that it is beyond.
        safe = max(r, 0.0) + near;
        safe /= select(1.0, clamp(-m, LEAST_FALL, 1.0), r < near);
        z = max(r * max(1.0, 2.0 / (1.0 - min(m, 0.6))), safe);
    }
    return met;
}
