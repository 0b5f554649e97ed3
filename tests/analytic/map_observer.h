// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/methods/raster_renderer.h"
#include "support/estimate.h"
#include "support/methods.h"

namespace utsuri::test {

/// A scene on the device, for looks at it by reflection mapping.
class MapObserver {
  public:
    MapObserver(Device& device, const Scene& scene, MapKind kind, const MapSettings& settings);

    Image picture(const Camera& camera, const RenderSettings& settings, std::uint32_t samples);
    /// See Observer::look().
    Estimate look(glm::dvec3 eye, glm::dvec3 target, std::uint32_t samples);
    /// The maps of the first reflector as captured for an eye: all faces, border included.
    std::vector<Image> maps(const Camera& camera);

    [[nodiscard]] const RenderStatistics& statistics() const { return statistics_; }

  private:
    Device& device_;
    SceneData data_;
    GpuScene gpu_scene_;
    MapKind kind_;
    MapSettings settings_;
    KeptLight light_;
    RenderStatistics statistics_;
};

/// Maps of 16 samples a texel, the rest as by default.
inline MapSettings map_settings(std::uint32_t size, std::optional<glm::dvec3> capture_point = std::nullopt) {
    MapSettings settings;
    settings.size = size;
    settings.samples = 16;
    settings.capture_point = capture_point;
    return settings;
}

/// Texel centre in picture coordinates, [-1, 1]^2 for the texels inside the border.
inline glm::dvec2 texel_centre(std::uint32_t column, std::uint32_t row, std::uint32_t size) {
    const double border = interop::MAP_BORDER;
    return {2.0 * (column + 0.5 - border) / size - 1.0, 1.0 - 2.0 * (row + 0.5 - border) / size};
}

}  // namespace utsuri::test
