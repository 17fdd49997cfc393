// Traces one sample of every pixel: a path from the eye over at most two surfaces to the studio's lights.
//
// Theory: Path tracing with next-event estimation (Kajiya, "The Rendering Equation", 1986), each segment of the path
// by sphere tracing (Hart 1996) with automatically relaxed steps: the slope of the distances met so far predicts how
// far the next sphere may lie for both to touch (Bálint, Valasek, Gera: "Operations on Signed Distance Function
// Estimates", 2023; step r ω with ω = 2/(1 − m)); where two spheres come apart, the ray goes back.
// Changes: Segments that see the camera, the key light or the studio and the probes of normals all go through one
// loop with one evaluation, because drivers take time in proportion to the calls of the scene. The last surface of a
// path takes the sky's light from a closed form.
// Practice: The prepass's depths and the view live as long as a picture's size and camera, the sums as long as
// nothing moves.

@group(1) @binding(0) var<storage, read> starts: array<vec2<f32>>;
/// The sum of the samples' radiances; w: how often the scene was evaluated for them.
@group(1) @binding(1) var<storage, read_write> sums: array<vec4<f32>>;

/// The β of the running mean of slopes.
const RELAXATION: f32 = 0.3;
/// Of one segment; few grazing rays come near it.
const MAX_STEPS: u32 = 200u;
/// Of a whole path; far below lavapipe's limit of 65535 for all loops of an invocation.
const MAX_EVALUATIONS: u32 = 900u;
/// The edge of the prepass's finest tiles.
const START_EDGE: u32 = 4u;
/// A hit is nearer to the surface than this part of a pixel.
const HIT: f32 = 0.25;
/// What reaches a path's last surface of the sky, at a guess.
const LAST_OPENNESS: f32 = 0.6;
/// The most that one sample may add.
const MAX_RADIANCE: f32 = 12.0;

/// What a segment is for.
const TO_SURFACE: u32 = 0u;
const TO_KEY: u32 = 1u;

/// The march along a segment.
struct March {
    ray: Ray,
    /// Up to where the ray is free.
    t: f32,
    /// The free radius there.
    r: f32,
    /// How far ahead the scene is asked next.
    z: f32,
    /// The mean slope of r over t.
    m: f32,
    /// Where the ray leaves the scene's box.
    end: f32,
    /// The distance that counts as a hit, and how it grows with t.
    hit: vec2<f32>,
    steps: u32,
}

fn march_from(ray: Ray, start: f32, hit: vec2<f32>) -> March {
    let crossing = box_crossing(ray);
    let t = max(crossing.x, start);
    // Where a ray enters the box it may meet a surface at once; where it leaves a surface, it must not.
    let r = select(0.0, FAR, t > 0.0);
    return March(ray, t, r, 0.0, -1.0, crossing.y, hit, 0u);
}

/// The k-th corner of a tetrahedron about the origin.
fn corner(k: u32) -> vec3<f32> {
    return vec3<f32>(f32(((k + 3u) >> 1u) & 1u), f32((k >> 1u) & 1u), f32(k & 1u)) * 2.0 - 1.0;
}

@compute @workgroup_size(8, 8)
fn trace(@builtin(global_invocation_id) id: vec3<u32>) {
    let pixel = view.part.xy + id.xy;
    if any(id.xy >= view.part.zw) || any(pixel >= view.size.xy) {
        return;
    }
    let index = pixel.y * view.size.x + pixel.x;
    let start = starts[tile_index(pixel, START_EDGE, view.level.w)].x * f32(view.size.w);
    sums[index] += path(pixel, start);
}

