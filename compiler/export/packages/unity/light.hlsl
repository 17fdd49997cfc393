// The light of Unity's built-in pipeline on {{ title }}, as its standard shader has it.

#ifndef {{ name | upper }}_LIGHT_INCLUDED
#define {{ name | upper }}_LIGHT_INCLUDED

#include "UnityPBSLighting.cginc"
#include "AutoLight.cginc"

/// What Unity's macros of shadows read.
struct Shadowed {
    float4 pos;
    UNITY_SHADOW_COORDS(0)
};

struct CasterVertex {
    float4 vertex;
};

/// How much of the light of this pass gets to a point.
float LightAttenuation(SceneHit hit) {
    CasterVertex v;
    v.vertex = float4(hit.positionOS, 1.0);
    Shadowed shadowed = (Shadowed)0;
    shadowed.pos = hit.positionCS;
    UNITY_TRANSFER_SHADOW(shadowed, float2(0.0, 0.0));
    UNITY_LIGHT_ATTENUATION(attenuation, shadowed, hit.positionWS);
    return attenuation;
}

/// What the surface sends to the eye of the light of this pass, and of what is all around if the pass is the first.
half3 LitColor(SceneHit hit, Surface surface, bool withSurroundings) {
    float3 toEye = normalize(_WorldSpaceCameraPos - hit.positionWS);
    half oneMinusReflectivity;
    half3 specular;
    half3 albedo = DiffuseAndSpecularFromMetallic(surface.color.rgb, surface.finish.y, specular, oneMinusReflectivity);
    half smoothness = 1.0 - surface.finish.x;

    UnityLight light;
    light.color = _LightColor0.rgb * LightAttenuation(hit);
    light.dir = normalize(_WorldSpaceLightPos0.xyz - _WorldSpaceLightPos0.w * hit.positionWS);
    light.ndotl = saturate(dot(hit.normalWS, light.dir));

    UnityIndirect indirect;
    indirect.diffuse = 0.0;
    indirect.specular = 0.0;
    if (withSurroundings) {
        indirect.diffuse = ShadeSHPerPixel(hit.normalWS, 0.0, hit.positionWS);
        Unity_GlossyEnvironmentData gloss = UnityGlossyEnvironmentSetup(smoothness, toEye, hit.normalWS, specular);
        indirect.specular = Unity_GlossyEnvironment(UNITY_PASS_TEXCUBE(unity_SpecCube0), unity_SpecCube0_HDR, gloss);
    }
    return UNITY_BRDF_PBS(albedo, specular, oneMinusReflectivity, smoothness, hit.normalWS, toEye, light, indirect).rgb;
}

#endif
