// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/proxies/proxy_planes.h"

#include "renderers/device_scene/scene_triangles.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace utsuri {
namespace {

/// Planes seen that are tried: those that most samples meet.
constexpr std::size_t kMostCandidates = 64;
/// Planes added to the bounds of the scene: each costs every look-up.
constexpr std::size_t kMostAdded = 12;
/// A plane is worth its cost if it takes this share off the misfit.
constexpr double kWorth = 0.02;
/// Planes that turn and part by less, as shares of a right angle's sine and of the distance at which they are
/// seen, are one: the misfit between them is less than a texel of most maps.
constexpr double kSamePlane = 1e-3;
/// Misfit that rounding makes.
constexpr double kSameMisfit = 1e-6;

/// The share of a sample's length at which it leaves a half space about the capture point.
double share_of(const SurroundingsSample& sample, const HalfSpace& plane) {
    const double towards = glm::dot(plane.normal, sample.direction) * sample.distance;
    return towards > 0.0 ? plane.offset / towards : std::numeric_limits<double>::infinity();
}

double least_share(const SurroundingsSample& sample, const std::vector<HalfSpace>& planes) {
    double share = std::numeric_limits<double>::infinity();
    for (const HalfSpace& plane : planes)
        share = std::min(share, share_of(sample, plane));
    return share;
}

struct SeenPlane {
    HalfSpace plane;
    std::size_t samples = 0;
};

/// The planes of the triangles that samples meet, those that most do first.
std::vector<HalfSpace> seen_planes(const SceneData& scene, const Surroundings& around) {
    std::vector<SeenPlane> seen;
    for (const SurroundingsSample& sample : around.samples) {
        glm::dvec3 normal = glm::normalize(doubled_area(corners_of(scene, sample.triangle)));
        if (glm::dot(normal, sample.direction) < 0.0) normal = -normal;
        const glm::dvec3 hit = sample.distance * sample.direction;
        const auto same = std::find_if(seen.begin(), seen.end(), [&](const SeenPlane& other) {
            return glm::distance(other.plane.normal, normal) <= kSamePlane &&
                   std::abs(glm::dot(other.plane.normal, hit) - other.plane.offset) <=
                       kSamePlane * sample.distance;
        });
        if (same != seen.end()) {
            ++same->samples;
            continue;
        }
        const double offset = glm::dot(normal, corners_of(scene, sample.triangle)[0] - around.point);
        if (offset > around.tolerance) seen.push_back({{normal, offset}, 1});
    }
    std::stable_sort(seen.begin(), seen.end(),
                     [](const SeenPlane& a, const SeenPlane& b) { return a.samples > b.samples; });
    std::vector<HalfSpace> planes;
    for (std::size_t i = 0; i < std::min(seen.size(), kMostCandidates); ++i)
        planes.push_back(seen[i].plane);
    return planes;
}

/// How far the half space of a plane through the capture point must reach to hold all places that rays start
/// from.
double least_offset(const Surroundings& around, const glm::dvec3& normal) {
    double least = 0.0;
    for (const glm::dvec3& start : around.starts)
        least = std::max(least, glm::dot(normal, start));
    return least;
}

/// Those that hold the places that rays start from, moved to them where rounding alone left these outside.
std::vector<HalfSpace> holding_starts(const Surroundings& around, const std::vector<HalfSpace>& planes) {
    std::vector<HalfSpace> holding;
    for (const HalfSpace& plane : planes) {
        const double least = least_offset(around, plane.normal);
        if (plane.offset >= least - around.tolerance)
            holding.push_back({plane.normal, std::max(plane.offset, least)});
    }
    return holding;
}

/// The sides of the scene, none nearer than a thousandth of its size: planes are to enclose the point.
std::vector<HalfSpace> sides_of_scene(const Surroundings& around) {
    constexpr double kNearest = 1e-3;
    const double size = glm::length(glm::dvec3(around.scene.extent()));
    std::vector<HalfSpace> planes;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            glm::dvec3 normal(0.0);
            normal[axis] = sign;
            const glm::vec3& corner = sign > 0.0 ? around.scene.upper : around.scene.lower;
            const double offset = sign * (static_cast<double>(corner[axis]) - around.point[axis]);
            planes.push_back({normal, std::max({offset, least_offset(around, normal), kNearest * size})});
        }
    }
    return planes;
}

double mean_log(const std::vector<double>& shares) {
    double sum = 0.0;
    for (const double share : shares)
        sum += std::abs(std::log(share));
    return shares.empty() ? 0.0 : sum / static_cast<double>(shares.size());
}

/// Where samples leave what a plane cuts off from.
std::vector<double> cut(std::vector<double> shares, const std::vector<SurroundingsSample>& samples,
                        const HalfSpace& plane) {
    for (std::size_t i = 0; i < samples.size(); ++i)
        shares[i] = std::min(shares[i], share_of(samples[i], plane));
    return shares;
}

/// Leaves out, from the first on, planes without which nothing seen is missed.
std::vector<HalfSpace> without_idle(const std::vector<SurroundingsSample>& samples,
                                    std::vector<HalfSpace> planes) {
    const double limit = mean_misfit(samples, planes) + kSameMisfit;
    for (std::size_t i = 0; i < planes.size();) {
        std::vector<HalfSpace> others = planes;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        if (mean_misfit(samples, others) <= limit && enclosed_region(others)) {
            planes = std::move(others);
        } else {
            ++i;
        }
    }
    return planes;
}

/// least_share() of each sample.
std::vector<double> least_shares(const std::vector<SurroundingsSample>& samples,
                                 const std::vector<HalfSpace>& planes) {
    std::vector<double> shares;
    shares.reserve(samples.size());
    for (const SurroundingsSample& sample : samples)
        shares.push_back(least_share(sample, planes));
    return shares;
}

}  // namespace

double mean_misfit(const std::vector<SurroundingsSample>& samples, const std::vector<HalfSpace>& planes) {
    return mean_log(least_shares(samples, planes));
}

std::vector<HalfSpace> fit_proxy_planes(const SceneData& scene, const Surroundings& around) {
    const std::vector<SurroundingsSample>& samples = around.samples;
    const std::vector<HalfSpace> candidates = holding_starts(around, seen_planes(scene, around));
    std::vector<HalfSpace> planes = sides_of_scene(around);
    std::vector<double> shares = least_shares(samples, planes);
    double misfit = mean_log(shares);
    for (std::size_t added = 0; added < kMostAdded; ++added) {
        const HalfSpace* best = nullptr;
        double least = (1.0 - kWorth) * misfit;
        for (const HalfSpace& candidate : candidates) {
            const double tried = mean_log(cut(shares, samples, candidate));
            if (tried >= least) continue;
            least = tried;
            best = &candidate;
        }
        if (!best) break;
        planes.push_back(*best);
        shares = cut(std::move(shares), samples, *best);
        misfit = least;
    }
    return without_idle(samples, std::move(planes));
}

}  // namespace utsuri
