// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/reflectors/reflector_plane.h"

#include "renderers/device_scene/closest_hit.h"
#include "renderers/device_scene/scene_triangles.h"

#include "geometry/view_directions.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace utsuri {
namespace {

/// The plane of the largest triangle, if it holds all of them.
std::optional<ReflectorPlane> common_plane(const SceneData& scene, std::span<const std::uint32_t> triangles) {
    const auto area = [&](std::uint32_t t) { return glm::length(doubled_area(corners_of(scene, t))); };
    const auto largest =
        std::max_element(triangles.begin(), triangles.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return area(a) < area(b); });
    if (largest == triangles.end() || !(area(*largest) > 0.0)) return std::nullopt;
    const TrianglePlane plane(scene, *largest);
    if (!std::all_of(triangles.begin(), triangles.end(), [&](std::uint32_t t) { return plane.holds(t); }))
        return std::nullopt;
    return ReflectorPlane{plane.normal(), glm::dot(plane.normal(), corners_of(scene, *largest)[0])};
}

/// Mean of how far one sees from a point of a mirror to the side that a normal points to, in diagonals of the
/// scene. Where nothing is met there is nothing to see, unless the scene has an environment.
double openness(const SceneData& scene, std::uint32_t instance, const glm::dvec3& point,
                const glm::dvec3& normal) {
    constexpr int kDirections = 128;
    const double diagonal = glm::length(glm::dvec3(scene.bounds.extent()));
    double sum = 0.0;
    int count = 0;
    for (const glm::dvec3& direction : view_directions(kDirections)) {
        if (glm::dot(direction, normal) <= 0.0) continue;
        const auto hit = closest_hit_without(scene, instance, point, direction, diagonal);
        ++count;
        if (hit || scene.requirements.environment) sum += hit ? hit->t / diagonal : 1.0;
    }
    return sum / count;
}

}  // namespace

std::optional<ReflectorPlane> plane_of(const SceneData& scene, std::uint32_t instance) {
    std::optional<ReflectorPlane> plane = common_plane(scene, triangles_of(scene, instance));
    if (!plane) return plane;
    const Bounds& bounds = bounds_of(scene, instance);
    const glm::dvec3 point = 0.5 * (glm::dvec3(bounds.lower) + glm::dvec3(bounds.upper));
    if (openness(scene, instance, point, -plane->normal) > openness(scene, instance, point, plane->normal))
        plane = ReflectorPlane{-plane->normal, -plane->distance};
    return plane;
}

}  // namespace utsuri
