// SPDX-License-Identifier: Apache-2.0
#include "renderers/common/light_cache.h"

#include "renderers/common/renderer.h"

#include "base/error.h"

#include "interop/bindings.h"
#include "kernels/fill_light_cache.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace utsuri {
namespace {

/// Intervals along an edge, at most: their points are numbered within 32 bits.
constexpr double kMostIntervals = 32768.0;
constexpr std::uint32_t kGroupSize = 64;
constexpr std::uint64_t kMostPointsPerDispatch = std::uint64_t{kMaxGroups} * kGroupSize;
/// A sample takes one shadow ray on each side; see kQueriesPerInvocation in film_kernel.cpp for the bound.
constexpr std::uint32_t kMostSamplesPerDispatch = 256;

std::uint64_t lattice_points(std::uint64_t edge) {
    return edge == 0 ? 0 : (edge + 1) * (edge + 2) / 2;
}

/// Whether any light that arrives is reflected diffusely.
bool is_diffuse(const interop::MaterialInfo& material) {
    return material.metallic < 1.0f && material.base_colour != glm::vec3(0.0f);
}

std::vector<interop::LightCacheTriangle> plan(const SceneData& data, double spacing) {
    std::vector<interop::LightCacheTriangle> result;
    result.reserve(data.triangle_infos.size());
    std::uint64_t first = 0;
    for (std::size_t t = 0; t < data.triangle_infos.size(); ++t) {
        const interop::BvhTriangle& corners = data.bvh.triangles[t];
        std::uint64_t edge = 0;
        if (is_diffuse(data.materials[data.triangle_infos[t].material])) {
            const double longest = std::max({glm::distance(glm::dvec3(corners.v0), glm::dvec3(corners.v1)),
                                             glm::distance(glm::dvec3(corners.v1), glm::dvec3(corners.v2)),
                                             glm::distance(glm::dvec3(corners.v2), glm::dvec3(corners.v0))});
            edge = static_cast<std::uint64_t>(std::clamp(std::ceil(longest / spacing), 1.0, kMostIntervals));
        }
        result.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(edge)});
        first += lattice_points(edge);
    }
    return result;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

std::uint64_t light_cache_points(const std::vector<interop::LightCacheTriangle>& plan) {
    std::uint64_t count = 0;
    for (const interop::LightCacheTriangle& triangle : plan)
        count += lattice_points(triangle.edge);
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
        distance *= std::sqrt(1.1 * static_cast<double>(points) / static_cast<double>(most_points));
    }
}

LightCache::LightCache(Device& device, const SceneData& data, const LightCacheSettings& settings)
    : LightCache(device, settings,
                 plan_light_cache(data, settings.spacing,
                                  device.summary().storage_range_bytes / sizeof(interop::LightCachePoint))) {}

LightCache::LightCache(Device& device, const LightCacheSettings& settings,
                       const std::vector<interop::LightCacheTriangle>& plan)
    : device_(&device),
      settings_(settings),
      scene_triangles_(static_cast<std::uint32_t>(plan.size())),
      points_(light_cache_points(plan)),
      triangles_(make_buffer<interop::LightCacheTriangle>(device, plan, "triangles of the light cache")),
      light_(device, std::max<std::uint64_t>(1, points_) * sizeof(interop::LightCachePoint), "light cache"),
      counters_(device, sizeof(interop::Counters), "light cache counters") {}

FrameCounts LightCache::fill(const GpuScene& scene, std::uint32_t seed, double& seconds_to_compile,
                             Progress& progress) {
    Bindings bindings = scene.bindings();
    bindings.merge(this->bindings());
    bindings[interop::BINDING_COUNTERS] = &counters_;
    const auto start = std::chrono::steady_clock::now();
    const Kernel kernel(*device_, "fill_light_cache", kernels::fill_light_cache, scene.specialization(),
                        sizeof(interop::LightCachePush));
    const BindingSet set = kernel.bind(bindings);
    interop::LightCachePush push{};
    push.triangles = scene_triangles_;
    push.samples = settings_.samples;
    push.seed = seed;
    // Drivers may compile at the first dispatch; this one has no point to work on.
    device_->run("compile a kernel",
                 [&](const vk::raii::CommandBuffer& commands) { kernel.dispatch(commands, set, push, 1); });
    seconds_to_compile = seconds_since(start);

    FrameCounts counts;
    DispatchBudget budget;
    light_.fill_with_zero();
    const std::uint32_t samples = std::min(settings_.samples, kMostSamplesPerDispatch);
    for (std::uint64_t first = 0; first < points_; first = push.end_point) {
        if (progress.cancelled()) throw Interrupted();
        const std::uint64_t fitting =
            std::clamp<std::uint64_t>(budget.next_units() / samples, kGroupSize, kMostPointsPerDispatch);
        push.first_point = static_cast<std::uint32_t>(first);
        push.end_point = static_cast<std::uint32_t>(std::min(points_, first + fitting));
        for (push.sample_begin = 0; push.sample_begin < settings_.samples;
             push.sample_begin = push.sample_end) {
            push.sample_end = std::min(push.sample_begin + samples, settings_.samples);
            accumulate(counts, add_samples(kernel, set, push, budget));
        }
        progress.update(static_cast<double>(push.end_point), static_cast<double>(points_));
    }
    return counts;
}

FrameCounts LightCache::add_samples(const Kernel& kernel, const BindingSet& set,
                                    const interop::LightCachePush& push, DispatchBudget& budget) {
    const std::uint32_t points = push.end_point - push.first_point;
    counters_.fill_with_zero();
    FrameCounts counts;
    counts.gpu_seconds = device_->run("fill the light cache", [&](const vk::raii::CommandBuffer& commands) {
        kernel.dispatch(commands, set, push, (points + kGroupSize - 1) / kGroupSize);
    });
    budget.record(std::uint64_t{points} * (push.sample_end - push.sample_begin), counts.gpu_seconds);
    const auto totals = counters_.download_records<interop::Counters>(1).front();
    if (totals.incomplete > 0) {
        throw DeviceError("fill the light cache", device_->summary().name,
                          fmt::format("the driver ended the loops of {} points early", totals.incomplete));
    }
    counts.rays = totals.rays;
    return counts;
}

Bindings LightCache::bindings() const {
    return {{interop::BINDING_LIGHT_CACHE_TRIANGLES, &triangles_},
            {interop::BINDING_LIGHT_CACHE_POINTS, &light_}};
}

}  // namespace utsuri
