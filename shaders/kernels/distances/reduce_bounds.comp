// SPDX-License-Identifier: Apache-2.0
// Bounds over blocks of twice the edge.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/bindings.h"
#include "interop/distance_map.h"
#include "interop/workgroup.h"
#include "lib/distance_bounds.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(push_constant, scalar) uniform Push { BoundDistancesPush push; };

layout(scalar, set = METHOD_SET, binding = BINDING_DISTANCE_BOUNDS) restrict buffer DistanceBoundsBuffer { DistanceBounds distance_bounds[]; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= push.size * push.size) return;
    uint stride = 2u * push.size;
    uint first = push.first_source + 2u * (index / push.size) * stride + 2u * (index % push.size);
    DistanceBounds bounds = distance_bounds[first];
    for (uint i = 1u; i < 4u; ++i) {
        DistanceBounds part = distance_bounds[first + (i >> 1) * stride + (i & 1u)];
        bounds.nearest = min(bounds.nearest, part.nearest);
        bounds.farthest = farther(bounds.farthest, part.farthest);
    }
    distance_bounds[push.first_bounds + index] = bounds;
}
