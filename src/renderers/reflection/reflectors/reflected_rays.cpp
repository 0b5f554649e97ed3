// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/reflectors/reflected_rays.h"

#include "renderers/device_scene/closest_hit.h"
#include "renderers/device_scene/scene_triangles.h"
#include "renderers/reflection/reflectors/reflector_plane.h"

#include "base/sampler.h"
#include "geometry/reference_intersection.h"
#include "geometry/view_directions.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace utsuri {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Sequences of samples that must not agree.
constexpr std::uint32_t kRayKey = 0;
constexpr std::uint32_t kPlaceKey = 1;

/// The triangles of an instance, to choose points of its area from.
class Area {
  public:
    Area(const SceneData& scene, std::uint32_t instance)
        : scene_(scene), bounds_(bounds_of(scene, instance)) {
        double sum = 0.0;
        for (const std::uint32_t triangle : triangles_of(scene, instance)) {
            const double area = glm::length(doubled_area(corners_of(scene, triangle)));
            if (!(area > 0.0)) continue;
            sum += area;
            triangles_.push_back(triangle);
            sums_.push_back(sum);
        }
    }

    struct Point {
        std::uint32_t triangle;
        glm::dvec3 position;
        glm::dvec3 normal;  ///< unit, on the front
    };
    [[nodiscard]] Point at(std::uint32_t key, std::uint32_t index) const {
        const glm::dvec2 which = sample_2d(key, index, 0);
        const glm::dvec2 where = sample_2d(key, index, 1);
        const auto above = std::upper_bound(sums_.begin(), sums_.end(), which.x * sums_.back());
        const auto chosen =
            std::min<std::ptrdiff_t>(above - sums_.begin(), static_cast<std::ptrdiff_t>(sums_.size()) - 1);
        const std::uint32_t triangle = triangles_[static_cast<std::size_t>(chosen)];
        const Corners corners = corners_of(scene_, triangle);
        const double root = std::sqrt(static_cast<double>(where.x));
        const glm::dvec3 position =
            (1.0 - root) * corners[0] + root * (1.0 - where.y) * corners[1] + root * where.y * corners[2];
        return {triangle, position, glm::normalize(doubled_area(corners))};
    }
    [[nodiscard]] bool empty() const { return triangles_.empty(); }
    [[nodiscard]] double size() const { return glm::length(glm::dvec3(bounds_.extent())); }

  private:
    const SceneData& scene_;
    Bounds bounds_;
    std::vector<std::uint32_t> triangles_;
    std::vector<double> sums_;  ///< of doubled areas up to and with each
};

/// @param u two numbers in [0, 1)
glm::dvec3 cosine_direction(const glm::dvec3& normal, const glm::dvec2& u) {
    const glm::dvec3 helper = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 tangent = glm::normalize(glm::cross(helper, normal));
    const glm::dvec3 bitangent = glm::cross(normal, tangent);
    const double radius = std::sqrt(u.x);
    const double angle = 2.0 * std::numbers::pi * u.y;
    return radius * std::cos(angle) * tangent + radius * std::sin(angle) * bitangent +
           std::sqrt(1.0 - u.x) * normal;
}

}  // namespace

std::vector<ReflectedRay> reflected_rays(const SceneData& scene, std::uint32_t instance,
                                         std::uint32_t count) {
    std::vector<ReflectedRay> rays;
    const Area area(scene, instance);
    if (area.empty()) return rays;
    const std::optional<ReflectorPlane> plane = plane_of(scene, instance);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Area::Point point = area.at(kRayKey, i);
        const glm::dvec3 normal = plane ? plane->normal : point.normal;
        const glm::dvec3 direction = cosine_direction(normal, sample_2d(kRayKey, i, 2));
        const auto hit =
            closest_hit_reference(scene.bvh, point.position, direction, kInfinity,
                                  [&](std::uint32_t triangle) { return triangle != point.triangle; });
        if (!hit || scene.triangle_infos[hit->triangle].instance == instance) continue;
        rays.push_back({point.position, direction, point.position + hit->t * direction});
    }
    return rays;
}

SurfaceSpread spread_over_surface(const SceneData& scene, std::uint32_t instance, std::uint32_t count) {
    const Area area(scene, instance);
    SurfaceSpread spread{{}, area.size()};
    for (std::uint32_t i = 0; i < count && !area.empty(); ++i)
        spread.places.push_back(area.at(kPlaceKey, i).position);
    return spread;
}

double distance_to_surroundings(const SceneData& scene, std::uint32_t instance, const glm::dvec3& point) {
    constexpr int kDirections = 64;
    double least = kInfinity;
    for (const glm::dvec3& direction : view_directions(kDirections)) {
        const auto hit = closest_hit_without(scene, instance, point, direction, least);
        if (hit) least = hit->t;
    }
    return least;
}

}  // namespace utsuri
