// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/maps/seen_changes.h"

#include "renderers/device_scene/scene_triangles.h"

#include "base/same_bits.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
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

/// Whether all of some points are beyond one side of a view, with room for rounding that grows with their
/// distance. What is beyond a side is then a convex region: with corners it holds all between them.
bool are_beyond(const ViewPyramid& view, std::span<const glm::vec3> corners) {
    const auto along = [](const glm::dvec3& offset, const glm::dvec3& direction) {
        return glm::dot(offset, direction) / glm::dot(direction, direction);
    };
    const glm::dvec3 normal = glm::normalize(glm::cross(view.right, view.up));
    const double per_depth = glm::dot(view.forward, normal);
    // Of depth, and of a place in the picture, by which both are off for an offset of length one.
    const double shorter = std::min(glm::length(view.right), glm::length(view.up));
    const double depth_rounding = kRounding / std::abs(per_depth);
    const double rounding =
        kRounding / shorter + depth_rounding * (1.0 + glm::length(view.forward) / shorter);
    // Beyond the left, right, lower and upper side.
    std::array<std::size_t, 4> beyond{};
    for (const glm::vec3& corner : corners) {
        const glm::dvec3 offset = glm::dvec3(corner) - view.apex;
        const double depth = glm::dot(offset, normal) / per_depth;
        const double x = along(offset - depth * view.forward, view.right);
        const double y = along(offset - depth * view.forward, view.up);
        const double least = rounding * glm::length(offset);
        const std::array distances = {-x - depth, x - depth, -y - depth, y - depth};
        for (std::size_t side = 0; side < 4; ++side)
            beyond[side] += distances[side] > least ? 1 : 0;
    }
    return std::any_of(beyond.begin(), beyond.end(),
                       [&](std::size_t count) { return count == corners.size(); });
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
    return !are_beyond(*this, std::array{triangle.v0, triangle.v1, triangle.v2});
}

bool ViewPyramid::may_show(const Bounds& box) const {
    if (box.empty()) return false;
    std::array<glm::vec3, 8> corners{};
    for (std::size_t i = 0; i < 8; ++i) {
        corners[i] = {(i & 1) != 0 ? box.upper.x : box.lower.x, (i & 2) != 0 ? box.upper.y : box.lower.y,
                      (i & 4) != 0 ? box.upper.z : box.lower.z};
    }
    return !are_beyond(*this, corners);
}

TriangleGroups::TriangleGroups(std::uint32_t instances) : group_of_(instances, interop::NONE) {}

void TriangleGroups::add(std::uint32_t instance, std::uint32_t entry, const Bounds& box) {
    std::uint32_t& group = group_of_[instance];
    if (group == interop::NONE) {
        group = static_cast<std::uint32_t>(groups_.size());
        groups_.push_back({instance, {}, {}});
    }
    groups_[group].bounds.extend(box);
    groups_[group].entries.push_back(entry);
    bounds_.extend(box);
}

SeenChanges::SeenChanges(const SceneData& data, const SceneChange& change, std::vector<std::uint32_t> lit)
    : data_(data),
      change_(change),
      lit_(std::move(lit)),
      moved_(data.requirements.instances),
      changed_groups_(data.requirements.instances),
      lit_groups_(data.requirements.instances) {
    for (std::uint32_t i = 0; i < change.triangles.size(); ++i) {
        const std::uint32_t instance = data.triangle_infos[change.triangles[i]].instance;
        const interop::BvhTriangle& was = change.before[i];
        const interop::BvhTriangle& is = data.bvh.triangles[change.triangles[i]];
        if (!same_bits(was, is)) moved_[instance] = true;
        Bounds box = bounds_of(was);
        box.extend(bounds_of(is));
        changed_groups_.add(instance, i, box);
    }
    for (const std::uint32_t triangle : lit_) {
        lit_groups_.add(data.triangle_infos[triangle].instance, triangle,
                        bounds_of(data.bvh.triangles[triangle]));
    }
    const Requirements& needs = data.requirements;
    std::set_union(needs.reflective_instances.begin(), needs.reflective_instances.end(),
                   needs.glossy_instances.begin(), needs.glossy_instances.end(),
                   std::back_inserter(reflecting_));
}

bool SeenChanges::surfaces_may_change_in(const ViewPyramid& view, std::uint32_t without) const {
    return changed_groups_.any_in(view, without, [&](std::uint32_t i) {
        return view.may_show(data_.bvh.triangles[change_.triangles[i]]) || view.may_show(change_.before[i]);
    });
}

bool SeenChanges::appearance_may_change_in(const ViewPyramid& view, std::uint32_t without) const {
    if (empty()) return false;
    const auto shows = [&](std::uint32_t triangle) { return view.may_show(data_.bvh.triangles[triangle]); };
    return change_.environment || surfaces_may_change_in(view, without) || shows_reflections(view, without) ||
           lit_groups_.any_in(view, without, shows);
}

bool SeenChanges::shows_reflections(const ViewPyramid& view, std::uint32_t without) const {
    return std::any_of(reflecting_.begin(), reflecting_.end(), [&](std::uint32_t instance) {
        if (instance == without || !view.may_show(bounds_of(data_, instance))) return false;
        const std::span<const std::uint32_t> triangles = triangles_of(data_, instance);
        return std::any_of(triangles.begin(), triangles.end(), [&](std::uint32_t triangle) {
            return view.may_show(data_.bvh.triangles[triangle]);
        });
    });
}

}  // namespace utsuri