/// The radiance of one sample of a pixel; w: how often the scene was evaluated for it.
fn path(pixel: vec2<u32>, start: f32) -> vec4<f32> {
    // A jittered ray through the pixel.
    let sample = view.size.z;
    let seed = hash(pixel.x, pixel.y);
    let point = vec2<f32>(pixel) + 0.5 + tent(unit_square(seed, sample, 0u));
    let inverse_L = 1.0 / view.eye.w;
    let epsilon = view.box_min.w;
    let pixel_angle = view.forward.w;
    let from_centre = (2.0 * point - vec2<f32>(view.size.xy)) / f32(min(view.size.x, view.size.y));
    let background = backdrop(vec2<f32>(from_centre.x, -from_centre.y));

    var march = march_from(camera_ray(point), start, vec2<f32>(epsilon, HIT * pixel_angle));
    var purpose = TO_SURFACE;
    var radiance = vec3<f32>(0.0);
    var throughput = vec3<f32>(1.0);
    // Surfaces met so far; whether the first was the floor; how blurred a lobe the ray was drawn from.
    var depth = 0u;
    var from_floor = false;
    var blur = 0.0;
    // What the key light adds if it is seen, and the segment that follows.
    var key_radiance = vec3<f32>(0.0);
    var next = Ray(vec3<f32>(0.0), vec3<f32>(0.0));
    var next_throughput = vec3<f32>(0.0);
    // Inside a translucent solid, distances count from within.
    var side = 1.0;
    // Corners of the tetrahedron about the hit that are still to be asked, their size, and the normal so far.
    var probes = 0u;
    var h = 0.0;
    var n = vec3<f32>(0.0);
    var evaluations = 0u;

    for (var i = 0u; i < MAX_EVALUATIONS; i++) {
        var missed = probes == 0u && !(march.t < march.end && march.steps < MAX_STEPS);
        var surface_met = false;
        var surface = Surface(vec4<f32>(1.0), vec4<f32>(1.0, 0.0, 0.0, 0.0));
        var position = march.ray.o + march.t * march.ray.w;

        if !missed {
            // Ask the scene, ahead on the ray or at a corner about the hit.
            let ahead = min(march.t + march.z, march.end);
            let asked = select(march.ray.o + ahead * march.ray.w, position + h * corner(probes - 1u), probes > 0u);
            let R = scene_distance(asked) * inverse_L;
            evaluations += 1u;

            if probes > 0u {
                // The differences to the corners sum up to the normal.
                n += R * corner(probes - 1u);
                probes -= 1u;
                surface_met = probes == 0u;
            } else {
                // An automatically relaxed step.
                let R_side = side * R;
                let z = ahead - march.t;
                let near = march.hit.x + march.hit.y * ahead;
                let apart = z > march.r + abs(R_side) && z > near;
                let M = select(-1.0, (R_side - march.r) / z, z > 0.0);
                march.m = select(mix(march.m, M, RELAXATION), -1.0, apart || z <= 0.0);
                march.t = select(ahead, march.t, apart);
                let before = march.r;
                march.r = select(R_side, march.r, apart);
                march.z = max(march.r * max(1.0, 2.0 / (1.0 - min(march.m, 0.6))), near);
                march.steps += 1u;

                // A hit: nearer than the pixel is wide, and getting nearer (so that no ray hits what it leaves).
                if !apart && R_side < near && R_side < before {
                    if purpose == TO_KEY {
                        key_radiance = vec3<f32>(0.0);
                        missed = true;
                    } else {
                        march.t += max(R_side, 0.0);
                        h = max(2.0 * near, 16.0 * epsilon);
                        n = vec3<f32>(0.0);
                        probes = 4u;
                    }
                }
            }
        }

        if surface_met {
            surface = scene_surface(position);
            let opacity = unit_interval(hash(seed, hash(sample, 64u + i)));
            if opacity >= surface.color.a {
                // Translucent: the ray goes on, out of the other side.
                side = -side;
                march.t += 2.0 * h;
                march.r = 0.0;
                march.z = 0.0;
                surface_met = false;
                continue;
            }
            // A hit at a point without slope, such as a sphere's centre, faces the ray.
            n = select(-march.ray.w, normalize(n), dot(n, n) > 1e-30);
        }

        if missed && purpose == TO_KEY {
            // The key light is seen, or is not; the path goes on.
            radiance += key_radiance;
            if depth > 1u {
                break;
            }
            throughput = next_throughput;
            march = march_from(next, 0.0, vec2<f32>(march.hit.x, 0.0));
            purpose = TO_SURFACE;
            continue;
        }

        if missed {
            // Past the scene: the floor, or the studio.
            let t_floor = floor_crossing(march.ray);
            if t_floor < 0.0 {
                radiance += throughput * select(sky(march.ray.w, blur), background, depth == 0u || from_floor);
                break;
            }
            position = march.ray.o + t_floor * march.ray.w;
            n = vec3<f32>(0.0, 0.0, 1.0);
            surface = Surface(vec4<f32>(FLOOR_ALBEDO, 1.0), vec4<f32>(1.0, 0.0, 0.0, 0.0));
            surface_met = true;
            from_floor = depth == 0u;
            h = 2.0 * (march.hit.x + march.hit.y * t_floor);
        }

        if surface_met {
            // A surface: light it by the key light, and draw where the path goes next.
            depth += 1u;
            let x = vertex_of(surface, n, -march.ray.w);
            let origin = position + 2.0 * h * n;
            let l = key_drawn(unit_square(seed, sample, 4u * depth));
            side = 1.0;
            if from_floor && depth == 1u {
                // The floor that the camera sees is the backdrop, darker where the scene hides light from it.
                key_radiance = background * FLOOR_KEY_SHARE;
                let d = unit_disc(unit_square(seed, sample, 4u * depth + 1u));
                next = Ray(origin, vec3<f32>(d, sqrt(max(1.0 - dot(d, d), 1e-4))));
                next_throughput = 1.0 - FLOOR_KEY_SHARE;
            } else {
                radiance += throughput * surface.color.rgb * surface.finish.z;
                key_radiance = throughput * key_scattered(x, l);
                let lobe = unit_square(seed, sample, 4u * depth + 2u).x;
                let drawn = scatter_drawn(x, unit_square(seed, sample, 4u * depth + 1u), lobe);
                next = Ray(origin, drawn.w);
                next_throughput = throughput * drawn.weight;
                blur = drawn.blur;
            }
            if depth > 1u {
                radiance += throughput * (x.body + x.f0) * ambient(n) * LAST_OPENNESS;
            }
            march = march_from(Ray(origin, l), 0.0, vec2<f32>(0.5 * h, 0.0));
            if all(key_radiance <= vec3<f32>(0.0)) {
                march.end = 0.0;
            }
            purpose = TO_KEY;
        }
    }
    return vec4<f32>(min(radiance, vec3<f32>(MAX_RADIANCE)), f32(evaluations));
}
