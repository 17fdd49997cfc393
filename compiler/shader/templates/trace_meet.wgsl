// Marches rays to the surfaces they meet.
//
// Theory: Sphere tracing (Hart 1996) with automatically relaxed steps: the slope of the distances met so far predicts how
// far the next sphere may lie for both to touch (Bálint, Valasek, Gera: "Operations on Signed Distance Function
// Estimates", 2023; step r ω with ω = 2/(1 − m)); where two spheres come apart, the ray goes back.
// Changes: Segments to surfaces, segments to lights and the probes of normals all ask the scene in one place of one loop,
// because drivers take time in proportion to the calls of the scene.
// Practice: some twenty evaluations for a ray from the eye, and four for the normal.

/// The β of the running mean of slopes.
const RELAXATION: f32 = 0.3;
/// Of one segment; few grazing rays come near it. lavapipe ends all loops of an invocation together after 65535 rounds,
/// those within the scene's distance included.
const MAX_STEPS: u32 = 1500u;
/// The edge of the prepass's finest tiles.
const START_EDGE: u32 = 4u;
/// A hit is nearer to the surface than this part of a pixel.
const HIT: f32 = 0.01;

/// A segment of a path.
struct Segment {
    ray: Ray,
    /// Up to here nothing is met.
    start: f32,
    /// Nor from here on.
    end: f32,
    /// The distance that counts as a hit, and how much it grows along the ray.
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
    /// The distance there, and its slope: the normal, but for its length.
    d: f32,
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
    // The ray is free up to t, where the free radius is r; the scene is asked next z ahead; m is the mean slope of r.
    var t = max(crossing.x, segment.start);
    // Where a ray enters the box it may meet a surface at once; where it leaves a surface it must not.
    var r = select(0.0, FAR, t > 0.0);
    var z = 0.0;
    var m = -1.0;
    var met = Met(-1.0, 0.0, vec3<f32>(0.0), 0.0, 0u);
    // Corners of the tetrahedron about the hit that are still to be asked; d at the hit, and how it fell on the way
    // there; how small d has to be now to be worth asking.
    var probes = 0u;
    var found = 0.0;
    var fall = 0.0;
    var worth = FAR;

    while (probes > 0u) | ((t < end) & (met.evaluations < MAX_STEPS)) {
        // Ask the scene: ahead on the ray, or at a corner about the hit.
        let ahead = min(t + z, end);
        let at_corner = o + met.t * w + met.h * corner(probes - 1u);
        let d = scene_distance(select(o + ahead * w, at_corner, probes > 0u));
        met.evaluations += 1u;

        // The differences to the corners sum up to the slope, and so to the normal. Distances that fall slowly, as
        // those of warped and of scaled parts may, look nearer than they are: then it was no hit, and the ray goes on.
        if probes > 0u {
            met.n += d * corner(probes - 1u);
            probes -= 1u;
            if probes > 0u {
                continue;
            }
            let slope = max(length(met.n) / (4.0 * met.h), fall);
            if found <= (segment.hit.x + segment.hit.y * t) * slope {
                // How far it is to the surface itself.
                met.d = segment.side * found / max(slope, TINY);
                break;
            }
            met.t = -1.0;
            met.n = vec3<f32>(0.0);
            worth = 0.5 * found;
            continue;
        }

        // Where the spheres come apart, or a relaxed step went into a solid, go back and step to the former one's end.
        let free = segment.side * d / view.eye.w;
        let step = ahead - t;
        let near = segment.hit.x + segment.hit.y * ahead;
        if step > r + free && z > max(r, near) {
            m = -1.0;
            z = max(r, near);
            continue;
        }

        // A hit: nearer than the pixel is wide, and getting nearer (or a ray would hit what it leaves). Here d counts
        // and not d/L, which is small far from surfaces too if some part of the scene has a large L.
        worth = select(FAR, worth, segment.side * d < near);
        let hits = segment.side * d < min(near, worth) && free < r;
        fall = view.eye.w * (r - free) / max(step, TINY);
        m = select(-1.0, mix(m, (free - r) / step, RELAXATION), step > 0.0 && r < FAR);
        t = ahead;
        r = free;
        if hits {
            met.t = t;
            met.h = max(2.0 * near, 16.0 * view.box_min.w);
            found = segment.side * d;
            probes = 4u;
        }

        // The next sphere touches this one if the slope stays what it was.
        z = max(r * max(1.0, 2.0 / (1.0 - min(m, 0.6))), near);
    }
    return met;
}
