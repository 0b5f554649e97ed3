// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection_map/proxy_box.h"

#include "renderers/reflection_map/view_directions.h"

#include "geometry/reference_intersection.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace utsuri {
namespace {

constexpr int kDirections = 1024;
/// Rounds of the search over the six sides, each a scan at the distances that rays met and no others: a side
/// that fits lies where something is.
constexpr int kRounds = 4;

struct Sight {
    glm::dvec3 direction;  ///< unit
    double distance;
};

std::vector<Sight> look_around(const SceneData& scene, std::uint32_t instance, const glm::dvec3& point) {
    std::vector<Sight> sights;
    for (const glm::dvec3& direction : view_directions(kDirections)) {
        const auto hit = closest_hit_reference(
            scene.bvh, point, direction, std::numeric_limits<double>::infinity(),
            [&](std::uint32_t triangle) { return scene.triangle_infos[triangle].instance != instance; });
        if (hit) sights.push_back({direction, hit->t});
    }
    return sights;
}

/// Distances of the six sides from the point: side 2 axis + (upper ? 1 : 0).
using Sides = std::array<double, 6>;

/// How far along an axis a sight reaches towards a side; not positive where it looks away from it.
double reach(const Sight& sight, std::size_t side) {
    const double component = sight.direction[static_cast<int>(side / 2)] * sight.distance;
    return side % 2 == 1 ? component : -component;
}

double mean_misfit(const std::vector<Sight>& sights, const Sides& sides) {
    double sum = 0.0;
    for (const Sight& sight : sights) {
        // The box is left at the least share of the sight's length.
        double share = std::numeric_limits<double>::infinity();
        for (std::size_t side = 0; side < 6; ++side) {
            const double towards = reach(sight, side);
            if (towards > 0.0) share = std::min(share, sides[side] / towards);
        }
        sum += std::abs(std::log(share));
    }
    return sum / static_cast<double>(sights.size());
}

/// Distances that the sights aimed at a side reach towards it, a few dozen of them in order.
std::vector<double> candidates(const std::vector<Sight>& sights, std::size_t side, double least) {
    std::vector<double> reached;
    for (const Sight& sight : sights) {
        const double towards = reach(sight, side);
        const glm::dvec3 size = glm::abs(sight.direction);
        if (towards > least && size[static_cast<int>(side / 2)] >= 0.5 * std::max({size.x, size.y, size.z}))
            reached.push_back(towards);
    }
    std::sort(reached.begin(), reached.end());
    constexpr std::size_t kMost = 48;
    if (reached.size() <= kMost) return reached;
    std::vector<double> spread;
    for (std::size_t i = 0; i < kMost; ++i)
        spread.push_back(reached[i * (reached.size() - 1) / (kMost - 1)]);
    return spread;
}

Bounds bounds_of(const SceneData& scene, std::uint32_t instance) {
    Bounds bounds;
    for (std::size_t t = 0; t < scene.triangle_infos.size(); ++t) {
        if (scene.triangle_infos[t].instance != instance) continue;
        bounds.extend(scene.bvh.triangles[t].v0);
        bounds.extend(scene.bvh.triangles[t].v1);
        bounds.extend(scene.bvh.triangles[t].v2);
    }
    return bounds;
}

}  // namespace

Bounds fit_proxy_box(const SceneData& scene, std::uint32_t instance, const glm::dvec3& point) {
    const std::vector<Sight> sights = look_around(scene, instance, point);
    // The reflector must not reach out of the box: its rays start inside.
    const Bounds own = bounds_of(scene, instance);
    Sides least{};
    Sides sides{};
    for (std::size_t side = 0; side < 6; ++side) {
        const int axis = static_cast<int>(side / 2);
        const auto distance = [&](const Bounds& bounds) {
            return side % 2 == 1 ? static_cast<double>(bounds.upper[axis]) - point[axis]
                                 : point[axis] - static_cast<double>(bounds.lower[axis]);
        };
        least[side] = std::max(own.empty() ? 0.0 : distance(own), 0.0);
        sides[side] = std::max(distance(scene.bounds), least[side]);
    }
    double misfit = sights.empty() ? 0.0 : mean_misfit(sights, sides);
    for (int round = 0; round < kRounds && !sights.empty(); ++round) {
        for (std::size_t side = 0; side < 6; ++side) {
            for (const double distance : candidates(sights, side, least[side])) {
                Sides tried = sides;
                tried[side] = distance;
                const double tried_misfit = mean_misfit(sights, tried);
                if (tried_misfit >= misfit) continue;
                misfit = tried_misfit;
                sides = tried;
            }
        }
    }
    Bounds box;
    box.extend(glm::vec3(point - glm::dvec3(sides[0], sides[2], sides[4])));
    box.extend(glm::vec3(point + glm::dvec3(sides[1], sides[3], sides[5])));
    return box;
}

}  // namespace utsuri
