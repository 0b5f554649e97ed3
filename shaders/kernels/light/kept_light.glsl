// SPDX-License-Identifier: Apache-2.0
// Light kept on surfaces.
#ifndef UTSURI_KERNELS_LIGHT_KEPT_LIGHT
#define UTSURI_KERNELS_LIGHT_KEPT_LIGHT
#include "interop/bindings.h"
#include "interop/light_mesh.h"
#include "lib/numeric.glsl"

layout(set = METHOD_SET, binding = BINDING_LIGHT_MESH_NODES) uniform usamplerBuffer light_nodes;
layout(set = METHOD_SET, binding = BINDING_LIGHT_MESH_LEAVES) uniform usamplerBuffer light_leaves;

/// How far rays may be off on the triangles that they hit: 64 roundings of the size of the triangle.
const vec2 RAY_PLACE_ERROR = vec2(1.0 / 262144.0);

LightMeshRoot light_root(uint triangle) {
    uvec4 words = texelFetch(light_nodes, int(triangle));
    return LightMeshRoot(words.x, words.y, words.z, words.w);
}

LightMeshSplit light_split(uint index) {
    uvec4 words = texelFetch(light_nodes, int(index));
    return LightMeshSplit(uintBitsToFloat(words.x), uintBitsToFloat(words.y), words.z, words.w);
}

/// The part of the tree that holds all of the grid's cell at a place, and what is on the other side of cuts within a cell of it.
uint cell_at(LightMeshRoot root, vec2 place) {
    uint i = min(uint(max(place.x, 0.0) * float(root.rows)), root.rows - 1u);
    uint j = min(uint(max(place.y, 0.0) * float(root.rows)), root.rows - 1u - i);
    return root.first_cell + j * root.rows - j * (j - 1u) / 2u + i;
}

/// A place on a triangle, and what is asked about it.
struct LightQuery {
    vec2 place;        ///< barycentric coordinates b1, b2
    vec2 error;        ///< of place, at most
    bool second_side;  ///< where the place may lie on both sides of a cut by its error: which one to take
    bool unsure;       ///< whether there was such a cut
};

/// The leaf at a place in a part of a tree.
uint leaf_at(uint part, inout LightQuery query) {
    while ((part & LIGHT_MESH_LEAF) == 0u) {
        LightMeshSplit split = light_split(part & LIGHT_MESH_INDEX);
        vec2 slopes = (split.first & LIGHT_MESH_BY_B2) != 0u ? vec2(split.slope, 1.0) : vec2(1.0, split.slope);
        float beyond = split.constant + dot(slopes, query.place);
        // Light is the same on both sides of other splits: it does not matter which one rounding chooses.
        bool is_unsure = (split.second & LIGHT_MESH_CUT) != 0u && abs(beyond) <= dot(abs(slopes), query.error);
        query.unsure = query.unsure || is_unsure;
        bool second = is_unsure ? query.second_side : beyond > 0.0;
        part = second ? split.second : split.first;
    }
    return part;
}

/// Light on one side of a leaf. A place that lies beside the leaf by its error gets no more and no less than there is on it.
vec3 leaf_light(uint leaf, vec2 place, bool front) {
    if ((leaf & (front ? LIGHT_MESH_FRONT : LIGHT_MESH_BACK)) == 0u) return vec3(0.0);
    bool comes_second = !front && (leaf & LIGHT_MESH_FRONT) != 0u;
    int texel = 3 * int((leaf & LIGHT_MESH_INDEX) + (comes_second ? 1u : 0u));
    uvec4 constant = texelFetch(light_leaves, texel);
    uvec4 along_b1 = texelFetch(light_leaves, texel + 1);
    uvec4 along_b2 = texelFetch(light_leaves, texel + 2);
    uvec3 bounds = uvec3(constant.w, along_b1.w, along_b2.w);
    vec3 light = uintBitsToFloat(constant.rgb) + place.x * uintBitsToFloat(along_b1.rgb) +
                 place.y * uintBitsToFloat(along_b2.rgb);
    return clamp(light, uintBitsToFloat(bounds << 16u), uintBitsToFloat(bounds & 0xffff0000u));
}

/// What a white diffuse surface would send out at a point of a triangle, to one side, cd/m2. A point that may lie on both
/// sides of a line, where a wall stands on a floor, say, gets the darker light: no light comes through by rounding.
/// @param place barycentric coordinates b1, b2
/// @param error of place, at most
vec3 kept_light(uint triangle, vec2 place, vec2 error, bool front) {
    LightMeshRoot root = light_root(triangle);
    if (root.tree == NONE) return vec3(0.0);
    uint part = root.tree;
    // Cells know of cuts within a cell of them: where a place is not known as well as that, the whole tree tells.
    if (root.rows > 0u && all(lessThan(error * float(root.rows), vec2(1.0)))) part = cell_at(root, place);
    vec3 light = vec3(0.0);
    float darkest = INFINITY;
    LightQuery query = LightQuery(place, error, false, true);
    for (uint side = 0u; side < 2u && query.unsure; ++side) {
        query.second_side = side == 1u;
        query.unsure = false;
        vec3 found = leaf_light(leaf_at(part, query), place, front);
        float sum = found.x + found.y + found.z;
        if (sum < darkest) {
            darkest = sum;
            light = found;
        }
    }
    return light;
}

#endif
