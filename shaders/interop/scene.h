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
    uint light;   ///< the light this triangle is, or NONE
    uint layers;  ///< how many lie on it in its plane, one on top of the other, at most MOST_LAYERS
};

INTEROP_CONSTANT MOST_LAYERS = 15u;

/// How a texture is looked up: TextureSlotInfo::sampling has wrap_s + (wrap_t << TEXTURE_WRAP_BITS), and
/// TEXTURE_LINEAR where it is filtered. Texels repeat unless a wrap mode says otherwise.
INTEROP_CONSTANT TEXTURE_CLAMP_TO_EDGE = 1u;
INTEROP_CONSTANT TEXTURE_MIRRORED_REPEAT = 2u;
INTEROP_CONSTANT TEXTURE_WRAP_BITS = 2u;
INTEROP_CONSTANT TEXTURE_WRAP_MASK = 3u;
INTEROP_CONSTANT TEXTURE_LINEAR = 16u;

/// What a material looks up, and how.
struct TextureSlotInfo {
    uint texture;      ///< its number among the textures in use, or NONE
    uint sampling;     ///< as above
    uint first_texel;  ///< of the texture
    uint width;
    uint height;
};

struct MaterialInfo {
    vec3 base_colour;
    float metallic;
    vec3 emissive;       ///< cd/m2
    float roughness;     ///< perceptual
    vec3 dielectric_f0;  ///< of the dielectric part at normal incidence, where it is fully specular; above
                         ///< 1 it counts as 1
    float specular;      ///< scales all that the dielectric part reflects specularly, in [0, 1]
    float ior;           ///< index of refraction behind the front over that before it, > 0
    uint double_sided;   ///< 1: emits from both sides
    TextureSlotInfo base_colour_texture;
    TextureSlotInfo metallic_roughness_texture;
    TextureSlotInfo emissive_texture;
    TextureSlotInfo specular_texture;         ///< its alpha scales `specular`
    TextureSlotInfo specular_colour_texture;  ///< scales dielectric_f0
};

INTEROP_CONSTANT LIGHT_TRIANGLE = 0u;
INTEROP_CONSTANT LIGHT_POINT = 1u;
INTEROP_CONSTANT LIGHT_SPOT = 2u;
INTEROP_CONSTANT LIGHT_DIRECTIONAL = 3u;
INTEROP_CONSTANT LIGHT_ENVIRONMENT = 4u;

struct LightInfo {
    uint type;
    uint triangle;      ///< LIGHT_TRIANGLE: its index
    float probability;  ///< that it is chosen, by power; of lights that are somewhere: that one of them is
    vec3 position;      ///< point and spot
    vec3 direction;     ///< unit, the way light travels; spot and directional
    vec3 intensity;     ///< cd, lux or, for the environment, cd/m2
    float range;        ///< metres; infinity where unlimited
    float spot_scale;   ///< KHR_lights_punctual: 1 / max(0.001, cos inner - cos outer)
    float spot_offset;  ///< KHR_lights_punctual: -cos outer * spot_scale
    uint path;          ///< its way down the light tree, from the lowest bit on: 1 leads to a second child
    uint path_length;   ///< levels
};

INTEROP_END
#endif
