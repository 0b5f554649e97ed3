// SPDX-License-Identifier: Apache-2.0
#include "geometry/node_boxes.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace utsuri {
namespace {

using interop::BVH_WIDTH;

/// Quantises the boxes of the slots on one axis. Returns the biased exponent of the cell.
struct QuantisedAxis {
    std::uint32_t exponent = 0;
    std::array<std::uint32_t, BVH_WIDTH> lower{};
    std::array<std::uint32_t, BVH_WIDTH> upper{};
};

constexpr double kCells = 255.0;

QuantisedAxis quantise_axis(const SlotBoxes& boxes, const Bounds& parent, int axis) {
    QuantisedAxis result;
    const double origin = static_cast<double>(parent.lower[axis]);
    const double extent = static_cast<double>(parent.upper[axis]) - origin;
    // The smallest power of two with 255 cells covering the extent. Biased exponents below 1 would be
    // denormal.
    int exponent = extent > 0.0 ? std::ilogb(extent / kCells) : -126;
    while (std::ldexp(kCells, exponent) < extent)
        ++exponent;
    exponent = std::max(exponent, -126);
    result.exponent = static_cast<std::uint32_t>(exponent + 127);
    const double cell = std::ldexp(1.0, exponent);
    for (std::uint32_t s = 0; s < BVH_WIDTH; ++s) {
        const Bounds& box = boxes[s];
        if (box.empty()) continue;
        // Differences of float32 values in float64 can round where exponents are far apart: step outwards
        // until sure.
        double lower = std::floor((static_cast<double>(box.lower[axis]) - origin) / cell);
        double upper = std::ceil((static_cast<double>(box.upper[axis]) - origin) / cell);
        while (lower > 0.0 && origin + lower * cell > static_cast<double>(box.lower[axis]))
            lower -= 1.0;
        while (upper < kCells && origin + upper * cell < static_cast<double>(box.upper[axis]))
            upper += 1.0;
        result.lower[s] = static_cast<std::uint32_t>(std::clamp(lower, 0.0, kCells));
        result.upper[s] = static_cast<std::uint32_t>(std::clamp(upper, 0.0, kCells));
    }
    return result;
}

}  // namespace

glm::uvec2 pack_bytes(const std::array<std::uint32_t, BVH_WIDTH>& bytes) {
    glm::uvec2 words(0u);
    for (std::uint32_t s = 0; s < BVH_WIDTH; ++s)
        words[static_cast<int>(s / 4)] |= bytes[s] << (8 * (s % 4));
    return words;
}

void set_boxes(interop::BvhNode& node, const Bounds& bounds, const SlotBoxes& boxes) {
    std::array<QuantisedAxis, 3> axes;
    for (int axis = 0; axis < 3; ++axis)
        axes[static_cast<std::size_t>(axis)] = quantise_axis(boxes, bounds, axis);
    const std::uint32_t node_slots = node.origin_exponents.w & 0xff000000u;
    node.origin_exponents =
        glm::uvec4(std::bit_cast<std::uint32_t>(bounds.lower.x), std::bit_cast<std::uint32_t>(bounds.lower.y),
                   std::bit_cast<std::uint32_t>(bounds.lower.z),
                   axes[0].exponent | (axes[1].exponent << 8) | (axes[2].exponent << 16) | node_slots);
    node.lower_xy = glm::uvec4(pack_bytes(axes[0].lower), pack_bytes(axes[1].lower));
    node.lower_z_upper_x = glm::uvec4(pack_bytes(axes[2].lower), pack_bytes(axes[0].upper));
    node.upper_yz = glm::uvec4(pack_bytes(axes[1].upper), pack_bytes(axes[2].upper));
}

}  // namespace utsuri
