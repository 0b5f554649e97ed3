// SPDX-License-Identifier: Apache-2.0
// Closest-hit and any-hit search of the BVH.
#ifndef UTSURI_KERNELS_SCENE_TRAVERSAL
#define UTSURI_KERNELS_SCENE_TRAVERSAL

#extension GL_EXT_control_flow_attributes : require

#include "kernels/scene/layers.glsl"
#include "kernels/scene/scene_bindings.glsl"
#include "lib/bvh_node.glsl"
#include "lib/triangle.glsl"

struct Ray {
    vec3 origin;
    vec3 direction;           ///< any length but zero; t is in multiples of it
    float t_max;
    uint excluded[2];         ///< triangles that cannot be hit: the one left, the one aimed at; or NONE
    uint excluded_instance;   ///< honoured where EXCLUDES_INSTANCE
};

struct Hit {
    float t;
    uint triangle;   ///< NONE where nothing is hit
    float b1;
    float b2;
};

Ray make_ray(vec3 origin, vec3 direction, uint leaving_triangle, uint excluded_instance) {
    return Ray(origin, direction, INFINITY, uint[2](leaving_triangle, NONE), excluded_instance);
}

/// 0 < t <= best.t, and of equal distances the lowest triangle index, whatever the order of the search.
bool is_closer(TriangleHit candidate, uint triangle, Hit best) {
    return candidate.hit && candidate.t > 0.0 &&
           (candidate.t < best.t || (candidate.t == best.t && triangle < best.triangle));
}

bool is_excluded(Ray ray, uint triangle, BvhTriangle vertices) {
    if (triangle == ray.excluded[0] || triangle == ray.excluded[1]) return true;
    if (EXCLUDES_INSTANCE && triangle_infos[triangle].instance == ray.excluded_instance) return true;
    // From a capture point on a mirror the wall behind it is seen from its edge.
    if (HAS_LAYERS && EXCLUDES_INSTANCE && is_edge_on(vertices, ray.origin)) return true;
    return HAS_LAYERS && (holds_end(vertices, ray.excluded[0], ray.origin) ||
                          holds_end(vertices, ray.excluded[1], ray.origin + ray.direction));
}

/// The closest hit so far, or of what lies on top at that place.
struct Search {
    Hit best;
    float reach;  ///< t up to which there may be a better one
};

/// @param any_hit whether one hit is as good as any other
void consider(uint triangle, Ray ray, ShearedRay sheared, bool any_hit, inout Search search) {
    BvhTriangle vertices = bvh_triangle(triangle);
    TriangleHit candidate = intersect_triangle(sheared, vertices.v0, vertices.v1, vertices.v2);
    bool is_better = is_closer(candidate, triangle, search.best);
    float depth = 0.0;
    if (HAS_LAYERS && !any_hit && candidate.hit && candidate.t > 0.0) {
        depth = layer_depth(vertices, ray.direction, candidate.t);
        if (abs(candidate.t - search.best.t) <= depth) {
            is_better = is_on_top(triangle, vertices, search.best.triangle, is_better);
        }
    }
    if (!is_better || is_excluded(ray, triangle, vertices)) return;
    search.best = Hit(candidate.t, triangle, candidate.b1, candidate.b2);
    search.reach = candidate.t + depth;
}

/// The nodes and triangles of a group still to visit are bits of one word: see hit_children().
Hit traverse(Ray ray, bool any_hit) {
    const uint NODE_MASK = ~((1u << BVH_NODE_BITS) - 1u);
    BoxRay box_ray = make_box_ray(ray.origin, ray.direction);
    ShearedRay sheared = shear_ray(ray.origin, ray.direction);
    Search search = Search(Hit(ray.t_max, NONE, 0.0, 0.0), ray.t_max);
    uvec2 stack[STACK_SIZE];
    uint stack_size = 0u;
    uvec2 group = uvec2(0u, 1u << 31);  // the root, as if it were the only child of a node
    uvec2 leaf = uvec2(0u);             // first triangle of a node, and a bit for each to be tested
    bool searching = true;
    while (searching) {
        // Nodes until triangles turn up: a subgroup then tests the triangles of all its rays together.
        while (leaf.y == 0u) {
            if ((group.y & NODE_MASK) == 0u) {
                if (stack_size == 0u) {
                    searching = false;
                    break;
                }
                group = stack[--stack_size];
            }
            uint bit = uint(findMSB(group.y));
            group.y &= ~(1u << bit);
            if ((group.y & NODE_MASK) != 0u) stack[stack_size++] = group;

            uint slot = (bit - BVH_NODE_BITS) ^ box_ray.octant;
            BvhNode node = bvh_node(group.x + bitCount(group.y & ((1u << slot) - 1u)));
            uint hits = hit_children(node, box_ray, search.reach);
            group = uvec2(node.bases_meta.x, (hits & NODE_MASK) | (node.origin_exponents.w >> BVH_NODE_BITS));
            leaf = uvec2(node.bases_meta.y, hits & ~NODE_MASK);
        }
        while (leaf.y != 0u) {
            uint triangle = leaf.x + uint(findLSB(leaf.y));
            leaf.y &= leaf.y - 1u;
            consider(triangle, ray, sheared, any_hit, search);
            if (any_hit && search.best.triangle != NONE) {
                searching = false;
                leaf.y = 0u;
            }
        }
    }
    return search.best;
}

Hit closest_hit(Ray ray) {
    return traverse(ray, false);
}

bool is_occluded(Ray ray) {
    return traverse(ray, true).triangle != NONE;
}

#endif
