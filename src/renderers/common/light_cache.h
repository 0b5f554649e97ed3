// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/common/film_kernel.h"
#include "renderers/common/gpu_scene.h"
#include "renderers/common/scene_data.h"

#include "base/progress.h"
#include "gpu/dispatch_budget.h"

#include "interop/light_cache.h"

#include <cstdint>
#include <vector>

namespace utsuri {

struct LightCacheSettings {
    /// Distance of neighbouring points, at most, as a share of the diagonal of the scene's bounds, > 0.
    double spacing = 1.0 / 300.0;
    std::uint32_t samples = 16;  ///< per point and side, >= 1
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

    /// Simulates direct light at every point.
    /// @param seconds_to_compile is set to the time of the pipeline
    /// @throws Interrupted if progress says so
    FrameCounts fill(const GpuScene& scene, std::uint32_t seed, double& seconds_to_compile,
                     Progress& progress);

    [[nodiscard]] std::uint64_t points() const { return points_; }
    [[nodiscard]] Bindings bindings() const;

  private:
    LightCache(Device& device, const LightCacheSettings& settings,
               const std::vector<interop::LightCacheTriangle>& plan);
    FrameCounts add_samples(const Kernel& kernel, const BindingSet& set, const interop::LightCachePush& push,
                            DispatchBudget& budget);

    Device* device_;
    LightCacheSettings settings_;
    std::uint32_t scene_triangles_;
    std::uint64_t points_;
    Buffer triangles_;
    Buffer light_;
    Buffer counters_;
};

}  // namespace utsuri
