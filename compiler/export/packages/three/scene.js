// What the scene "{{ title }}" has in all its forms: live numbers, and its own view.

/** What is known of the live numbers: what they are called, from where to where they go, and by which steps. */
export const PARAMETERS = {{ parameters | tojson(indent=4) }};

/** The live numbers as they are by default. */
export function defaults() {
    return Object.fromEntries(PARAMETERS.map((parameter) => [parameter.name, parameter.default]));
}

/** The box that the scene is in: millimetres, z is up. */
export const BOX = {
    min: {{ box_min | tojson }},
    max: {{ box_max | tojson }},
};

/** The scene's own view, in its own space; the field of view is vertical, in degrees. */
export const VIEW = {
    eye: {{ eye | tojson }},
    target: {{ target | tojson }},
    up: {{ up | tojson }},
    fieldOfView: {{ field_of_view }},
    aspect: {{ aspect }},
};
