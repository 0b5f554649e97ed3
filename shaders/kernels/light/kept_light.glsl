// SPDX-License-Identifier: Apache-2.0
// Light kept on surfaces.
#ifndef UTSURI_KERNELS_LIGHT_KEPT_LIGHT
#define UTSURI_KERNELS_LIGHT_KEPT_LIGHT
#include "kernels/light/light_records.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_LIGHT_MESH_POINTS) readonly restrict buffer LightMeshPoints {
    LightMeshPoint light_points[];
};

/// Levels of a tree, at most: contact_cuts.cpp makes at most 96, halving leaves takes some dozens.
const uint LIGHT_MESH_DEPTH = 192u;

/// Counts the corners of a triangle from another one, which keeps their order.
vec3 from_corner(vec3 b, uint corner) {
    return corner == 0u ? b : (corner == 1u ? b.yzx : b.zxy);
}

/// What a white diffuse surface would send out at a point of a triangle, to one side, cd/m2.
/// @param node light_record() of the triangle
/// @param place barycentric coordinates b1, b2
vec3 kept_light(uvec4 node, vec2 place, bool front) {
    vec3 b = vec3(1.0 - place.x - place.y, place);
    // Rasterisers run lanes that show nothing, too, with records that are none: without a bound they would go on for long.
    for (uint level = 0u; level < LIGHT_MESH_DEPTH && node.x != LIGHT_MESH_LEAF; ++level) {
        b = from_corner(b, node.x);
        float share = uintBitsToFloat(node.z);
        // In the child, the coordinate of the split point takes over from that of the corner that is cut off.
        float beyond = b.y * (1.0 - share) - b.x * share;
        b = beyond > 0.0 ? vec3(b.x / (1.0 - share), beyond / (1.0 - share), b.z) : vec3(-beyond / share, b.y / share, b.z);
        node = light_record(node.y + (beyond > 0.0 ? 1u : 0u));
    }
    if (node.x != LIGHT_MESH_LEAF || node.y == NONE) return vec3(0.0);
    b = max(b, vec3(0.0));  // a place may lie beside its triangle by rounding, which narrow leaves make more of
    if (front) {
        return b.x * light_points[node.y].front + b.y * light_points[node.z].front + b.z * light_points[node.w].front;
    }
    return b.x * light_points[node.y].back + b.y * light_points[node.z].back + b.z * light_points[node.w].back;
}

#endif
