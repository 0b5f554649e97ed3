// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bounds.h"

#include "interop/bvh.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace utsuri {

/// A BVH as the device reads it.
struct Bvh {
    std::vector<interop::BvhNode> nodes;          ///< at least the root
    std::vector<interop::BvhTriangle> triangles;  ///< in device order
    std::vector<std::uint32_t> order;             ///< order[device triangle] = input triangle
    std::uint32_t depth = 1;                      ///< at most interop::BVH_MAX_DEPTH
    /// Of what is in each node, before it is quantised: kept by refit() for the next one, empty before the
    /// first.
    std::vector<Bounds> node_bounds;
};

/// Builds the BVH of a triangle soup; see binary_bvh.h and wide_bvh.h for the methods and their guarantees.
/// @param positions finite vertices, metres
/// @param triangles indices into positions, in range
Bvh build_bvh(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles);

/// Moves the triangles of a BVH: which nodes there are and what they hold stays, the boxes above triangles
/// that moved are made anew, at the first call all of them. The result depends on where the triangles are,
/// not on the steps that they took. Rays find the same as with a BVH of the moved triangles, the slower the
/// farther these went each its own way.
/// @param positions finite vertices, metres
/// @param triangles indices into positions, in range; as many as the BVH has, in the order of its input
void refit(Bvh& bvh, std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles);

/// Box of the child in `slot` of a node, as the device sees it, in float64 without rounding.
struct ChildBox {
    glm::dvec3 lower;
    glm::dvec3 upper;
};
ChildBox child_box(const interop::BvhNode& node, std::uint32_t slot);

/// Byte `slot` of two packed words.
inline std::uint32_t packed_byte(std::uint32_t low, std::uint32_t high, std::uint32_t slot) {
    return ((slot < 4 ? low : high) >> (8 * (slot % 4))) & 0xffu;
}

/// Meta byte of a slot (see interop/bvh.h) taken apart.
struct SlotContent {
    bool is_node = false;
    std::uint32_t node = 0;            ///< index of the child node
    std::uint32_t first_triangle = 0;  ///< device triangles of the leaf
    std::uint32_t triangle_count = 0;  ///< 0 for a node or an empty slot
};
SlotContent slot_content(const interop::BvhNode& node, std::uint32_t slot);

}  // namespace utsuri
