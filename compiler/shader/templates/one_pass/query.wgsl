// Queries: everything that the pass wants to know of the scene.
//
// Theory: Rays are marched as in `trace_meet.wgsl`, cones as in `shadows/verified/march.wgsl`.
// Changes: Both, and the probes of normals, ask the scene in one place of one loop, because drivers that put functions in
// the place of their calls take time in proportion to the calls of the scene.
// Practice: some twenty evaluations for a ray from the eye, four for its normal; six to twelve for a cone.

/// To find the surface that a ray meets.
const QUERY_RAY: i32 = 0;
/// To find how much of a cone is free.
const QUERY_CONE: i32 = 1;

/// The β of the running mean of slopes.
const RELAXATION: f32 = 0.3;
/// A ray that comes nearer more slowly than this steps as if it came as fast.
const LEAST_FALL: f32 = 0.0625;
/// Of one query. Few grazing rays come near it.
const MAX_STEPS: i32 = 400;
const MAX_CONE_STEPS: i32 = 192;
/// How far ahead a planar silhouette lets a step go, of what it would allow: while looking for contact, and behind it.
const CONE_LOOKING: f32 = 0.9;
const CONE_FOLLOWING: f32 = 0.4;
/// The shortest step, of the cone's radius: where proofs come after, and where what a step leaps over is lost.
const LEAST_STEP_PROVEN: f32 = 0.6;
const LEAST_STEP_BELIEVED: f32 = 0.25;

/// A question.
struct Query {
    /// One of the kinds above.
    kind: i32,
    o: vec3<f32>,
    /// Of length 1.
    w: vec3<f32>,
    /// Up to here the ray or the cone is known to be free.
    start: f32,
    /// Nor does anything from here on count.
    end: f32,
    /// Of a ray: how far steps go beyond what is free, and how much that grows along the ray.
    hit: vec2<f32>,
    /// Of a ray: 1 outside of solids; −1 within one, where distances count from within.
    side: f32,
    /// Of a cone: the sine of its half angle; of a ray: that of the cone whose free part is asked for besides.
    sine: f32,
    /// Of a cone: the normal of the surface it starts at, and how far above it.
    n: vec3<f32>,
    offset: f32,
    /// Of a cone: whether to prove that it is free, or else to believe the spheres.
    proves: bool,
    /// Of a cone: whether to look for contact first, and then on along the axis.
    looks: bool,
    /// Of a cone: whether the normal of what covers it is asked for.
    faces: bool,
}

/// What is known then.
struct Answer {
    /// How far along the ray it meets a surface, negative for none; how far along the cone its axis does, or is nearest to one.
    t: f32,
    /// The slope of the distance there: the normal, but for its length.
    n: vec3<f32>,
    /// How far around n was asked.
    h: f32,
    /// The least distance from the axis, in radii of the cone: 1 or more if it is free, −1 or less if it is covered.
    least: f32,
    /// Of a cone that proves: how far it is free; negative if all of it is.
    contact: f32,
    evaluations: i32,
}

/// The k-th corner of a tetrahedron about the origin.
fn tetrahedron_corner(k: i32) -> vec3<f32> {
    if k == 0 {
        return vec3<f32>(1.0, -1.0, -1.0);
    }
    if k == 1 {
        return vec3<f32>(-1.0, -1.0, 1.0);
    }
    if k == 2 {
        return vec3<f32>(-1.0, 1.0, -1.0);
    }
    return vec3<f32>(1.0, 1.0, 1.0);
}

/// A ray from o to where the scene ends.
fn query_ray(o: vec3<f32>, w: vec3<f32>, hit: vec2<f32>) -> Query {
    return Query(QUERY_RAY, o, w, 0.0, FAR, hit, 1.0, 1.0, vec3<f32>(0.0), 0.0, false, false, true);
}

/// A cone from a point that lies `offset` above a surface whose normal is n.
fn query_cone(o: vec3<f32>, w: vec3<f32>, sine: f32, end: f32, n: vec3<f32>, offset: f32, proves: bool) -> Query {
    return Query(QUERY_CONE, o, w, 0.0, end, vec2<f32>(0.0), 1.0, sine, n, offset, proves, proves, false);
}

