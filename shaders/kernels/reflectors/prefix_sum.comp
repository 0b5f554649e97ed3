// SPDX-License-Identifier: Apache-2.0
// Replaces each of a list of counts by the sum of those before it, and writes the sum of all behind the last. One
// workgroup, and integers: the same on every device.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/bindings.h"
#include "interop/reflection.h"
#include "interop/workgroup.h"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(push_constant, scalar) uniform Push { PrefixSumPush push; };

layout(scalar, set = METHOD_SET, binding = BINDING_SUMMED_COUNTS) restrict buffer Counts { uint counts[]; };

shared uint sums[WORKGROUP_SIZE];

void main() {
    uint lane = gl_LocalInvocationID.x;
    uint share = (push.count + WORKGROUP_SIZE - 1u) / WORKGROUP_SIZE;
    uint begin = min(lane * share, push.count);
    uint end = min(begin + share, push.count);
    uint sum = 0u;
    for (uint i = begin; i < end; ++i) sum += counts[i];
    sums[lane] = sum;
    barrier();
    uint before = 0u;
    for (uint i = 0u; i < lane; ++i) before += sums[i];
    for (uint i = begin; i < end; ++i) {
        uint count = counts[i];
        counts[i] = before;
        before += count;
    }
    if (lane == WORKGROUP_SIZE - 1u) counts[push.count] = before;
}
