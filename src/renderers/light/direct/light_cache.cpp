// SPDX-License-Identifier: Apache-2.0
#include "renderers/light/direct/light_cache.h"

#include "renderers/light/direct/lattice_plan.h"

#include "base/error.h"
#include "base/same_bits.h"
#include "base/stopwatch.h"
#include "gpu/dispatch_budget.h"

#include "interop/bindings.h"
#include "interop/specialization.h"
#include "kernels/fill_light_cache.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <utility>

namespace utsuri {
namespace {

constexpr std::uint64_t kSides = 2;
constexpr std::uint64_t kMostPointsPerDispatch = std::uint64_t{kMaxGroups} * interop::WORKGROUP_SIZE;

/// Seconds that a dispatch may take where its points, unlike those before, are in half shadow and take all
/// their rays: half of what makes drivers reset a device.
constexpr double kLongestDispatch = 1.0;

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

/// Light that triangles keep, under the numbers that their points have in other lattices; zero on triangles
/// whose own lattice differs.
std::vector<interop::LightCachePoint> renumbered(const std::vector<interop::LightCachePoint>& points,
                                                 const std::vector<interop::LightCacheTriangle>& were,
                                                 const std::vector<interop::LightCacheTriangle>& are) {
    std::vector<interop::LightCachePoint> result(light_cache_points(are));
    for (std::size_t t = 0; t < are.size(); ++t) {
        if (!same_lattice(were[t], are[t])) continue;
        std::copy_n(points.begin() + were[t].first_point, lattice_points(are[t]),
                    result.begin() + are[t].first_point);
    }
    return result;
}

/// Light and where it is kept.
struct Kept {
    const std::vector<interop::LightCacheTriangle>& lattices;
    const std::vector<interop::LightCachePoint>& points;
};

bool same_light(const Kept& before, const Kept& after, std::size_t triangle) {
    const interop::LightCacheTriangle& was = before.lattices[triangle];
    const interop::LightCacheTriangle& is = after.lattices[triangle];
    if (!same_lattice(was, is)) return false;
    const std::uint64_t count = lattice_points(is);
    return count == 0 || std::memcmp(&before.points[was.first_point], &after.points[is.first_point],
                                     count * sizeof(interop::LightCachePoint)) == 0;
}

std::vector<std::uint32_t> changed_triangles(const Kept& before, const Kept& after) {
    std::vector<std::uint32_t> changed;
    for (std::uint32_t t = 0; t < after.lattices.size(); ++t) {
        if (!same_light(before, after, t)) changed.push_back(t);
    }
    return changed;
}

/// How many points may be simulated in some seconds, each with all its rays, if rays take as long as those
/// counted.
double points_within(double seconds, const FrameCounts& counted, std::uint32_t samples) {
    const double rays = seconds * static_cast<double>(counted.rays) / std::max(counted.gpu_seconds, 1e-9);
    return std::clamp(rays / static_cast<double>(kSides * samples), 1.0,
                      static_cast<double>(kMostPointsPerDispatch));
}

std::uint64_t buffer_bytes(const std::vector<interop::LightCacheTriangle>& lattices) {
    return std::max<std::uint64_t>(1, light_cache_points(lattices)) * sizeof(interop::LightCachePoint);
}

}  // namespace

LightCache::LightCache(Device& device, const SceneData& data, const GpuScene& scene,
                       const LightSettings& settings)
    : SurfaceLight(device, data.requirements.glossy),
      device_(device),
      data_(data),
      scene_(scene),
      settings_(settings),
      lattices_(plan()),
      triangles_(make_buffer<interop::LightCacheTriangle>(device, lattices_, "triangles of the light cache")),
      light_(device, buffer_bytes(lattices_), "light cache"),
      counters_(device, "light cache counters") {}

LightCache::Lattices LightCache::plan() const {
    return plan_light_cache(data_, settings_.spacing,
                            device_.summary().storage_range_bytes / sizeof(interop::LightCachePoint));
}

void LightCache::make_buffers(Lattices planned) {
    const std::uint64_t bytes = buffer_bytes(planned);
    if (light_.size() != bytes) light_ = Buffer(device_, bytes, "light cache");
    lattices_ = std::move(planned);
    triangles_.upload(std::as_bytes(std::span(lattices_)));
}

void LightCache::fill(Progress& progress) {
    if (is_filled()) return;
    last_read_.clear();
    light_.fill_with_zero();
    simulate(all_space().boxes, progress);
    changed_.resize(lattices_.size());
    std::iota(changed_.begin(), changed_.end(), 0u);
}

void LightCache::update(const SceneChange& change, Progress& progress) {
    if (is_filled()) return;
    Lattices planned = plan();
    if (!revision_) return make_buffers(std::move(planned));
    const ChangedSpace changed = change.lights ? all_space() : changed_space(data_, change);
    const Points before = last_read_.empty() ? points() : std::exchange(last_read_, {});
    const Lattices were = lattices_;
    const bool keeps = may_keep(planned, changed);
    make_buffers(std::move(planned));
    if (!keeps) {
        light_.fill_with_zero();
    } else if (!same_bits(were, lattices_)) {
        const Points kept = renumbered(before, were, lattices_);
        light_.upload(std::as_bytes(std::span(kept)));
    }
    simulate(keeps ? changed.boxes : all_space().boxes, progress);
    last_read_ = points();
    changed_ = changed_triangles({were, before}, {lattices_, last_read_});
}

bool LightCache::may_keep(const Lattices& planned, const ChangedSpace& changed) const {
    if (*revision_ + 1 != scene_.light_revision()) return false;
    for (std::uint32_t t = 0; t < planned.size(); ++t) {
        if (!same_lattice(lattices_[t], planned[t]) &&
            !std::binary_search(changed.triangles.begin(), changed.triangles.end(), t))
            return false;
    }
    return true;
}

std::vector<interop::LightCachePoint> LightCache::points() const {
    return light_.download_records<interop::LightCachePoint>(light_cache_points(lattices_));
}

void LightCache::simulate(const std::vector<interop::ChangedBox>& changed, Progress& progress) {
    revision_.reset();  // until all of it is there
    cost_ = {};
    const std::uint64_t count = light_cache_points(lattices_);
    if (count == 0) {
        revision_ = scene_.light_revision();
        return;
    }
    const std::vector<interop::LightBounds> bounds = bounds_of_lights(data_);
    const Buffer bounds_buffer = make_buffer<interop::LightBounds>(device_, bounds, "bounds of lights");
    const Buffer changed_boxes = make_buffer<interop::ChangedBox>(device_, changed, "boxes of what changed");
    Bindings bindings = scene_.bindings();
    bindings.merge(kept_bindings());
    bindings[interop::BINDING_COUNTERS] = &counters_.buffer();
    bindings[interop::BINDING_LIGHT_BOUNDS] = &bounds_buffer;
    bindings[interop::BINDING_CHANGED_BOXES] = &changed_boxes;
    const Stopwatch compilation;
    Specialization specialization = scene_.specialization();
    specialization[interop::SPEC_SUMS_LIGHTS] = sums_lights(data_) ? 1 : 0;
    const Kernel kernel(device_, "fill_light_cache", kernels::fill_light_cache, specialization,
                        sizeof(interop::LightCachePush));
    const BindingSet set = kernel.bind(bindings);
    interop::LightCachePush push{};
    push.triangles = static_cast<std::uint32_t>(lattices_.size());
    push.samples = settings_.samples;
    push.seed = settings_.seed;
    push.light_bounds = static_cast<std::uint32_t>(bounds.size());
    push.changed_boxes = static_cast<std::uint32_t>(changed.size());
    // Drivers may compile at the first dispatch; this one has no point to work on.
    device_.run("compile a kernel",
                [&](const vk::raii::CommandBuffer& commands) { kernel.dispatch(commands, set, push, 1); });
    cost_.compile_seconds = compilation.seconds();

    const Stopwatch simulation;
    DispatchBudget budget;
    double most_points = static_cast<double>(kMostPointsPerDispatch);
    for (std::uint64_t first = 0; first < count; first = push.end_point) {
        if (progress.cancelled()) throw Interrupted();
        const std::uint64_t fitting = std::clamp<std::uint64_t>(
            std::min<std::uint64_t>(budget.next_units(), settings_.points_per_dispatch), 1,
            static_cast<std::uint64_t>(most_points));
        push.first_point = static_cast<std::uint32_t>(first);
        push.end_point = static_cast<std::uint32_t>(std::min(count, first + fitting));
        const FrameCounts counts = simulate_points(kernel, set, push);
        // Points that keep their light tell nothing about those after them.
        if (counts.rays > 0) {
            budget.record(push.end_point - push.first_point, counts.gpu_seconds);
            most_points = points_within(kLongestDispatch, counts, settings_.samples);
        }
        accumulate(cost_.counts, counts);
        progress.update(static_cast<double>(push.end_point), static_cast<double>(count));
    }
    cost_.seconds = simulation.seconds();
    revision_ = scene_.light_revision();
}

FrameCounts LightCache::simulate_points(const Kernel& kernel, const BindingSet& set,
                                        const interop::LightCachePush& push) {
    const std::uint32_t points = push.end_point - push.first_point;
    counters_.clear();
    const double seconds = device_.run("fill the light cache", [&](const vk::raii::CommandBuffer& commands) {
        kernel.dispatch(commands, set, push, group_count(points));
    });
    FrameCounts counts = counters_.read("fill the light cache", "points", "fewer --light-spp");
    counts.gpu_seconds = seconds;
    return counts;
}

Bindings LightCache::kept_bindings() const {
    return {{interop::BINDING_LIGHT_CACHE_TRIANGLES, &triangles_},
            {interop::BINDING_LIGHT_CACHE_POINTS, &light_}};
}

}  // namespace utsuri
