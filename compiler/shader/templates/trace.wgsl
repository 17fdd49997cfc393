// Traces one sample of every pixel: a path from the eye over at most two surfaces to lights and sky.
//
// Theory: Path tracing with next-event estimation (Kajiya, "The Rendering Equation", 1986), each segment of the path
// by sphere tracing (Hart 1996) with automatically relaxed steps: the slope of the distances met so far predicts how
// far the next sphere may lie for both to touch (Bálint, Valasek, Gera: "Operations on Signed Distance Function
// Estimates", 2023; step r ω with ω = 2/(1 − m)); where two spheres come apart, the ray goes back.
// Changes: The first surface's direct light is left to passes of its own (`shadows/`), which draw nothing at random: it
// is written down as a receiver, and only lights that ask for it are sampled there. Segments to surfaces, segments to lights and the probes of normals all ask the scene in one place of
// one loop, because drivers take time in proportion to the calls of the scene. Lights and surfaces stay outside that
// loop, because software drivers run both sides of every branch. The last surface of a path takes the sky's light
// from a closed form.
// Practice: the prepass's depths live as long as a picture's size, camera and live numbers, the sums likewise.

@group(1) @binding(0) var<storage, read> starts: array<vec2<f32>>;
/// The sum of the samples' radiances; w: how often the scene was evaluated for them.
@group(1) @binding(1) var<storage, read_write> sums: array<vec4<f32>>;
/// What the part's pixels see, row by row.
@group(1) @binding(2) var<storage, read_write> receivers: array<Receiver>;
@group(1) @binding(3) var<storage, read> lights: array<Light>;

/// What `view.level.x` may ask for: that paths end at the first surface, which is met through the pixel's centre.
const RECEIVERS_ONLY: u32 = 1u;

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
const HIT: f32 = 0.01;
/// Behind the first surface none counts as smoother than this, or few bright paths would be seen as dots.
const LAST_ROUGHNESS: f32 = 0.6;
/// How much of the sky reaches a path's last surface, at a guess.
const LAST_OPENNESS: f32 = 0.6;
/// Where shadow rays start, off the surface, as a part of the distance from the eye. Less would lose contact with f32;
/// more would lose contact shadows.
const SHADOW_OFFSET: f32 = 4e-4;
/// The most that one sample may add.
const MAX_RADIANCE: f32 = 12.0;

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

