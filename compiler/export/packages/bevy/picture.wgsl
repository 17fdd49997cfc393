{{ about }}
//
// The scene as its own lights show it, all over the view.

#import bevy_pbr::{
    mesh_functions::{get_local_from_world, get_world_from_local},
    mesh_view_bindings::view,
}

{{ code }}

/// A point of the mesh, in metres with y up, as the scene has it: in millimetres with z up.
fn scene_point(local: vec3<f32>) -> vec3<f32> {
    return 1000.0 * vec3<f32>(local.x, -local.z, local.y);
}

struct Corner {
    @builtin(position) position: vec4<f32>,
    @location(0) ndc: vec2<f32>,
    @location(1) @interpolate(flat) instance_index: u32,
}

@vertex
fn vertex(@builtin(instance_index) instance_index: u32, @location(0) position: vec3<f32>) -> Corner {
    return Corner(vec4<f32>(position.xy, 0.5, 1.0), position.xy, instance_index);
}

struct Output {
    @location(0) color: vec4<f32>,
    @builtin(frag_depth) depth: f32,
}

@fragment
fn fragment(in: Corner) -> Output {
    let size = view.viewport.zw;
    let local_from_world = get_local_from_world(in.instance_index);
    let eye = scene_point((local_from_world * vec4<f32>(view.world_position, 1.0)).xyz);
    let pixel_angle = 2.0 / (view.clip_from_view[1].y * size.y);
    var sum = vec3<f32>(0.0);
    var depth = 0.0;
    for (var i = 0; i < RAYS; i++) {
        let ndc = in.ndc + 2.0 * ray_offset(i) / size;
        let on_plane = (ndc + view.clip_from_view[2].xy) / vec2<f32>(view.clip_from_view[0].x, view.clip_from_view[1].y);
        let direction = view.world_from_view * vec4<f32>(on_plane, -1.0, 0.0);
        let w = normalize(scene_point((local_from_world * direction).xyz));
        let seen = one_pass(eye, w, pixel_angle, ndc * size / length(size), i);
        sum += seen.color;
        let p = eye + seen.t * w;
        let local = 0.001 * vec3<f32>(p.x, p.z, -p.y);
        let clip = view.clip_from_world * get_world_from_local(in.instance_index) * vec4<f32>(local, 1.0);
        depth = select(clamp(clip.z / clip.w, 0.0, 1.0), 0.0, seen.t < 0.0);
    }
    return Output(vec4<f32>(shown(sum / f32(RAYS)), 1.0), depth);
}
