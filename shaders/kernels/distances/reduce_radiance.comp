// SPDX-License-Identifier: Apache-2.0
// Bounds on radiance over blocks of twice the edge.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/bindings.h"
#include "interop/distance_map.h"
#include "interop/workgroup.h"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(push_constant, scalar) uniform Push { BoundDistancesPush push; };

layout(scalar, set = METHOD_SET, binding = BINDING_DARKEST) restrict buffer Darkest { vec3 darkest[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_BRIGHTEST) restrict buffer Brightest { vec3 brightest[]; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= push.size * push.size) return;
    uint stride = 2u * push.size;
    uint first = push.first_source + 2u * (index / push.size) * stride + 2u * (index % push.size);
    vec3 least = darkest[first];
    vec3 largest = brightest[first];
    for (uint i = 1u; i < 4u; ++i) {
        uint part = first + (i >> 1) * stride + (i & 1u);
        least = min(least, darkest[part]);
        largest = max(largest, brightest[part]);
    }
    darkest[push.first_bounds + index] = least;
    brightest[push.first_bounds + index] = largest;
}
