// SPDX-License-Identifier: Apache-2.0
#include "renderers/light/direct/lattice_plan.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace utsuri {
namespace {

/// Intervals along an edge, at most: their points are numbered within 32 bits.
constexpr double kMostIntervals = 32768.0;

/// Points that are too many are thinned by so much more than it takes: intervals are whole, so that fewer go
/// than the square of their length tells, and without it the plan would near its bound in many small steps.
constexpr double kSparePoints = 1.1;

/// Whole intervals over a length that are no longer than `spacing`. Both are 0 in a scene that is one point.
double intervals_over(double length, double spacing) {
    return length > spacing ? std::min(std::ceil(length / spacing), kMostIntervals) : 1.0;
}

/// Rows over a triangle that keep neighbours in and across rows within `spacing`.
interop::LightCacheTriangle plan_rows(const interop::BvhTriangle& triangle, double spacing) {
    const std::array<glm::dvec3, 3> corners = {glm::dvec3(triangle.v0), glm::dvec3(triangle.v1),
                                               glm::dvec3(triangle.v2)};
    std::array<double, 3> opposite{};
    for (std::size_t i = 0; i < 3; ++i)
        opposite[i] = glm::distance(corners[(i + 1) % 3], corners[(i + 2) % 3]);
    const auto apex =
        static_cast<std::size_t>(std::min_element(opposite.begin(), opposite.end()) - opposite.begin());
    const double longest = *std::max_element(opposite.begin(), opposite.end());
    const double intervals = intervals_over(opposite[apex], spacing);
    const double rows = intervals_over(longest, spacing * intervals);
    return {0, static_cast<std::uint32_t>(intervals), static_cast<std::uint32_t>(rows),
            static_cast<std::uint32_t>(apex)};
}

std::vector<interop::LightCacheTriangle> plan(const SceneData& data, double spacing) {
    std::vector<interop::LightCacheTriangle> result;
    result.reserve(data.triangle_infos.size());
    std::uint64_t first = 0;
    for (std::size_t t = 0; t < data.triangle_infos.size(); ++t) {
        const interop::MaterialInfo& material = data.materials[data.triangle_infos[t].material];
        result.push_back(reflects_diffusely(material) ? plan_rows(data.bvh.triangles[t], spacing)
                                                      : interop::LightCacheTriangle{0, 0, 1, 0});
        result.back().first_point = static_cast<std::uint32_t>(first);
        first += lattice_points(result.back());
    }
    return result;
}

}  // namespace

std::uint64_t lattice_points(const interop::LightCacheTriangle& lattice) {
    if (lattice.intervals == 0) return 0;
    // Rows of 2 to intervals + 1 points, each size rows_per_interval times, and the apex.
    const std::uint64_t n = lattice.intervals;
    return lattice.rows_per_interval * (n * (n + 3) / 2) + 1;
}

bool same_lattice(const interop::LightCacheTriangle& a, const interop::LightCacheTriangle& b) {
    return a.intervals == b.intervals && a.rows_per_interval == b.rows_per_interval && a.apex == b.apex;
}

std::uint64_t light_cache_points(const std::vector<interop::LightCacheTriangle>& plan) {
    std::uint64_t count = 0;
    for (const interop::LightCacheTriangle& triangle : plan)
        count += lattice_points(triangle);
    return count;
}

std::vector<interop::LightCacheTriangle> plan_light_cache(const SceneData& data, double spacing,
                                                          std::uint64_t most_points) {
    const double diagonal = glm::length(glm::dvec3(data.bounds.extent()));
    double distance = spacing * diagonal;
    while (true) {
        std::vector<interop::LightCacheTriangle> planned = plan(data, distance);
        const std::uint64_t points = light_cache_points(planned);
        // One interval a triangle is the least there is; the buffer then says that it does not fit.
        if (points <= most_points || distance >= diagonal) return planned;
        distance *= std::sqrt(kSparePoints * static_cast<double>(points) / static_cast<double>(most_points));
    }
}

}  // namespace utsuri
