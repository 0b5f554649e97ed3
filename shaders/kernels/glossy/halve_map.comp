// SPDX-License-Identifier: Apache-2.0
// The next level of a cube of maps without borders: means over blocks of four texels, weighted by their solid angles; of one
// over the distance, by the light, too.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/bindings.h"
#include "interop/glossy_map.h"
#include "interop/specialization.h"
#include "interop/workgroup.h"
#include "lib/cube.glsl"
#include "lib/light_distance.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(constant_id = SPEC_KEEPS_DISTANCES) const bool KEEPS_DISTANCES = false;

layout(push_constant, scalar) uniform Push { HalveMapPush push; };

layout(scalar, set = METHOD_SET, binding = BINDING_MAP_TEXELS) restrict buffer MapTexels { vec3 map_texels[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_MAP_INVERSE_DISTANCES) restrict buffer MapInverseDistances {
    float map_inverse_distances[];
};

void main() {
    uint index = push.begin + gl_GlobalInvocationID.x;
    if (index >= push.end) return;
    uint per_face = push.size * push.size;
    uint face = index / per_face;
    uvec2 block = uvec2(index % push.size, index % per_face / push.size);
    uint edge = 2u * push.size;
    vec3 sum = vec3(0.0);
    LightDistance distance = LightDistance(0.0, 0.0);
    float weights = 0.0;
    for (uint i = 0u; i < 4u; ++i) {
        uvec2 texel = 2u * block + uvec2(i & 1u, i >> 1);
        float weight = cube_solid_angle(cube_place(texel, edge));
        uint source = push.first_source + face * edge * edge + texel.y * edge + texel.x;
        sum += weight * map_texels[source];
        if (KEEPS_DISTANCES) add_light(distance, weight * map_texels[source], map_inverse_distances[source]);
        weights += weight;
    }
    map_texels[push.first_texel + index] = sum / weights;
    if (KEEPS_DISTANCES) map_inverse_distances[push.first_texel + index] = distance.inverse;
}
