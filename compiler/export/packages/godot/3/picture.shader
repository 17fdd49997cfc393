{{ about }}
//
// For Godot 3: a material of a quad of 2 by 2 metres, which covers the whole view. It shows the scene under its own lights, and
// none of the engine's.

shader_type spatial;
render_mode unshaded, cull_disabled;

// The eye, and the ways to the view's middle, its right and its upper edge, in the scene's millimetres.
varying vec3 view_eye;
varying vec3 view_forward;
varying vec3 view_right;
varying vec3 view_up;

{{ code }}

void vertex() {
{% for parameter in parameters if parameter.is_time %}
    {{ parameter.name }}_now = {{ parameter.name }}_runs ? fract(TIME / 8.0) : {{ parameter.name }};
{% endfor %}
    mat4 to_object = inverse(MODELVIEW_MATRIX);
    view_eye = to_object[3].xyz;
    view_forward = (to_object * vec4(INV_PROJECTION_MATRIX[3].xy, -1.0, 0.0)).xyz;
    view_right = INV_PROJECTION_MATRIX[0][0] * to_object[0].xyz;
    view_up = INV_PROJECTION_MATRIX[1][1] * to_object[1].xyz;
    POSITION = vec4(VERTEX.xy, 1.0, 1.0);
}

void fragment() {
    float pixel_angle = 2.0 * length(view_up) / (VIEWPORT_SIZE.y * length(view_forward));
    vec3 sum = vec3(0.0);
    vec3 p = view_eye;
    for (int i = 0; i < RAYS; i++) {
        vec2 place = 2.0 * (FRAGCOORD.xy + ray_offset(i)) - VIEWPORT_SIZE;
        vec2 at = place / VIEWPORT_SIZE;
        vec3 w = normalize(view_forward + at.x * view_right + at.y * view_up);
        vec3 color;
        float t;
        vec3 position;
        vec3 normal;
        bool is_floor;
        int evaluations;
        one_pass(view_eye, w, pixel_angle, place / length(VIEWPORT_SIZE), i, color, t, position, normal, is_floor, evaluations);
        sum += color;
        // What is nowhere is behind everything.
        p = view_eye + (t > 0.0 ? t : 1e9) * w;
    }
    ALBEDO = shown(sum / float(RAYS));
    vec4 clip = PROJECTION_MATRIX * (INV_CAMERA_MATRIX * (WORLD_MATRIX * vec4(p, 1.0)));
    DEPTH = min(0.5 * clip.z / clip.w + 0.5, 1.0);
}
