// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/common/light_cache.h"
#include "renderers/reflection_map/map_capture.h"
#include "renderers/reflection_map/planar_drawer.h"
#include "renderers/reflection_map/reflection_maps.h"
#include "renderers/reflection_map/rough_maps.h"

namespace utsuri {

/// Plane mirrors drawn with mirrored cameras, to a depth; what is reflective but not plane looks maps up as
/// MapKind::proxy does. Everything is lit from light kept on surfaces.
class PlanarRenderer : public Renderer {
  public:
    /// `device`, `data`, `scene` and `light` must outlive this.
    /// @param light is filled by the first renderer that needs it
    PlanarRenderer(Device& device, const SceneData& data, const GpuScene& scene, FilledLight& light,
                   const Camera& camera, const RenderSettings& settings, const MapSettings& map_settings);

    void prepare(Progress& progress) override;
    void look_from(const Camera& camera) override;
    bool draw_frame() override;

    [[nodiscard]] const PlaneMirrors& mirrors() const { return mirrors_; }
    /// What a frame draws.
    [[nodiscard]] const std::vector<MirrorImage>& images() const { return images_; }

  protected:
    FrameCounts render(Film& film, std::uint32_t count, Progress& progress) override;

  private:
    [[nodiscard]] Bindings drawing_bindings() const;

    const SceneData& data_;
    const GpuScene& scene_;
    FilledLight& filled_light_;
    Camera camera_;
    RenderSettings settings_;
    PlaneMirrors mirrors_;
    ReflectionMaps maps_;
    RoughMaps rough_maps_;
    LightCache light_cache_;
    MapCapture capture_;
    PlanarDrawer drawer_;
    std::vector<MirrorImage> images_;
};

}  // namespace utsuri
