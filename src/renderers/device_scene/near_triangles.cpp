// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/near_triangles.h"

#include "renderers/device_scene/scene_triangles.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace utsuri {
namespace {

bool overlaps(const Bounds& a, const Bounds& b) {
    return a.lower.x <= b.upper.x && a.lower.y <= b.upper.y && a.lower.z <= b.upper.z &&
           b.lower.x <= a.upper.x && b.lower.y <= a.upper.y && b.lower.z <= a.upper.z;
}

Bounds bounds_of(const ChildBox& box) {
    return {glm::vec3(box.lower), glm::vec3(box.upper)};
}

/// Whether some of a box may be that near to a plane.
bool reaches_plane(const Bounds& box, const TriangleFrame& frame, double gap) {
    const glm::dvec3 centre = 0.5 * (glm::dvec3(box.lower) + glm::dvec3(box.upper));
    const glm::dvec3 half = 0.5 * (glm::dvec3(box.upper) - glm::dvec3(box.lower));
    return std::abs(frame.height(centre)) <= gap + glm::dot(glm::abs(frame.normal()), half);
}

}  // namespace

std::vector<std::uint32_t> triangles_near_plane(const SceneData& scene, std::uint32_t triangle,
                                                const TriangleFrame& frame, double gap) {
    // Twice the gap: boxes are of float32.
    const auto room = static_cast<float>(2.0 * gap);
    Bounds around = utsuri::bounds_of(scene.bvh.triangles[triangle]);
    around.lower -= glm::vec3(room);
    around.upper += glm::vec3(room);
    const auto is_near = [&](const Bounds& box) {
        return overlaps(box, around) && reaches_plane(box, frame, 2.0 * gap);
    };
    std::vector<std::uint32_t> found;
    std::vector<std::uint32_t> nodes = {0};
    while (!nodes.empty()) {
        const interop::BvhNode& node = scene.bvh.nodes[nodes.back()];
        nodes.pop_back();
        for (std::uint32_t slot = 0; slot < interop::BVH_WIDTH; ++slot) {
            const SlotContent content = slot_content(node, slot);
            if (!content.is_node && content.triangle_count == 0) continue;
            if (!is_near(bounds_of(child_box(node, slot)))) continue;
            if (content.is_node) nodes.push_back(content.node);
            for (std::uint32_t i = 0; i < content.triangle_count; ++i) {
                const std::uint32_t other = content.first_triangle + i;
                if (other != triangle && is_near(utsuri::bounds_of(scene.bvh.triangles[other])))
                    found.push_back(other);
            }
        }
    }
    return found;
}

}  // namespace utsuri
