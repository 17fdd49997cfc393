// Traces one sample of every pixel: a path from the eye over at most two surfaces to lights and sky.
//
// Theory: Path tracing with next-event estimation (Kajiya, "The Rendering Equation", 1986), each segment of the path
// marched by `meet`.
// Changes: The first surface's direct light is left to passes of its own (`shadows/`), which draw nothing at random: it
// is written down as a receiver, and only lights that ask for it are sampled there. Lights and surfaces stay outside the
// loop that asks the scene, because software drivers run both sides of every branch. The last surface of a path takes
// the sky's light from a closed form.
// Practice: the prepass's depths live as long as a picture's size, camera and live numbers, the sums likewise.

@group(1) @binding(0) var<storage, read> starts: array<vec2<f32>>;
/// The sum of the samples' radiances; w: how often the scene was evaluated for them.
@group(1) @binding(1) var<storage, read_write> sums: array<vec4<f32>>;
/// What the part's pixels see, row by row.
@group(1) @binding(2) var<storage, read_write> receivers: array<Receiver>;
@group(1) @binding(3) var<storage, read> lights: array<Light>;

/// What `view.level.x` may ask for: that paths end at the first surface, which is met through the pixel's centre.
const RECEIVERS_ONLY: u32 = 1u;

/// Of one path; more than four only behind translucent surfaces.
const MAX_SEGMENTS: u32 = 16u;
/// How many surfaces a path meets.
const MAX_DEPTH: u32 = 2u;
/// Behind the first surface none counts as smoother than this, or few bright paths would be seen as dots.
const LAST_ROUGHNESS: f32 = 0.6;
/// How much of the sky reaches a path's last surface, at a guess.
const LAST_OPENNESS: f32 = 0.6;
/// Where shadow rays start, off the surface, as a part of the distance from the eye. Less would lose contact with f32;
/// more would lose contact shadows.
const SHADOW_OFFSET: f32 = 4e-4;
/// The most that one sample may add.
const MAX_RADIANCE: f32 = 12.0;

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
        let position = segment.ray.o + t * segment.ray.w;
        var surface = scene_surface(position);
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
        let catches = missed && depth == 1u && setting_is_studio();
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
