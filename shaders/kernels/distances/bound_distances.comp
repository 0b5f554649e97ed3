// SPDX-License-Identifier: Apache-2.0
// Bounds on the distances that a texel and its neighbours hold, the finest level, and how far these are from lying in a
// plane.
#version 460
#extension GL_GOOGLE_include_directive : require
#define DISTANCE_SAMPLES_ACCESS
#include "interop/workgroup.h"
#include "kernels/distances/inverse_depth.glsl"
#include "lib/distance_bounds.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(push_constant, scalar) uniform Push { BoundDistancesPush push; };

layout(scalar, set = METHOD_SET, binding = BINDING_DISTANCE_BOUNDS) writeonly restrict buffer DistanceBoundsBuffer {
    DistanceBounds distance_bounds[];
};

void widen(inout DistanceBounds bounds, float value) {
    if (value != 0.0) bounds.nearest = min(bounds.nearest, abs(value));
    bounds.farthest = farther(bounds.farthest, value != 0.0 ? value : INFINITY);
}

/// Of a texel of the face and the two beside it along an axis.
float second_difference(uint first, uvec2 at, uvec2 along) {
    return abs(inverse_depth_at(first, at - along) - 2.0 * inverse_depth_at(first, at) +
               inverse_depth_at(first, at + along));
}

/// How far a corner is off what the four centres about it say.
float corner_difference(uint first, uvec2 at) {
    float mean = 0.25 * (inverse_depth_at(first, at) + inverse_depth_at(first, at - uvec2(1u, 0u)) +
                         inverse_depth_at(first, at - uvec2(0u, 1u)) + inverse_depth_at(first, at - 1u));
    return abs(inverse_depth(distance_samples[first + at.y * DISTANCE_STRIDE + at.x].corner, vec2(at)) - mean);
}

/// How far what is kept about a texel is from lying in a plane.
float bend_at(uint first, uvec2 at) {
    float corners = 0.0;
    for (uint i = 0u; i < 4u; ++i) corners = max(corners, corner_difference(first, at + uvec2(i & 1u, i >> 1)));
    return second_difference(first, at, uvec2(1u, 0u)) + second_difference(first, at, uvec2(0u, 1u)) + corners;
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= push.size * push.size) return;
    // Where the sample of a neighbour is, counted from the border's corner.
    uvec2 first = uvec2(index % DISTANCE_SIZE, index / DISTANCE_SIZE);
    DistanceBounds bounds = DistanceBounds(INFINITY, 0.0);
    // Three by three centres, and the four by four corners around them.
    for (uint y = 0u; y < 4u; ++y) {
        for (uint x = 0u; x < 4u; ++x) {
            uvec2 at = min(first + uvec2(x, y), uvec2(DISTANCE_STRIDE - 1u));
            DistanceSample found = distance_samples[push.first_source + at.y * DISTANCE_STRIDE + at.x];
            widen(bounds, found.corner);
            if (x < 3u && y < 3u) widen(bounds, found.centre);
        }
    }
    distance_bounds[push.first_bounds + index] = bounds;
    uvec2 at = first + DISTANCE_BORDER;
    distance_samples[push.first_source + at.y * DISTANCE_STRIDE + at.x].bend = bend_at(push.first_source, at);
}
