{{ about }}

#import bevy_pbr::{
    forward_io::VertexOutput,
    mesh_bindings::mesh,
    mesh_functions::{get_local_from_world, get_world_from_local},
    mesh_view_bindings::view,
    pbr_functions::{apply_pbr_lighting, calculate_view, main_pass_post_lighting_processing},
    pbr_types,
}

{{ code }}

struct Output {
    @location(0) color: vec4<f32>,
    @builtin(frag_depth) depth: f32,
}

@fragment
fn fragment(in: VertexOutput) -> Output {
    let hit = meet_scene(in.world_position.xyz, in.instance_index);
    if !hit.is_hit {
        discard;
    }
    let surface = scene_surface(hit.position);

    var input = pbr_types::pbr_input_new();
    input.material.base_color = vec4<f32>(surface.color.rgb, 1.0);
    input.material.perceptual_roughness = surface.finish.x;
    input.material.metallic = surface.finish.y;
    input.material.emissive = vec4<f32>(surface.finish.z * surface.color.rgb, 0.0);
    input.flags = mesh[in.instance_index].flags;
    input.is_orthographic = view.clip_from_view[3].w == 1.0;
    input.frag_coord = vec4<f32>(in.position.xy, hit.depth, 1.0);
    input.world_position = hit.world_position;
    input.world_normal = hit.world_normal;
    input.N = hit.world_normal;
    input.V = calculate_view(hit.world_position, input.is_orthographic);
    return Output(main_pass_post_lighting_processing(input, apply_pbr_lighting(input)), hit.depth);
}
