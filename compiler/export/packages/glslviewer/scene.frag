#version 330
{{ about }}
//
// glslViewer scene.frag -w 960 -h 720. Drag to turn the scene.{% if parameters %} Type {{ parameters[0].name }},{{ parameters[0].max }} to move a live number.{% endif %}

uniform vec2 u_resolution;
uniform vec2 u_mouse;
uniform float u_time;
{% for parameter in parameters %}
{% if parameter.is_time %}
#define {{ parameter.name }} fract(u_time / 8.0) // {{ parameter.text }}
{% else %}
uniform float u_{{ parameter.name }}; // {{ parameter.text }}
#define {{ parameter.name }} (u_{{ parameter.name }} == 0.0 ? {{ parameter.default | float }} : u_{{ parameter.name }})
{% endif %}
{% endfor %}

out vec4 fragColor;

{{ code }}

void main() {
    vec2 turn = u_mouse == vec2(0.0) ? vec2(0.0) : (u_mouse / u_resolution - 0.5) * vec2(-6.0, -3.0);
    Camera camera = orbiting_camera(turn, 1.0, u_resolution.x / u_resolution.y);
    fragColor = vec4(picture(gl_FragCoord.xy, u_resolution, camera, 4).rgb, 1.0);
}
