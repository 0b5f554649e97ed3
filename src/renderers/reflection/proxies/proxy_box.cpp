// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/proxies/proxy_box.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace utsuri {
namespace {

/// Rounds of the search over the six sides, each a scan at the distances that rays met and no others: a side
/// that fits lies where something is.
constexpr int kRounds = 4;

/// Distances of the six sides from the point: side 2 axis + (upper ? 1 : 0).
using Sides = std::array<double, 6>;

/// How far along an axis a sample reaches towards a side; not positive where it looks away from it.
double reach(const SurroundingsSample& sample, std::size_t side) {
    const double component = sample.direction[static_cast<int>(side / 2)] * sample.distance;
    return side % 2 == 1 ? component : -component;
}

double mean_misfit(const std::vector<SurroundingsSample>& samples, const Sides& sides) {
    double sum = 0.0;
    for (const SurroundingsSample& sample : samples) {
        // The box is left at the least share of the sample's length.
        double share = std::numeric_limits<double>::infinity();
        for (std::size_t side = 0; side < 6; ++side) {
            const double towards = reach(sample, side);
            if (towards > 0.0) share = std::min(share, sides[side] / towards);
        }
        sum += std::abs(std::log(share));
    }
    return sum / static_cast<double>(samples.size());
}

/// Distances that the samples aimed at a side reach towards it, a few dozen of them in order.
std::vector<double> candidates(const Surroundings& around, std::size_t side, double least) {
    std::vector<double> reached;
    for (const SurroundingsSample& sample : around.samples) {
        const double towards = reach(sample, side);
        const glm::dvec3 size = glm::abs(sample.direction);
        // What a place touches is beyond it, whatever rounding made of either.
        const bool is_beyond = towards > 0.0 && towards > least - around.tolerance;
        if (is_beyond && size[static_cast<int>(side / 2)] >= 0.5 * std::max({size.x, size.y, size.z}))
            reached.push_back(std::max(towards, least));
    }
    std::sort(reached.begin(), reached.end());
    constexpr std::size_t kMost = 48;
    if (reached.size() <= kMost) return reached;
    std::vector<double> spread;
    for (std::size_t i = 0; i < kMost; ++i)
        spread.push_back(reached[i * (reached.size() - 1) / (kMost - 1)]);
    return spread;
}

}  // namespace

Bounds fit_proxy_box(const Surroundings& around) {
    const std::vector<SurroundingsSample>& samples = around.samples;
    const glm::dvec3& point = around.point;
    glm::dvec3 lower(0.0);
    glm::dvec3 upper(0.0);
    for (const glm::dvec3& start : around.starts) {
        lower = glm::min(lower, start);
        upper = glm::max(upper, start);
    }
    Sides least{};
    Sides sides{};
    for (std::size_t side = 0; side < 6; ++side) {
        const int axis = static_cast<int>(side / 2);
        const bool is_upper = side % 2 == 1;
        const double scene = is_upper ? static_cast<double>(around.scene.upper[axis]) - point[axis]
                                      : point[axis] - static_cast<double>(around.scene.lower[axis]);
        least[side] = is_upper ? upper[axis] : -lower[axis];
        sides[side] = std::max(scene, least[side]);
    }
    double misfit = samples.empty() ? 0.0 : mean_misfit(samples, sides);
    for (int round = 0; round < kRounds && !samples.empty(); ++round) {
        for (std::size_t side = 0; side < 6; ++side) {
            for (const double distance : candidates(around, side, least[side])) {
                Sides tried = sides;
                tried[side] = distance;
                const double tried_misfit = mean_misfit(samples, tried);
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
