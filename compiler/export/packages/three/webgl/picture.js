{{ about }}

import { BufferGeometry, Float32BufferAttribute, Mesh, ShaderMaterial } from "three";
import { defaults } from "../scene.js";

/**
 * The scene under its own lights, sky and floor, as `chiaro render --one-pass` draws it: it fills the view, and takes part in
 * the depth test. three.js's lights and shadows have no part in it.
 */
export class {{ type_name }}Picture extends Mesh {
    constructor() {
        const parameters = defaults();
        const corners = new Float32BufferAttribute([-1, -1, 0, 3, -1, 0, -1, 3, 0], 3);
        const material = new ShaderMaterial({
            uniforms: { parameters: { value: parameters } },
            vertexShader: VERTEX,
            fragmentShader: `${SCENE}\n${FRAGMENT}`,
            toneMapped: false,
        });
        super(new BufferGeometry().setAttribute("position", corners), material);

        /** The live numbers. */
        this.parameters = parameters;
        this.frustumCulled = false;
    }
{% include "three/time.js" %}

    copy(source, recursive) {
        // The material is shared, and the live numbers with it.
        return Object.assign(super.copy(source, recursive), { parameters: source.parameters });
    }

    dispose() {
        this.geometry.dispose();
        this.material.dispose();
    }
}

/** The ray through a corner of the view, from the camera's plane on, in the scene's own space. */
const VERTEX = /* glsl */ `
varying vec2 place;
varying vec3 viewDirection;
varying vec3 rayOrigin;
varying vec3 rayDirection;
#include <common>

void main() {
    place = position.xy;
    gl_Position = vec4(place, 0.0, 1.0);
    mat4 toScene = inverse(modelViewMatrix);
    vec4 onView = inverse(projectionMatrix) * vec4(place, 0.5, 1.0);
    vec3 point = onView.xyz / onView.w;
    bool isPerspective = isPerspectiveMatrix(projectionMatrix);
    rayOrigin = (toScene * vec4(isPerspective ? vec3(0.0) : vec3(point.xy, 0.0), 1.0)).xyz;
    viewDirection = isPerspective ? point / -point.z : vec3(0.0, 0.0, -1.0);
    rayDirection = mat3(toScene) * viewDirection;
}
`;

const FRAGMENT = /* glsl */ `
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
    uniform float logDepthBufFC;
#endif
varying vec2 place;
varying vec3 viewDirection;
varying vec3 rayOrigin;
varying vec3 rayDirection;
#include <common>

void main() {
    // Of one pixel: its sides in the view, which goes from -1 to 1, and the angle between it and the next.
    vec2 pixel = vec2(dFdx(place.x), dFdy(place.y));
    vec3 originX = dFdx(rayOrigin);
    vec3 originY = dFdy(rayOrigin);
    vec3 directionX = dFdx(rayDirection);
    vec3 directionY = dFdy(rayDirection);
    float pixelAngle = length(dFdy(viewDirection));

    vec3 sum = vec3(0.0);
    vec3 nearest = rayOrigin + FAR * rayDirection;
    float least = FAR;
    for (int i = 0; i < RAYS; i++) {
        vec2 offset = ray_offset(i);
        vec3 o = rayOrigin + offset.x * originX + offset.y * originY;
        vec3 w = normalize(rayDirection + offset.x * directionX + offset.y * directionY);
        // From the centre, to the right and upwards; the corners are at 1.
        vec2 at = (place + offset * pixel) / pixel / length(1.0 / pixel);
        OnePass seen = one_pass(o, w, pixelAngle, at, i);
        sum += seen.color;
        if (seen.t >= 0.0 && seen.t < least) {
            least = seen.t;
            nearest = o + seen.t * w;
        }
    }
    gl_FragColor = vec4(shown(sum / float(RAYS)), 1.0);
    #include <colorspace_fragment>

    vec4 clip = projectionMatrix * modelViewMatrix * vec4(nearest, 1.0);
    float depth = clip.z / clip.w;
    #ifndef USE_REVERSED_DEPTH_BUFFER
        depth = 0.5 * depth + 0.5;
    #endif
    #ifdef USE_LOGARITHMIC_DEPTH_BUFFER
        if (isPerspectiveMatrix(projectionMatrix)) depth = log2(1.0 + clip.w) * logDepthBufFC * 0.5;
    #endif
    gl_FragDepth = clamp(depth, 0.0, 1.0);
}
`;

/** The scene and its light. */
const SCENE = /* glsl */ `
{% if parameters %}
{% include "three/webgl/parameters.glsl" %}
{% endif %}
{{ code | template_literal }}
`;
