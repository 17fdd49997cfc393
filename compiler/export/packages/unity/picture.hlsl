{{ about }}
//
// The scene as its own lights show it: one_pass(eye, direction, pixel angle, place, ray), and shown(radiance). Points are those of the scene, in
// millimetres with z up. The shader that includes this declares the live numbers.

#ifndef {{ name | upper }}_PICTURE_INCLUDED
#define {{ name | upper }}_PICTURE_INCLUDED

{{ code }}

/// A point of the object, in metres, as the scene has it.
float3 ScenePoint(float3 positionOS) {
    return 1000.0 * positionOS.xzy;
}

/// The depth of a point in the depth buffer.
float SceneDepth(float4 positionCS) {
#if defined(UNITY_REVERSED_Z)
    return positionCS.z / positionCS.w;
#else
    return 0.5 * positionCS.z / positionCS.w + 0.5;
#endif
}

#endif
