// What a surface gets from all around: the sky, and what of the scene and the floor hides it.
//
// Theory: Irradiance by voxel cone tracing's few wide cones (Crassin et al., "Interactive Indirect Illumination Using Voxel
// Cone Tracing", 2011), here through the distance field (as Wright, "Dynamic Occlusion with Signed Distance Fields", 2015): the
// least d/(t sin α) along a cone's axis is how much of it is free.
// Changes: The cones' directions are those of an icosahedron that stands still in the world, weighed by the cosine; so no
// seam runs where a surface's own axes turn. Where a cone is covered, light comes from the surface that covers it.

const SKY_CONES: i32 = 12;
/// The sine of the half angle of a cone that is a twelfth of all directions.
const SKY_SINE: f32 = 0.553;
/// How much of the sky reaches a second surface, at a guess, as `trace.wgsl` has it.
const LAST_OPENNESS: f32 = 0.6;
/// Behind the first surface none counts as smoother than this, as `trace.wgsl` has it.
const LAST_ROUGHNESS: f32 = 0.6;
/// How much of the lights reaches a second surface, at a guess, where nobody asked: one of the scene, and the floor.
const LAST_SEEN: f32 = 0.6;
const FLOOR_SEEN: f32 = 0.8;
/// The same of what a rough surface mirrors, as a part of how much of the sky that surface sees.
const SEEN_OF_OPEN: f32 = 1.3;

/// The direction of a cone: the k-th corner of an icosahedron that stands on one, turned for each of a pixel's rays.
fn sky_direction(k: i32, ray: i32) -> vec3<f32> {
    let side = select(-1.0, 1.0, k < SKY_CONES / 2);
    let of_side = k % (SKY_CONES / 2);
    if of_side == 0 {
        return vec3<f32>(0.0, 0.0, side);
    }
    let angle = 0.4 * PI * (f32(of_side) + f32(ray) / f32(RAYS)) + 0.3;
    return side * vec3<f32>(0.894427 * cos(angle), 0.894427 * sin(angle), 0.447214);
}

/// The sky in a cone. The studio's soft boxes are smaller than a cone; what its axis misses of them is above.
fn sky_of_cone(w: vec3<f32>) -> vec3<f32> {
    let missed = select(0.0, 0.2 * max(w.z, 0.0), setting_is_studio());
    return (1.0 + missed) * sky(w, 1.0);
}

/// The lobe's view of the sky: in the direction where most of it comes from, as blurred as it is.
fn sky_of_lobe(n: vec3<f32>, mirrored: vec3<f32>, roughness: f32) -> vec3<f32> {
    let bend = (1.0 - roughness) * (sqrt(1.0 - roughness) + roughness);
    let own = 0.06 + 2.5 * roughness;
    let lobe = 3.0 * roughness * roughness;
    let blur = (sqrt(own * own + lobe * lobe) - 0.06) / 2.5;
    return sky(normalize(mix(n, mirrored, bend)), blur);
}

/// A second surface, as `trace.wgsl` sees it in direction w: rougher than it is.
fn second_vertex(n: vec3<f32>, surface: Surface, w: vec3<f32>) -> Vertex {
    var rougher = surface;
    rougher.finish.x = max(surface.finish.x, LAST_ROUGHNESS);
    return vertex_of(rougher, n, -w);
}

/// What a second surface sends back along w, of whose lights it sees this part, and so much of its own glow.
fn second_radiance(p: vec3<f32>, n: vec3<f32>, surface: Surface, w: vec3<f32>, seen: f32, glow: f32) -> vec3<f32> {
    let x = second_vertex(n, surface, w);
    var radiance = surface.color.rgb * (surface.finish.z * glow) + (x.body + x.f0) * ambient(n) * LAST_OPENNESS;
    for (var i = 0; i < setting_light_count(); i++) {
        radiance += seen * second_light(x, p, setting_light(i));
    }
    return radiance;
}

/// What it sends back of a light of which it sees all.
fn second_light(x: Vertex, p: vec3<f32>, light: Light) -> vec3<f32> {
    let cone = light_bound(light, p);
    let irradiance = light_irradiance(light, p, x.n);
    let cosine = max(dot(x.n, cone.xyz), 0.1);
    let sent = (1.0 - x.albedo) * x.body / PI + gloss_towards(x, cone.xyz, min(cone.w, 1.0)) / cosine;
    return sent * irradiance * light.radiance.rgb;
}

/// A cone from o, above a surface, to the floor or to where the scene ends.
fn query_surroundings(o: vec3<f32>, w: vec3<f32>, sine: f32, n: vec3<f32>, clearance: f32) -> Query {
    let t_floor = floor_crossing(Ray(o, w));
    let end = select(1.5 * scene_reach(o, w), t_floor, t_floor >= 0.0);
    var query = query_cone(o, w, sine, end, n, clearance, false);
    query.faces = true;
    return query;
}

/// What such a cone sees if nothing covers it: the floor, or this of the sky.
fn light_beyond(query: Query, from_sky: vec3<f32>) -> vec3<f32> {
    if floor_crossing(Ray(query.o, query.w)) < 0.0 {
        return from_sky;
    }
    let at = query.o + query.end * query.w;
    return second_radiance(at, vec3<f32>(0.0, 0.0, 1.0), floor_surface(), query.w, FLOOR_SEEN, 0.0);
}

/// How much of a cone is free, of what the surface that it starts at leaves of it.
fn cone_openness(least: f32, cosine: f32, sine: f32) -> f32 {
    return clamp(smooth_area(least) / smooth_area(cosine / sine), 0.0, 1.0);
}

fn floor_surface() -> Surface {
    return Surface(vec4<f32>(FLOOR_ALBEDO, 1.0), vec4<f32>(1.0, 0.0, 0.0, 0.0));
}
