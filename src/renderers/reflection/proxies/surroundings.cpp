// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/proxies/surroundings.h"

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

constexpr int kDirections = 1024;
/// Places on a reflector that are looked at to see whether something hides them: spread over its area, and
/// over its corners, where it reaches farthest.
constexpr std::size_t kPlacesByArea = 1024;
constexpr std::size_t kCornerPlaces = 1024;

/// Vertices of triangles, thinned to at most `most` triangles' worth.
std::vector<glm::dvec3> corners_from(const SceneData& scene, std::span<const std::uint32_t> triangles,
                                     std::size_t most, const glm::dvec3& point) {
    std::vector<glm::dvec3> places;
    const std::size_t step = std::max<std::size_t>(1, 3 * triangles.size() / most);
    places.reserve(3 * ((triangles.size() + step - 1) / step));
    for (std::size_t i = 0; i < triangles.size(); i += step) {
        for (const glm::dvec3& corner : corners_of(scene, triangles[i]))
            places.push_back(corner - point);
    }
    return places;
}

/// Evenly spread over the area of triangles (R2 sequence, Roberts 2018).
std::vector<glm::dvec3> places_by_area(const SceneData& scene, std::span<const std::uint32_t> triangles,
                                       const glm::dvec3& point) {
    std::vector<double> area_up_to;
    area_up_to.reserve(triangles.size());
    double total = 0.0;
    for (const std::uint32_t triangle : triangles)
        area_up_to.push_back(total += glm::length(doubled_area(corners_of(scene, triangle))));
    std::vector<glm::dvec3> places;
    if (!(total > 0.0)) return places;
    places.reserve(kPlacesByArea);
    constexpr double kPlastic = 1.32471795724474602596;
    std::size_t at = 0;
    for (std::size_t i = 0; i < kPlacesByArea; ++i) {
        const double area = (static_cast<double>(i) + 0.5) / static_cast<double>(kPlacesByArea) * total;
        while (at + 1 < triangles.size() && area_up_to[at] < area)
            ++at;
        double whole = 0.0;
        double b1 = std::modf(static_cast<double>(i + 1) / kPlastic, &whole);
        double b2 = std::modf(static_cast<double>(i + 1) / (kPlastic * kPlastic), &whole);
        if (b1 + b2 > 1.0) {
            b1 = 1.0 - b1;
            b2 = 1.0 - b2;
        }
        const Corners corners = corners_of(scene, triangles[at]);
        places.push_back(corners[0] + b1 * (corners[1] - corners[0]) + b2 * (corners[2] - corners[0]) -
                         point);
    }
    return places;
}

std::vector<glm::dvec3> starts_on(const SceneData& scene, std::uint32_t instance, const glm::dvec3& point,
                                  double tolerance) {
    const std::span<const std::uint32_t> triangles = triangles_of(scene, instance);
    std::vector<glm::dvec3> places = places_by_area(scene, triangles, point);
    const std::vector<glm::dvec3> corners = corners_from(scene, triangles, kCornerPlaces, point);
    places.insert(places.end(), corners.begin(), corners.end());
    const auto is_seen = [&](const glm::dvec3& place) {
        const double distance = glm::length(place);
        return !(distance > tolerance) ||
               !closest_hit_without(scene, instance, point, place, 1.0 - tolerance / distance);
    };
    const auto hidden = std::stable_partition(places.begin(), places.end(), is_seen);
    if (hidden == places.begin() || hidden == places.end())
        return corners_from(scene, triangles, std::numeric_limits<std::size_t>::max(), point);
    places.erase(hidden, places.end());
    return places;
}

}  // namespace

Surroundings sample_surroundings(const SceneData& scene, std::uint32_t instance, const glm::dvec3& point) {
    // Two vertices that are meant to meet, each off by its own rounding, on either side of a plane.
    Surroundings around{point, scene.bounds, 4.0 * vertex_error(scene), {}, {}};
    for (const glm::dvec3& direction : view_directions(kDirections)) {
        const auto hit =
            closest_hit_without(scene, instance, point, direction, std::numeric_limits<double>::infinity());
        if (hit) around.samples.push_back({direction, hit->t, hit->triangle});
    }
    around.starts = starts_on(scene, instance, point, around.tolerance);
    return around;
}

}  // namespace utsuri
