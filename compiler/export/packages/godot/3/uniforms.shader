{% for parameter in parameters %}
{% if parameter.is_time %}
uniform bool {{ parameter.name }}_runs = true; // or else {{ parameter.name }} is where it is put
uniform float {{ parameter.name }} : hint_range({{ parameter.min | float }}, {{ parameter.max | float }}, {{ parameter.step | float }}) = {{ parameter.default | float }};
{% else %}
uniform float {{ parameter.name }} : hint_range({{ parameter.min | float }}, {{ parameter.max | float }}, {{ parameter.step | float }}) = {{ parameter.default | float }}; // {{ parameter.text }}
{% endif %}
{% endfor %}
{% for parameter in parameters if parameter.is_time %}
varying float {{ parameter.name }}_now; // {{ parameter.text }}
{% endfor %}
{% if parameters %}

{% endif %}
