struct Parameters {
{% for parameter in parameters %}
    float {{ parameter.name }}; // {{ parameter.text | template_literal }}
{% endfor %}
};

uniform Parameters parameters;

