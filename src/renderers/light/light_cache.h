// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/film/frame_counts.h"
#include "renderers/light/light_reach.h"
#include "renderers/scene/gpu_scene.h"
#include "renderers/scene/scene_data.h"

#include "base/progress.h"
#include "gpu/dispatch_budget.h"
#include "gpu/kernel.h"

#include "interop/light_cache.h"

#include <cstdint>
#include <vector>

namespace utsuri {

struct LightCacheSettings {
    /// Distance of neighbouring points, at most, as a share of the diagonal of the scene's bounds, > 0.
    double spacing = 1.0 / 300.0;
    /// Per point and side, in [1, kMostLightSamples]; fewer where the first ones agree.
    std::uint32_t samples = 64;
};

/// Bounded by what an invocation may do: see kQueriesPerInvocation in film_kernel.cpp.
inline constexpr std::uint32_t kMostLightSamples = 256;

/// Light once simulated, on the host, and what that took: several methods of a comparison share it.
struct FilledLight {
    LightCacheSettings settings;
    std::vector<interop::LightCachePoint> points;       ///< empty until filled
    std::vector<interop::LightCacheTriangle> lattices;  ///< that the points are on
    std::uint32_t revision = 0;                         ///< SceneData::light_revision that they are of
    std::vector<std::uint32_t> changed;  ///< triangles whose light was other the revision before; ascending
    FrameCounts counts;
    double seconds = 0.0;          ///< wall time, pipeline excluded
    double compile_seconds = 0.0;  ///< pipeline
};

/// Where light is kept: a lattice over each triangle that has a diffuse part, fine enough for `spacing`, and
/// coarser on all of them alike where the points would be more than `most_points`.
/// @returns an entry for each triangle, in device order
std::vector<interop::LightCacheTriangle> plan_light_cache(const SceneData& data, double spacing,
                                                          std::uint64_t most_points);

/// Points of a planned cache.
std::uint64_t light_cache_points(const std::vector<interop::LightCacheTriangle>& plan);

/// Light arriving at diffuse surfaces, kept at points on them, so that drawing a frame simulates none. It
/// depends on the scene and its lights, not on the eye.
class LightCache {
  public:
    /// @throws DeviceError if it does not fit
    LightCache(Device& device, const SceneData& data, const LightCacheSettings& settings);

    /// Takes the light from `filled`, after simulating it there if that was not done yet, or for the scene
    /// before it changed: then only at points from which some way to a light leads through what changed.
    /// @param changed since the scene's light_revision() before
    /// @throws Interrupted if progress says so
    void fill(const GpuScene& scene, std::uint32_t seed, const ChangedSpace& changed, FilledLight& filled,
              Progress& progress);

    [[nodiscard]] std::uint64_t points() const { return points_; }
    [[nodiscard]] Bindings bindings() const;

  private:
    LightCache(Device& device, const SceneData& data, const LightCacheSettings& settings,
               const std::vector<interop::LightCacheTriangle>& plan);
    /// Whether `filled` is of the scene one change before, at the same points of surfaces that it did not
    /// touch.
    [[nodiscard]] bool may_keep(const FilledLight& filled, std::uint32_t revision,
                                const ChangedSpace& changed) const;
    void simulate(const GpuScene& scene, std::uint32_t seed, const std::vector<interop::ChangedBox>& changed,
                  FilledLight& filled, Progress& progress);
    /// Takes what was simulated over to the host.
    void keep(std::uint32_t revision, FilledLight& filled) const;
    FrameCounts simulate_points(const Kernel& kernel, const BindingSet& set,
                                const interop::LightCachePush& push);

    Device* device_;
    LightCacheSettings settings_;
    bool sums_lights_;
    std::vector<interop::LightCacheTriangle> lattices_;
    std::vector<interop::LightBounds> bounds_of_lights_;
    std::uint64_t points_;
    Buffer triangles_;
    Buffer light_;
    Buffer light_bounds_;
    Buffer counters_;
};

}  // namespace utsuri