/// Asks the scene.
fn ask(query: Query) -> Answer {
    let is_cone = query.kind == QUERY_CONE;
    let lipschitz = setting_lipschitz();
    var answer = Answer(-1.0, vec3<f32>(0.0), 0.0, UNBOUNDED, -1.0, 0);

    // Of a ray. It is free up to t, where the free radius is r, and steps to `safe` beyond leap over nothing; the scene is
    // asked next z ahead; m is the mean slope of r.
    let crossing = box_crossing(Ray(query.o, query.w));
    let end = min(crossing.y, query.end);
    var t = max(crossing.x, query.start);
    // Where a ray enters the box it may meet a surface at once; where it leaves a surface it must not.
    var r = select(0.0, FAR, t > 0.0);
    var safe = 0.0;
    var z = 0.0;
    var m = -1.0;
    // Corners of the tetrahedron about the hit that are still to be asked.
    var probes = 0;

    // Of a cone.
    var march = march_along(
        query.w, query.sine, query.end, query.n, query.offset,
        select(0.0, select(CONE_FOLLOWING, CONE_LOOKING, query.looks), query.proves), select(LEAST_STEP_BELIEVED, LEAST_STEP_PROVEN, query.proves), query.looks,
    );
    march.proves = query.proves;
    var starts_ahead = query.start > 0.0;

    while answer.evaluations < select(MAX_STEPS, MAX_CONE_STEPS, is_cone) {
        if probes == 0 && select(t >= end, march.over, is_cone) {
            if !is_cone || !query.faces || march.least > 0.95 * query.sine {
                break;
            }
            answer.h = max(0.25 * query.sine * answer.t, query.offset);
            probes = 4;
        }

        // Ask the scene: ahead on the ray, at a corner about the hit, or on the cone's axis.
        let ahead = min(t + z, end);
        let on_axis = select(march_asks(march), query.start, starts_ahead);
        var p = query.o + select(ahead, on_axis, is_cone) * query.w;
        if probes > 0 {
            p = query.o + answer.t * query.w + answer.h * tetrahedron_corner(probes - 1);
        }
        let d = scene_distance(p);
        answer.evaluations += 1;

        if is_cone && probes == 0 {
            let f = d / lipschitz;
            if starts_ahead {
                starts_ahead = false;
                march.t = on_axis;
                march.f = f;
                march.slope = 0.0;
                march.over = f <= 0.0;
                march.least = select(march.least, 0.0, f <= 0.0);
            } else {
                let least = march.least;
                let before = vec2<f32>(march.t, march.f);
                march = march_takes(march, on_axis, f);
                if march.least < least && least > 0.0 {
                    let crossing = mix(before.x, march.t, before.y / max(before.y - march.f, TINY));
                    answer.t = select(march.t, crossing, march.f < 0.0 && march.t > before.x);
                }
                if march.touched && march.looking {
                    // Look on from here along the axis, more carefully, whether all of it is covered.
                    answer.contact = march.t;
                    march.looking = false;
                    march.planar = CONE_FOLLOWING;
                    march.least = UNBOUNDED;
                    march.careful = false;
                }
            }
            continue;
        }

        // The differences to the corners sum up to the slope, and so to the normal.
        if probes > 0 {
            answer.n += d * tetrahedron_corner(probes - 1);
            probes -= 1;
            if probes == 0 {
                break;
            }
            continue;
        }

        // Where the spheres come apart, or a relaxed step went into a solid, go back and step to the former one's end.
        let free = query.side * d / lipschitz;
        let step_taken = ahead - t;
        if step_taken > r + free && z > safe {
            m = -1.0;
            z = safe;
            continue;
        }

        // A hit: inside, and getting deeper (or a ray would hit what it leaves).
        let near = query.hit.x + query.hit.y * ahead;
        if free < 0.0 && free < r {
            answer.t = select(ahead, t + step_taken * r / (r - free), r > 0.0 && r < FAR);
            answer.h = max(2.0 * near, 16.0 * setting_epsilon());
            probes = 4;
        }
        m = select(-1.0, mix(m, (free - r) / step_taken, RELAXATION), step_taken > 0.0 && r < FAR);
        t = ahead;
        r = free;
        answer.least = min(answer.least, free / max(query.sine * (ahead - query.start), TINY));

        // The next sphere touches this one if the slope stays what it was. Near a surface the ray goes on to where the slope
        // says that it is beyond.
        safe = max(r, 0.0) + near;
        safe /= select(1.0, clamp(-m, LEAST_FALL, 1.0), r < near);
        z = max(r * max(1.0, 2.0 / (1.0 - min(m, 0.6))), safe);
    }
    if is_cone {
        answer.least = march.least / query.sine;
    }
    return answer;
}
