// A picture in one pass: what a ray from the eye sees, without buffers, noise or history.
//
// Theory: What `trace.wgsl` and the passes after it gather over many samples: direct light by verified cones, the sky and the
// light between surfaces by a few wide cones, the mirror image by a ray.
// Changes: All questions to the scene go through one call of `ask`; this loop makes the next question of the last answer.
// Practice: some hundred evaluations a ray.

/// A hit is nearer to the surface than this part of a pixel.
const HIT: f32 = 0.01;
/// Where shadow rays start, off the surface, as a part of the distance from the eye.
const SHADOW_OFFSET: f32 = 4e-4;
/// The most radiance of a ray.
const MAX_RADIANCE: f32 = 12.0;
/// A reflection that sends back less than this part is guessed.
const WORTH_MIRRORING: f32 = 0.03;
/// How many surfaces are seen through each other, and the least of the light behind that is worth looking for.
const MAX_LAYERS: i32 = 6;
const LEAST_TRANSMITTED: f32 = 0.02;
/// Of one ray.
const MAX_QUERIES: i32 = 256;

/// What a query is about: the ray from the eye; a light; a cell of it; the sky; the mirror image, and a light there; a part of
/// a mirror image that is blurred.
const STAGE_EYE: i32 = 0;
const STAGE_LIGHT: i32 = 1;
const STAGE_CELL: i32 = 2;
const STAGE_SKY: i32 = 3;
const STAGE_MIRROR: i32 = 4;
const STAGE_MIRROR_LIGHT: i32 = 5;
const STAGE_LOBE: i32 = 6;
const STAGE_OVER: i32 = 7;

/// What a ray sees.
struct OnePass {
    /// The radiance that reaches the eye, as the picture is exposed for it.
    color: vec3<f32>,
    /// How far along the ray the first surface is, the floor included; negative if there is none.
    t: f32,
    /// That surface's point and unit normal.
    position: vec3<f32>,
    normal: vec3<f32>,
    /// Whether it is the floor.
    is_floor: bool,
    /// How often the scene was evaluated.
    evaluations: i32,
}

