// SPDX-License-Identifier: Apache-2.0
// Maps convolved with rough lobes, a level for each step of roughness.
#ifndef UTSURI_KERNELS_GLOSSY_ROUGH_LEVELS
#define UTSURI_KERNELS_GLOSSY_ROUGH_LEVELS

#extension GL_EXT_scalar_block_layout : require

#include "interop/bindings.h"
#include "interop/rough_map.h"
#include "lib/cube.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_ROUGH_LEVELS) readonly restrict buffer RoughLevels { RoughLevel rough_levels[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_ROUGH_TEXELS) readonly restrict buffer RoughTexels { vec3 rough_texels[]; };

/// The levels next to a roughness.
struct RoughLobe {
    RoughLevel below;
    RoughLevel above;
    float share;  ///< of the level above; 0: it is none
};

/// Four texels about a direction: that of least coordinates, and where from its centre on the direction points.
struct RoughTexel {
    uint least;
    uint stride;
    vec2 offset;
};

RoughTexel rough_texel(RoughLevel level, vec3 direction) {
    uint face = cube_face(direction);
    vec3 c = cube_components(direction, face);
    uint stride = level.size + 2u * ROUGH_MAP_BORDER;
    vec2 position = (0.5 * float(level.size)) * (c.xy / c.z + 1.0) + float(ROUGH_MAP_BORDER) - 0.5;
    vec2 corner = clamp(floor(position), vec2(0.0), vec2(float(stride - 2u)));
    vec2 f = clamp(position - corner, 0.0, 1.0);
    return RoughTexel(level.first_texel + (face * stride + uint(corner.y)) * stride + uint(corner.x), stride, f);
}

/// Bilinear value of a level.
vec3 rough_level(RoughLevel level, vec3 direction) {
    RoughTexel texel = rough_texel(level, direction);
    return mix(mix(rough_texels[texel.least], rough_texels[texel.least + 1u], texel.offset.x),
               mix(rough_texels[texel.least + texel.stride], rough_texels[texel.least + texel.stride + 1u], texel.offset.x),
               texel.offset.y);
}

#endif
