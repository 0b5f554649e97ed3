// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/maps/seen_changes.h"

#include "base/same_bits.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace utsuri {
namespace {

/// Rounding of a ray's direction and of the hit on it, in float32, as a share of the distance: a few units in
/// the last place.
constexpr double kRounding = 0x1p-20;

glm::dvec3 axis(std::uint32_t index) {
    glm::dvec3 unit(0.0);
    unit[static_cast<int>(index % 3)] = 1.0;
    return unit;
}

}  // namespace

ViewPyramid::ViewPyramid(const interop::CameraInfo& camera)
    : apex(camera.origin), right(camera.right), up(camera.up), forward(camera.forward) {}

ViewPyramid::ViewPyramid(const glm::dvec3& point, std::uint32_t face, double wider)
    : apex(point),
      right((1.0 + wider) * axis(face / 2 + 1)),
      up((1.0 + wider) * axis(face / 2 + 2)),
      forward((face % 2 == 0 ? 1.0 : -1.0) * axis(face / 2)) {}

bool ViewPyramid::may_show(const interop::BvhTriangle& triangle) const {
    const auto along = [](const glm::dvec3& offset, const glm::dvec3& direction) {
        return glm::dot(offset, direction) / glm::dot(direction, direction);
    };
    const glm::dvec3 normal = glm::normalize(glm::cross(right, up));
    const double per_depth = glm::dot(forward, normal);
    // Of depth, and of a place in the picture, by which both are off for an offset of length one.
    const double shorter = std::min(glm::length(right), glm::length(up));
    const double depth_rounding = kRounding / std::abs(per_depth);
    const double rounding = kRounding / shorter + depth_rounding * (1.0 + glm::length(forward) / shorter);
    // Beyond the left, right, lower and upper side.
    std::array<int, 4> beyond{};
    for (const glm::vec3& vertex : {triangle.v0, triangle.v1, triangle.v2}) {
        const glm::dvec3 offset = glm::dvec3(vertex) - apex;
        const double depth = glm::dot(offset, normal) / per_depth;
        const double x = along(offset - depth * forward, right);
        const double y = along(offset - depth * forward, up);
        const double least = rounding * glm::length(offset);
        const std::array distances = {-x - depth, x - depth, -y - depth, y - depth};
        for (std::size_t side = 0; side < 4; ++side)
            beyond[side] += distances[side] > least ? 1 : 0;
    }
    return std::none_of(beyond.begin(), beyond.end(), [](int corners) { return corners == 3; });
}

SeenChanges::SeenChanges(const SceneData& data, const SceneChange& change, std::vector<std::uint32_t> lit)
    : data_(data), change_(change), lit_(std::move(lit)) {
    for (std::uint32_t t = 0; t < data.triangle_infos.size(); ++t) {
        const SurfaceFeatures& surface = data.requirements.surfaces[data.triangle_infos[t].material];
        if (surface.glossy || surface.mirror) reflecting_.push_back(t);
    }
}

bool SeenChanges::has_moved(std::uint32_t instance) const {
    for (std::size_t i = 0; i < change_.triangles.size(); ++i) {
        const std::uint32_t triangle = change_.triangles[i];
        if (data_.triangle_infos[triangle].instance == instance &&
            !same_bits(data_.bvh.triangles[triangle], change_.before[i]))
            return true;
    }
    return false;
}

bool SeenChanges::surfaces_may_change_in(const ViewPyramid& view, std::uint32_t without) const {
    for (std::size_t i = 0; i < change_.triangles.size(); ++i) {
        const std::uint32_t triangle = change_.triangles[i];
        if (data_.triangle_infos[triangle].instance == without) continue;
        if (view.may_show(data_.bvh.triangles[triangle]) || view.may_show(change_.before[i])) return true;
    }
    return false;
}

bool SeenChanges::appearance_may_change_in(const ViewPyramid& view, std::uint32_t without) const {
    if (empty()) return false;
    if (change_.surroundings || surfaces_may_change_in(view, without) || shows_reflections(view, without))
        return true;
    return std::any_of(lit_.begin(), lit_.end(), [&](std::uint32_t triangle) {
        return data_.triangle_infos[triangle].instance != without &&
               view.may_show(data_.bvh.triangles[triangle]);
    });
}

bool SeenChanges::shows_reflections(const ViewPyramid& view, std::uint32_t without) const {
    return std::any_of(reflecting_.begin(), reflecting_.end(), [&](std::uint32_t triangle) {
        return data_.triangle_infos[triangle].instance != without &&
               view.may_show(data_.bvh.triangles[triangle]);
    });
}

}  // namespace utsuri
