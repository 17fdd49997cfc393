// Traces one sample of every pixel: a path from the eye over at most two surfaces to the studio's lights.
//
// Theory: Path tracing with next-event estimation (Kajiya, "The Rendering Equation", 1986), each segment of the path
// by sphere tracing (Hart 1996) with automatically relaxed steps: the slope of the distances met so far predicts how
// far the next sphere may lie for both to touch (Bálint, Valasek, Gera: "Operations on Signed Distance Function
// Estimates", 2023; step r ω with ω = 2/(1 − m)); where two spheres come apart, the ray goes back.
// Changes: Segments to surfaces, segments to the key light and the probes of normals all ask the scene in one place of
// one loop, because drivers take time in proportion to the calls of the scene. Lights and surfaces stay outside that
// loop, because software drivers run both sides of every branch. The last surface of a path takes the sky's light
// from a closed form.
// Practice: the prepass's depths live as long as a picture's size, camera and live numbers, the sums likewise.

@group(1) @binding(0) var<storage, read> starts: array<vec2<f32>>;
/// The sum of the samples' radiances; w: how often the scene was evaluated for them.
@group(1) @binding(1) var<storage, read_write> sums: array<vec4<f32>>;

/// The β of the running mean of slopes.
const RELAXATION: f32 = 0.3;
/// Of one segment; few grazing rays come near it. lavapipe ends all loops of an invocation together after 65535 rounds,
/// those within the scene's distance included.
const MAX_STEPS: u32 = 1500u;
/// Of one path; more than four only behind translucent surfaces.
const MAX_SEGMENTS: u32 = 16u;
/// How many surfaces a path meets.
const MAX_DEPTH: u32 = 2u;
/// The edge of the prepass's finest tiles.
const START_EDGE: u32 = 4u;
/// A hit is nearer to the surface than this part of a pixel.
const HIT: f32 = 0.25;
/// Behind the first surface none counts as smoother than this, or few bright paths would be seen as dots.
const LAST_ROUGHNESS: f32 = 0.6;
/// How much of the sky reaches a path's last surface, at a guess.
const LAST_OPENNESS: f32 = 0.6;
/// The most that one sample may add.
const MAX_RADIANCE: f32 = 12.0;

/// A segment of a path.
struct Segment {
    ray: Ray,
    /// Up to here nothing is met.
    start: f32,
    /// The distance that counts as a hit, and how much it grows along the ray.
    hit: vec2<f32>,
    /// 1 outside solids; −1 within a translucent one, where distances count from within.
    side: f32,
    /// Whether it goes to the key light, and only has to know if anything is in between.
    to_key: bool,
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
    let end = crossing.y;
    // The ray is free up to t, where the free radius is r; the scene is asked next z ahead; m is the mean slope of r.
    var t = max(crossing.x, segment.start);
    // Where a ray enters the box it may meet a surface at once; where it leaves a surface it must not.
    var r = select(0.0, FAR, t > 0.0);
    var z = 0.0;
    var m = -1.0;
    var met = Met(-1.0, vec3<f32>(0.0), 0.0, 0u);
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
            met.t = t + max(free, 0.0);
            met.h = max(2.0 * near, 16.0 * view.box_min.w);
            found = segment.side * d;
            probes = 4u;
        }

        // The next sphere touches this one if the slope stays what it was.
        z = max(r * max(1.0, 2.0 / (1.0 - min(m, 0.6))), near);
    }
    return met;
}

