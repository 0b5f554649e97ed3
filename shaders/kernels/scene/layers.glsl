// SPDX-License-Identifier: Apache-2.0
// Surfaces that overlap in one plane: what lies on top is hit, from whichever side and however rounding puts them. Which one
// lies on top, the host has found (coplanar_layers.h).
#ifndef UTSURI_KERNELS_SCENE_LAYERS
#define UTSURI_KERNELS_SCENE_LAYERS

#include "kernels/scene/scene_bindings.glsl"
#include "lib/triangle_geometry.glsl"

/// How far apart surfaces in one plane are at most: layer_distance() of coplanar_layers.h.
float layer_distance() {
    uvec4 root = texelFetch(bvh_nodes, 0);
    vec3 lower = uintBitsToFloat(root.xyz);
    vec3 upper = lower + 255.0 * uintBitsToFloat(uvec3(root.w, root.w >> 8u, root.w >> 16u) << 23u & 0x7f800000u);
    float largest = max_component(max(abs(lower), abs(upper)));
    // The next power of two, times 2^-19.
    return uintBitsToFloat((floatBitsToUint(largest) & 0x7f800000u) + (1u << 23u)) / 524288.0;
}

/// What the host finds to be in one plane in float64 is so here to within this many distances of layers.
const float LAYER_ROUNDING = 2.0;

/// Whether all corners of a triangle are in the plane of another.
bool lies_in_plane(BvhTriangle of_plane, BvhTriangle other) {
    vec3 normal = triangle_normal(of_plane);
    vec3 heights = vec3(dot(normal, other.v0 - of_plane.v0), dot(normal, other.v1 - of_plane.v0), dot(normal, other.v2 - of_plane.v0));
    return max_component(abs(heights)) <= LAYER_ROUNDING * layer_distance();
}

bool are_in_one_plane(BvhTriangle a, uint b) {
    BvhTriangle other = bvh_triangle(b);
    return lies_in_plane(a, other) || lies_in_plane(other, a);
}

/// How far apart on a ray hits on surfaces in one plane may be, in multiples of its direction.
float layer_depth(BvhTriangle vertices, vec3 direction, float t) {
    const float T_ROUNDING = 1.0 / 1048576.0;
    vec3 normal = triangle_normal(vertices);
    float reach = LAYER_ROUNDING * layer_distance() + T_ROUNDING * t * max_component(abs(direction));
    return reach / abs(dot(normal, direction));
}

/// Whether a triangle is seen from its edge, if at all, from a point on some surface.
bool is_edge_on(BvhTriangle vertices, vec3 point) {
    // Points are moved off their surfaces by their own rounding.
    const float OFF_SURFACE = 4.0;
    return abs(dot(triangle_normal(vertices), point - vertices.v0)) <= OFF_SURFACE * layer_distance();
}

/// Whether a point on another triangle is in the plane of this one, and that triangle, too: no ray from there comes to this
/// one, and it hides nothing there.
bool holds_end(BvhTriangle vertices, uint end, vec3 point) {
    return end != NONE && is_edge_on(vertices, point) && are_in_one_plane(vertices, end);
}

/// Of two hits no farther apart than layer_depth(), whether the candidate is on what lies on top; as is_nearer where neither
/// lies on the other.
bool is_on_top(uint candidate, BvhTriangle vertices, uint best, bool is_nearer) {
    if (best == NONE) return is_nearer;
    uint layers = triangle_infos[candidate].layers;
    uint best_layers = triangle_infos[best].layers;
    if (layers == best_layers || !are_in_one_plane(vertices, best)) return is_nearer;
    return layers < best_layers;
}

#endif
