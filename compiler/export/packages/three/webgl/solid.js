{{ about }}

import { BackSide, BoxGeometry, Mesh, MeshDepthMaterial, MeshDistanceMaterial, MeshPhysicalMaterial, ShaderChunk } from "three";
import { BOX, defaults } from "../scene.js";

/**
 * The scene as a mesh: a box, in each pixel of which a ray looks for the scene's surface. Lights, environments, fog and shadows
 * are three.js's own.
 */
export class {{ type_name }}Solid extends Mesh {
    constructor() {
        const size = BOX.max.map((most, axis) => most - BOX.min[axis]);
        const center = BOX.max.map((most, axis) => (most + BOX.min[axis]) / 2);
        // Like textures, the scene's colours, roughness, metalness and emission are multiplied by the material's.
        const material = new MeshPhysicalMaterial({ roughness: 1, metalness: 1, emissive: "white", side: BackSide, shadowSide: BackSide });
        super(new BoxGeometry(...size).translate(...center), material);

        /** The live numbers. */
        this.parameters = defaults();
        this.customDepthMaterial = traced(new MeshDepthMaterial(), this.parameters);
        this.customDistanceMaterial = traced(new MeshDistanceMaterial(), this.parameters);
        traced(this.material, this.parameters);
        this.castShadow = true;
        this.receiveShadow = true;
    }
{% include "three/time.js" %}

    copy(source, recursive) {
        // Materials are shared, and the live numbers with them.
        const { parameters, customDepthMaterial, customDistanceMaterial } = source;
        return Object.assign(super.copy(source, recursive), { parameters, customDepthMaterial, customDistanceMaterial });
    }

    dispose() {
        for (const part of [this.geometry, this.material, this.customDepthMaterial, this.customDistanceMaterial]) part.dispose();
    }
}

/**
 * Lets a material of three.js shade the scene's surface in the place of the box's.
 *
 * What its vertex shader says of a vertex, the fragment shader says of the point that the ray meets: the vertex shader's main
 * function moves there, and varyings become variables that it sets.
 */
function traced(material, parameters) {
    material.customProgramCacheKey = () => SCENE;
    material.onBeforeCompile = (shader) => {
        shader.uniforms.parameters = { value: parameters };

        const vertex = shader.vertexShader;
        const body = vertex.slice(vertex.indexOf("void main() {") + "void main() {".length, vertex.lastIndexOf("}"));
        const atPoint = body
            .replace("#include <begin_vertex>", "vec3 transformed = point;")
            .replace("#include <beginnormal_vertex>", "vec3 objectNormal = normal;");
        shader.vertexShader = vertex
            .replace("void main() {", "varying vec3 rayOrigin;\nvarying vec3 rayDirection;\n\nvoid main() {")
            .replace("#include <project_vertex>", `#include <project_vertex>\n${RAY}`);

        const [declarations, main] = shader.fragmentShader.split("void main() {");
        const variables = expanded(declarations).replace(/\bvarying (?=\w+ v[A-Z])/g, "");
        const moved = expanded(atPoint).replaceAll("gl_Position", "clipPosition");
        const shaded = main
            .replace("#include <logdepthbuf_fragment>", "")
            .replace("#include <color_fragment>", "#include <color_fragment>\n    diffuseColor *= surface.color;")
            .replace("#include <roughnessmap_fragment>", "#include <roughnessmap_fragment>\n    roughnessFactor *= surface.finish.x;")
            .replace("#include <metalnessmap_fragment>", "#include <metalnessmap_fragment>\n    metalnessFactor *= surface.finish.y;")
            .replace("#include <emissivemap_fragment>", "#include <emissivemap_fragment>\n    totalEmissiveRadiance *= surface.color.rgb * surface.finish.z;");
        shader.fragmentShader =
            `${SCENE}\n${variables}\n${PLACED}\nvoid moveTo(vec3 point, vec3 normal) {\n${moved}}\n\nvoid main() {\n${HIT}\n${shaded}`;
    };
    return material;
}

/** A text with its includes filled in. */
function expanded(text) {
    return text.replace(/^[ \t]*#include <(\w+)>/gm, (_, name) => expanded(ShaderChunk[name]));
}

/** The ray through a vertex of the box, from the camera's plane on, in the scene's own space. */
const RAY = /* glsl */ `
    mat4 toScene = inverse(modelViewMatrix);
    bool isPerspective = isPerspectiveMatrix(projectionMatrix);
    rayOrigin = (toScene * vec4(isPerspective ? vec3(0.0) : vec3(mvPosition.xy, 0.0), 1.0)).xyz;
    rayDirection = isPerspective ? transformed - rayOrigin : -toScene[2].xyz;
`;

/** What the moved vertex shader reads and writes beside the fragment shader's own variables. */
const PLACED = /* glsl */ `
#undef FLIP_SIDED
#ifndef HAS_NORMAL
    #define HAS_NORMAL
#endif

uniform mat4 modelMatrix;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform mat3 normalMatrix;
#if NUM_SPOT_LIGHT_COORDS > 0
    uniform mat4 spotLightMatrix[NUM_SPOT_LIGHT_COORDS];
#endif
#if defined(USE_SHADOWMAP) && NUM_DIR_LIGHT_SHADOWS > 0
    uniform mat4 directionalShadowMatrix[NUM_DIR_LIGHT_SHADOWS];
#endif
#if defined(USE_SHADOWMAP) && NUM_POINT_LIGHT_SHADOWS > 0
    uniform mat4 pointShadowMatrix[NUM_POINT_LIGHT_SHADOWS];
#endif

varying vec3 rayOrigin;
varying vec3 rayDirection;

vec4 clipPosition;
`;

/** Goes to where the ray meets the scene, before all else of the fragment shader. */
const HIT = /* glsl */ `
    vec3 rayUnit = normalize(rayDirection);
    // Points nearer to each other than this are one: a millionth of the scene's size, and a tenth of a pixel.
    float near = 1e-6 * length(SCENE_MAX - SCENE_MIN) + 0.1 * length(dFdx(rayOrigin));
    float growth = 0.1 * length(dFdx(rayUnit));
    float t = scene_hit(rayOrigin, rayUnit, 0.0, 1e30, near, growth);
    if (t < 0.0) discard;
    vec3 point = rayOrigin + t * rayUnit;
    Surface surface = scene_surface(point);
    moveTo(point, scene_normal(point, max(2.0 * (near + growth * t), 16e-6 * length(SCENE_MAX - SCENE_MIN))));

    gl_FragDepth = clipPosition.z / clipPosition.w;
    #ifndef USE_REVERSED_DEPTH_BUFFER
        gl_FragDepth = 0.5 * gl_FragDepth + 0.5;
    #endif
    #if defined(USE_LOGARITHMIC_DEPTH_BUFFER) && !defined(DISTANCE)
        if (vIsPerspective != 0.0) gl_FragDepth = log2(vFragDepth) * logDepthBufFC * 0.5;
    #endif
`;

/** Distances and surfaces of the scene. */
const SCENE = /* glsl */ `
{% if parameters %}
{% include "three/webgl/parameters.glsl" %}
{% endif %}
{{ code | template_literal }}
`;
