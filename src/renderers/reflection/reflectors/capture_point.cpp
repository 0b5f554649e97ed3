// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/reflectors/capture_point.h"

#include "renderers/device_scene/closest_hit.h"
#include "renderers/device_scene/scene_triangles.h"

#include "geometry/view_directions.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace utsuri {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kDirections = 64;
/// Surface points of the instance that are looked at to see whether it is exposed.
constexpr std::size_t kSurfaceSamples = 16;

/// Whether most of a spread of points on the instance are outside other geometry. An instance whose surface
/// sees as many backs as its centre is not buried: the scene just shows it backs, like a room modelled inside
/// out.
bool is_exposed(const SceneData& scene, std::uint32_t instance) {
    const std::span<const std::uint32_t> triangles = triangles_of(scene, instance);
    const std::size_t step = std::max<std::size_t>(1, triangles.size() / kSurfaceSamples);
    std::size_t samples = 0;
    std::size_t inside = 0;
    for (std::size_t i = 0; i < triangles.size(); i += step, ++samples) {
        const Corners corners = corners_of(scene, triangles[i]);
        const glm::dvec3 centre = (corners[0] + corners[1] + corners[2]) / 3.0;
        if (is_inside_geometry(scene, instance, centre)) ++inside;
    }
    return 2 * inside < samples;
}

/// The nearest point outside, found along rays that leave through the back of a surface.
glm::dvec3 move_out(const SceneData& scene, std::uint32_t instance, const glm::dvec3& centre, double radius) {
    glm::dvec3 best = centre;
    double best_distance = kInfinity;
    for (const glm::dvec3& direction : view_directions(kDirections)) {
        const auto exit = closest_hit_without(scene, instance, centre, direction, kInfinity);
        if (!exit || !exit->back_face || exit->t >= best_distance) continue;
        const glm::dvec3 surface = centre + exit->t * direction;
        const auto next =
            closest_hit_without(scene, instance, surface + 1e-9 * exit->t * direction, direction, kInfinity);
        // Half way to what comes next, but no farther than half the object: maps are truest near it.
        const double clearance = 0.5 * std::min(next ? next->t : kInfinity, radius);
        const glm::dvec3 candidate = surface + clearance * direction;
        if (is_inside_geometry(scene, instance, candidate)) continue;
        best = candidate;
        best_distance = exit->t;
    }
    return best;
}

}  // namespace

bool is_inside_geometry(const SceneData& scene, std::uint32_t instance, const glm::dvec3& point) {
    int backs = 0;
    for (const glm::dvec3& direction : view_directions(kDirections)) {
        const auto hit = closest_hit_without(scene, instance, point, direction, kInfinity);
        if (hit && hit->back_face) ++backs;
    }
    return 2 * backs > kDirections;
}

glm::dvec3 find_capture_point(const SceneData& scene, std::uint32_t instance) {
    const Bounds& bounds = bounds_of(scene, instance);
    if (bounds.empty()) return glm::dvec3(0.0);
    const glm::dvec3 centre = 0.5 * (glm::dvec3(bounds.lower) + glm::dvec3(bounds.upper));
    if (!is_inside_geometry(scene, instance, centre) || !is_exposed(scene, instance)) return centre;
    return move_out(scene, instance, centre, 0.5 * glm::length(glm::dvec3(bounds.extent())));
}

}  // namespace utsuri
