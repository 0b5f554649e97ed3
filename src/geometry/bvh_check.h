// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bvh.h"

#include <cstddef>
#include <string>

namespace utsuri {

/// Walks a BVH and tells the first thing that is wrong with it, or an empty text: every node and every
/// triangle reached exactly once, every triangle inside each box above it, `order` a permutation, depth as
/// stated and within bounds.
/// @param triangle_count triangles the BVH was built from
std::string check_bvh(const Bvh& bvh, std::size_t triangle_count);

}  // namespace utsuri
