// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/closest_hit.h"

#include "renderers/device_scene/scene_triangles.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace utsuri {
namespace {

/// How near a plane with others in it a point is from which it is seen from its edge, in distances of layers:
/// as shaders/kernels/scene/layers.glsl has it.
constexpr double kOffSurface = 4.0;

bool is_edge_on(const SceneData& scene, std::uint32_t triangle, const glm::dvec3& point) {
    const Corners corners = corners_of(scene, triangle);
    const glm::dvec3 area = doubled_area(corners);
    return std::abs(glm::dot(area, point - corners[0])) <=
           kOffSurface * static_cast<double>(scene.layer_distance) * glm::length(area);
}

}  // namespace

std::optional<ReferenceHit> closest_hit_without(const SceneData& scene, std::uint32_t instance,
                                                const glm::dvec3& origin, const glm::dvec3& direction,
                                                double t_max) {
    return closest_hit_reference(scene.bvh, origin, direction, t_max, [&](std::uint32_t triangle) {
        if (scene.triangle_infos[triangle].instance == instance) return false;
        return scene.layer_distance == 0.0f || !is_edge_on(scene, triangle, origin);
    });
}

}  // namespace utsuri
