// SPDX-License-Identifier: Apache-2.0
#include "geometry/bvh_check.h"

#include <fmt/format.h>
#include <glm/common.hpp>

#include <algorithm>
#include <limits>
#include <vector>

namespace utsuri {
namespace {

class Checker {
  public:
    explicit Checker(const Bvh& bvh)
        : bvh_(bvh), node_visits_(bvh.nodes.size(), 0), triangle_visits_(bvh.triangles.size(), 0) {}

    std::string run(std::size_t triangle_count) {
        if (bvh_.triangles.size() != triangle_count || bvh_.order.size() != triangle_count) {
            return fmt::format("{} triangles and {} order entries for {} input triangles",
                               bvh_.triangles.size(), bvh_.order.size(), triangle_count);
        }
        const double infinity = std::numeric_limits<double>::infinity();
        visit_node(0, {glm::dvec3(-infinity), glm::dvec3(infinity)}, 1);
        if (!problem_.empty()) return problem_;
        if (deepest_ != bvh_.depth || bvh_.depth > interop::BVH_MAX_DEPTH) {
            return fmt::format("depth {} found, {} stated, {} allowed", deepest_, bvh_.depth,
                               interop::BVH_MAX_DEPTH);
        }
        return check_visits(triangle_count);
    }

  private:
    void fail(std::string text) {
        if (problem_.empty()) problem_ = std::move(text);
    }

    void visit_node(std::uint32_t index, const ChildBox& bounds, std::uint32_t depth) {
        if (index >= bvh_.nodes.size()) return fail(fmt::format("node {} does not exist", index));
        if (++node_visits_[index] > 1) return fail(fmt::format("node {} is reached twice", index));
        deepest_ = std::max(deepest_, depth);
        const interop::BvhNode& node = bvh_.nodes[index];
        for (std::uint32_t slot = 0; slot < interop::BVH_WIDTH && problem_.empty(); ++slot) {
            const SlotContent content = slot_content(node, slot);
            if (!content.is_node && content.triangle_count == 0) continue;
            // A grid may reach beyond the parent's box by its rounding; what counts is what both boxes let
            // through.
            const ChildBox own = child_box(node, slot);
            const ChildBox box{glm::max(bounds.lower, own.lower), glm::min(bounds.upper, own.upper)};
            if (content.is_node) visit_node(content.node, box, depth + 1);
            for (std::uint32_t i = 0; i < content.triangle_count; ++i) {
                visit_triangle(content.first_triangle + i, box, index);
            }
        }
    }

    void visit_triangle(std::uint32_t index, const ChildBox& box, std::uint32_t node) {
        if (index >= bvh_.triangles.size()) return fail(fmt::format("triangle {} does not exist", index));
        if (++triangle_visits_[index] > 1) return fail(fmt::format("triangle {} is reached twice", index));
        const interop::BvhTriangle& triangle = bvh_.triangles[index];
        for (const glm::vec3& vertex : {triangle.v0, triangle.v1, triangle.v2}) {
            for (int axis = 0; axis < 3; ++axis) {
                const auto value = static_cast<double>(vertex[axis]);
                if (value < box.lower[axis] || value > box.upper[axis]) {
                    fail(
                        fmt::format("triangle {} leaves its box below node {} on axis {}: {} not in [{}, {}]",
                                    index, node, axis, value, box.lower[axis], box.upper[axis]));
                }
            }
        }
    }

    std::string check_visits(std::size_t triangle_count) const {
        for (std::size_t i = 0; i < node_visits_.size(); ++i) {
            if (node_visits_[i] != 1) return fmt::format("node {} is not reached", i);
        }
        std::vector<std::uint8_t> seen(triangle_count, 0);
        for (std::size_t i = 0; i < triangle_count; ++i) {
            if (triangle_visits_[i] != 1) return fmt::format("triangle {} is not reached", i);
            const std::uint32_t input = bvh_.order[i];
            if (input >= triangle_count || seen[input] != 0)
                return fmt::format("order is no permutation at {}", i);
            seen[input] = 1;
        }
        return {};
    }

    const Bvh& bvh_;
    std::vector<std::uint8_t> node_visits_;
    std::vector<std::uint8_t> triangle_visits_;
    std::uint32_t deepest_ = 0;
    std::string problem_;
};

}  // namespace

std::string check_bvh(const Bvh& bvh, std::size_t triangle_count) {
    return Checker(bvh).run(triangle_count);
}

}  // namespace utsuri
