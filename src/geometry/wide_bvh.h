// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/binary_bvh.h"

#include "interop/bvh.h"

#include <cstdint>
#include <vector>

namespace utsuri {

/// The nodes of the flat layout and the order of triangles they refer to.
struct WideBvh {
    std::vector<interop::BvhNode> nodes;  ///< nodes[0] is the root, there even where there is no triangle
    std::vector<std::uint32_t> order;     ///< order[device triangle] = input triangle
    std::uint32_t depth = 0;              ///< nodes on the longest way from the root
};

/// Joins the nodes of a binary BVH into nodes of up to eight children at the least expected cost, by dynamic
/// programming over the binary tree (Ylitie et al. 2017, section 3), orders children by octant, and quantises
/// their boxes outwards.
WideBvh widen(const BinaryBvh& binary);

}  // namespace utsuri
