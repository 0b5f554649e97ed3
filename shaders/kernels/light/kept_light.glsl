// SPDX-License-Identifier: Apache-2.0
// Light kept on surfaces.
#ifndef UTSURI_KERNELS_LIGHT_KEPT_LIGHT
#define UTSURI_KERNELS_LIGHT_KEPT_LIGHT
#include "kernels/light/light_records.glsl"
#include "lib/numeric.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_LIGHT_MESH_POINTS) readonly restrict buffer LightMeshPoints {
    LightMeshPoint light_points[];
};

/// Counts the corners of a triangle from another one, which keeps their order.
vec3 from_corner(vec3 b, uint corner) {
    return corner == 0u ? b : (corner == 1u ? b.yzx : b.zxy);
}

/// Where a point of a triangle lies, and how far it may be off, in barycentric coordinates of a node.
struct NodePlace {
    vec3 b;
    vec3 error;  ///< at most, of each; >= 0
};

/// How far rays may be off on the triangles that they hit: 64 roundings of the size of the triangle.
const vec2 RAY_PLACE_ERROR = vec2(1.0 / 262144.0);

/// The leaf at a place.
/// @param second_side where a place may lie on both sides of a split by its error: which one to take
/// @param unsure is set where there was such a split
uvec4 leaf_at(uvec4 node, inout NodePlace place, bool second_side, inout bool unsure) {
    // Rasterisers run lanes that show nothing, too, with records that are none: without a bound they would go on for long.
    for (uint level = 0u; level < LIGHT_MESH_DEPTH && node.x != LIGHT_MESH_LEAF; ++level) {
        vec3 b = from_corner(place.b, node.x);
        vec3 error = from_corner(place.error, node.x);
        float share = uintBitsToFloat(node.z);
        // In the child, the coordinate of the split point takes over from that of the corner that is cut off.
        float beyond = b.y * (1.0 - share) - b.x * share;
        float beyond_error = error.y * (1.0 - share) + error.x * share;
        bool is_unsure = abs(beyond) <= beyond_error;
        unsure = unsure || is_unsure;
        bool second = is_unsure ? second_side : beyond > 0.0;
        if (second) {
            place.b = vec3(b.x, beyond, 0.0) / (1.0 - share);
            place.error = vec3(error.x, beyond_error, 0.0) / (1.0 - share);
        } else {
            place.b = vec3(-beyond, b.y, 0.0) / share;
            place.error = vec3(beyond_error, error.y, 0.0) / share;
        }
        place.b.z = b.z;
        place.error.z = error.z;
        node = light_record(node.y + (second ? 1u : 0u));
    }
    return node;
}

/// What a white diffuse surface would send out at a point of a triangle, to one side, cd/m2. A point that may lie on both
/// sides of a line, where a wall stands on a floor, say, gets the darker light: no light comes through by rounding.
/// @param node light_record() of the triangle
/// @param place barycentric coordinates b1, b2
/// @param error of place, at most
vec3 kept_light(uvec4 node, vec2 place, vec2 error, bool front) {
    vec3 light = vec3(0.0);
    float darkest = INFINITY;
    bool unsure = true;
    for (uint side = 0u; side < 2u && unsure; ++side) {
        unsure = false;
        NodePlace there = NodePlace(vec3(1.0 - place.x - place.y, place), vec3(error.x + error.y, error));
        uvec4 leaf = leaf_at(node, there, side == 1u, unsure);
        if (leaf.x != LIGHT_MESH_LEAF || leaf.y == NONE) return vec3(0.0);
        // A place may lie beside its leaf by its error.
        vec3 b = max(there.b, vec3(0.0));
        b /= b.x + b.y + b.z;
        vec3 found = front ? b.x * light_points[leaf.y].front + b.y * light_points[leaf.z].front + b.z * light_points[leaf.w].front
                           : b.x * light_points[leaf.y].back + b.y * light_points[leaf.z].back + b.z * light_points[leaf.w].back;
        float sum = found.x + found.y + found.z;
        if (sum < darkest) {
            darkest = sum;
            light = found;
        }
    }
    return light;
}

#endif
