{{ about }}
//
// scene_distance(p), scene_gradient(p, h) and scene_surface(p) are what to call; h is how far around p to ask, such as 0.001 of
// the size of what is seen. Include this below #version and, in GLSL ES, the default precision of floats.

{% for parameter in parameters %}
uniform float {{ parameter.name }}; // {{ parameter.text }}
{% endfor %}

{{ code }}
