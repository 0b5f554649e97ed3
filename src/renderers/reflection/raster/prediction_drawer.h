// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/gpu_scene.h"
#include "renderers/reflection/raster/reflection_error.h"
#include "renderers/reflection/raster/reflector_drawer.h"

#include "gpu/raster_pipeline.h"

#include "interop/raster.h"

#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

namespace utsuri {

/// Draws the errors of a method's look-ups instead of what they show.
class PredictionDrawer {
  public:
    /// @param kind whose look-ups
    /// @param specialization of the fragment stage, with map and distance sizes
    /// @param bindings of scene, kept light, maps, distance maps and BINDING_FRAME, which must outlive this
    /// @param reflectors whose vertices have been reflected for the eye
    PredictionDrawer(Device& device, const SceneData& data, MapKind kind, std::size_t faces,
                     const Specialization& specialization, const Bindings& bindings,
                     const ReflectorDrawer& reflectors, std::uint32_t width, std::uint32_t height);

    /// Row-major, top row first.
    /// @param tolerance of MapKind::hybrid, which searches no farther where it is met; else 0
    [[nodiscard]] std::vector<PredictedError> predict(const interop::CameraInfo& camera, float tolerance);
    [[nodiscard]] std::vector<MeasuredError> measure(const interop::CameraInfo& camera, float tolerance);

  private:
    struct Stage {
        RasterPipeline pipeline;
        BindingSet bindings;
    };
    [[nodiscard]] Stage make_stage(const char* name, std::span<const std::uint32_t> fragment,
                                   const Specialization& specialization, Bindings bindings) const;
    [[nodiscard]] std::vector<glm::vec4> draw(const Stage& stage, const interop::CameraInfo& camera,
                                              float tolerance);

    Device& device_;
    interop::FrameInfo info_;
    const Buffer& frame_;
    Attachment colour_;
    Attachment depth_;
    Buffer triangles_;
    std::uint32_t triangle_count_;
    Buffer polygons_;
    std::uint32_t polygon_count_;
    RasterPipeline depth_pass_;
    BindingSet depth_bindings_;
    Stage predict_;
    Stage measure_;
};

}  // namespace utsuri
