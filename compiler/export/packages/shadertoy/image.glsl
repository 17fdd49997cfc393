{{ about }}
//
// Paste this into the Image tab of a new shader on shadertoy.com. Drag to turn the scene.

/// Rays a pixel; 4 is smooth, 1 is fast.
const int PIXEL_RAYS = 4;

{% for parameter in parameters %}
{% if parameter.is_time %}
#define {{ parameter.name }} fract(iTime / 8.0) // {{ parameter.text }}
{% else %}
const float {{ parameter.name }} = {{ parameter.default | float }}; // {{ parameter.text }}
{% endif %}
{% endfor %}

{{ code }}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 turn = iMouse.z == 0.0 ? vec2(0.0) : (iMouse.xy / iResolution.xy - 0.5) * vec2(-6.0, -3.0);
    Camera camera = orbiting_camera(turn, 1.0, iResolution.x / iResolution.y);
    fragColor = vec4(picture(fragCoord, iResolution.xy, camera, PIXEL_RAYS).rgb, 1.0);
}