/// The radiance along a ray from the eye. `pixel_angle` is the angle between neighbouring pixels in radians, `place` where in
/// the picture the ray is: from its centre, to the right and upwards, its corners at a distance of 1; `ray` which of a pixel's it is.
fn one_pass(o: vec3<f32>, w: vec3<f32>, pixel_angle: f32, place: vec2<f32>, ray: i32) -> OnePass {
    let eye_ray = Ray(o, w);
    let background = background_of(w, place);
    let shining = nearest_shining(eye_ray);
    let t_floor = floor_crossing(eye_ray);
    let count = setting_light_count();
    let epsilon = setting_epsilon();
    var result = OnePass(vec3<f32>(0.0), -1.0, vec3<f32>(0.0), vec3<f32>(0.0), false, 0);

    var stage = STAGE_EYE;
    var query = query_ray(o, w, vec2<f32>(epsilon, HIT * pixel_angle));
    query.end = shining.w;
    // What of the light behind the surfaces so far reaches the eye; how many there are.
    var transmitted = 1.0;
    var layer = 0;

    // The surface that is being lit.
    var position = o;
    var n = -w;
    var surface = floor_surface();
    var x = vertex_of(surface, n, -w);
    var catches = false;
    var weight = 0.0;
    var offset = epsilon;
    var clearance = epsilon;
    var next_query = query;
    // Its light.
    var index = 0;
    var irradiance = 0.0;
    var bare = 1.0;
    var contact = -1.0;
    var cell = 0;
    var seen = 0.0;
    var shares = 0.0;
    var piece = Piece(n, 1.0, 0.0, 0.0, 1.0);
    // Its sky: the weights of cones, the light that comes through them, and how much of them is free.
    var sky_weight = 0.0;
    var sky_light = vec3<f32>(0.0);
    var sky_open = 0.0;
    // Its mirror image.
    var mirror_position = o;
    var mirror_n = -w;
    var mirror_surface = surface;
    var mirror_open = 1.0;
    var mirror_light = vec3<f32>(0.0);
    var lobe_weight = 0.0;

    for (var asked = 0; asked < MAX_QUERIES; asked++) {
        let answer = ask(query);
        result.evaluations += answer.evaluations;
        let is_hit = answer.t >= 0.0;

        // The surface that was met, or that covers a cone most.
        let slope_n = select(-query.w, normalize(answer.n), dot(answer.n, answer.n) > TINY);
        let met_position = query.o + answer.t * query.w;
        var met = surface;
        if is_hit && stage != STAGE_LIGHT && stage != STAGE_CELL && stage != STAGE_MIRROR_LIGHT {
            met = scene_surface(met_position);
        }

        if stage == STAGE_EYE {
            if !is_hit && shining.w < FAR && (t_floor < 0.0 || shining.w < t_floor) {
                result.color += transmitted * shining.rgb;
                break;
            }
            if !is_hit && t_floor < 0.0 {
                result.color += transmitted * background;
                break;
            }
            let t = select(t_floor, answer.t, is_hit);
            position = select(o + t_floor * w, met_position, is_hit);
            n = select(vec3<f32>(0.0, 0.0, 1.0), slope_n, is_hit);
            surface = met;
            if !is_hit {
                surface = floor_surface();
            }
            if layer == 0 {
                result.t = t;
                result.position = position;
                result.normal = n;
                result.is_floor = !is_hit;
            }
            let h = select(2.0 * (epsilon + HIT * pixel_angle * t), answer.h, is_hit);
            let opacity = clamp(surface.color.a, 0.0, 1.0);
            weight = transmitted * opacity;
            transmitted *= 1.0 - opacity;
            next_query = query;
            next_query.side = -query.side;
            next_query.start = t + 2.0 * h;
            catches = !is_hit && setting_is_studio();
            x = vertex_of(surface, n, -w);
            clearance = max(2.0 * h, pixel_angle * t);
            offset = max(SHADOW_OFFSET * t, 8.0 * epsilon);
            result.color += select(weight * surface.color.rgb * surface.finish.z, vec3<f32>(0.0), catches);
            sky_weight = 0.0;
            sky_light = vec3<f32>(0.0);
            sky_open = 0.0;
            stage = STAGE_LIGHT;
            index = -1;
        } else if stage == STAGE_LIGHT {
            contact = answer.contact;
            cell = 0;
            shares = 0.0;
            if contact < 0.0 {
                seen = bare;
            } else if answer.least <= -0.999 {
                seen = 0.0;
            } else if CELLS == 1 {
                seen = min(bare, smooth_area(answer.least));
            } else {
                seen = 0.0;
                stage = STAGE_CELL;
            }
        } else if stage == STAGE_CELL {
            let part = min(smooth_area(answer.least), segment_area(piece.horizon));
            seen += piece.weight * part;
            cell += 1;
        } else if stage == STAGE_SKY {
            // The surface's own horizon is no occluder: the cosine knows of it.
            let cosine = dot(n, query.w);
            let open = cone_openness(answer.least, cosine, SKY_SINE);
            let beyond = light_beyond(query, select(sky_of_cone(query.w), background, catches));
            // What glows is often smaller than a cone, which would show as bands: it lights nothing but mirrors.
            let covering = second_radiance(met_position, slope_n, met, query.w, LAST_SEEN, 0.0);
            sky_weight += cosine;
            sky_open += cosine * open;
            sky_light += cosine * mix(covering, beyond, open);
        } else if stage == STAGE_MIRROR {
            let t_mirror = floor_crossing(Ray(query.o, query.w));
            mirror_open = cone_openness(answer.least, max(dot(n, query.w), 0.02), query.sine);
            mirror_open = select(mirror_open, 0.0, is_hit);
            mirror_light = vec3<f32>(0.0);
            if is_hit || t_mirror >= 0.0 {
                mirror_position = select(query.o + t_mirror * query.w, met_position, is_hit);
                mirror_n = select(vec3<f32>(0.0, 0.0, 1.0), slope_n, is_hit);
                mirror_surface = met;
                if !is_hit {
                    mirror_surface = floor_surface();
                    mirror_open = 0.0;
                }
                mirror_light = second_radiance(mirror_position, mirror_n, mirror_surface, query.w, 0.0, 1.0);
                stage = STAGE_MIRROR_LIGHT;
                index = -1;
            } else {
                stage = STAGE_OVER;
            }
        } else if stage == STAGE_LOBE {
            let open = cone_openness(answer.least, dot(n, query.w), query.sine);
            let beyond = light_beyond(query, sky(query.w, sqrt(x.alpha)));
            // What a surface mirrors that sees much of the sky is likely to see the lights.
            let seen_there = clamp(SEEN_OF_OPEN * sky_open / max(sky_weight, TINY), 0.0, 1.0);
            let covering = second_radiance(met_position, slope_n, met, query.w, seen_there, 1.0);
            let share = lobe_direction(x, index, ray).w;
            lobe_weight += share;
            mirror_light += share * mix(covering, beyond, open);
        } else {
            let bare_there = light_bare(setting_light(index), query.o, mirror_n);
            let part = select(min(bare_there, smooth_area(answer.least)), bare_there, answer.contact < 0.0);
            let there = second_vertex(mirror_n, mirror_surface, reflect(-x.v, n));
            mirror_light += part / max(bare_there, TINY) * second_light(there, query.o, setting_light(index));
        }

        // What to ask next.
        var asks = false;
        while !asks {
            if stage == STAGE_CELL {
                if cell < CELLS {
                    let lit_from = position + offset * n;
                    let light = setting_light(index);
                    piece = light_piece(light, lit_from, n, cell, ray);
                    if is_round(light) {
                        shares += 1.0 / f32(CELLS);
                    } else {
                        piece.weight /= max(irradiance, TINY);
                        shares += piece.weight;
                    }
                    if piece.weight > 0.0 && piece.t_max > 0.0 {
                        query = piece_cone(piece, lit_from, n, offset, contact);
                        asks = true;
                    } else {
                        seen += piece.weight;
                        cell += 1;
                    }
                } else {
                    seen = min(seen / max(shares, TINY), bare);
                    stage = STAGE_LIGHT;
                }
            } else if stage == STAGE_LIGHT {
                if index >= 0 {
                    let light = setting_light(index);
                    let sent = select(direct_radiance(x, light, position + offset * n, irradiance), background * FLOOR_KEY_SHARE, catches);
                    result.color += weight * min(select(0.0, seen / max(bare, TINY), irradiance > 0.0) * sent, vec3<f32>(MAX_RADIANCE));
                }
                index += 1;
                if index >= count {
                    stage = STAGE_SKY;
                    index = -1;
                } else {
                    let lit_from = position + offset * n;
                    let light = setting_light(index);
                    irradiance = light_irradiance(light, lit_from, n);
                    bare = light_bare(light, lit_from, n);
                    seen = select(0.0, bare, is_within(light, lit_from));
                    query = light_cone(light, lit_from, n, offset);
                    asks = irradiance > 0.0 && query.sine > 0.0;
                }
            } else if stage == STAGE_SKY {
                index += 1;
                if index < SKY_CONES {
                    let towards = sky_direction(index, ray);
                    if dot(n, towards) > 0.01 {
                        query = query_surroundings(position + clearance * n, towards, SKY_SINE, n, clearance);
                        asks = true;
                    }
                } else {
                    let from_sky = sky_light / max(sky_weight, TINY);
                    if catches {
                        result.color += weight * (1.0 - FLOOR_KEY_SHARE) * from_sky;
                        stage = STAGE_OVER;
                    } else {
                        result.color += weight * (1.0 - x.albedo) * x.body * from_sky;
                        let mirrored = reflect(-x.v, n);
                        let most = max(x.albedo.x, max(x.albedo.y, x.albedo.z));
                        stage = STAGE_MIRROR;
                        query = query_ray(position + clearance * n, mirrored, vec2<f32>(0.25 * clearance, 0.0));
                        query.sine = clamp(1.5 * x.alpha, 0.05, 0.7);
                        mirror_open = 1.0;
                        asks = most > WORTH_MIRRORING && dot(mirrored, n) > 0.0;
                        if asks && x.alpha > LEAST_LOBE_ALPHA {
                            stage = STAGE_LOBE;
                            mirror_light = vec3<f32>(0.0);
                            lobe_weight = 0.0;
                            index = -1;
                            asks = false;
                        } else if !asks {
                            stage = STAGE_OVER;
                        }
                    }
                }
            } else if stage == STAGE_MIRROR_LIGHT {
                index += 1;
                if index < count {
                    let lit_from = mirror_position + clearance * mirror_n;
                    query = light_cone(setting_light(index), lit_from, mirror_n, clearance);
                    query.looks = false;
                    asks = query.sine > 0.0;
                } else {
                    stage = STAGE_OVER;
                }
            } else if stage == STAGE_LOBE {
                index += 1;
                if index < LOBE_CONES {
                    let towards = lobe_direction(x, index, ray);
                    if towards.w > 0.0 {
                        let sine = min(LOBE_SINE * x.alpha, 0.5);
                        query = query_surroundings(position + clearance * n, towards.xyz, sine, n, clearance);
                        asks = true;
                    }
                } else {
                    mirror_light /= max(lobe_weight, TINY);
                    mirror_open = 0.0;
                    stage = STAGE_OVER;
                }
            } else if stage == STAGE_OVER {
                if !catches {
                    let lobe = sky_of_lobe(n, reflect(-x.v, n), sqrt(x.alpha));
                    result.color += weight * x.albedo * mix(mirror_light, lobe, mirror_open);
                }
                layer += 1;
                if transmitted < LEAST_TRANSMITTED || layer >= MAX_LAYERS {
                    break;
                }
                stage = STAGE_EYE;
                query = next_query;
                asks = true;
            }
        }
        if !asks {
            break;
        }
    }
    result.color = min(result.color, vec3<f32>(MAX_RADIANCE));
    return result;
}

/// What a surface sends to the eye of a light of which it sees all, and gets this irradiance per radiance.
fn direct_radiance(x: Vertex, light: Light, p: vec3<f32>, irradiance: f32) -> vec3<f32> {
    let body = (1.0 - x.albedo) * x.body / PI * irradiance;
    return (body + gloss_of_light(light, x, p)) * light.radiance.rgb;
}
