{{ about }}
//
// Draw one triangle of three vertices without buffers. Group 0 has `view` at binding 1{% if parameters %} and the live numbers at binding 0{% endif %}.

/// size.xy: the picture's size in pixels; z: how many rays a pixel has, 1 or 4. orbit.xy: how far the view is turned, in
/// radians; z: how many times as far away as in the scene's own view, normally 1.
struct View {
    size: vec4<f32>,
    orbit: vec4<f32>,
}

@group(0) @binding(1) var<uniform> view: View;

@vertex
fn corner(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    return vec4<f32>(select(-1.0, 3.0, index == 1u), select(-1.0, 3.0, index == 2u), 0.0, 1.0);
}

@fragment
fn pixel(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let size = view.size.xy;
    let camera = orbiting_camera(view.orbit.xy, view.orbit.z, size.x / size.y);
    let shown = picture(vec2<f32>(position.x, size.y - position.y), size, camera, i32(view.size.z));
    return vec4<f32>(shown.rgb, 1.0);
}

{{ code }}
