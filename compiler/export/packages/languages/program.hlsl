{{ about }}
//
// Shader model 5 or later: `corner` is the vertex shader of three vertices without buffers, `pixel` the pixel shader.

cbuffer View : register(b0) {
    float2 resolution; // the picture's size in pixels
    float2 turn; // how far the view is turned, to the left and upwards, in radians; normally 0
    float zoom; // how many times as far away as in the scene's own view; normally 1
    int rays; // how many rays a pixel has: 4, or 1
};

{% if parameters %}
cbuffer Parameters : register(b1) {
{% for parameter in parameters %}
    float {{ parameter.name }}; // {{ parameter.text }}
{% endfor %}
};

{% endif %}
{{ code }}

float4 corner(uint index : SV_VertexID) : SV_Position {
    return float4(index == 1 ? 3.0 : -1.0, index == 2 ? 3.0 : -1.0, 0.0, 1.0);
}

float4 pixel(float4 position : SV_Position) : SV_Target {
    Camera camera = orbiting_camera(turn, zoom, resolution.x / resolution.y);
    float2 point_from_below = float2(position.x, resolution.y - position.y);
    return float4(picture(point_from_below, resolution, camera, rays).rgb, 1.0);
}
