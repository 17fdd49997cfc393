{{ about }}
//
// A fragment shader: draw a triangle that covers the picture.

uniform vec2 resolution; // the picture's size in pixels
uniform vec2 turn; // how far the view is turned, to the left and upwards, in radians; normally 0
uniform float zoom; // how many times as far away as in the scene's own view; normally 1, and 0 counts as 1
uniform int rays; // how many rays a pixel has: 4, or 1
{% for parameter in parameters %}
uniform float {{ parameter.name }}; // {{ parameter.text }}
{% endfor %}

out vec4 fragment_color;

{{ code }}

void main() {
    Camera camera = orbiting_camera(turn, zoom > 0.0 ? zoom : 1.0, resolution.x / resolution.y);
    fragment_color = vec4(picture(gl_FragCoord.xy, resolution, camera, max(rays, 1)).rgb, 1.0);
}
