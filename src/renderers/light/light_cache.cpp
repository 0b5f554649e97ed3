// SPDX-License-Identifier: Apache-2.0
#include "renderers/light/light_cache.h"

#include "renderers/light/light_reach.h"

#include "base/check.h"
#include "base/error.h"

#include "interop/bindings.h"
#include "interop/frame.h"
#include "interop/specialization.h"
#include "kernels/fill_light_cache.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstring>

namespace utsuri {
namespace {

/// Intervals along an edge, at most: their points are numbered within 32 bits.
constexpr double kMostIntervals = 32768.0;
constexpr std::uint32_t kGroupSize = 64;
constexpr std::uint64_t kSides = 2;
constexpr std::uint64_t kMostPointsPerDispatch = std::uint64_t{kMaxGroups} * kGroupSize;

std::uint64_t lattice_points(const interop::LightCacheTriangle& lattice) {
    if (lattice.intervals == 0) return 0;
    // Rows of 2 to intervals + 1 points, each size rows_per_interval times, and the apex.
    const std::uint64_t n = lattice.intervals;
    return lattice.rows_per_interval * (n * (n + 3) / 2) + 1;
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
    const double intervals = std::clamp(std::ceil(opposite[apex] / spacing), 1.0, kMostIntervals);
    const double rows = std::clamp(std::ceil(longest / (spacing * intervals)), 1.0, kMostIntervals);
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

/// Summing more lights than this at every point would cost more than sampling them.
constexpr std::size_t kMostSummedLights = 64;

/// Whether all lights of a scene have a closed form: textured ones have none.
bool sums_lights(const SceneData& data) {
    const auto is_textured = [&](const interop::LightInfo& light) {
        return light.type == interop::LIGHT_TRIANGLE &&
               data.materials[data.triangle_infos[light.triangle].material].emissive_texture.texture !=
                   interop::NONE;
    };
    return data.lights.size() <= kMostSummedLights &&
           std::none_of(data.lights.begin(), data.lights.end(), is_textured);
}

bool same_lattice(const interop::LightCacheTriangle& a, const interop::LightCacheTriangle& b) {
    return a.intervals == b.intervals && a.rows_per_interval == b.rows_per_interval && a.apex == b.apex;
}

/// Light under the numbers that points have in other lattices; zero on triangles whose own differs.
std::vector<interop::LightCachePoint> renumbered(const FilledLight& filled,
                                                 const std::vector<interop::LightCacheTriangle>& lattices) {
    std::vector<interop::LightCachePoint> points(light_cache_points(lattices));
    for (std::size_t t = 0; t < lattices.size(); ++t) {
        if (!same_lattice(filled.lattices[t], lattices[t])) continue;
        const auto first = filled.points.begin() + filled.lattices[t].first_point;
        std::copy_n(first, lattice_points(lattices[t]), points.begin() + lattices[t].first_point);
    }
    return points;
}

bool same_light(const FilledLight& before, const interop::LightCacheTriangle& was,
                const std::vector<interop::LightCachePoint>& points, const interop::LightCacheTriangle& is) {
    if (!same_lattice(was, is)) return false;
    const std::uint64_t count = lattice_points(is);
    return count == 0 || std::memcmp(&before.points[was.first_point], &points[is.first_point],
                                     count * sizeof(interop::LightCachePoint)) == 0;
}

/// Triangles on which light differs from what was there before; all if nothing was.
std::vector<std::uint32_t> changed_triangles(const FilledLight& before,
                                             const std::vector<interop::LightCachePoint>& points,
                                             const std::vector<interop::LightCacheTriangle>& lattices) {
    std::vector<std::uint32_t> changed;
    const bool is_first = before.lattices.size() != lattices.size();
    for (std::uint32_t t = 0; t < lattices.size(); ++t) {
        if (is_first || !same_light(before, before.lattices[t], points, lattices[t])) changed.push_back(t);
    }
    return changed;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

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
        distance *= std::sqrt(1.1 * static_cast<double>(points) / static_cast<double>(most_points));
    }
}

LightCache::LightCache(Device& device, const SceneData& data, const LightCacheSettings& settings)
    : LightCache(device, data, settings,
                 plan_light_cache(data, settings.spacing,
                                  device.summary().storage_range_bytes / sizeof(interop::LightCachePoint))) {}

LightCache::LightCache(Device& device, const SceneData& data, const LightCacheSettings& settings,
                       const std::vector<interop::LightCacheTriangle>& plan)
    : device_(&device),
      settings_(settings),
      sums_lights_(sums_lights(data)),
      lattices_(plan),
      bounds_of_lights_(bounds_of_lights(data)),
      points_(light_cache_points(plan)),
      triangles_(make_buffer<interop::LightCacheTriangle>(device, plan, "triangles of the light cache")),
      light_(device, std::max<std::uint64_t>(1, points_) * sizeof(interop::LightCachePoint), "light cache"),
      light_bounds_(make_buffer<interop::LightBounds>(device, bounds_of_lights_, "bounds of lights")),
      counters_(device, sizeof(interop::Counters), "light cache counters") {}

void LightCache::fill(const GpuScene& scene, std::uint32_t seed, const ChangedSpace& changed,
                      FilledLight& filled, Progress& progress) {
    if (points_ == 0) return;
    if (!filled.points.empty() && filled.revision == scene.light_revision()) {
        UTSURI_CHECK_EQ(filled.points.size(), points_);
        light_.upload(std::as_bytes(std::span(filled.points)));
        return;
    }
    if (may_keep(filled, scene.light_revision(), changed)) {
        const std::vector<interop::LightCachePoint> before = renumbered(filled, lattices_);
        light_.upload(std::as_bytes(std::span(before)));
        simulate(scene, seed, changed.boxes, filled, progress);
    } else {
        light_.fill_with_zero();
        simulate(scene, seed, all_space().boxes, filled, progress);
    }
    keep(scene.light_revision(), filled);
}

bool LightCache::may_keep(const FilledLight& filled, std::uint32_t revision,
                          const ChangedSpace& changed) const {
    if (filled.points.empty() || filled.revision + 1 != revision ||
        filled.lattices.size() != lattices_.size())
        return false;
    for (std::uint32_t t = 0; t < lattices_.size(); ++t) {
        if (!same_lattice(filled.lattices[t], lattices_[t]) &&
            !std::binary_search(changed.triangles.begin(), changed.triangles.end(), t))
            return false;
    }
    return true;
}

void LightCache::keep(std::uint32_t revision, FilledLight& filled) const {
    auto points = light_.download_records<interop::LightCachePoint>(points_);
    filled.changed = changed_triangles(filled, points, lattices_);
    filled.points = std::move(points);
    filled.lattices = lattices_;
    filled.revision = revision;
}

void LightCache::simulate(const GpuScene& scene, std::uint32_t seed,
                          const std::vector<interop::ChangedBox>& changed, FilledLight& filled,
                          Progress& progress) {
    const Buffer changed_boxes = make_buffer<interop::ChangedBox>(*device_, changed, "boxes of what changed");
    Bindings bindings = scene.bindings();
    bindings.merge(this->bindings());
    bindings[interop::BINDING_COUNTERS] = &counters_;
    bindings[interop::BINDING_LIGHT_BOUNDS] = &light_bounds_;
    bindings[interop::BINDING_CHANGED_BOXES] = &changed_boxes;
    auto start = std::chrono::steady_clock::now();
    Specialization specialization = scene.specialization();
    specialization[interop::SPEC_SUMS_LIGHTS] = sums_lights_ ? 1 : 0;
    const Kernel kernel(*device_, "fill_light_cache", kernels::fill_light_cache, specialization,
                        sizeof(interop::LightCachePush));
    const BindingSet set = kernel.bind(bindings);
    interop::LightCachePush push{};
    push.triangles = static_cast<std::uint32_t>(lattices_.size());
    push.samples = settings_.samples;
    push.seed = seed;
    push.light_bounds = static_cast<std::uint32_t>(bounds_of_lights_.size());
    push.changed_boxes = static_cast<std::uint32_t>(changed.size());
    // Drivers may compile at the first dispatch; this one has no point to work on.
    device_->run("compile a kernel",
                 [&](const vk::raii::CommandBuffer& commands) { kernel.dispatch(commands, set, push, 1); });
    filled.compile_seconds = seconds_since(start);

    start = std::chrono::steady_clock::now();
    filled.counts = {};
    DispatchBudget budget;
    for (std::uint64_t first = 0; first < points_; first = push.end_point) {
        if (progress.cancelled()) throw Interrupted();
        const std::uint64_t fitting = std::clamp<std::uint64_t>(
            budget.next_units() / (kSides * settings_.samples), kGroupSize, kMostPointsPerDispatch);
        push.first_point = static_cast<std::uint32_t>(first);
        push.end_point = static_cast<std::uint32_t>(std::min(points_, first + fitting));
        const FrameCounts counts = simulate_points(kernel, set, push);
        // Points that keep their light cost next to nothing; those after them may cost all their rays.
        if (counts.rays > 0) budget.record(counts.rays, counts.gpu_seconds);
        accumulate(filled.counts, counts);
        progress.update(static_cast<double>(push.end_point), static_cast<double>(points_));
    }
    filled.seconds = seconds_since(start);
}

FrameCounts LightCache::simulate_points(const Kernel& kernel, const BindingSet& set,
                                        const interop::LightCachePush& push) {
    const std::uint32_t points = push.end_point - push.first_point;
    counters_.fill_with_zero();
    FrameCounts counts;
    counts.gpu_seconds = device_->run("fill the light cache", [&](const vk::raii::CommandBuffer& commands) {
        kernel.dispatch(commands, set, push, (points + kGroupSize - 1) / kGroupSize);
    });
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
