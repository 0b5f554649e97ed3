// SPDX-License-Identifier: Apache-2.0
#include "geometry/reference_intersection.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <vector>

namespace utsuri {
namespace {

/// Slab test in float64, widened by far more than its rounding.
bool hits_box(const ChildBox& box, const glm::dvec3& origin, const glm::dvec3& direction, double t_max) {
    constexpr double kRelativeSlack = 1e-12;
    double t_near = 0.0;
    double t_far = t_max;
    for (int axis = 0; axis < 3; ++axis) {
        const double slack =
            kRelativeSlack * (std::abs(box.lower[axis]) + std::abs(box.upper[axis]) + std::abs(origin[axis]));
        const double lower = box.lower[axis] - slack - origin[axis];
        const double upper = box.upper[axis] + slack - origin[axis];
        if (direction[axis] == 0.0) {
            if (lower > 0.0 || upper < 0.0) return false;
            continue;
        }
        const double t0 = lower / direction[axis];
        const double t1 = upper / direction[axis];
        t_near = std::max(t_near, std::min(t0, t1));
        t_far = std::min(t_far, std::max(t0, t1));
    }
    return t_near <= t_far;
}

}  // namespace

std::optional<ReferenceHit> intersect_triangle_reference(const interop::BvhTriangle& triangle,
                                                         const glm::dvec3& origin,
                                                         const glm::dvec3& direction, double t_max) {
    const glm::dvec3 v0(triangle.v0);
    const glm::dvec3 edge1 = glm::dvec3(triangle.v1) - v0;
    const glm::dvec3 edge2 = glm::dvec3(triangle.v2) - v0;
    const glm::dvec3 p = glm::cross(direction, edge2);
    const double determinant = glm::dot(edge1, p);
    if (determinant == 0.0) return std::nullopt;
    const glm::dvec3 s = origin - v0;
    const double b1 = glm::dot(s, p) / determinant;
    const glm::dvec3 q = glm::cross(s, edge1);
    const double b2 = glm::dot(direction, q) / determinant;
    const double t = glm::dot(edge2, q) / determinant;
    if (b1 < 0.0 || b2 < 0.0 || b1 + b2 > 1.0 || !(t > 0.0) || !(t < t_max)) return std::nullopt;
    return ReferenceHit{t, 0, b1, b2, determinant < 0.0};
}

std::optional<ReferenceHit> closest_hit_reference(const Bvh& bvh, const glm::dvec3& origin,
                                                  const glm::dvec3& direction, double t_max,
                                                  const std::function<bool(std::uint32_t)>& accept) {
    std::optional<ReferenceHit> best;
    std::vector<std::uint32_t> stack{0};
    while (!stack.empty()) {
        const interop::BvhNode& node = bvh.nodes[stack.back()];
        stack.pop_back();
        for (std::uint32_t slot = 0; slot < interop::BVH_WIDTH; ++slot) {
            const SlotContent content = slot_content(node, slot);
            if (!content.is_node && content.triangle_count == 0) continue;
            if (!hits_box(child_box(node, slot), origin, direction, t_max)) continue;
            if (content.is_node) stack.push_back(content.node);
            for (std::uint32_t i = 0; i < content.triangle_count; ++i) {
                const std::uint32_t triangle = content.first_triangle + i;
                auto hit = intersect_triangle_reference(bvh.triangles[triangle], origin, direction, t_max);
                if (!hit || !accept(triangle)) continue;
                hit->triangle = triangle;
                t_max = hit->t;
                best = hit;
            }
        }
    }
    return best;
}

}  // namespace utsuri
