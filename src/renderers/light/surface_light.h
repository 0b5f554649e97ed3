// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_change.h"
#include "renderers/film/frame_counts.h"

#include "base/progress.h"
#include "gpu/buffer.h"
#include "gpu/pipeline_interface.h"

#include <cstdint>
#include <vector>

namespace utsuri {

/// What simulating light took.
struct LightCost {
    FrameCounts counts;
    double seconds = 0.0;          ///< wall time, pipeline excluded
    double compile_seconds = 0.0;  ///< pipeline
};

/// Light that diffuse surfaces of a scene send out, kept on them, on the device: one for all that look it up.
/// Kernels see it as those of kernels/light/ have it. It depends on the scene and its lights, not on the eye.
class SurfaceLight {
  public:
    /// @param device must outlive this
    /// @param under_glossy whether some of the diffuse surfaces lie under a glossy lobe, which takes its
    /// share of the
    ///     light according to the eye
    SurfaceLight(Device& device, bool under_glossy);
    SurfaceLight(const SurfaceLight&) = delete;
    SurfaceLight& operator=(const SurfaceLight&) = delete;
    virtual ~SurfaceLight() = default;

    /// Simulates the light of the scene as it is, unless it is there.
    /// @throws Interrupted if progress says so; the light is not there then
    virtual void fill(Progress& progress) = 0;
    /// The same after a change that the scene on the device has taken over, if the light was there before it;
    /// what the change cannot have reached is kept. Buffers may be others afterwards: bindings() are to be
    /// asked for again.
    /// @throws Interrupted if progress says so; the light is not there then
    virtual void update(const SceneChange& change, Progress& progress) = 0;

    /// What kernels/light/kept_light.glsl and lobe_albedo.glsl read. fill() comes first.
    [[nodiscard]] Bindings bindings() const;

    /// Of the last fill() or update() that simulated light.
    [[nodiscard]] const LightCost& cost() const { return cost_; }
    /// Triangles that send out other light since the last change of the scene that concerned light, all of
    /// them if nothing was there before; ascending.
    [[nodiscard]] const std::vector<std::uint32_t>& changed() const { return changed_; }

  protected:
    /// What kernels/light/kept_light.glsl reads.
    [[nodiscard]] virtual Bindings kept_bindings() const = 0;

    LightCost cost_;
    std::vector<std::uint32_t> changed_;

  private:
    Buffer lobe_albedos_;  ///< without entries unless some surface is under a glossy lobe
};

}  // namespace utsuri
