// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/film/film_kernel.h"
#include "renderers/light/surface_light.h"
#include "renderers/methods/renderer.h"
#include "renderers/methods/renderer_input.h"

#include <memory>

namespace utsuri {

/// Follows every reflection ray by ray. Surfaces are lit anew where rays meet them, or, with
/// RenderSettings::kept_light, from the light kept on them, as drawn pictures are.
class RayTracer : public Renderer {
  public:
    RayTracer(const RendererInput& input, const RenderSettings& settings);

    void prepare(Progress& progress) override;
    void update(const SceneChange& change, Progress& progress) override;
    void set_camera(const Camera& camera) override;

  protected:
    FrameCounts render(Film& film, std::uint32_t count, Progress& progress) override;

  private:
    [[nodiscard]] FilmKernel make_kernel() const;

    Device& device_;
    const SceneData& data_;
    const GpuScene& scene_;
    const LightMethod& light_method_;
    std::shared_ptr<SurfaceLight> kept_light_;  ///< with RenderSettings::kept_light
    RenderSettings settings_;
    FrameSettings frame_;
    FilmKernel kernel_;
};

}  // namespace utsuri
