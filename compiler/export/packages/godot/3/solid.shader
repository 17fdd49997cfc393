{% set size = ((box_max[0] - box_min[0]) ** 2 + (box_max[1] - box_min[1]) ** 2 + (box_max[2] - box_min[2]) ** 2) ** 0.5 %}
{{ about }}
//
// For Godot 3: a material of a box that is as large as the scene's, or larger, with its middle at the same place. It works from
// inside, too. The box should be subdivided: the engine looks shadows up at what lies between its vertices.

shader_type spatial;
render_mode cull_front;

const vec3 BOX_CENTER = vec3({{ ((box_min[0] + box_max[0]) / 2) | float }}, {{ ((box_min[1] + box_max[1]) / 2) | float }}, {{ ((box_min[2] + box_max[2]) / 2) | float }});
const float BOX_SIZE = {{ size | float }}; // its diagonal

// Where rays start, and whereto they go, in the scene's millimetres.
varying vec3 ray_start;
varying vec3 ray_way;

{{ code }}

// How far along a ray it meets the scene, or else comes nearest to it.
float scene_approach(vec3 o, vec3 w) {
    vec2 crossing = scene_box_crossing(o, w);
    float t = max(crossing.x, 0.0);
    float nearest = t;
    float least = BOX_SIZE;
    for (int i = 0; i < 100; i++) {
        float d = scene_distance(o + t * w);
        if (d < least) {
            least = d;
            nearest = t;
        }
        if (d < 1e-4 * BOX_SIZE || t > crossing.y) {
            break;
        }
        t += max(d / SCENE_LIPSCHITZ, 1e-3 * BOX_SIZE);
    }
    return nearest;
}

void vertex() {
{% for parameter in parameters if parameter.is_time %}
    {{ parameter.name }}_now = {{ parameter.name }}_runs ? fract(TIME / 8.0) : {{ parameter.name }};
{% endfor %}
    mat4 to_object = inverse(MODELVIEW_MATRIX);
    vec3 point = VERTEX + BOX_CENTER;
    if (PROJECTION_MATRIX[3][3] > 0.5) {
        // An orthographic camera, or a sun: rays are parallel.
        ray_way = -normalize(to_object[2].xyz);
        ray_start = point - 2.0 * BOX_SIZE * ray_way;
    } else {
        ray_start = to_object[3].xyz + BOX_CENTER;
        ray_way = point - ray_start;
    }

    // The engine lights what vertices span: so they go along their rays, to just above the
    // surface, which shows at the same pixels.
    vec3 w = normalize(ray_way);
    point = ray_start + (scene_approach(ray_start, w) - 0.01 * BOX_SIZE) * w;
    ray_way = PROJECTION_MATRIX[3][3] > 0.5 ? ray_way : point - ray_start;
    VERTEX = point - BOX_CENTER;
}

void fragment() {
    vec3 w = normalize(ray_way);
    float pixel_angle = length(dFdx(w));
    float t = scene_hit(ray_start, w, 0.0, 1e9, 1e-5 * BOX_SIZE, 0.25 * pixel_angle);
    if (t < 0.0) {
        discard;
    }
    vec3 p = ray_start + t * w;
    vec4 color;
    vec4 finish;
    scene_surface(p, color, finish);
    // What is translucent leaves pixels out: noise by Jimenez ("Next Generation Post Processing in Call of Duty", 2014).
    if (color.a < fract(52.9829189 * fract(dot(FRAGCOORD.xy, vec2(0.06711056, 0.00583715))))) {
        discard;
    }

    mat4 to_view = INV_CAMERA_MATRIX * WORLD_MATRIX;
    // In maps of shadows this is what the bias is.
    vec4 clip = PROJECTION_MATRIX * (to_view * vec4(p + 0.002 * BOX_SIZE * w - BOX_CENTER, 1.0));
    DEPTH = 0.5 * clip.z / clip.w + 0.5;
    NORMAL = normalize((to_view * vec4(scene_normal(p, max(pixel_angle * t, 1e-5 * BOX_SIZE)), 0.0)).xyz);
    ALBEDO = color.rgb;
    ROUGHNESS = finish.x;
    METALLIC = finish.y;
    EMISSION = finish.z * color.rgb;
}
