// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/gpu_scene.h"
#include "renderers/device_scene/scene_data.h"
#include "renderers/reflection/raster/deferred_tracer.h"
#include "renderers/reflection/raster/draw_list.h"
#include "renderers/reflection/raster/reflector_drawer.h"

#include "gpu/raster_pipeline.h"

#include "interop/raster.h"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace utsuri {

/// Draws one view of a scene with the raster pipeline.
class FrameDrawer {
  public:
    /// @param bindings of scene, kept light, maps and BINDING_FRAME, which must outlive this
    /// @param kind how reflections are looked up, those of glossy lobes included
    /// @param reflectors draws what is reflective; none if nothing is; must outlive this
    /// @throws DeviceError if the device cannot draw pictures of this size
    FrameDrawer(Device& device, const SceneData& data, MapKind kind, const Specialization& specialization,
                const Bindings& bindings, const ReflectorDrawer* reflectors, std::uint32_t width,
                std::uint32_t height);

    /// Makes the driver compile what record() needs.
    void warm_up();

    /// Records the drawing of one picture.
    /// @param camera make_camera_info()
    void record(const vk::raii::CommandBuffer& commands, const interop::CameraInfo& camera,
                const interop::FrameInfo& frame) const;
    /// What it draws into.
    [[nodiscard]] const Attachment& picture() const { return colour_; }
    /// What the last record() left to rays. Only where it defers_reflections().
    /// @param camera of that record()
    [[nodiscard]] DeferredPicture deferred_picture(const interop::CameraInfo& camera) const;

  private:
    /// One pipeline and the triangles it draws.
    struct Batch {
        RasterPipeline pipeline;
        BindingSet bindings;
        std::uint32_t first;
        std::uint32_t count;
    };

    FrameDrawer(Device& device, const SceneData& data, const DrawList& list, MapKind kind,
                const Specialization& specialization, const Bindings& bindings,
                const ReflectorDrawer* reflectors, std::uint32_t width, std::uint32_t height);
    [[nodiscard]] Bindings with_draw_list(Bindings bindings) const;
    std::vector<Batch> make_batches(const std::vector<DrawBatch>& planned,
                                    const Specialization& specialization, const Bindings& bindings);
    void draw_cleared(const vk::raii::CommandBuffer& commands, const std::function<void()>& record) const;

    Device& device_;
    const ReflectorDrawer* reflectors_;
    const Buffer& frame_;
    std::array<float, 4> background_;
    Attachment colour_;
    std::optional<Attachment> deferred_;
    Attachment depth_;
    Buffer triangles_;
    std::uint32_t triangle_count_;
    RasterPipeline depth_pass_;
    BindingSet depth_bindings_;
    std::vector<Batch> batches_;
};

}  // namespace utsuri
