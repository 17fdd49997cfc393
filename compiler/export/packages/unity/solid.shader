{{ about }}

// The scene as a solid that Unity lights: for the Universal Render Pipeline 12 or later, and for the built-in one.
Shader "Chiaro/{{ title }}" {
    Properties {
{% for parameter in parameters if not parameter.is_time %}
        _{{ parameter.name }} ("{{ parameter.label }}", Range({{ parameter.min }}, {{ parameter.max }})) = {{ parameter.default }}
{% endfor %}
    }

    SubShader {
        PackageRequirements { "com.unity.render-pipelines.universal": "12.0" }
        Tags { "RenderPipeline" = "UniversalPipeline" "RenderType" = "Opaque" "Queue" = "AlphaTest" "DisableBatching" = "True" }
        Cull Front

        HLSLINCLUDE
        #pragma target 4.5
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

        CBUFFER_START(UnityPerMaterial)
{% for parameter in parameters %}
        float _{{ parameter.name }}{{ "_unused" if parameter.is_time }};
{% else %}
        float _unused;
{% endfor %}
        CBUFFER_END
{% for parameter in parameters if parameter.is_time %}
        #define _{{ parameter.name }} frac(_Time.y / 8.0)
{% endfor %}

        #include "{{ name }}.hlsl"

        struct Corner {
            float4 positionCS : SV_POSITION;
            float3 positionWS : TEXCOORD0;
        };

        Corner BoxCorner(float4 positionOS : POSITION) {
            Corner corner;
            corner.positionWS = TransformObjectToWorld(positionOS.xyz);
            corner.positionCS = TransformWorldToHClip(corner.positionWS);
            return corner;
        }
        ENDHLSL

        Pass {
            Name "ForwardLit"
            Tags { "LightMode" = "UniversalForward" }

            HLSLPROGRAM
            #pragma vertex BoxCorner
            #pragma fragment Lit
            #pragma multi_compile _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_CASCADE _MAIN_LIGHT_SHADOWS_SCREEN
            #pragma multi_compile _ _ADDITIONAL_LIGHTS_VERTEX _ADDITIONAL_LIGHTS
            #pragma multi_compile _ _FORWARD_PLUS _CLUSTER_LIGHT_LOOP
            #pragma multi_compile_fragment _ _ADDITIONAL_LIGHT_SHADOWS
            #pragma multi_compile_fragment _ _SHADOWS_SOFT
            #pragma multi_compile_fragment _ _SCREEN_SPACE_OCCLUSION
            #pragma multi_compile_fog
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"

            half4 Lit(Corner corner, out float depth : SV_Depth) : SV_Target {
                SceneHit hit = MeetScene(corner.positionWS);
                depth = SceneDepth(hit.positionCS);
                Surface surface = scene_surface(hit.position);

                SurfaceData material = (SurfaceData)0;
                material.albedo = surface.color.rgb;
                material.metallic = surface.finish.y;
                material.smoothness = 1.0 - surface.finish.x;
                material.emission = surface.finish.z * surface.color.rgb;
                material.occlusion = 1.0;
                material.alpha = 1.0;
                material.normalTS = half3(0.0, 0.0, 1.0);

                InputData place = (InputData)0;
                place.positionWS = hit.positionWS;
                place.normalWS = hit.normalWS;
                place.viewDirectionWS = GetWorldSpaceNormalizeViewDir(hit.positionWS);
                place.shadowCoord = TransformWorldToShadowCoord(hit.positionWS);
#if defined(_MAIN_LIGHT_SHADOWS_SCREEN)
                place.shadowCoord = ComputeScreenPos(hit.positionCS);
#endif
                place.fogCoord = ComputeFogFactor(hit.positionCS.z);
                place.bakedGI = SampleSH(hit.normalWS);
                place.normalizedScreenSpaceUV = GetNormalizedScreenSpaceUV(corner.positionCS);
                place.shadowMask = half4(1.0, 1.0, 1.0, 1.0);

                half4 color = UniversalFragmentPBR(place, material);
                return half4(MixFog(color.rgb, place.fogCoord), 1.0);
            }
            ENDHLSL
        }

        Pass {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            ColorMask 0

            HLSLPROGRAM
            #pragma vertex BoxCorner
            #pragma fragment Shadow
            #pragma multi_compile _ _CASTING_PUNCTUAL_LIGHT_SHADOW
            #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonMaterial.hlsl"
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Shadows.hlsl"

            float3 _LightDirection;
            float3 _LightPosition;

            float Shadow(Corner corner) : SV_Depth {
                SceneHit hit = MeetScene(corner.positionWS);
#if defined(_CASTING_PUNCTUAL_LIGHT_SHADOW)
                float3 towardsLight = normalize(_LightPosition - hit.positionWS);
#else
                float3 towardsLight = _LightDirection;
#endif
                float4 biased = TransformWorldToHClip(ApplyShadowBias(hit.positionWS, hit.normalWS, towardsLight));
                return saturate(SceneDepth(biased));
            }
            ENDHLSL
        }

        Pass {
            Name "DepthOnly"
            Tags { "LightMode" = "DepthOnly" }
            ColorMask R

            HLSLPROGRAM
            #pragma vertex BoxCorner
            #pragma fragment Depth

            half4 Depth(Corner corner, out float depth : SV_Depth) : SV_Target {
                depth = SceneDepth(MeetScene(corner.positionWS).positionCS);
                return depth;
            }
            ENDHLSL
        }

        Pass {
            Name "DepthNormals"
            Tags { "LightMode" = "DepthNormals" }

            HLSLPROGRAM
            #pragma vertex BoxCorner
            #pragma fragment DepthNormals

            half4 DepthNormals(Corner corner, out float depth : SV_Depth) : SV_Target {
                SceneHit hit = MeetScene(corner.positionWS);
                depth = SceneDepth(hit.positionCS);
                return half4(hit.normalWS, 0.0);
            }
            ENDHLSL
        }
    }

    SubShader {
        Tags { "RenderType" = "Opaque" "Queue" = "AlphaTest" "DisableBatching" = "True" }
        Cull Front

        CGINCLUDE
        #pragma target 4.5
        #include "UnityCG.cginc"

{% for parameter in parameters %}
{% if parameter.is_time %}
        #define _{{ parameter.name }} frac(_Time.y / 8.0)
{% else %}
        float _{{ parameter.name }};
{% endif %}
{% endfor %}

        #include "{{ name }}.hlsl"

        struct Corner {
            float4 positionCS : SV_POSITION;
            float3 positionWS : TEXCOORD0;
        };

        Corner BoxCorner(float4 positionOS : POSITION) {
            Corner corner;
            corner.positionWS = mul(unity_ObjectToWorld, float4(positionOS.xyz, 1.0)).xyz;
            corner.positionCS = mul(UNITY_MATRIX_VP, float4(corner.positionWS, 1.0));
            return corner;
        }
        ENDCG

        Pass {
            Name "FORWARD"
            Tags { "LightMode" = "ForwardBase" }

            CGPROGRAM
            #pragma vertex BoxCorner
            #pragma fragment Lit
            #pragma multi_compile_fwdbase nolightmap nodynlightmap novertexlight
            #pragma multi_compile_fog
            #include "{{ name }}_light.hlsl"

            half4 Lit(Corner corner, out float depth : SV_Depth) : SV_Target {
                SceneHit hit = MeetScene(corner.positionWS);
                depth = SceneDepth(hit.positionCS);
                Surface surface = scene_surface(hit.position);
                half3 color = LitColor(hit, surface, true) + surface.finish.z * surface.color.rgb;
                UNITY_CALC_FOG_FACTOR(hit.positionCS.z);
                UNITY_FOG_LERP_COLOR(color, unity_FogColor, unityFogFactor);
                return half4(color, 1.0);
            }
            ENDCG
        }

        Pass {
            Name "FORWARD_DELTA"
            Tags { "LightMode" = "ForwardAdd" }
            Blend One One
            ZWrite Off

            CGPROGRAM
            #pragma vertex BoxCorner
            #pragma fragment Lit
            #pragma multi_compile_fwdadd_fullshadows
            #include "{{ name }}_light.hlsl"

            half4 Lit(Corner corner, out float depth : SV_Depth) : SV_Target {
                SceneHit hit = MeetScene(corner.positionWS);
                depth = SceneDepth(hit.positionCS);
                return half4(LitColor(hit, scene_surface(hit.position), false), 1.0);
            }
            ENDCG
        }

        Pass {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }

            CGPROGRAM
            #pragma vertex BoxCorner
            #pragma fragment Shadow
            #pragma multi_compile_shadowcaster

            half4 Shadow(Corner corner, out float depth : SV_Depth) : SV_Target {
                SceneHit hit = MeetScene(corner.positionWS);
                depth = saturate(SceneDepth(UnityApplyLinearShadowBias(hit.positionCS)));
#if defined(SHADOWS_CUBE) && !defined(SHADOWS_CUBE_IN_DEPTH_TEX)
                return UnityEncodeCubeShadowDepth((length(hit.positionWS - _LightPositionRange.xyz) + unity_LightShadowBias.x) * _LightPositionRange.w);
#else
                return 0.0;
#endif
            }
            ENDCG
        }
    }
}
