{{ about }}
//
// scene_distance(p), scene_gradient(p, h) and scene_surface(p) are what to call; h is how far around p to ask, such as 0.001 of
// the size of what is seen.{% if parameters %} What depends on live numbers gets them as its first argument.{% endif %}


#include <metal_stdlib>
using namespace metal;

{% if parameters %}
struct Parameters {
{% for parameter in parameters %}
    float {{ parameter.name }}; // {{ parameter.text }}
{% endfor %}
};

{% endif %}
{{ code }}
