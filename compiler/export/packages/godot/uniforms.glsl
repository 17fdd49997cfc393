{% for parameter in parameters %}
{% if parameter.is_time %}
uniform bool {{ parameter.name }}_runs = true; // or else {{ parameter.name }} is where it is put
uniform float {{ parameter.name }} : hint_range({{ parameter.min | float }}, {{ parameter.max | float }}, {{ parameter.step | float }}) = {{ parameter.default | float }};
{% else %}
uniform float {{ parameter.name }} : hint_range({{ parameter.min | float }}, {{ parameter.max | float }}, {{ parameter.step | float }}) = {{ parameter.default | float }}; // {{ parameter.text }}
{% endif %}
{% endfor %}
{% for parameter in parameters if parameter.is_time %}

// {{ parameter.text }}
float {{ parameter.name }}_now() {
    return {{ parameter.name }}_runs ? fract(TIME / 8.0) : {{ parameter.name }};
}
{% endfor %}
{% if parameters %}

{% endif %}
