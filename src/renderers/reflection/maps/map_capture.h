// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/gpu_scene.h"
#include "renderers/film/film_kernel.h"
#include "renderers/film/render_settings.h"
#include "renderers/film/render_statistics.h"
#include "renderers/light/surface_light.h"
#include "renderers/reflection/maps/reflection_maps.h"
#include "renderers/reflection/maps/texel_tracer.h"

#include "base/progress.h"

#include <optional>

namespace utsuri {

/// Renders reflection maps with the tracing kernel, those alone that something looked up: what no reflection
/// reaches costs nothing.
class MapCapture {
  public:
    /// `device`, `scene`, `light` and `maps` must outlive this.
    MapCapture(Device& device, const GpuScene& scene, const SurfaceLight& light, ReflectionMaps& maps,
               const RenderSettings& settings, const MapSettings& map_settings);

    /// Compiles what capturing needs, and asks for all maps if the settings say so. The light must be filled.
    /// @param eye whose axes sphere maps follow from then on
    void prepare(const Camera& eye, RenderStatistics& statistics);

    /// Captures the maps that a picture looked up and lacked, or fewer once `progress` is cancelled. Such a
    /// picture shows nothing in their place, and must be drawn again.
    /// @returns whether there were any
    bool capture_missing(RenderStatistics& statistics, Progress& progress);

  private:
    [[nodiscard]] FrameCounts capture(std::uint32_t map);
    /// A film of that many pixels along an edge: the last one, if maps of one size follow one another.
    Film& film_of(std::uint32_t edge);

    Device& device_;
    const GpuScene& scene_;
    const SurfaceLight& light_;
    ReflectionMaps& maps_;
    RenderSettings settings_;
    std::uint32_t samples_;  ///< per texel
    bool captures_all_;
    std::optional<TexelTracer> tracer_;  ///< from prepare() on, if there are maps
    std::optional<Film> film_;
};

}  // namespace utsuri
