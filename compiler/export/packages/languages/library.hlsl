{{ about }}
//
// scene_distance(p), scene_gradient(p, h) and scene_surface(p) are what to call; h is how far around p to ask, such as 0.001 of
// the size of what is seen. Matrices stand by their rows and are multiplied from the right: mul(p, m).

{% if parameters %}
cbuffer Parameters {
{% for parameter in parameters %}
    float {{ parameter.name }}; // {{ parameter.text }}
{% endfor %}
};

{% endif %}
{{ code }}
