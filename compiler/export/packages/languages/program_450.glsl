{{ about }}
//
// A fragment shader for Vulkan and for OpenGL 4.5: draw a triangle that covers the picture. In Vulkan its blocks are in
// descriptor set 0.

layout(std140, binding = 0) uniform View {
    vec2 resolution; // the picture's size in pixels
    vec2 turn; // how far the view is turned, to the left and upwards, in radians; normally 0
    float zoom; // how many times as far away as in the scene's own view; normally 1, and 0 counts as 1
    int rays; // how many rays a pixel has: 4, or 1
};

{% if parameters %}
layout(std140, binding = 1) uniform Parameters {
{% for parameter in parameters %}
    float {{ parameter.name }}; // {{ parameter.text }}
{% endfor %}
};

{% endif %}
layout(location = 0) out vec4 fragment_color;

{{ code }}

void main() {
    Camera camera = orbiting_camera(turn, zoom > 0.0 ? zoom : 1.0, resolution.x / resolution.y);
    vec2 point_from_below = gl_FragCoord.xy;
#ifdef VULKAN
    point_from_below.y = resolution.y - point_from_below.y;
#endif
    fragment_color = vec4(picture(point_from_below, resolution, camera, max(rays, 1)).rgb, 1.0);
}
