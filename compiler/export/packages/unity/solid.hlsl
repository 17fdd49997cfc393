{{ about }}
//
// Unity: metres, y up. scene_distance(p), scene_gradient(p, h) and scene_surface(p) take points of the scene, in millimetres with z up:
// ScenePoint makes one of a point of the object. The shader that includes this declares the live numbers.

#ifndef {{ name | upper }}_INCLUDED
#define {{ name | upper }}_INCLUDED

{{ code }}

/// A point of the object, in metres, as the scene has it.
float3 ScenePoint(float3 positionOS) {
    return 1000.0 * positionOS.xzy;
}

/// What a pass meets.
struct SceneHit {
    float3 positionOS;
    float3 positionWS;
    float3 normalWS;
    float4 positionCS;
    /// The same in the scene, in millimetres.
    float3 position;
};

/// Where the ray through a point of the box meets the scene, from the eye or from the light whose shadows are drawn. Pixels that
/// miss it are discarded. Draw the box's back faces, so that the eye may be within it.
SceneHit MeetScene(float3 positionWS) {
    // The matrices tell both kinds of eyes apart; what Unity tells of cameras isn't set while shadows are drawn.
    bool isOrthographic = UNITY_MATRIX_P._m33 == 1.0;
    float3 eye = -mul(UNITY_MATRIX_V._m03_m13_m23, (float3x3)UNITY_MATRIX_V);
    float3 direction = isOrthographic ? -UNITY_MATRIX_V[2].xyz : positionWS - eye;
    float3 origin = isOrthographic ? positionWS : eye;

    float3 o = ScenePoint(mul(unity_WorldToObject, float4(origin, 1.0)).xyz);
    float3 w = normalize(ScenePoint(mul((float3x3)unity_WorldToObject, direction)));
    float size = length(SCENE_MAX - SCENE_MIN);
    float near = 1e-5 * size;
    float growth = isOrthographic ? 0.0 : 0.5 / abs(UNITY_MATRIX_P._m11 * _ScreenParams.y);
    float t = scene_hit(o, w, isOrthographic ? -2.0 * size : 0.0, 1e9, near, growth);
    if (t == -1.0) {
        discard;
    }

    SceneHit hit;
    hit.position = o + t * w;
    hit.positionOS = 0.001 * hit.position.xzy;
    hit.positionWS = mul(unity_ObjectToWorld, float4(hit.positionOS, 1.0)).xyz;
    float3 normal = scene_normal(hit.position, max(2.0 * (near + growth * abs(t)), 16.0 * near)).xzy;
    hit.normalWS = normalize(mul(normal, (float3x3)unity_WorldToObject));
    hit.positionCS = mul(UNITY_MATRIX_VP, float4(hit.positionWS, 1.0));
    return hit;
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
