// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/film/render_settings.h"
#include "renderers/film/render_statistics.h"
#include "renderers/light/surface_light.h"
#include "renderers/reflection/distances/distance_maps.h"
#include "renderers/reflection/distances/radiance_bounds.h"
#include "renderers/reflection/glossy/glossy_maps.h"
#include "renderers/reflection/maps/map_capture.h"
#include "renderers/reflection/maps/reflection_maps.h"

#include <optional>
#include <vector>

namespace utsuri {

/// What glossy lobes reflect beside maps of a kind.
GlossyMapSettings glossy_map_settings(MapKind kind, const MapSettings& maps);

/// Reflection maps of one kind and all that drawing looks up beside them: light on surfaces, maps of glossy
/// lobes, and where the kind needs them distances and bounds of radiance.
class PreparedMaps {
  public:
    /// `device`, `data`, `scene` and `light` must outlive this.
    /// @param light is filled before prepare()
    /// @param eye the first one
    /// @param instances that get reflection maps, ascending
    /// @param previous of the scene before it changed: what they are and update() need not make anew is taken
    /// over from them
    PreparedMaps(Device& device, const SceneData& data, const GpuScene& scene, SurfaceLight& light,
                 const Camera& eye, MapKind kind, const RenderSettings& settings,
                 const MapSettings& map_settings, const std::vector<std::uint32_t>& instances,
                 PreparedMaps* previous = nullptr);
    PreparedMaps(const PreparedMaps&) = delete;
    PreparedMaps& operator=(const PreparedMaps&) = delete;

    /// Fills and captures what drawing looks up, but for reflection maps: those are captured when a picture
    /// has looked them up. Adds what that took to the statistics.
    /// @throws Interrupted if progress says so
    void prepare(const Camera& eye, RenderStatistics& statistics, Progress& progress);
    /// The same after a change of the scene that these were made with `previous` maps for, and the light has
    /// taken over: what sees nothing of the change is kept.
    void update(const SceneChange& change, const Camera& eye, RenderStatistics& statistics,
                Progress& progress);
    /// See MapCapture::capture_missing().
    bool capture_missing(RenderStatistics& statistics, Progress& progress) {
        return capture_.capture_missing(statistics, progress);
    }

    /// Of the scene and of all that is looked up.
    [[nodiscard]] Bindings bindings() const;
    [[nodiscard]] Specialization specialization() const;

    [[nodiscard]] const ReflectionMaps& maps() const { return maps_; }
    [[nodiscard]] const GlossyMaps& glossy_maps() const { return glossy_maps_; }
    [[nodiscard]] bool has_distances() const { return distances_.has_value(); }

  private:
    const SceneData& data_;
    const GpuScene& scene_;
    SurfaceLight& light_;
    RenderSettings settings_;
    MapKind kind_;
    std::vector<interop::ProxyPlane> proxy_planes_;  ///< of reflection maps, then of glossy ones
    ReflectionMaps maps_;
    std::optional<DistanceMaps> distances_;
    std::optional<RadianceBounds> radiance_bounds_;
    GlossyMaps glossy_maps_;
    Buffer proxy_plane_buffer_;
    Buffer frame_;  ///< interop::FrameInfo, written by what draws
    MapCapture capture_;
};

}  // namespace utsuri
