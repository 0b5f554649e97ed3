// SPDX-License-Identifier: Apache-2.0
// Light kept on surfaces.
#ifndef UTSURI_KERNELS_LIGHT_KEPT_LIGHT
#define UTSURI_KERNELS_LIGHT_KEPT_LIGHT
#extension GL_EXT_scalar_block_layout : require

#include "interop/bindings.h"
#include "interop/light_mesh.h"
#include "lib/numeric.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_LIGHT_MESH_NODES) readonly restrict buffer LightMeshNodes { LightMeshNode light_nodes[]; };
/// LightMeshPoints, side by side: front and back of each.
layout(scalar, set = METHOD_SET, binding = BINDING_LIGHT_MESH_POINTS) readonly restrict buffer LightMeshSides { vec3 light_sides[]; };

/// Counts the corners of a triangle from another one, which keeps their order.
vec3 from_corner(vec3 b, uint corner) {
    return corner == 0u ? b : (corner == 1u ? b.yzx : b.zxy);
}

/// LightMeshNode::first, second and third.
uvec3 light_corners(uint node) {
    return uvec3(light_nodes[node].first, light_nodes[node].second, light_nodes[node].third);
}

/// How far rays may be off on the triangles that they hit: 64 roundings of the size of the triangle.
const vec2 RAY_PLACE_ERROR = vec2(1.0 / 262144.0);

/// The child of a node that is halved some times, each time at the edge that its newest corner looks at. Light is the same on
/// both sides of such a split: it does not matter which one rounding chooses.
uint halved_child(inout vec3 b, uint halvings) {
    uint child = 0u;
    for (uint i = 0u; i < halvings; ++i) {
        bool second = b.y > b.x;
        float apart = abs(b.x - b.y);
        float newest = 2.0 * min(b.x, b.y);
        b = second ? vec3(apart, b.z, newest) : vec3(b.z, apart, newest);
        child = 2u * child + (second ? 1u : 0u);
    }
    return child;
}

/// A place on a triangle, and what is asked about it.
struct LightQuery {
    vec2 error;        ///< of its barycentric coordinates, at most
    bool second_side;  ///< where the place may lie on both sides of a cut by its error: which one to take
    bool unsure;       ///< whether there was such a cut
};

/// The child of a node that is cut.
/// @param cut LightMeshNode::first, second and third
uint cut_child(inout vec3 b, uvec3 cut, inout LightQuery query) {
    float share = uintBitsToFloat(cut.x);
    // In the child, the coordinate of the split point takes over from that of the corner that is cut off.
    float beyond = b.y * (1.0 - share) - b.x * share;
    bool is_unsure = abs(beyond) <= dot(uintBitsToFloat(cut.yz), query.error);
    query.unsure = query.unsure || is_unsure;
    bool second = is_unsure ? query.second_side : beyond > 0.0;
    float part = 1.0 / (second ? 1.0 - share : share);
    b = second ? vec3(b.x * part, beyond * part, b.z) : vec3(-beyond * part, b.y * part, b.z);
    return second ? 1u : 0u;
}

const uint HALVINGS_AT = LIGHT_MESH_KIND_BITS + LIGHT_MESH_CORNER_BITS;
const uint CHILD_AT = HALVINGS_AT + LIGHT_MESH_HALVINGS_BITS;

uint node_kind(uint head) {
    return head & ((1u << LIGHT_MESH_KIND_BITS) - 1u);
}

uint node_corner(uint head) {
    return head >> LIGHT_MESH_KIND_BITS & ((1u << LIGHT_MESH_CORNER_BITS) - 1u);
}

uint node_halvings(uint head) {
    return head >> HALVINGS_AT & ((1u << LIGHT_MESH_HALVINGS_BITS) - 1u);
}

/// The points at the corners of the leaf at a place; NONE where no light is kept.
/// @param b barycentric coordinates on the triangle, then on the leaf
uvec3 leaf_at(uint triangle, inout vec3 b, inout LightQuery query) {
    uint node = triangle;
    uint head = light_nodes[node].head;
    // A loop for each kind: lanes of another one cost nothing where there are none.
    while (node_kind(head) != LIGHT_MESH_LEAF) {
        while (node_kind(head) == LIGHT_MESH_HALVED) {
            b = from_corner(b, node_corner(head));
            node = (head >> CHILD_AT) + halved_child(b, node_halvings(head));
            head = light_nodes[node].head;
        }
        while (node_kind(head) == LIGHT_MESH_CUT) {
            b = from_corner(b, node_corner(head));
            node = (head >> CHILD_AT) + cut_child(b, light_corners(node), query);
            head = light_nodes[node].head;
        }
    }
    return light_corners(node);
}

/// What a white diffuse surface would send out at a point of a triangle, to one side, cd/m2. A point that may lie on both
/// sides of a line, where a wall stands on a floor, say, gets the darker light: no light comes through by rounding.
/// @param place barycentric coordinates b1, b2
/// @param error of place, at most
vec3 kept_light(uint triangle, vec2 place, vec2 error, bool front) {
    vec3 light = vec3(0.0);
    float darkest = INFINITY;
    LightQuery query = LightQuery(error, false, true);
    for (uint side = 0u; side < 2u && query.unsure; ++side) {
        query.second_side = side == 1u;
        query.unsure = false;
        vec3 b = vec3(1.0 - place.x - place.y, place);
        uvec3 points = leaf_at(triangle, b, query);
        if (points.x == NONE) return vec3(0.0);
        // A place may lie beside its leaf by its error.
        b = max(b, vec3(0.0));
        b /= b.x + b.y + b.z;
        uvec3 sides = 2u * points + (front ? 0u : 1u);
        vec3 found = b.x * light_sides[sides.x] + b.y * light_sides[sides.y] + b.z * light_sides[sides.z];
        float sum = found.x + found.y + found.z;
        if (sum < darkest) {
            darkest = sum;
            light = found;
        }
    }
    return light;
}

#endif
