// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/film/film_kernel.h"
#include "renderers/methods/renderer.h"
#include "renderers/scene/gpu_scene.h"

namespace utsuri {

/// direct/trace: direct light with shadows, mirrors and rough lobes followed ray by ray.
class RayTracer : public Renderer {
  public:
    /// `device`, `data` and `scene` must outlive this.
    RayTracer(Device& device, const SceneData& data, const GpuScene& scene, const Camera& camera,
              const RenderSettings& settings);

    void prepare(Progress& progress) override;
    /// Keeps nothing of the scene but its buffers.
    void follow(const SceneChange& change, Progress& progress) override;
    void look_from(const Camera& camera) override;

  protected:
    FrameCounts render(Film& film, std::uint32_t count, Progress& progress) override;

  private:
    Device& device_;
    const SceneData& data_;
    RenderSettings settings_;
    FrameSettings frame_;
    FilmKernel kernel_;
};

}  // namespace utsuri
