// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/gpu_scene.h"
#include "renderers/device_scene/scene_data.h"
#include "renderers/film/device_counters.h"
#include "renderers/light/direct/light_pieces.h"
#include "renderers/light/direct/summed_lights.h"
#include "renderers/light/light_settings.h"
#include "renderers/light/surface_light.h"

#include "gpu/dispatch_budget.h"
#include "gpu/kernel.h"

#include "interop/light_mesh.h"

#include <span>
#include <vector>

namespace utsuri {

/// Direct light with shadows at places on surfaces: kernels/light/simulate_light.comp.
class LightSimulation {
  public:
    /// All of them must outlive this, and the scene must not change.
    /// @param changed where a change was: what is known at places is right unless light reaches them through
    ///     these
    LightSimulation(Device& device, const SceneData& data, const GpuScene& scene,
                    const LightSettings& settings, const std::vector<interop::ChangedBox>& changed);

    /// @param light what is known at places that say so; all of it is light afterwards
    /// @throws Interrupted if progress says so
    void simulate(std::span<const interop::LightMeshPlace> places, std::span<interop::LightMeshPoint> light,
                  Progress& progress);

    /// Of all there was.
    [[nodiscard]] const LightCost& cost() const { return cost_; }

  private:
    FrameCounts dispatch(const BindingSet& set, std::uint64_t first, std::uint64_t end);

    Device& device_;
    const LightSettings& settings_;
    std::vector<interop::LightBounds> bounds_;
    LightPieces pieces_;
    SummedLights summed_;
    Buffer piece_radiance_;
    Buffer summed_lights_;
    Buffer light_groups_;
    Buffer light_bounds_;
    Buffer changed_boxes_;
    DeviceCounters counters_;
    Kernel kernel_;
    Bindings bindings_;
    interop::LightPush push_{};
    DispatchBudget budget_;
    double most_points_;  ///< in one dispatch
    std::uint64_t done_ = 0;
    LightCost cost_;
};

}  // namespace utsuri
