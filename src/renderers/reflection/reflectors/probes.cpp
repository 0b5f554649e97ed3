// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/reflectors/probes.h"

#include "renderers/device_scene/closest_hit.h"
#include "renderers/reflection/reflectors/capture_point.h"
#include "renderers/reflection/reflectors/reflected_rays.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace utsuri {
namespace {

/// Rays that stand for all that a reflector can show, and places on it that a probe may take.
constexpr std::uint32_t kRays = 256;
constexpr std::uint32_t kPlaces = 48;
/// A probe costs as much as the first; it must take away this share of the first one's error.
constexpr double kLeastGain = 1.0 / 32.0;
/// What is nearer to a place than this share of the reflector's size touches it: maps from there would show
/// little else.
constexpr double kLeastClearance = 1e-3;

/// What a probe at one place would do for each of the rays.
struct Candidate {
    glm::dvec3 place;
    std::vector<double> passes;  ///< least distance of the ray's line
    std::vector<double> errors;  ///< radians
};

bool sees(const SceneData& scene, std::uint32_t instance, const glm::dvec3& place, const glm::dvec3& point) {
    constexpr double kUpToThePoint = 1.0 - 1e-6;
    return !closest_hit_without(scene, instance, place, point - place, kUpToThePoint);
}

/// The angle at a place between a ray's direction, which would be looked up there, and what it meets.
double parallax(const glm::dvec3& place, const ReflectedRay& ray) {
    const glm::dvec3 towards = ray.hit - place;
    return std::atan2(glm::length(glm::cross(ray.direction, towards)), glm::dot(ray.direction, towards));
}

Candidate judge(const SceneData& scene, std::uint32_t instance, const glm::dvec3& place,
                const std::vector<ReflectedRay>& rays, MapKind kind) {
    Candidate candidate{place, {}, {}};
    for (const ReflectedRay& ray : rays) {
        candidate.passes.push_back(glm::length(glm::cross(place - ray.origin, ray.direction)));
        const bool is_found = keeps_distances(kind) && sees(scene, instance, place, ray.hit);
        candidate.errors.push_back(is_found ? 0.0 : parallax(place, ray));
    }
    return candidate;
}

/// What is looked up for each ray with the probes so far.
struct Choice {
    std::vector<double> passes;
    std::vector<double> errors;

    /// Maps without distances are looked up at the probe that the ray passes nearest, as shaders do; else any
    /// probe that sees what the ray meets will do.
    [[nodiscard]] double error_with(const Candidate& candidate, std::size_t ray, bool by_passes) const {
        if (by_passes) {
            return candidate.passes[ray] < passes[ray] ? candidate.errors[ray] : errors[ray];
        }
        return std::min(errors[ray], candidate.errors[ray]);
    }
    [[nodiscard]] double sum_with(const Candidate& candidate, bool by_passes) const {
        double sum = 0.0;
        for (std::size_t ray = 0; ray < errors.size(); ++ray)
            sum += error_with(candidate, ray, by_passes);
        return sum;
    }
    void take(const Candidate& candidate, bool by_passes) {
        for (std::size_t ray = 0; ray < errors.size(); ++ray) {
            errors[ray] = error_with(candidate, ray, by_passes);
            passes[ray] = std::min(passes[ray], candidate.passes[ray]);
        }
    }
};

bool is_clear(const SceneData& scene, std::uint32_t instance, const glm::dvec3& place, double clearance) {
    return distance_to_surroundings(scene, instance, place) >= clearance &&
           !is_inside_geometry(scene, instance, place);
}

std::vector<glm::dvec3> find_more(const SceneData& scene, std::uint32_t instance, const glm::dvec3& first,
                                  MapKind kind, std::uint32_t most) {
    std::vector<glm::dvec3> points = {first};
    const std::vector<ReflectedRay> rays = reflected_rays(scene, instance, kRays);
    if (rays.empty()) return points;
    std::vector<Candidate> candidates;
    const SurfaceSpread spread = spread_over_surface(scene, instance, kPlaces);
    for (const glm::dvec3& place : spread.places) {
        if (is_clear(scene, instance, place, kLeastClearance * spread.size))
            candidates.push_back(judge(scene, instance, place, rays, kind));
    }
    const bool by_passes = !keeps_distances(kind);
    const Candidate of_first = judge(scene, instance, first, rays, kind);
    Choice choice{of_first.passes, of_first.errors};
    const double nothing_gained = std::accumulate(choice.errors.begin(), choice.errors.end(), 0.0);
    double sum = nothing_gained;
    while (points.size() < most && !candidates.empty()) {
        const auto best = std::min_element(
            candidates.begin(), candidates.end(), [&](const Candidate& a, const Candidate& b) {
                return choice.sum_with(a, by_passes) < choice.sum_with(b, by_passes);
            });
        const double lowered = choice.sum_with(*best, by_passes);
        if (!(sum - lowered > kLeastGain * nothing_gained)) break;
        sum = lowered;
        choice.take(*best, by_passes);
        points.push_back(best->place);
        candidates.erase(best);
    }
    return points;
}

}  // namespace

std::vector<Probe> place_probes(const SceneData& scene, const std::vector<std::uint32_t>& reflectors,
                                MapKind kind, const ProbeSettings& settings) {
    std::vector<Probe> probes;
    for (std::uint32_t reflector = 0; reflector < reflectors.size(); ++reflector) {
        const std::uint32_t instance = reflectors[reflector];
        const glm::dvec3 first =
            settings.first ? *settings.first - scene.origin : find_capture_point(scene, instance);
        if (settings.most == 1) {
            probes.push_back({reflector, first});
            continue;
        }
        for (const glm::dvec3& point : find_more(scene, instance, first, kind, settings.most))
            probes.push_back({reflector, point});
    }
    return probes;
}

std::vector<interop::ProbeRange> probe_ranges(const std::vector<Probe>& probes, std::size_t reflectors) {
    std::vector<interop::ProbeRange> ranges(reflectors);
    for (std::uint32_t i = 0; i < probes.size(); ++i) {
        interop::ProbeRange& range = ranges[probes[i].reflector];
        if (range.count == 0) range.first = i;
        ++range.count;
    }
    return ranges;
}

}  // namespace utsuri
