// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"
#include "renderers/film/device_counters.h"
#include "renderers/film/film.h"
#include "renderers/film/film_kernel.h"

#include "gpu/raster_pipeline.h"

#include "interop/raster.h"

#include <array>
#include <functional>
#include <vector>

namespace utsuri {

/// @throws DeviceError if the device has no raster pipeline
Device& require_graphics(Device& device);

/// What a drawn picture shows where nothing is: the environment.
std::array<float, 4> background_of(const SceneData& data);

/// Distance of the near plane, scene space.
float near_plane(const SceneData& data);

/// What all draws of a picture are told, but for the samples: seed, depth and tolerance are left to the
/// caller.
interop::FrameInfo frame_info(const SceneData& data, std::uint32_t width, std::uint32_t height);

/// Records the drawing of one picture, told what is the same for all its draws.
using RecordPicture =
    std::function<void(const vk::raii::CommandBuffer& commands, const interop::FrameInfo& frame)>;

/// Draws pictures and adds them to a film, a sample of each pixel a time. Samples of one picture lie at one
/// place in their pixels, which a Sobol sequence moves from picture to picture.
class DrawnSamples {
  public:
    /// @param map_states BINDING_MAP_STATES of the maps that are looked up; must outlive this
    DrawnSamples(Device& device, std::uint32_t width, std::uint32_t height, const Buffer& map_states);

    /// Starts to count for samples of a film.
    void begin(const Film& film);
    /// Draws one picture and adds it to the film, unless it lacks a map that it looked up: then the film
    /// stays as it is.
    /// @param frame of the picture, the place of the sample left out
    /// @param colour what `record` draws into
    /// @returns seconds on the device
    double draw(const Film& film, interop::FrameInfo frame, const Attachment& colour,
                const RecordPicture& record);
    /// Since begin(), the time on the device left out.
    [[nodiscard]] FrameCounts counts() const;

  private:
    Device& device_;
    Buffer drawn_;
    DeviceCounters counters_;
    Kernel add_kernel_;
    const Buffer& map_states_;
    std::vector<BindingSet> sets_;  ///< of the film's bands
};

}  // namespace utsuri
