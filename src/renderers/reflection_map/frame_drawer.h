// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/common/film.h"
#include "renderers/common/film_kernel.h"
#include "renderers/common/gpu_scene.h"
#include "renderers/common/scene_data.h"
#include "renderers/reflection_map/draw_list.h"
#include "renderers/reflection_map/reflector_drawer.h"

#include "base/progress.h"
#include "gpu/raster_pipeline.h"

#include "interop/raster.h"

#include <array>

namespace utsuri {

/// What one call of FrameDrawer::add_samples() draws.
struct DrawSettings {
    interop::CameraInfo camera;  ///< make_camera_info()
    std::uint32_t seed = 0;
    std::uint32_t specular_depth = 8;
    float tolerance = 0.0f;  ///< see MapSettings
};

/// Distance of the near plane for a scene.
float near_plane(const SceneData& data);

/// Draws one view of a scene with the raster pipeline and adds the pictures to a film, a sample of each pixel
/// a time. Samples of one picture lie at one place in their pixels, which a Sobol sequence moves from picture
/// to picture.
class FrameDrawer {
  public:
    /// @param bindings of scene, light cache and maps
    /// @param reflectors draws what is reflective; none if nothing is; must outlive this
    /// @throws DeviceError if the device cannot draw pictures of this size
    FrameDrawer(Device& device, const SceneData& data, const Specialization& specialization,
                const Bindings& bindings, const ReflectorDrawer* reflectors, std::uint32_t width,
                std::uint32_t height);

    /// Makes the driver compile what add_samples() needs.
    void warm_up();

    FrameCounts add_samples(Film& film, const DrawSettings& settings, std::uint32_t count,
                            Progress& progress);

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
    [[nodiscard]] Bindings with_draw_list(Bindings bindings) const;
    std::vector<Batch> make_batches(const std::vector<DrawBatch>& planned,
                                    const Specialization& specialization, const Bindings& bindings);
    double draw(const interop::RasterPush& push, const Film& film, const std::vector<BindingSet>& sets);

    Device& device_;
    const ReflectorDrawer* reflectors_;
    float near_plane_;
    std::array<float, 4> background_;
    Attachment colour_;
    Attachment depth_;
    Buffer drawn_;
    Buffer counters_;
    Buffer triangles_;
    std::uint32_t triangle_count_;
    RasterPipeline depth_pass_;
    BindingSet depth_bindings_;
    std::vector<Batch> batches_;
    Kernel add_kernel_;
};

}  // namespace utsuri
