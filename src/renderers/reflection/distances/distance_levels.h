// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "interop/distance_map.h"

#include <bit>
#include <cstdint>

namespace utsuri {

/// Samples of a face of `size` texels an edge, border included.
constexpr std::uint32_t samples_per_face(std::uint32_t size) {
    const std::uint32_t stride = size + 2 * interop::DISTANCE_BORDER;
    return stride * stride;
}

/// Levels of bounds over a face: blocks of one texel, of two by two, up to all of it.
/// @param size a power of two
constexpr std::uint32_t bound_levels(std::uint32_t size) {
    return static_cast<std::uint32_t>(std::bit_width(size));
}

/// Where a level begins among the bounds of a face: levels of size^2, size^2 / 4, ... blocks come before it.
constexpr std::uint32_t first_of_level(std::uint32_t size, std::uint32_t level) {
    const std::uint32_t at_level = size >> level;
    return 4 * (size * size - at_level * at_level) / 3;
}

constexpr std::uint32_t bounds_per_face(std::uint32_t size) {
    return first_of_level(size, bound_levels(size) - 1) + 1;
}

}  // namespace utsuri
