{{ about }}
//
// `corner` is the vertex function of three vertices without buffers, `pixel` the fragment function.

#include <metal_stdlib>
using namespace metal;

struct View {
    float2 resolution; // the picture's size in pixels
    float2 turn; // how far the view is turned, to the left and upwards, in radians; normally 0
    float zoom; // how many times as far away as in the scene's own view; normally 1
    int rays; // how many rays a pixel has: 4, or 1
};

{% if parameters %}
struct Parameters {
{% for parameter in parameters %}
    float {{ parameter.name }}; // {{ parameter.text }}
{% endfor %}
};

{% endif %}
{{ code }}

struct Corner {
    float4 position [[position]];
};

vertex Corner corner(uint index [[vertex_id]]) {
    return Corner{float4(index == 1 ? 3.0 : -1.0, index == 2 ? 3.0 : -1.0, 0.0, 1.0)};
}

fragment float4 pixel(Corner at [[stage_in]], constant View& view [[buffer(0)]]{% if parameters %}, constant Parameters& parameters [[buffer(1)]]{% endif %}) {
    Camera camera = orbiting_camera(view.turn, view.zoom, view.resolution.x / view.resolution.y);
    float2 from_below = float2(at.position.x, view.resolution.y - at.position.y);
    return float4(picture({% if parameters %}parameters, {% endif %}from_below, view.resolution, camera, view.rays).rgb, 1.0);
}
