/// A point of the mesh, in metres with y up, as the scene has it: in millimetres with z up.
fn scene_point(local: vec3<f32>) -> vec3<f32> {
    return 1000.0 * vec3<f32>(local.x, -local.z, local.y);
}

/// The same the other way round, of a point, or of a direction but for its length.
fn local_point(p: vec3<f32>) -> vec3<f32> {
    return 0.001 * vec3<f32>(p.x, p.z, -p.y);
}

/// What is met.
struct SceneHit {
    /// In the scene, in millimetres.
    position: vec3<f32>,
    /// The same in the world.
    world_position: vec4<f32>,
    world_normal: vec3<f32>,
    depth: f32,
    is_hit: bool,
}

/// Where the ray through a point of the box meets the scene, from the eye or from the light whose shadows are drawn.
fn meet_scene(through: vec3<f32>, instance_index: u32) -> SceneHit {
    let is_orthographic = view.clip_from_view[3].w == 1.0;
    let direction = select(through - view.world_position, -view.world_from_view[2].xyz, is_orthographic);
    let origin = select(view.world_position, through, is_orthographic);

    let local_from_world = get_local_from_world(instance_index);
    let o = scene_point((local_from_world * vec4<f32>(origin, 1.0)).xyz);
    let w = normalize(scene_point((local_from_world * vec4<f32>(direction, 0.0)).xyz));
    let size = length(SCENE_MAX - SCENE_MIN);
    let near = 1e-5 * size;
    let growth = select(0.5 / abs(view.clip_from_view[1].y * view.viewport.w), 0.0, is_orthographic);
    let t = scene_hit(o, w, select(0.0, -2.0 * size, is_orthographic), 1e9, near, growth);

    var hit: SceneHit;
    hit.is_hit = t != -1.0;
    if !hit.is_hit {
        return hit;
    }
    hit.position = o + t * w;
    hit.world_position = get_world_from_local(instance_index) * vec4<f32>(local_point(hit.position), 1.0);
    let normal = local_point(scene_normal(hit.position, max(2.0 * (near + growth * abs(t)), 16.0 * near)));
    hit.world_normal = normalize((vec4<f32>(normal, 0.0) * local_from_world).xyz);
    let clip = view.clip_from_world * hit.world_position;
    hit.depth = clamp(clip.z / clip.w, 0.0, 1.0);
    return hit;
}
