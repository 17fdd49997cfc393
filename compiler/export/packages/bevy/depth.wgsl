{{ about }}
//
// For shadow maps, and for what Bevy draws ahead of the light: depth and normals.

#import bevy_pbr::{
    mesh_functions::{get_local_from_world, get_previous_world_from_local, get_world_from_local},
    mesh_view_bindings::view,
    prepass_io::VertexOutput,
}
#ifdef MOTION_VECTOR_PREPASS
#import bevy_pbr::pbr_prepass_functions::calculate_motion_vector
#endif

{{ code }}

struct Output {
#ifdef NORMAL_PREPASS
    @location(0) normal: vec4<f32>,
#endif
#ifdef MOTION_VECTOR_PREPASS
    @location(1) motion_vector: vec2<f32>,
#endif
    @builtin(frag_depth) depth: f32,
}

@fragment
fn fragment(in: VertexOutput) -> Output {
    let hit = meet_scene(in.world_position.xyz, in.instance_index);
    if !hit.is_hit {
        discard;
    }
    var out: Output;
#ifdef NORMAL_PREPASS
    out.normal = vec4<f32>(0.5 * hit.world_normal + 0.5, 1.0);
#endif
#ifdef MOTION_VECTOR_PREPASS
    let local = vec4<f32>(local_point(hit.position), 1.0);
    let previous = get_previous_world_from_local(in.instance_index) * local;
    out.motion_vector = calculate_motion_vector(hit.world_position, previous);
#endif
    out.depth = hit.depth;
    return out;
}
