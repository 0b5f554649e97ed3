// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/film/film.h"
#include "renderers/film/film_kernel.h"
#include "renderers/scene/scene_data.h"

#include "base/progress.h"
#include "gpu/raster_pipeline.h"

#include "interop/raster.h"

#include <array>
#include <functional>

namespace utsuri {

/// @throws DeviceError if the device has no raster pipeline
Device& drawing_device(Device& device);

/// What a drawn picture shows where nothing is: the surroundings.
std::array<float, 4> background_of(const SceneData& data);

/// Distance of the near plane, scene space.
float near_plane(const SceneData& data);

/// What all draws of a picture are told, but for the samples: seed, depth and tolerance are left to the
/// caller.
interop::FrameInfo frame_info(const SceneData& data, std::uint32_t width, std::uint32_t height);

/// See DrawnSamples::add().
using CompleteMaps = std::function<bool()>;

/// Draws pictures and adds them to a film, a sample of each pixel a time. Samples of one picture lie at one
/// place in their pixels, which a Sobol sequence moves from picture to picture.
class DrawnSamples {
  public:
    /// @param map_states BINDING_MAP_STATES of the maps that are looked up
    DrawnSamples(Device& device, std::uint32_t width, std::uint32_t height, const Buffer& map_states);

    /// @param frame of the picture, the place of the sample left out
    /// @param colour what `record` draws into
    /// @param record records the drawing of one picture
    /// @param complete captures the maps that a picture lacked and tells whether there were any: the picture
    /// was not added then, and is drawn again
    FrameCounts add(Film& film, interop::FrameInfo frame, std::uint32_t count, Progress& progress,
                    const Attachment& colour,
                    const std::function<void(const vk::raii::CommandBuffer& commands,
                                             const interop::FrameInfo& frame)>& record,
                    const CompleteMaps& complete);

  private:
    Device& device_;
    Buffer drawn_;
    Buffer counters_;
    Kernel add_kernel_;
    const Buffer& map_states_;
};

}  // namespace utsuri
