// SPDX-License-Identifier: Apache-2.0
// Turns the sums of a film into texels of a reflection map.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/bindings.h"
#include "interop/frame.h"
#include "interop/reflection.h"
#include "interop/workgroup.h"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(push_constant, scalar) uniform Push { ResolveMapPush push; };

layout(scalar, set = METHOD_SET, binding = BINDING_FILM) readonly restrict buffer Film { FilmPixel film[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_MAP_TEXELS) writeonly restrict buffer MapTexels { vec3 map_texels[]; };

void main() {
    uint texel = gl_GlobalInvocationID.x;
    if (texel >= push.texels) return;
    FilmPixel pixel = film[texel];
    map_texels[push.first_texel + texel] = (pixel.halves[0].sum + pixel.halves[1].sum) / float(push.samples);
}
