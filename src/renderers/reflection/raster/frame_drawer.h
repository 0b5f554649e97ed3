// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/film/film.h"
#include "renderers/film/film_kernel.h"
#include "renderers/reflection/raster/draw_list.h"
#include "renderers/reflection/raster/drawn_samples.h"
#include "renderers/reflection/raster/reflector_drawer.h"
#include "renderers/scene/gpu_scene.h"
#include "renderers/scene/scene_data.h"

#include "base/progress.h"
#include "gpu/raster_pipeline.h"

#include "interop/raster.h"

#include <glm/vec4.hpp>

#include <array>
#include <vector>

namespace utsuri {

/// What one call of FrameDrawer::add_samples() draws.
struct DrawSettings {
    interop::CameraInfo camera;  ///< make_camera_info()
    std::uint32_t seed = 0;
    std::uint32_t specular_depth = 8;
    float tolerance = 0.0f;  ///< Tolerance::most
};

/// Draws one view of a scene with the raster pipeline and adds the pictures to a film: see DrawnSamples.
class FrameDrawer {
  public:
    /// @param bindings of scene, light cache, maps and BINDING_FRAME; the last and the states of the maps
    /// must outlive this
    /// @param reflectors draws what is reflective; none if nothing is; must outlive this
    /// @throws DeviceError if the device cannot draw pictures of this size
    FrameDrawer(Device& device, const SceneData& data, const Specialization& specialization,
                const Bindings& bindings, const ReflectorDrawer* reflectors, std::uint32_t width,
                std::uint32_t height);

    /// Makes the driver compile what add_samples() needs.
    void warm_up();

    /// Draws one picture and leaves it for frame().
    /// @param jitter where in its pixel each sample lies, in [0, 1)^2
    void draw_frame(const DrawSettings& settings, const glm::vec2& jitter = {0.5f, 0.5f});
    [[nodiscard]] Image frame() const;
    /// How the reflections of that picture were found: Renderer::traced_pixels().
    [[nodiscard]] std::vector<float> traced_pixels() const;

    /// @param complete see DrawnSamples::add()
    FrameCounts add_samples(Film& film, const DrawSettings& settings, std::uint32_t count, Progress& progress,
                            const CompleteMaps& complete);

  private:
    /// One pipeline and the triangles it draws.
    struct Batch {
        RasterPipeline pipeline;
        BindingSet bindings;
        std::uint32_t first;
        std::uint32_t count;
    };

    FrameDrawer(Device& device, const SceneData& data, const DrawList& list,
                const Specialization& specialization, const Bindings& bindings,
                const ReflectorDrawer* reflectors, std::uint32_t width, std::uint32_t height);
    [[nodiscard]] interop::FrameInfo frame_of(const DrawSettings& settings) const;
    void record(const vk::raii::CommandBuffer& commands, const interop::CameraInfo& camera,
                const interop::FrameInfo& frame) const;
    [[nodiscard]] Bindings with_draw_list(Bindings bindings) const;
    std::vector<Batch> make_batches(const std::vector<DrawBatch>& planned,
                                    const Specialization& specialization, const Bindings& bindings);

    Device& device_;
    const ReflectorDrawer* reflectors_;
    interop::FrameInfo info_;
    const Buffer& frame_;
    std::array<float, 4> background_;
    Attachment colour_;
    Attachment depth_;
    DrawnSamples samples_;
    Buffer triangles_;
    std::uint32_t triangle_count_;
    RasterPipeline depth_pass_;
    BindingSet depth_bindings_;
    std::vector<Batch> batches_;
};

}  // namespace utsuri
