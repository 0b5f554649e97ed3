// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/light/surface_light.h"
#include "renderers/reflection/maps/seen_changes.h"
#include "renderers/scene/gpu_scene.h"

#include "base/progress.h"

#include "interop/radiance_bounds.h"
#include "interop/reflection.h"

#include <cstdint>
#include <vector>

namespace utsuri {

/// How dark and how bright what each reflector's capture point sees is, over the blocks of directions that
/// DistanceMaps bounds distances over: what tells, where a reflected ray may end in a range of places, how
/// bright it can be there.
class RadianceBounds {
  public:
    /// @param size of the distance maps
    /// @throws UsageError if they cannot fit into one buffer of the device
    /// @param instances that each of the probes belongs to
    RadianceBounds(Device& device, std::vector<std::uint32_t> instances,
                   const std::vector<interop::ProbeInfo>& infos, std::uint32_t size);

    /// Takes bounds over from those of the scene before it changed, where they are as many and as fine: of
    /// the capture points that stay where they are.
    void reuse_from(RadianceBounds& previous);
    /// Drops what a change may have changed.
    void forget(const SeenChanges& changes);

    /// Traces rays along those that measure distances, of faces that are not bounded yet, and bounds what
    /// they bring.
    /// @param light filled
    /// @param seconds_to_compile is increased by the time of the pipelines
    FrameCounts capture(const GpuScene& scene, const SurfaceLight& light, double& seconds_to_compile,
                        Progress& progress);

    [[nodiscard]] Bindings bindings() const;

  private:
    Device* device_;
    std::vector<std::uint32_t> instances_;
    std::vector<interop::ProbeInfo> probes_;
    std::uint32_t size_;
    Buffer samples_;  ///< of one face
    Buffer darkest_;
    Buffer brightest_;
    std::vector<bool> captured_;  ///< of each face of each probe
};

}  // namespace utsuri
