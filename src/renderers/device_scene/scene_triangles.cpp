// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/scene_triangles.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace utsuri {
namespace {

double least_height(const Corners& corners) {
    double longest = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
        longest = std::max(longest, glm::distance(corners[i], corners[(i + 1) % 3]));
    return glm::length(doubled_area(corners)) / longest;
}

}  // namespace

Corners corners_of(const SceneData& scene, std::uint32_t triangle) {
    const interop::BvhTriangle& t = scene.bvh.triangles[triangle];
    return {glm::dvec3(t.v0), glm::dvec3(t.v1), glm::dvec3(t.v2)};
}

Bounds bounds_of(const interop::BvhTriangle& triangle) {
    Bounds bounds;
    for (const glm::vec3& vertex : {triangle.v0, triangle.v1, triangle.v2})
        bounds.extend(vertex);
    return bounds;
}

glm::dvec3 doubled_area(const Corners& corners) {
    return glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
}

std::span<const std::uint32_t> triangles_of(const SceneData& scene, std::uint32_t instance) {
    const std::vector<std::uint32_t>& first = scene.instance_triangles.first;
    return std::span(scene.instance_triangles.triangles)
        .subspan(first[instance], first[instance + 1] - first[instance]);
}

std::uint32_t material_of(const SceneData& scene, std::uint32_t instance) {
    return scene.triangle_infos[triangles_of(scene, instance).front()].material;
}

const Bounds& bounds_of(const SceneData& scene, std::uint32_t instance) {
    return scene.instance_triangles.bounds[instance];
}

double vertex_error(const SceneData& scene) {
    const glm::dvec3 largest =
        glm::max(glm::abs(glm::dvec3(scene.bounds.lower)), glm::abs(glm::dvec3(scene.bounds.upper)));
    return kUnitRoundoff * glm::length(largest);
}

TrianglePlane::TrianglePlane(const SceneData& scene, std::uint32_t triangle, const glm::dvec3& normal)
    : scene_(scene),
      error_(vertex_error(scene)),
      height_(least_height(corners_of(scene, triangle))),
      normal_(normal) {
    const Corners corners = corners_of(scene, triangle);
    centre_ = (corners[0] + corners[1] + corners[2]) / 3.0;
}

TrianglePlane::TrianglePlane(const SceneData& scene, std::uint32_t triangle)
    : TrianglePlane(scene, triangle, glm::normalize(doubled_area(corners_of(scene, triangle)))) {}

double TrianglePlane::tolerance(double distance) const {
    return error_ * (2.0 + 3.0 * distance / height_);
}

bool TrianglePlane::holds(const glm::dvec3& point) const {
    const glm::dvec3 from_centre = point - centre_;
    return std::abs(glm::dot(from_centre, normal_)) <= tolerance(glm::length(from_centre));
}

bool TrianglePlane::holds(std::uint32_t triangle) const {
    const Corners corners = corners_of(scene_, triangle);
    return std::all_of(corners.begin(), corners.end(),
                       [&](const glm::dvec3& corner) { return holds(corner); });
}

}  // namespace utsuri
