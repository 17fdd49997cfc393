struct Parameters {
{% for parameter in parameters %}
    {{ parameter.name }}: f32, // {{ parameter.text | template_literal }}
{% endfor %}
}

var<private> parameters: Parameters;

