import { Mesh } from "three";
import { Parameters } from "../scene.js";

/** The scene under its own lights, sky and floor, as `chiaro render --one-pass` draws it. */
export class {{ type_name }}Picture extends Mesh {
    /** The live numbers. */
    parameters: Parameters;
{% for parameter in parameters if parameter.is_time %}
    /** In how many seconds `parameters.{{ parameter.name }}` goes from 0 to 1; 0 leaves it as it is. */
    period: number;
{% endfor %}
    dispose(): void;
}
