// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/common/film.h"
#include "renderers/common/film_kernel.h"
#include "renderers/common/gpu_scene.h"
#include "renderers/common/scene_data.h"

#include "base/progress.h"
#include "gpu/raster_pipeline.h"

#include "interop/raster.h"

#include <array>

namespace utsuri {

/// Draws one view of a scene with the raster pipeline and adds the pictures to a film, a sample of each pixel
/// a time. Samples of one picture lie at one place in their pixels, which a Sobol sequence moves from picture
/// to picture.
class FrameDrawer {
  public:
    /// @param bindings of scene, light cache and maps
    /// @throws DeviceError if the device cannot draw pictures of this size
    FrameDrawer(Device& device, const SceneData& data, const Specialization& specialization,
                const Bindings& bindings, std::uint32_t width, std::uint32_t height);

    /// Makes the driver compile what add_samples() needs.
    void warm_up();

    /// @param camera of the picture (make_camera_info())
    FrameCounts add_samples(Film& film, const interop::CameraInfo& camera, std::uint32_t seed,
                            std::uint32_t count, Progress& progress);

  private:
    double draw(const interop::RasterPush& push, std::uint32_t triangles, const Film* film,
                const std::vector<BindingSet>& sets);

    Device& device_;
    std::uint32_t triangles_;
    float near_plane_;
    std::array<float, 4> background_;
    Attachment colour_;
    Attachment depth_;
    Buffer drawn_;
    Buffer counters_;
    RasterPipeline pipeline_;
    BindingSet pipeline_bindings_;
    Kernel add_kernel_;
};

}  // namespace utsuri
