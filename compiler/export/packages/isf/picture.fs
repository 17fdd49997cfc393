/*{
    "ISFVSN": "2",
    "DESCRIPTION": {{ (title ~ ", a scene written by Chiaro " ~ version) | tojson }},
    "CREDIT": "The scene's author; Chiaro's part is CC0 1.0",
    "CATEGORIES": ["Generator"],
    "INPUTS": [
        { "NAME": "turn", "TYPE": "point2D", "LABEL": "Turned to the left and upwards, in radians", "DEFAULT": [0, 0], "MIN": [-3.1416, -1.5], "MAX": [3.1416, 1.5] },
        { "NAME": "zoom", "TYPE": "float", "LABEL": "How many times as far away", "DEFAULT": 1, "MIN": 0.2, "MAX": 5 },
{% for parameter in parameters if not parameter.is_time %}
        { "NAME": {{ parameter.name | tojson }}, "TYPE": "float", "LABEL": {{ parameter.label | tojson }}, "DEFAULT": {{ parameter.default }}, "MIN": {{ parameter.min }}, "MAX": {{ parameter.max }} },
{% endfor %}
        { "NAME": "rays", "TYPE": "long", "LABEL": "Rays a pixel", "VALUES": [1, 4], "LABELS": ["1", "4"], "DEFAULT": 4 }
    ]
}*/

{{ about }}
//
// An ISF generator (isf.video), for hosts that have GLSL 1.50 or later.

{% for parameter in parameters if parameter.is_time %}
#define {{ parameter.name }} fract(TIME / 8.0) // {{ parameter.text }}
{% endfor %}

{{ code }}

void main() {
    Camera camera = orbiting_camera(turn, zoom, RENDERSIZE.x / RENDERSIZE.y);
    gl_FragColor = vec4(picture(gl_FragCoord.xy, RENDERSIZE, camera, rays).rgb, 1.0);
}
