// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bounds.h"

#include "interop/bvh.h"

#include <array>

namespace utsuri {

/// A byte for each slot in two words.
glm::uvec2 pack_bytes(const std::array<std::uint32_t, interop::BVH_WIDTH>& bytes);

/// Boxes of the children of one node by slot; empty where a slot is.
using SlotBoxes = std::array<Bounds, interop::BVH_WIDTH>;

/// Sets the grid of a node and the boxes of its children on it, quantised outwards; all else of the node
/// stays.
/// @param bounds of the node: holds the boxes
void set_boxes(interop::BvhNode& node, const Bounds& bounds, const SlotBoxes& boxes);

}  // namespace utsuri
