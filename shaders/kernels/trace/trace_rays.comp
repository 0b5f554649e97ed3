// SPDX-License-Identifier: Apache-2.0
// Traces a list of rays: the search alone, for tests and benchmarks.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "interop/rays.h"
#include "interop/workgroup.h"
#include "kernels/scene/traversal.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(constant_id = SPEC_ANY_HIT) const bool ANY_HIT = false;

layout(push_constant, scalar) uniform Push { TraceRaysPush push; };

layout(scalar, set = METHOD_SET, binding = BINDING_RAYS) readonly restrict buffer Rays { RayInfo rays[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_HITS) writeonly restrict buffer Hits { HitInfo hits[]; };

void main() {
    if (gl_GlobalInvocationID.x >= push.count) return;
    uint index = push.first + gl_GlobalInvocationID.x;
    RayInfo info = rays[index];
    Ray ray = make_ray(info.origin, info.direction, info.excluded, NONE);
    ray.t_max = info.t_max;
    Hit hit = traverse(ray, ANY_HIT);
    hits[index] = HitInfo(hit.triangle == NONE ? INFINITY : hit.t, hit.triangle, hit.b1, hit.b2);
}
