// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/reflection_map/reflection_maps.h"

namespace utsuri {

/// direct/polygon-map and direct/sphere-map: what the first hit reflects is looked up in maps captured
/// beforehand.
class MapRenderer : public Renderer {
  public:
    /// `device`, `data` and `scene` must outlive this.
    MapRenderer(Device& device, const SceneData& data, const GpuScene& scene, const Camera& camera,
                MapKind kind, const RenderSettings& settings, const MapSettings& map_settings);

    void prepare(Progress& progress) override;

    [[nodiscard]] const ReflectionMaps& maps() const { return maps_; }

  protected:
    FrameCounts render(Film& film, std::uint32_t count, Progress& progress) override;

  private:
    [[nodiscard]] Bindings all_bindings() const;
    /// The pass over the reflectors' vertices, which is all that a moving eye costs besides the picture.
    double reflect_vertices();

    Device& device_;
    const GpuScene& scene_;
    Camera camera_;
    RenderSettings settings_;
    glm::vec3 eye_;
    ReflectionMaps maps_;
    Buffer vertices_;
    Buffer vertex_reflections_;
    Kernel vertex_kernel_;
    BindingSet vertex_bindings_;
    FrameSettings frame_;
    FilmKernel kernel_;
};

}  // namespace utsuri
