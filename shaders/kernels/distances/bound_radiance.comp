// SPDX-License-Identifier: Apache-2.0
// Bounds on the radiance that a texel and its neighbours hold, the finest level.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/bindings.h"
#include "interop/radiance_bounds.h"
#include "interop/workgroup.h"
#include "lib/distance_constants.glsl"
#include "lib/numeric.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(push_constant, scalar) uniform Push { BoundDistancesPush push; };

layout(scalar, set = METHOD_SET, binding = BINDING_RADIANCE_SAMPLES) readonly restrict buffer RadianceSamples {
    RadianceSample radiance_samples[];
};
layout(scalar, set = METHOD_SET, binding = BINDING_DARKEST) writeonly restrict buffer Darkest { vec3 darkest[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_BRIGHTEST) writeonly restrict buffer Brightest { vec3 brightest[]; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= push.size * push.size) return;
    // Where the sample of a neighbour is, counted from the border's corner.
    uvec2 first = uvec2(index % DISTANCE_SIZE, index / DISTANCE_SIZE);
    vec3 least = vec3(INFINITY);
    vec3 largest = vec3(0.0);
    // Three by three centres, and the four by four corners around them.
    for (uint y = 0u; y < 4u; ++y) {
        for (uint x = 0u; x < 4u; ++x) {
            uvec2 at = min(first + uvec2(x, y), uvec2(DISTANCE_STRIDE - 1u));
            RadianceSample found = radiance_samples[at.y * DISTANCE_STRIDE + at.x];
            least = min(least, found.corner);
            largest = max(largest, found.corner);
            if (x < 3u && y < 3u) {
                least = min(least, found.centre);
                largest = max(largest, found.centre);
            }
        }
    }
    darkest[push.first_bounds + index] = least;
    brightest[push.first_bounds + index] = largest;
}
