// SPDX-License-Identifier: MIT
// Vertex animation textures of `sinew animate --vat` for instances in Unity's Universal Render Pipeline (2021.3 or newer). _Play of each instance:
// first frame; intervals between frames, negative: the clip holds its last frame; frames a second; seconds ahead.
Shader "Sinew/Vertex Animation Textures"
{
    Properties
    {
        [MainTexture] _BaseMap ("Picture", 2D) = "white" {}
        [MainColor] _BaseColor ("Color", Color) = (1, 1, 1, 1)
        [NoScaleOffset] _PositionHigh ("NAME.vat.position_high.png", 2D) = "black" {}
        [NoScaleOffset] _PositionLow ("NAME.vat.position_low.png", 2D) = "black" {}
        [NoScaleOffset] _NormalTexture ("NAME.vat.normal.png", 2D) = "gray" {}
        _BoundsMin ("bounds.min", Vector) = (0, 0, 0, 0)
        _BoundsMax ("bounds.max", Vector) = (1, 1, 1, 0)
        _RowsPerFrame ("rows_per_frame", Integer) = 1
        [Toggle] _MirrorX ("glTF importer mirrors x (glTFast, UnityGLTF)", Float) = 1
        _Play ("Clip without instances", Vector) = (0, 1, 30, 0)
    }
    SubShader
    {
        Tags { "RenderType" = "Opaque" "RenderPipeline" = "UniversalPipeline" }
        Pass
        {
            Tags { "LightMode" = "UniversalForward" }
            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile_instancing
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"

            TEXTURE2D(_BaseMap);
            SAMPLER(sampler_BaseMap);
            Texture2D<float4> _PositionHigh;
            Texture2D<float4> _PositionLow;
            Texture2D<float4> _NormalTexture;
            CBUFFER_START(UnityPerMaterial)
                float4 _BaseMap_ST;
                half4 _BaseColor;
                float4 _PositionHigh_TexelSize;
                float4 _BoundsMin;
                float4 _BoundsMax;
                int _RowsPerFrame;
                float _MirrorX;
            CBUFFER_END
            UNITY_INSTANCING_BUFFER_START(Crowd)
                UNITY_DEFINE_INSTANCED_PROP(float4, _Play)
            UNITY_INSTANCING_BUFFER_END(Crowd)

            struct Attributes
            {
                float2 uv : TEXCOORD0;
                float2 texel : TEXCOORD1;
                UNITY_VERTEX_INPUT_INSTANCE_ID
            };

            struct Varyings
            {
                float4 position : SV_POSITION;
                float2 uv : TEXCOORD0;
                float3 normal : TEXCOORD1;
            };

            float3 PositionAt(int2 at)
            {
                float3 value = 65280.0 * _PositionHigh.Load(int3(at, 0)).rgb + 255.0 * _PositionLow.Load(int3(at, 0)).rgb;
                return lerp(_BoundsMin.xyz, _BoundsMax.xyz, value / 65535.0);
            }

            float3 NormalAt(int2 at)
            {
                return (255.0 * _NormalTexture.Load(int3(at, 0)).rgb - 128.0) / 127.0;
            }

            Varyings Vertex(Attributes input)
            {
                UNITY_SETUP_INSTANCE_ID(input);
                float4 play = UNITY_ACCESS_INSTANCED_PROP(Crowd, _Play);
                float count = abs(play.y);
                float time = (_Time.y + play.w) * play.z;
                time = play.y > 0.0 ? time - count * floor(time / count) : clamp(time, 0.0, count);
                float frame = min(floor(time), max(count - 1.0, 0.0));
                // Unity's row 0 is the lowest one of the picture, and importers turn v.
                int2 at = int2(input.texel * _PositionHigh_TexelSize.zw) - int2(0, int(play.x + frame) * _RowsPerFrame);
                int2 next = at - int2(0, count > 0.0 ? _RowsPerFrame : 0);
                float3 side = float3(_MirrorX > 0.5 ? -1.0 : 1.0, 1.0, 1.0);
                float3 position = side * lerp(PositionAt(at), PositionAt(next), time - frame);
                float3 normal = side * normalize(lerp(NormalAt(at), NormalAt(next), time - frame));
                Varyings output;
                output.position = TransformObjectToHClip(position);
                output.normal = TransformObjectToWorldNormal(normal);
                output.uv = TRANSFORM_TEX(input.uv, _BaseMap);
                return output;
            }

            half4 Fragment(Varyings input) : SV_Target
            {
                half4 color = SAMPLE_TEXTURE2D(_BaseMap, sampler_BaseMap, input.uv) * _BaseColor;
                Light light = GetMainLight();
                half3 normal = normalize(input.normal);
                half3 received = SampleSH(normal) + light.color * saturate(dot(normal, light.direction));
                return half4(color.rgb * received, color.a);
            }
            ENDHLSL
        }
    }
}
