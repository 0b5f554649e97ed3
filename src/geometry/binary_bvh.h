// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bounds.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace utsuri {

/// A node over the triangles order[first] .. order[first + count). A node of one triangle is a leaf; else its
/// left child is the next node and its right child is `right`.
struct BinaryBvhNode {
    Bounds bounds;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t right = 0;

    [[nodiscard]] bool is_leaf() const { return count == 1; }
};

/// A binary BVH down to single triangles, the input of the wide one. Depth-first: nodes[0] is the root, a
/// subtree over n triangles takes the 2n - 1 nodes from its root on. No nodes for no triangles.
struct BinaryBvh {
    std::vector<BinaryBvhNode> nodes;
    std::vector<std::uint32_t> order;  ///< triangle indices
};

/// Builds by the surface area heuristic over binned centroids (Wald 2007), with splits at the median where
/// centroids coincide or where the depth (counted in nodes, root 1) would exceed `max_depth`. The tree
/// depends on nothing but the input: not on threads, and not on the scale by a power of two.
/// @param positions finite vertices
/// @param triangles indices into them, in range
/// @param max_depth at least 2 + log2 of the number of triangles
BinaryBvh build_binary_bvh(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles,
                           std::uint32_t max_depth);

}  // namespace utsuri
