// SPDX-License-Identifier: Apache-2.0
// The scene as kernels read it. Lengths are in metres relative to the scene's origin, light is photometric.
#ifndef UTSURI_INTEROP_SCENE_H
#define UTSURI_INTEROP_SCENE_H
#include "interop/prelude.h"
INTEROP_BEGIN

/// What a hit on a triangle leads to. Indexed like BvhTriangle.
struct TriangleInfo {
    uvec3 vertices;  ///< into the vertex attribute buffers
    uint material;
    uint instance;
    uint light;  ///< the light this triangle is, or NONE
};

struct TextureSlotInfo {
    uint texture;   ///< into the texture headers, or NONE
    uint sampling;  ///< wrap s (bits 0-1), wrap t (bits 2-3), filter (bit 4): the enums of scene/texture.h
};

struct MaterialInfo {
    vec3 base_colour;
    float metallic;
    vec3 emissive;         ///< cd/m2
    float roughness;       ///< perceptual
    float dielectric_f0;   ///< reflectance of the dielectric part at normal incidence
    float dielectric_f90;  ///< the same at grazing incidence
    float ior;             ///< index of refraction behind the front over that before it, > 0
    uint double_sided;     ///< 1: emits from both sides
    TextureSlotInfo base_colour_texture;
    TextureSlotInfo metallic_roughness_texture;
    TextureSlotInfo emissive_texture;
};

struct TextureHeader {
    uint first_texel;
    uint width;
    uint height;
};

INTEROP_CONSTANT LIGHT_TRIANGLE = 0u;
INTEROP_CONSTANT LIGHT_POINT = 1u;
INTEROP_CONSTANT LIGHT_SPOT = 2u;
INTEROP_CONSTANT LIGHT_DIRECTIONAL = 3u;
INTEROP_CONSTANT LIGHT_ENVIRONMENT = 4u;

struct LightInfo {
    uint type;
    uint triangle;      ///< LIGHT_TRIANGLE: its index
    float probability;  ///< that the light table picks this light
    vec3 position;      ///< point and spot
    vec3 direction;     ///< unit, the way light travels; spot and directional
    vec3 intensity;     ///< cd, lux or, for the environment, cd/m2
    float range;        ///< metres; infinity where unlimited
    float spot_scale;   ///< KHR_lights_punctual: 1 / max(0.001, cos inner - cos outer)
    float spot_offset;  ///< KHR_lights_punctual: -cos outer * spot_scale
};

/// One entry of an alias table (Walker 1977): take this entry where u < threshold, else its alias.
struct LightTableEntry {
    float threshold;
    uint alias;
};

INTEROP_END
#endif
