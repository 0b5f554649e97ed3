// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/methods/ray_tracer.h"

#include "interop/frame.h"

namespace utsuri {

/// Whether drawing a picture of a scene, before any of its mirrors, takes longer than tracing it: whether it
/// has fewer pixels than triangles, and more than some thousand of these.
bool costs_less_traced(const SceneData& data, const RenderSettings& settings);

/// What the hybrid method is there: it follows every ray.
class HybridTracer : public RayTracer {
  public:
    HybridTracer(const RendererInput& input, const RenderSettings& settings);

    void set_camera(const Camera& camera) override;
    [[nodiscard]] std::vector<PredictedError> predict_errors() override;
    [[nodiscard]] std::vector<MeasuredError> measure_errors() override;
    [[nodiscard]] std::vector<float> traced_pixels() override;

  private:
    [[nodiscard]] std::vector<interop::AovPixel> first_hits() const;
    /// What tells of each pixel: kNoReflection, or at mirrors what `at_mirror` makes of the first hit.
    template <typename Errors, typename AtMirror>
    [[nodiscard]] std::vector<Errors> errors_of_pixels(const AtMirror& at_mirror) const;

    Device& device_;
    const SceneData& data_;
    const GpuScene& scene_;
    RenderSettings settings_;
    Camera camera_;
};

}  // namespace utsuri
