// SPDX-License-Identifier: Apache-2.0
// Maps convolved with glossy lobes, a level for each step of roughness.
#ifndef UTSURI_KERNELS_GLOSSY_GLOSSY_LEVELS
#define UTSURI_KERNELS_GLOSSY_GLOSSY_LEVELS

#extension GL_EXT_scalar_block_layout : require

#include "interop/bindings.h"
#include "interop/glossy_map.h"
#include "lib/cube.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_GLOSSY_LEVELS) readonly restrict buffer GlossyLevels { GlossyLevel glossy_levels[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_GLOSSY_TEXELS) readonly restrict buffer GlossyTexels { vec3 glossy_texels[]; };

/// The levels next to a roughness.
struct GlossyLobe {
    GlossyLevel below;
    GlossyLevel above;
    float share;  ///< of the level above; 0: it is none
};

/// Four texels about a direction: that of least coordinates, and where from its centre on the direction points.
struct GlossyTexel {
    uint least;
    uint stride;
    vec2 offset;
};

GlossyTexel glossy_texel(GlossyLevel level, vec3 direction) {
    uint face = cube_face(direction);
    vec3 c = cube_components(direction, face);
    uint stride = level.size + 2u * GLOSSY_MAP_BORDER;
    vec2 position = (0.5 * float(level.size)) * (c.xy / c.z + 1.0) + float(GLOSSY_MAP_BORDER) - 0.5;
    vec2 corner = clamp(floor(position), vec2(0.0), vec2(float(stride - 2u)));
    vec2 f = clamp(position - corner, 0.0, 1.0);
    return GlossyTexel(level.first_texel + (face * stride + uint(corner.y)) * stride + uint(corner.x), stride, f);
}

/// Bilinear value of a level.
vec3 glossy_level(GlossyLevel level, vec3 direction) {
    GlossyTexel texel = glossy_texel(level, direction);
    return mix(mix(glossy_texels[texel.least], glossy_texels[texel.least + 1u], texel.offset.x),
               mix(glossy_texels[texel.least + texel.stride], glossy_texels[texel.least + texel.stride + 1u], texel.offset.x),
               texel.offset.y);
}

#endif
