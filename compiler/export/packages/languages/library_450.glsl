{{ about }}
//
// scene_distance(p), scene_gradient(p, h) and scene_surface(p) are what to call; h is how far around p to ask, such as 0.001 of
// the size of what is seen. Include this below #version. It is for Vulkan and for OpenGL 4.5.

{% if parameters %}
// Where the live numbers are bound. Define PARAMETERS_PLACE for another place, such as `set = 1, binding = 2` in Vulkan.
#ifndef PARAMETERS_PLACE
#define PARAMETERS_PLACE binding = 0
#endif

layout(std140, PARAMETERS_PLACE) uniform Parameters {
{% for parameter in parameters %}
    float {{ parameter.name }}; // {{ parameter.text }}
{% endfor %}
};

{% endif %}
{{ code }}
