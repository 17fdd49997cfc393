{% for parameter in parameters if parameter.is_time %}

    /** In how many seconds `parameters.{{ parameter.name }}` goes from 0 to 1; 0 leaves it as it is. */
    period = 8;

    onBeforeRender() {
        if (this.period > 0) this.parameters.{{ parameter.name }} = (performance.now() / 1000 / this.period) % 1;
    }

    onBeforeShadow() {
        this.onBeforeRender();
    }
{% endfor %}
