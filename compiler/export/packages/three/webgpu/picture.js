{{ about }}

import { BufferGeometry, Float32BufferAttribute, Mesh } from "three";
import {
    Fn, cameraFar, cameraNear, cameraProjectionMatrix, cameraProjectionMatrixInverse, modelViewMatrix, positionGeometry, uniform,
    vec4, viewZToLogarithmicDepth, wgsl, wgslFn,
} from "three/tsl";
import { NodeMaterial } from "three/webgpu";
import { PARAMETERS, defaults } from "../scene.js";

/**
 * The scene under its own lights, sky and floor, as `chiaro render --one-pass` draws it: it fills the view, and takes part in
 * the depth test. three.js's lights and shadows have no part in it.
 */
export class {{ type_name }}Picture extends Mesh {
    constructor() {
        const corners = new Float32BufferAttribute([-1, -1, 0, 3, -1, 0, -1, 3, 0], 3);
        super(new BufferGeometry().setAttribute("position", corners), pictured());

        /** The live numbers. */
        this.parameters = defaults();
        this.frustumCulled = false;
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

/** A material that shows the picture. */
function pictured() {
    const live = PARAMETERS.map(({ name }) => uniform(0).onObjectUpdate(({ object }) => object.parameters[name]));
    const place = positionGeometry.xy;
    const seen = scenePicture(place, modelViewMatrix, modelViewMatrix.inverse(), cameraProjectionMatrix, cameraProjectionMatrixInverse, ...live).toVar("scenePicture");

    const material = new NodeMaterial();
    material.vertexNode = vec4(place, 0, 1);
    material.depthNode = depthOf(seen.w);
    material.fragmentNode = vec4(seen.rgb, 1);
    return material;
}

{% include "three/webgpu/depth.js" %}

/** The scene and its light. */
const scene = wgsl(/* wgsl */ `
{% if parameters %}
{% include "three/webgpu/parameters.wgsl" %}
{% endif %}
{{ code | template_literal }}
`);

/** What a pixel shows, linear; w: the camera's z of its nearest surface. place: where it is in the view, which goes from -1 to 1. */
const scenePicture = wgslFn(/* wgsl */ `
fn scene_picture(place: vec2<f32>, to_view: mat4x4<f32>, to_scene: mat4x4<f32>, projection: mat4x4<f32>, from_projection: mat4x4<f32>{% for parameter in parameters %}, live_{{ parameter.name }}: f32{% endfor %}) -> vec4<f32> {
{% if parameters %}
    parameters = Parameters({% for parameter in parameters %}live_{{ parameter.name }}{% if not loop.last %}, {% endif %}{% endfor %});
{% endif %}
    let is_perspective = projection[2][3] == -1.0;
    let on_view = from_projection * vec4<f32>(place, 0.5, 1.0);
    let in_view = on_view.xyz / on_view.w;
    let origin = (to_scene * vec4<f32>(select(vec3<f32>(in_view.xy, 0.0), vec3<f32>(0.0), is_perspective), 1.0)).xyz;
    let forward = select(vec3<f32>(0.0, 0.0, -1.0), in_view / -in_view.z, is_perspective);
    let direction = (to_scene * vec4<f32>(forward, 0.0)).xyz;
    // Of one pixel: its sides in the view, and the angle between it and the next. Rows of pixels go downwards.
    let pixel = vec2<f32>(dpdx(place.x), -dpdy(place.y));
    let pixel_angle = length(dpdy(forward));
    let origin_sides = array<vec3<f32>, 2>(dpdx(origin), -dpdy(origin));
    let direction_sides = array<vec3<f32>, 2>(dpdx(direction), -dpdy(direction));

    var sum = vec3<f32>(0.0);
    var least = FAR;
    var nearest = origin + FAR * direction;
    for (var i = 0; i < RAYS; i++) {
        let offset = ray_offset(i);
        let o = origin + offset.x * origin_sides[0] + offset.y * origin_sides[1];
        let w = normalize(direction + offset.x * direction_sides[0] + offset.y * direction_sides[1]);
        // From the centre, to the right and upwards; the corners are at 1.
        let at = (place + offset * pixel) / pixel / length(1.0 / pixel);
        let seen = one_pass(o, w, pixel_angle, at, i);
        sum += seen.color;
        if seen.t >= 0.0 && seen.t < least {
            least = seen.t;
            nearest = o + seen.t * w;
        }
    }
    return vec4<f32>(shown(sum / f32(RAYS)), (to_view * vec4<f32>(nearest, 1.0)).z);
}
`, [scene]);
