{{ about }}

import { BackSide, BoxGeometry, Mesh } from "three";
import {
    Fn, cameraFar, cameraNear, cameraProjectionMatrix, materialColor, materialEmissive, materialMetalness, materialRoughness,
    modelViewMatrix, normalLocal, overrideNodes, positionGeometry, positionLocal, transformNormalToView, uniform, vec4,
    viewZToLogarithmicDepth, wgsl, wgslFn,
} from "three/tsl";
import { MeshPhysicalNodeMaterial } from "three/webgpu";
import { BOX, PARAMETERS, defaults } from "../scene.js";

/**
 * The scene as a mesh: a box, in each pixel of which a ray looks for the scene's surface. Lights, environments, fog and shadows
 * are three.js's own.
 */
export class {{ type_name }}Solid extends Mesh {
    constructor() {
        const size = BOX.max.map((most, axis) => most - BOX.min[axis]);
        const center = BOX.max.map((most, axis) => (most + BOX.min[axis]) / 2);
        super(new BoxGeometry(...size).translate(...center), traced());

        /** The live numbers. */
        this.parameters = defaults();
        this.castShadow = true;
        this.receiveShadow = true;
    }
{% include "three/time.js" %}

    copy(source, recursive) {
        return Object.assign(super.copy(source, recursive), { parameters: { ...source.parameters } });
    }

    dispose() {
        this.geometry.dispose();
        this.material.dispose();
    }
}

/** A material that shades the scene's surface in the place of the box's. */
function traced() {
    const live = PARAMETERS.map(({ name }) => uniform(0).onObjectUpdate(({ object }) => object.parameters[name]));
    // The box's own point stays the vertex shader's, whatever the context below says of positions.
    const onBox = positionGeometry.context({ inlineVaryings: false });
    const hit = sceneSeen(onBox, modelViewMatrix, modelViewMatrix.inverse(), cameraProjectionMatrix, ...live).toVar("sceneHit");
    const normal = sceneFacing(hit).toVar("sceneNormal");
    const color = sceneColor(hit.xyz).toVar("sceneColor");
    const finish = sceneFinish(hit.xyz).toVar("sceneFinish");

    // Like textures, the scene's colours, roughness, metalness and emission are multiplied by the material's.
    const material = new MeshPhysicalNodeMaterial({ roughness: 1, metalness: 1, emissive: "white", side: BackSide, shadowSide: BackSide });
    // Whatever three.js asks of the vertex, it is told of the point that the ray meets.
    material.contextNode = overrideNodes([[positionLocal, hit.xyz], [normalLocal, normal]], null, "fragment");
    material.maskNode = hit.w.greaterThan(0);
    material.depthNode = depthOf(modelViewMatrix.mul(vec4(hit.xyz, 1)).z);
    material.normalNode = transformNormalToView(normal);
    material.colorNode = color.mul(vec4(materialColor.rgb, 1));
    material.roughnessNode = finish.x.mul(materialRoughness);
    material.metalnessNode = finish.y.mul(materialMetalness);
    material.emissiveNode = color.rgb.mul(finish.z).mul(materialEmissive);
    return material;
}

{% include "three/webgpu/depth.js" %}

/** Distances and surfaces of the scene. */
const scene = wgsl(/* wgsl */ `
{% if parameters %}
{% include "three/webgpu/parameters.wgsl" %}
{% endif %}
{{ code | template_literal }}

// Points nearer to each other than this are one.
const SCENE_NEAR: f32 = 1e-6 * length(SCENE_MAX - SCENE_MIN);
`);

/** Where the ray through a point of the box meets the scene; w: what of its way is near, or 0 if it doesn't meet it. */
const sceneSeen = wgslFn(/* wgsl */ `
fn scene_seen(on_box: vec3<f32>, to_view: mat4x4<f32>, to_scene: mat4x4<f32>, projection: mat4x4<f32>{% for parameter in parameters %}, live_{{ parameter.name }}: f32{% endfor %}) -> vec4<f32> {
{% if parameters %}
    parameters = Parameters({% for parameter in parameters %}live_{{ parameter.name }}{% if not loop.last %}, {% endif %}{% endfor %});
{% endif %}
    let is_perspective = projection[2][3] == -1.0;
    let in_view = (to_view * vec4<f32>(on_box, 1.0)).xyz;
    let o = (to_scene * vec4<f32>(select(vec3<f32>(in_view.xy, 0.0), vec3<f32>(0.0), is_perspective), 1.0)).xyz;
    let w = normalize(select(-to_scene[2].xyz, on_box - o, is_perspective));
    let near = SCENE_NEAR + 0.1 * length(dpdx(o));
    let growth = 0.1 * length(dpdx(w));
    let t = scene_hit(o, w, 0.0, 1e30, near, growth);
    return vec4<f32>(o + t * w, select(0.0, near + growth * t, t >= 0.0));
}
`, [scene]);

const sceneFacing = wgslFn(/* wgsl */ `
fn scene_facing(hit: vec4<f32>) -> vec3<f32> {
    return scene_normal(hit.xyz, max(2.0 * hit.w, 16.0 * SCENE_NEAR));
}
`, [scene]);

const sceneColor = wgslFn(/* wgsl */ `
fn scene_color(p: vec3<f32>) -> vec4<f32> {
    return scene_surface(p).color;
}
`, [scene]);

const sceneFinish = wgslFn(/* wgsl */ `
fn scene_finish(p: vec3<f32>) -> vec4<f32> {
    return scene_surface(p).finish;
}
`, [scene]);
