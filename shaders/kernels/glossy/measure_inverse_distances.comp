// SPDX-License-Identifier: Apache-2.0
// How far what surrounds a glossy surface is from its capture point: one ray a texel of what its maps are made of.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "interop/glossy_map.h"
#include "interop/workgroup.h"
#include "lib/cube.glsl"
#include "kernels/scene/traversal.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(push_constant, scalar) uniform Push { MeasureInverseDistancesPush push; };

/// One over metres; 0 where nothing is met.
layout(scalar, set = METHOD_SET, binding = BINDING_MAP_INVERSE_DISTANCES) writeonly restrict buffer MapInverseDistances {
    float map_inverse_distances[];
};

void main() {
    uint index = push.begin + gl_GlobalInvocationID.x;
    if (index >= push.end) return;
    uint per_face = push.size * push.size;
    vec2 p = cube_place(uvec2(index % push.size, index % per_face / push.size), push.size);
    vec3 direction = normalize(cube_vector(vec3(p, 1.0), index / per_face));
    Hit hit = closest_hit(make_ray(push.capture_point, direction, NONE, push.excluded_instance));
    // What touches the capture point is finitely near.
    map_inverse_distances[index] = hit.triangle == NONE ? 0.0 : min(1.0 / hit.t, 1e30);
}
