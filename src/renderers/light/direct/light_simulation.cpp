// SPDX-License-Identifier: Apache-2.0
#include "renderers/light/direct/light_simulation.h"

#include "renderers/light/direct/light_reach.h"
#include "renderers/light/direct/place_order.h"

#include "base/stopwatch.h"

#include "interop/bindings.h"
#include "interop/specialization.h"
#include "kernels/simulate_light.h"

#include <algorithm>

namespace utsuri {
namespace {

constexpr std::uint64_t kSides = 2;
constexpr std::uint64_t kMostPointsPerDispatch = std::uint64_t{kMaxGroups} * interop::WORKGROUP_SIZE;

/// Seconds that a dispatch may take where its points, unlike those before, are in half shadow and take all
/// their rays: half of what makes drivers reset a device.
constexpr double kLongestDispatch = 1.0;

Specialization with_sums(Specialization specialization, const SceneData& data) {
    specialization[interop::SPEC_SUMS_LIGHTS] = sums_lights(data) ? 1 : 0;
    return specialization;
}

/// Rays from one side of a point, at most.
std::uint64_t most_rays_of_a_side(const SummedLights& summed, std::uint32_t samples) {
    if (summed.groups.empty()) return samples;
    std::uint64_t rays = 0;
    for (const interop::LightGroup& group : summed.groups)
        rays += std::min(group.most_samples, samples);
    // What lamps have no share of takes one each.
    return std::min<std::uint64_t>(rays, samples + summed.groups.size());
}

/// How many points may be simulated in some seconds, each with all its rays, if rays take as long as those
/// counted.
double points_within(double seconds, const FrameCounts& counted, std::uint64_t rays_of_a_side) {
    const double rays = seconds * static_cast<double>(counted.rays) / std::max(counted.gpu_seconds, 1e-9);
    return std::clamp(rays / static_cast<double>(kSides * rays_of_a_side), 1.0,
                      static_cast<double>(kMostPointsPerDispatch));
}

}  // namespace

LightSimulation::LightSimulation(Device& device, const SceneData& data, const GpuScene& scene,
                                 const LightSettings& settings,
                                 const std::vector<interop::ChangedBox>& changed)
    : device_(device),
      settings_(settings),
      bounds_(bounds_of_lights(data)),
      pieces_(sums_lights(data) ? find_light_pieces(data) : LightPieces()),
      summed_(sums_lights(data) ? list_summed_lights(data, pieces_) : SummedLights()),
      piece_radiance_(make_buffer<glm::vec3>(device, pieces_.radiance, "pieces of lights")),
      summed_lights_(
          make_buffer<interop::SummedLight>(device, summed_.lights, "summed lights", BindingKind::texels)),
      light_groups_(make_buffer<interop::LightGroup>(device, summed_.groups, "groups of lights")),
      light_bounds_(make_buffer<interop::LightBounds>(device, bounds_, "bounds of lights")),
      changed_boxes_(make_buffer<interop::ChangedBox>(device, changed, "boxes of what changed")),
      counters_(device, "light counters"),
      kernel_(device, "simulate_light", kernels::simulate_light, with_sums(scene.specialization(), data),
              sizeof(interop::LightPush)),
      bindings_(scene.bindings()),
      most_points_(static_cast<double>(kMostPointsPerDispatch)) {
    bindings_[interop::BINDING_COUNTERS] = &counters_.buffer();
    bindings_[interop::BINDING_LIGHT_BOUNDS] = &light_bounds_;
    bindings_[interop::BINDING_LIGHT_PIECES] = &piece_radiance_;
    bindings_[interop::BINDING_SUMMED_LIGHTS] = &summed_lights_;
    bindings_[interop::BINDING_LIGHT_GROUPS] = &light_groups_;
    bindings_[interop::BINDING_CHANGED_BOXES] = &changed_boxes_;
    push_.samples = settings.samples;
    push_.seed = settings.seed;
    push_.plain_triangles = summed_.plain_triangles;
    push_.triangles = summed_.triangles;
    push_.light_bounds = static_cast<std::uint32_t>(bounds_.size());
    push_.changed_boxes = static_cast<std::uint32_t>(changed.size());
}

void LightSimulation::simulate(std::span<const interop::LightMeshPlace> places,
                               std::span<interop::LightMeshPoint> light, Progress& progress) {
    if (places.empty()) return;
    const Stopwatch stopwatch;
    const std::vector<std::uint32_t> order = order_by_place(places);
    std::vector<interop::LightMeshPlace> ordered_places;
    std::vector<interop::LightMeshPoint> ordered_light;
    for (const std::uint32_t i : order) {
        ordered_places.push_back(places[i]);
        ordered_light.push_back(light[i]);
    }
    const Buffer places_buffer =
        make_buffer<interop::LightMeshPlace>(device_, ordered_places, "places of light");
    Buffer light_buffer = make_buffer<interop::LightMeshPoint>(device_, ordered_light, "light at places");
    Bindings bindings = bindings_;
    bindings[interop::BINDING_LIGHT_PLACES] = &places_buffer;
    bindings[interop::BINDING_LIGHT_MESH_POINTS] = &light_buffer;
    const BindingSet set = kernel_.bind(bindings);
    if (cost_.compile_seconds == 0.0) {
        // Drivers may compile at the first dispatch; this one has no point to work on.
        dispatch(set, 0, 0);
        cost_.compile_seconds = stopwatch.seconds();
    }
    const Stopwatch simulation;
    std::uint64_t end = 0;
    for (std::uint64_t first = 0; first < places.size(); first = end) {
        if (progress.cancelled()) throw Interrupted();
        const std::uint64_t fitting = std::clamp<std::uint64_t>(
            std::min<std::uint64_t>(budget_.next_units(), settings_.points_per_dispatch), 1,
            static_cast<std::uint64_t>(most_points_));
        end = std::min<std::uint64_t>(places.size(), first + fitting);
        const FrameCounts counts = dispatch(set, first, end);
        // Points that keep their light, or get none, tell nothing about those after them.
        if (counts.rays >= end - first) {
            budget_.record(end - first, counts.gpu_seconds);
            most_points_ =
                points_within(kLongestDispatch, counts, most_rays_of_a_side(summed_, settings_.samples));
        }
        accumulate(cost_.counts, counts);
        progress.update(static_cast<double>(done_ + end), static_cast<double>(done_ + places.size()));
    }
    done_ += end;
    light_buffer.download(std::as_writable_bytes(std::span(ordered_light)));
    for (std::size_t i = 0; i < order.size(); ++i)
        light[order[i]] = ordered_light[i];
    cost_.seconds += simulation.seconds();
}

FrameCounts LightSimulation::dispatch(const BindingSet& set, std::uint64_t first, std::uint64_t end) {
    push_.first_point = static_cast<std::uint32_t>(first);
    push_.end_point = static_cast<std::uint32_t>(end);
    counters_.clear();
    const double seconds = device_.run("simulate light", [&](const vk::raii::CommandBuffer& commands) {
        kernel_.dispatch(commands, set, push_,
                         std::max(1u, group_count(push_.end_point - push_.first_point)));
    });
    FrameCounts counts = counters_.read("simulate light", "points", "fewer --light-spp");
    counts.gpu_seconds = seconds;
    return counts;
}

}  // namespace utsuri
