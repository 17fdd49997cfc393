{% block import %}{% endblock %}
import { Parameters } from "../scene.js";

/** The scene as a mesh: a box, in each pixel of which a ray looks for the scene's surface. */
export class {{ type_name }}Solid extends Mesh<BoxGeometry, {% block material %}{% endblock %}> {
    /** The live numbers. */
    parameters: Parameters;
{% for parameter in parameters if parameter.is_time %}
    /** In how many seconds `parameters.{{ parameter.name }}` goes from 0 to 1; 0 leaves it as it is. */
    period: number;
{% endfor %}
    dispose(): void;
}