/// The radiance of one sample of a pixel; w: how often the scene was evaluated for it.
fn path(pixel: vec2<u32>, start: f32) -> vec4<f32> {
    // A jittered ray through the pixel.
    let sample = view.size.z;
    let seed = hash(pixel.x, pixel.y);
    let point = vec2<f32>(pixel) + 0.5 + tent(unit_square(seed, sample, 0u));
    let size = vec2<f32>(view.size.xy);
    let from_centre = (2.0 * point - size) / length(size);
    let background = backdrop(vec2<f32>(from_centre.x, -from_centre.y));
    var segment = Segment(camera_ray(point), start, vec2<f32>(view.box_min.w, HIT * view.forward.w), 1.0, false);

    var radiance = vec3<f32>(0.0);
    var throughput = vec3<f32>(1.0);
    var evaluations = 0u;
    // Surfaces met so far; whether the first was the floor; how blurred the lobe is that the ray was drawn from.
    var depth = 0u;
    var from_floor = false;
    var blur = 0.0;
    // What the key light adds if it is seen, and how the path goes on then.
    var key_radiance = vec3<f32>(0.0);
    var next = segment;

    for (var i = 0u; i < MAX_SEGMENTS; i++) {
        let met = meet(segment);
        evaluations += met.evaluations;
        let missed = met.t < 0.0;

        if segment.to_key {
            // The key light is seen, or is not; the path goes on.
            radiance += select(vec3<f32>(0.0), key_radiance, missed);
            if depth == MAX_DEPTH {
                break;
            }
            segment = next;
            continue;
        }

        // Past the scene is the floor, or the studio.
        let t_floor = floor_crossing(segment.ray);
        if missed && t_floor < 0.0 {
            radiance += throughput * select(sky(segment.ray.w, blur), background, depth == 0u || from_floor);
            break;
        }
        let t = select(met.t, t_floor, missed);
        let position = segment.ray.o + t * segment.ray.w;
        var surface = scene_surface(position);
        // A hit at a point without slope, such as a sphere's centre, faces the ray.
        var n = select(-segment.ray.w, normalize(met.n), dot(met.n, met.n) > TINY);
        var h = met.h;
        if missed {
            surface = Surface(vec4<f32>(FLOOR_ALBEDO, 1.0), vec4<f32>(1.0, 0.0, 0.0, 0.0));
            n = vec3<f32>(0.0, 0.0, 1.0);
            h = 2.0 * (segment.hit.x + segment.hit.y * t);
        } else if unit_interval(hash(seed, hash(sample, 64u + i))) >= surface.color.a {
            // Translucent: as many rays as light passes go on, out of the other side.
            segment.side = -segment.side;
            segment.start = t + 2.0 * h;
            continue;
        }

        // Light the surface by the key light, and draw where the path goes next.
        depth += 1u;
        surface.finish.x = select(surface.finish.x, max(surface.finish.x, LAST_ROUGHNESS), depth > 1u);
        let x = vertex_of(surface, n, -segment.ray.w);
        let origin = position + 2.0 * h * n;
        let hit = vec2<f32>(0.5 * h, 0.0);
        let l = key_drawn(unit_square(seed, sample, 4u * depth));
        let u = unit_square(seed, sample, 4u * depth + 1u);
        if missed && depth == 1u {
            // The floor that the camera sees is the backdrop, darker where the scene hides light from it.
            from_floor = true;
            key_radiance = background * FLOOR_KEY_SHARE;
            throughput = 1.0 - FLOOR_KEY_SHARE;
            next = Segment(Ray(origin, cosine_drawn(n, u)), 0.0, hit, 1.0, false);
        } else {
            radiance += throughput * surface.color.rgb * surface.finish.z;
            radiance += select(vec3<f32>(0.0), throughput * (x.body + x.f0) * ambient(n) * LAST_OPENNESS, depth > 1u);
            key_radiance = throughput * key_scattered(x, l);
            let drawn = scatter_drawn(x, u, unit_square(seed, sample, 4u * depth + 2u).x);
            throughput *= drawn.weight;
            blur = drawn.blur;
            next = Segment(Ray(origin, drawn.w), 0.0, hit, 1.0, false);
        }
        // Who gets none of the key light need not look for it.
        let start_of_key = select(0.0, FAR, all(key_radiance <= vec3<f32>(0.0)));
        segment = Segment(Ray(origin, l), start_of_key, hit, 1.0, true);
    }
    return vec4<f32>(min(radiance, vec3<f32>(MAX_RADIANCE)), f32(evaluations));
}

@compute @workgroup_size(8, 8)
fn trace(@builtin(global_invocation_id) id: vec3<u32>) {
    let pixel = view.part.xy + id.xy;
    if any(id.xy >= view.part.zw) || any(pixel >= view.size.xy) {
        return;
    }
    let start = starts[tile_index(pixel, START_EDGE, view.level.w)].x * f32(view.size.w);
    sums[pixel.y * view.size.x + pixel.x] += path(pixel, start);
}
