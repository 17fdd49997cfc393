/** What is known of a live number. */
export interface Parameter {
    /** Its name in `parameters`. */
    name: keyof Parameters;
    /** What the scene calls it. */
    label: string;
    /** What it is, and from where to where it goes. */
    text: string;
    default: number;
    min: number;
    max: number;
    step: number;
    /** Whether it is the scene's time, which goes from 0 to 1 again and again. */
    is_time: boolean;
}

/** Values of the live numbers. */
export interface Parameters {
{% for parameter in parameters %}
    /** {{ parameter.text }} */
    {{ parameter.name }}: number;
{% endfor %}
}

export const PARAMETERS: readonly Parameter[];

/** The live numbers as they are by default. */
export function defaults(): Parameters;

/** The box that the scene is in: millimetres, z is up. */
export const BOX: { min: [number, number, number]; max: [number, number, number] };

/** The scene's own view, in its own space; the field of view is vertical, in degrees. */
export const VIEW: {
    eye: [number, number, number];
    target: [number, number, number];
    up: [number, number, number];
    fieldOfView: number;
    aspect: number;
};
