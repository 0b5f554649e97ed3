// SPDX-License-Identifier: Apache-2.0
#include "geometry/bvh.h"

#include "base/check.h"
#include "base/same_bits.h"
#include "geometry/binary_bvh.h"
#include "geometry/bounds.h"
#include "geometry/node_boxes.h"
#include "geometry/wide_bvh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

namespace utsuri {
namespace {

std::vector<interop::BvhTriangle> in_device_order(std::span<const glm::vec3> positions,
                                                  std::span<const glm::uvec3> triangles,
                                                  const std::vector<std::uint32_t>& order) {
    std::vector<interop::BvhTriangle> result;
    result.reserve(order.size());
    for (const std::uint32_t input : order) {
        const glm::uvec3& triangle = triangles[input];
        result.push_back({positions[triangle.x], positions[triangle.y], positions[triangle.z]});
    }
    return result;
}

/// Box of what is in a slot.
Bounds bounds_of(const Bvh& bvh, const SlotContent& content, const std::vector<Bounds>& nodes) {
    if (content.is_node) return nodes[content.node];
    Bounds bounds;
    for (std::uint32_t t = 0; t < content.triangle_count; ++t) {
        const interop::BvhTriangle& triangle = bvh.triangles[content.first_triangle + t];
        for (const glm::vec3& vertex : {triangle.v0, triangle.v1, triangle.v2})
            bounds.extend(vertex);
    }
    return bounds;
}

/// Whether a triangle in a slot moved.
/// @param nodes whether one below each node did
bool has_moved(const std::vector<interop::BvhTriangle>& before, const Bvh& bvh, const SlotContent& content,
               const std::vector<bool>& nodes) {
    if (content.is_node) return nodes[content.node];
    for (std::uint32_t t = 0; t < content.triangle_count; ++t) {
        const std::uint32_t triangle = content.first_triangle + t;
        if (!same_bits(before[triangle], bvh.triangles[triangle])) return true;
    }
    return false;
}

}  // namespace

Bvh build_bvh(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles) {
    // Joining nodes never makes the tree deeper, so the bound on the binary tree bounds the wide one.
    WideBvh wide = widen(build_binary_bvh(positions, triangles, interop::BVH_MAX_DEPTH));
    Bvh bvh;
    bvh.nodes = std::move(wide.nodes);
    bvh.order = std::move(wide.order);
    bvh.depth = wide.depth;
    bvh.triangles = in_device_order(positions, triangles, bvh.order);
    return bvh;
}

void refit(Bvh& bvh, std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles) {
    UTSURI_CHECK_EQ(triangles.size(), bvh.order.size());
    const std::vector<interop::BvhTriangle> before =
        std::exchange(bvh.triangles, in_device_order(positions, triangles, bvh.order));
    if (bvh.triangles.empty()) return;
    const bool knows_bounds = !bvh.node_bounds.empty();
    bvh.node_bounds.resize(bvh.nodes.size());
    std::vector<bool> moved(bvh.nodes.size());
    // Children come after their parents.
    for (std::size_t n = bvh.nodes.size(); n-- > 0;) {
        std::array<SlotContent, interop::BVH_WIDTH> slots;
        for (std::uint32_t slot = 0; slot < interop::BVH_WIDTH; ++slot)
            slots[slot] = slot_content(bvh.nodes[n], slot);
        moved[n] = !knows_bounds || std::any_of(slots.begin(), slots.end(), [&](const SlotContent& content) {
            return has_moved(before, bvh, content, moved);
        });
        if (!moved[n]) continue;
        SlotBoxes boxes;
        Bounds bounds;
        for (std::size_t slot = 0; slot < slots.size(); ++slot) {
            boxes[slot] = bounds_of(bvh, slots[slot], bvh.node_bounds);
            bounds.extend(boxes[slot]);
        }
        bvh.node_bounds[n] = bounds;
        set_boxes(bvh.nodes[n], bounds, boxes);
    }
}

ChildBox child_box(const interop::BvhNode& node, std::uint32_t slot) {
    const glm::uvec3 lower(packed_byte(node.lower_xy.x, node.lower_xy.y, slot),
                           packed_byte(node.lower_xy.z, node.lower_xy.w, slot),
                           packed_byte(node.lower_z_upper_x.x, node.lower_z_upper_x.y, slot));
    const glm::uvec3 upper(packed_byte(node.lower_z_upper_x.z, node.lower_z_upper_x.w, slot),
                           packed_byte(node.upper_yz.x, node.upper_yz.y, slot),
                           packed_byte(node.upper_yz.z, node.upper_yz.w, slot));
    ChildBox box{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto origin = static_cast<double>(std::bit_cast<float>(node.origin_exponents[axis]));
        const int exponent = static_cast<int>((node.origin_exponents.w >> (8 * axis)) & 0xffu) - 127;
        box.lower[axis] = origin + std::ldexp(static_cast<double>(lower[axis]), exponent);
        box.upper[axis] = origin + std::ldexp(static_cast<double>(upper[axis]), exponent);
    }
    return box;
}

SlotContent slot_content(const interop::BvhNode& node, std::uint32_t slot) {
    SlotContent content;
    const std::uint32_t meta = packed_byte(node.bases_meta.z, node.bases_meta.w, slot);
    const std::uint32_t node_slots = node.origin_exponents.w >> 24;
    if ((node_slots >> slot & 1u) != 0) {
        content.is_node = true;
        content.node =
            node.bases_meta.x + static_cast<std::uint32_t>(std::popcount(node_slots & ((1u << slot) - 1u)));
    } else if (meta != 0) {
        content.first_triangle = node.bases_meta.y + (meta & 0x1fu);
        content.triangle_count = static_cast<std::uint32_t>(std::popcount(meta >> 5));
    }
    return content;
}

}  // namespace utsuri
