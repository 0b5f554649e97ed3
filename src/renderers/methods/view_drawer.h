// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/reflection/raster/deferred_tracer.h"
#include "renderers/reflection/raster/reflection_error.h"

#include "gpu/attachment.h"
#include "scene/camera.h"

#include "interop/raster.h"

#include <vector>

namespace utsuri {

/// Draws views of a scene: what RasterRenderer leaves to a strategy.
class ViewDrawer {
  public:
    ViewDrawer() = default;
    ViewDrawer(const ViewDrawer&) = delete;
    ViewDrawer& operator=(const ViewDrawer&) = delete;
    virtual ~ViewDrawer() = default;

    /// Makes the driver compile what drawing needs.
    virtual void warm_up() = 0;
    virtual void set_camera(const Camera& camera) = 0;
    /// All that the present camera costs before its first picture; nothing after that.
    /// @returns seconds on the device
    virtual double prepare_view() = 0;
    /// Records the drawing of one picture.
    virtual void record(const vk::raii::CommandBuffer& commands, const interop::FrameInfo& frame) const = 0;
    /// What record() draws into, with the state of each pixel in the fourth channel: lib/pixel_state.glsl.
    [[nodiscard]] virtual const Attachment& picture() const = 0;

    /// What the last record() left to rays. Only where it defers_reflections().
    [[nodiscard]] virtual DeferredPicture deferred_picture() const = 0;

    /// See Renderer. picture() is of the present view, a sample at the centre of each pixel.
    [[nodiscard]] virtual std::vector<PredictedError> predict_errors() = 0;
    [[nodiscard]] virtual std::vector<MeasuredError> measure_errors() = 0;
};

}  // namespace utsuri
