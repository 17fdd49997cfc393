{{ about }}

// The scene under its own lights, with its own sky and floor, all over the view: for any pipeline.
Shader "Chiaro/{{ title }} picture" {
    Properties {
        _rays ("Rays a pixel: 4 is smooth, 1 is fast", Int) = 4
{% for parameter in parameters if not parameter.is_time %}
        _{{ parameter.name }} ("{{ parameter.label }}", Range({{ parameter.min }}, {{ parameter.max }})) = {{ parameter.default }}
{% endfor %}
    }

    SubShader {
        Tags { "RenderType" = "Opaque" "Queue" = "Geometry" "DisableBatching" = "True" }

        Pass {
            CGPROGRAM
            #pragma target 4.5
            #pragma vertex Everywhere
            #pragma fragment Picture
            #include "UnityCG.cginc"

            int _rays;
{% for parameter in parameters %}
{% if parameter.is_time %}
            #define _{{ parameter.name }} frac(_Time.y / 8.0)
{% else %}
            float _{{ parameter.name }};
{% endif %}
{% endfor %}

            #include "{{ name }}_picture.hlsl"

            struct Corner {
                float4 positionCS : SV_POSITION;
                float2 ndc : TEXCOORD0;
            };

            // The box's corners go to those of the view.
            Corner Everywhere(float4 positionOS : POSITION, float3 normalOS : NORMAL) {
                Corner corner;
                corner.ndc = sign(normalOS.xy);
                corner.positionCS = float4(corner.ndc, 0.5, 1.0);
                return corner;
            }

            half4 Picture(Corner corner, out float depth : SV_Depth) : SV_Target {
                float2 size = _ScreenParams.xy;
                float3 eye = ScenePoint(mul(unity_WorldToObject, float4(_WorldSpaceCameraPos, 1.0)).xyz);
                float pixelAngle = 2.0 / abs(UNITY_MATRIX_P._m11 * size.y);
                float3 sum = 0.0;
                float3 seenAt = 0.0;
                bool isSeen = false;
                for (int i = 0; i < _rays; i++) {
                    float2 ndc = corner.ndc + (_rays == 1 ? 0.0 : 2.0 * ray_offset(i) / size);
                    float2 onPlane = (ndc + UNITY_MATRIX_P._m02_m12) / UNITY_MATRIX_P._m00_m11;
                    float3 direction = mul(float3(onPlane, -1.0), (float3x3)UNITY_MATRIX_V);
                    float3 w = normalize(ScenePoint(mul((float3x3)unity_WorldToObject, direction)));
                    // Where in the picture it is, upwards whichever way the target is turned.
                    float2 place = ndc * float2(1.0, sign(UNITY_MATRIX_P._m11)) * size / length(size);
                    OnePass seen = one_pass(eye, w, pixelAngle, place, i);
                    sum += seen.color;
                    isSeen = seen.t >= 0.0;
                    seenAt = eye + seen.t * w;
                }

                float4 positionCS = mul(UNITY_MATRIX_VP, mul(unity_ObjectToWorld, float4(0.001 * seenAt.xzy, 1.0)));
                depth = SceneDepth(positionCS);
                if (!isSeen) {
                    depth = UNITY_NEAR_CLIP_VALUE == 1.0 ? 0.0 : 1.0;
                }
                float3 color = shown(sum / _rays);
#if defined(UNITY_COLORSPACE_GAMMA)
                color = srgb_from_linear(color);
#endif
                return half4(color, 1.0);
            }
            ENDCG
        }
    }
}