/// The radiance of one sample of a pixel; w: how often the scene was evaluated for it. Writes what the pixel sees to
/// `receivers[place]`, if something else lights that.
fn path(pixel: vec2<u32>, start: f32, place: u32) -> vec4<f32> {
    receivers[place].p.w = -1.0;
    let receivers_only = (view.level.x & RECEIVERS_ONLY) > 0u;

    // A jittered ray through the pixel.
    let sample = view.size.z;
    let seed = hash(pixel.x, pixel.y);
    let jitter = select(tent(unit_square(seed, sample, 0u)), vec2<f32>(0.0), receivers_only);
    let point = vec2<f32>(pixel) + 0.5 + jitter;
    let size = vec2<f32>(view.size.xy);
    let from_centre = (2.0 * point - size) / length(size);
    let eye_ray = camera_ray(point);
    let background = background_of(eye_ray.w, vec2<f32>(from_centre.x, -from_centre.y));
    let eye_hit = vec2<f32>(view.box_min.w, HIT * view.forward.w);
    let shining = nearest_shining(eye_ray);
    var segment = Segment(eye_ray, start, shining.t, eye_hit, 1.0, false);

    var radiance = vec3<f32>(0.0);
    var throughput = vec3<f32>(1.0);
    var evaluations = 0u;
    // Surfaces met so far; whether the first was the floor; how blurred the lobe is that the ray was drawn from.
    var depth = 0u;
    var from_floor = false;
    var blur = 0.0;
    // What the light adds if it is seen, and how the path goes on then.
    var direct = vec3<f32>(0.0);
    var next = segment;

    for (var i = 0u; i < MAX_SEGMENTS; i++) {
        let met = meet(segment);
        evaluations += met.evaluations;
        let missed = met.t < 0.0;

        if segment.to_light {
            // The light is seen, or is not; the path goes on.
            radiance += select(vec3<f32>(0.0), direct, missed);
            if depth == MAX_DEPTH {
                break;
            }
            segment = next;
            continue;
        }

        // Past the scene is a light, the floor, or the sky.
        let t_floor = floor_crossing(segment.ray);
        if missed && depth == 0u && shining.t < FAR && (t_floor < 0.0 || shining.t < t_floor) {
            radiance += throughput * shining.radiance;
            break;
        }
        if missed && t_floor < 0.0 {
            radiance += throughput * select(sky(segment.ray.w, blur), background, depth == 0u || from_floor);
            break;
        }
        let t = select(met.t, t_floor, missed);
        // A hit at a point without slope, such as a sphere's centre, faces the ray.
        var n = select(-segment.ray.w, normalize(met.n), dot(met.n, met.n) > TINY);
        var h = met.h;
        // Where the ray is hit by less than a pixel's width, the slope leads on to the surface.
        let position = segment.ray.o + t * segment.ray.w - select(met.d, 0.0, missed) * n;
        var surface = scene_surface(position);
        if missed {
            surface = Surface(vec4<f32>(FLOOR_ALBEDO, 1.0), vec4<f32>(1.0, 0.0, 0.0, 0.0));
            n = vec3<f32>(0.0, 0.0, 1.0);
            h = 2.0 * (segment.hit.x + segment.hit.y * t);
        } else if unit_interval(hash(seed, hash(sample, 64u + i))) >= surface.color.a {
            // Translucent: as many rays as light passes go on, out of the other side.
            segment.side = -segment.side;
            segment.start = t + max(segment.side * met.d, 0.0) + 2.0 * h;
            continue;
        }

        // Light the surface by a light, and draw where the path goes next.
        depth += 1u;
        surface.finish.x = select(surface.finish.x, max(surface.finish.x, LAST_ROUGHNESS), depth > 1u);
        let x = vertex_of(surface, n, -segment.ray.w);
        let clearance = max(2.0 * h, view.forward.w * t);
        let origin = position + clearance * n;
        let hit = vec2<f32>(0.25 * clearance, 0.0);
        let choice = unit_square(seed, sample, 4u * depth + 3u).x;
        let among = select(0u, LIGHT_SAMPLED, depth == 1u);
        // Lights are looked for from nearer to the surface: they may be near themselves.
        let offset = max(SHADOW_OFFSET * distance(position, view.eye.xyz), 8.0 * view.box_min.w);
        let lit_from = position + offset * n;
        let l = some_light_drawn(lit_from, n, unit_square(seed, sample, 4u * depth), choice, among);
        let u = unit_square(seed, sample, 4u * depth + 1u);
        let catches = missed && depth == 1u && is_studio();
        if catches {
            // The floor that the camera sees is the backdrop, darker where the scene hides light from it.
            from_floor = true;
            direct = select(vec3<f32>(0.0), background * FLOOR_KEY_SHARE, any(l.radiance > vec3<f32>(0.0)));
            throughput = 1.0 - FLOOR_KEY_SHARE;
            next = Segment(Ray(origin, cosine_drawn(n, u)), 0.0, FAR, hit, 1.0, false);
        } else {
            radiance += throughput * surface.color.rgb * surface.finish.z;
            radiance += select(vec3<f32>(0.0), throughput * (x.body + x.f0) * ambient(n) * LAST_OPENNESS, depth > 1u);
            let widening = select(0.0, l.angular_radius, depth > 1u);
            direct = throughput * scatter_towards(x, l.w, widening) * l.radiance;
            let drawn = scatter_drawn(x, u, unit_square(seed, sample, 4u * depth + 2u).x);
            throughput *= drawn.weight;
            blur = drawn.blur;
            next = Segment(Ray(origin, drawn.w), 0.0, FAR, hit, 1.0, false);
        }
        if depth == 1u {
            let color = select(clamp(surface.color.rgb, vec3<f32>(0.0), vec3<f32>(1.0)), background * FLOOR_KEY_SHARE, catches);
            let metallic = select(clamp(surface.finish.y, 0.0, 1.0), -1.0, catches);
            let finish = vec4<f32>(color, surface.finish.x);
            let one = some_light(position, n, unit_square(seed, sample, 60u).x, LIGHT_ONE_OF_MANY);
            let drawn = vec4<f32>(f32(one.index), one.weight, 0.0, 0.0);
            receivers[place] = Receiver(vec4<f32>(position, offset), vec4<f32>(n, metallic), finish, drawn);
            if receivers_only {
                break;
            }
        }
        // Who gets none of the light need not look for it.
        let start_of_direct = select(0.0, FAR, all(direct <= vec3<f32>(0.0)));
        segment = Segment(Ray(lit_from, l.w), start_of_direct, l.distance, vec2<f32>(0.25 * offset, 0.0), 1.0, true);
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
    sums[pixel.y * view.size.x + pixel.x] += path(pixel, start, id.y * view.part.z + id.x);
}
