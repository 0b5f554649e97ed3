// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/gpu_scene.h"
#include "renderers/light/surface_light.h"
#include "renderers/reflection/distances/measured_faces.h"

#include "base/progress.h"

#include "interop/radiance_bounds.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace utsuri {

/// How dark and how bright what each reflector's capture point sees is, over the blocks of directions that
/// DistanceMaps bounds distances over: what tells, where a reflected ray may end in a range of places, how
/// bright it can be there.
class RadianceBounds {
  public:
    /// @param faces of the distance maps
    /// @throws UsageError if they cannot fit into one buffer of the device
    RadianceBounds(Device& device, const MeasuredFaces& faces);

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

    /// What a block and its neighbours can show, cd/m2.
    struct Block {
        glm::vec3 darkest;
        glm::vec3 brightest;

        friend bool operator==(const Block&, const Block&) = default;
    };
    /// The blocks of a level of a face, row by row, for tests.
    [[nodiscard]] std::vector<Block> blocks(std::uint32_t probe, std::uint32_t face,
                                            std::uint32_t level) const;

  private:
    Device* device_;
    MeasuredFaces faces_;
    Buffer samples_;  ///< of one face
    Buffer darkest_;
    Buffer brightest_;
};

}  // namespace utsuri
